#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"

namespace riffle {

/// What to fit, and how much to trust each measured value. Uncertainties are relative standard uncertainties.
struct CalibrationOptions {
    /// Any of "roughness_height", "drag_coefficient", "lambda".
    std::vector<std::string> parameters{"drag_coefficient", "lambda"};
    double depth_mean_uncertainty = 0.03;
    double friction_velocity_uncertainty = 0.05;
    double profile_uncertainty = 0.05;  ///< of each velocity without its own uncertainty
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
};

struct CalibrationResult {
    std::vector<FittedParameter> parameters;
    std::vector<std::vector<double>> correlation;  ///< of the parameters, symmetric, ones on the diagonal
    std::vector<FittedQuantity> quantities;
    double chi_square = 0;          ///< weighted sum of squares after the fit
    double degrees_of_freedom = 0;  ///< independent measured values minus parameters
    double scatter_factor = 1;      ///< by which the uncertainties were widened, max(1, sqrt(chi^2/dof))
    std::vector<std::string> warnings;
    Case fitted;          ///< the case with the fitted values (its text is not changed)
    ColumnResult column;  ///< of the fitted case; between side walls the centreline of its section
};

/// Fit parameters of the column to the measured values of the case by weighted least squares (Levenberg-
/// Marquardt within the valid ranges). Used are: the depth-mean velocity; the measured profile, each point
/// with its own uncertainty; without one the rough log law (thesis 2.3) through the measured u_* and k_s,
/// whose points weigh together as two values, since two numbers made them; without k_s the friction velocity,
/// against the column's log-law fit. Uncertainties come from the covariance of the fit, widened where the
/// misfit exceeds the stated uncertainties. Throws InputError for an unknown or inapplicable parameter,
/// without measured values, or with fewer independent values than parameters.
[[nodiscard]] CalibrationResult calibrate_column(const Case& c, const CalibrationOptions& options);

/// The fitted values as overrides of the case file.
[[nodiscard]] std::vector<Override> fitted_overrides(const CalibrationResult& result);

}  // namespace riffle
