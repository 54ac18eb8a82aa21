#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"

namespace riffle::inline column {

/// What to fit, and how much to trust each measured value. Uncertainties are relative standard uncertainties.
struct CalibrationOptions {
    /// Parameters with one value for all conditions (calibration_parameters()).
    std::vector<std::string> parameters{"drag_coefficient", "lambda"};
    /// Parameters with a value of its own for each condition.
    std::vector<std::string> each = {};
    double depth_mean_uncertainty = 0.03;
    double friction_velocity_uncertainty = 0.05;
    double profile_uncertainty = 0.05;  ///< of each velocity without its own uncertainty
    double stress_uncertainty = 0.1;    ///< of each Reynolds stress of a section, over g S0 h
    /// Measured quantities to fit to: "depth-mean", "profile", "friction-velocity", "section"; empty: all
    /// that there are.
    std::vector<std::string> use = {};
    /// Points of cross-sections, one file for each condition; empty names and missing ones: none.
    std::vector<std::filesystem::path> sections = {};
};

/// A fitted parameter.
struct FittedParameter {
    std::string name;
    std::string key;   ///< in the case file: "bed.roughness_height"
    std::string unit;  ///< "m"; empty for numbers without unit
    double start = 0;
    double value = 0;
    double standard_uncertainty = 0;  ///< infinite where the measurements do not determine it
    double lower = 0;                 ///< allowed range
    double upper = 0;
    bool at_bound = false;
    /// Half-width of the 95 % interval: Student's t with the degrees of freedom where the uncertainties were
    /// widened by the scatter, else that of known uncertainties.
    double half_width = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> condition = std::nullopt;  ///< whose it is; none: of all
};

/// A measured value beside the column's before and after the fit. A profile is one entry, its `misfit` the
/// root mean square over the points.
struct FittedQuantity {
    std::string name;
    std::string unit;
    std::size_t points = 1;
    double measured = 0;     ///< profile: mean over the points
    double uncertainty = 0;  ///< standard; profile: mean over the points
    double before = 0;
    double after = 0;
    double relative_misfit_before = 0;
    double relative_misfit_after = 0;
    bool fitted_to = true;  ///< false: told only

    /// Whether the fit moved it away from the measured value by more than a tenth of its uncertainty.
    [[nodiscard]] bool worsened() const;
    /// Whether it then misses the measured value by more than its uncertainty.
    [[nodiscard]] bool missed_after() const;
};

/// One condition after the fit.
struct CalibratedCondition {
    std::string name;  ///< the title of its case
    std::vector<FittedQuantity> quantities;
    Case fitted;          ///< the case with the fitted values (its text is not changed)
    ColumnResult column;  ///< of the fitted case; between side walls the centreline of its section
};

struct CalibrationResult {
    std::vector<FittedParameter> parameters;
    std::vector<std::vector<double>> correlation;  ///< of the parameters, symmetric, ones on the diagonal
    std::vector<CalibratedCondition> conditions;
    double chi_square = 0;          ///< weighted sum of squares after the fit
    double degrees_of_freedom = 0;  ///< independent measured values minus parameters
    double scatter_factor = 1;      ///< by which the uncertainties were widened, max(1, sqrt(chi^2/dof))
    std::vector<std::string> warnings;

    /// Whether a quantity that was fitted to is worse than before and misses its measured value.
    [[nodiscard]] bool worsened() const;
};

/// Names of the parameters that can be fitted, with their keys: "roughness_height (bed.roughness_height)".
[[nodiscard]] std::vector<std::string> calibration_parameters();

/// Fit parameters of the column to the measured values of the cases by weighted least squares (Levenberg-
/// Marquardt within the valid ranges), all conditions at once. Used are: the depth-mean velocity; the
/// measured profile, each point with its own uncertainty; without one the rough log law (thesis 2.3) through
/// the measured u_* and k_s, whose points weigh together as two values, since two numbers made them; without
/// k_s the friction velocity, against the column's log-law fit; of a cross-section each velocity and stress,
/// against the section twin. Uncertainties come from the covariance of the fit, widened where the misfit
/// exceeds the stated uncertainties. Throws InputError for an unknown or inapplicable parameter, without
/// measured values, or with fewer independent values than parameters.
[[nodiscard]] CalibrationResult calibrate_columns(std::span<const Case> cases,
                                                  const CalibrationOptions& options);

/// The same of one case.
[[nodiscard]] CalibrationResult calibrate_column(const Case& c, const CalibrationOptions& options);

/// The fitted values of a condition as overrides of its case file.
[[nodiscard]] std::vector<Override> fitted_overrides(const CalibrationResult& result,
                                                     std::size_t condition = 0);

}  // namespace riffle::inline column
