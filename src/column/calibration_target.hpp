#pragma once

#include <optional>
#include <string>
#include <vector>

#include "column/calibration.hpp"
#include "column/velocity_measurements.hpp"

namespace riffle {

/// The measured values that a calibration aims at, with their weights.
class CalibrationTarget {
  public:
    /// Throws InputError if the case has no measured value.
    CalibrationTarget(const Case& c, const CalibrationOptions& options);

    /// (column - measured)/uncertainty of each value.
    [[nodiscard]] std::vector<double> residuals(const Case& c, const ColumnResult& column) const;

    [[nodiscard]] int size() const;

    /// Number of independent measured values.
    [[nodiscard]] double independent_values() const;

    /// Measured and computed values side by side.
    [[nodiscard]] std::vector<FittedQuantity> compare(const Case& before_case, const ColumnResult& before,
                                                      const Case& after_case,
                                                      const ColumnResult& after) const;

  private:
    std::optional<double> depth_mean_;
    double depth_mean_uncertainty_ = 0;
    std::optional<double> friction_velocity_;
    double friction_velocity_uncertainty_ = 0;
    VelocityMeasurements profile_;  ///< heights above the datum, which moves with the fitted roughness height
    std::string profile_name_;
    double profile_weight_ = 1;  ///< of each residual
};

}  // namespace riffle
