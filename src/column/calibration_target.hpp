#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "column/calibration.hpp"
#include "column/centreline.hpp"
#include "column/section_measurements.hpp"
#include "column/velocity_measurements.hpp"

namespace riffle::inline column {

/// The measured values of a condition that a calibration aims at, with their weights.
class CalibrationTarget {
  public:
    /// `section`: points of its cross-section; empty: none. Throws InputError if the case has no measured
    /// value that is to be used, FileError for a file that cannot be read.
    CalibrationTarget(const Case& c, const CalibrationOptions& options, const std::filesystem::path& section);

    /// (computed - measured)/uncertainty of each value.
    [[nodiscard]] std::vector<double> residuals(const Case& c, const Centreline& computed) const;

    /// Number of independent measured values.
    [[nodiscard]] double independent_values() const;

    /// Measured and computed values side by side, those that are not fitted to too.
    [[nodiscard]] std::vector<FittedQuantity> compare(const Case& before_case, const Centreline& before,
                                                      const Case& after_case, const Centreline& after) const;

    /// What contradicts itself among the measured values; empty: nothing known.
    [[nodiscard]] std::string contradiction() const;

  private:
    struct SectionValue {
        double computed = 0;  ///< not-a-number where the section has none
        double measured = 0;
        double uncertainty = 0;
        bool stress = false;
    };
    [[nodiscard]] std::vector<SectionValue> section_values(const Case& c, const SectionResult& section) const;
    void add_points(const char* name, bool stress, const Case& before_case, const Centreline& before,
                    const Case& after_case, const Centreline& after,
                    std::vector<FittedQuantity>& result) const;

    Case case_;
    std::optional<double> depth_mean_;
    double depth_mean_uncertainty_ = 0;
    std::optional<double> friction_velocity_;
    double friction_velocity_uncertainty_ = 0;
    VelocityMeasurements profile_;  ///< heights over the datum
    std::string profile_name_;
    double profile_weight_ = 1;
    double profile_uncertainty_ = 0;
    double stress_uncertainty_ = 0;  ///< m2/s2
    SectionPoints section_;
    bool uses_depth_mean_ = false, uses_friction_velocity_ = false, uses_profile_ = false,
         uses_section_ = false;
};

}  // namespace riffle::inline column
