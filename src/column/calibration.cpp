#include "column/calibration.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "column/calibration_target.hpp"
#include "column/centreline.hpp"
#include "statistics/least_squares.hpp"

namespace riffle {

namespace {

/// A parameter that can be fitted: where it lives in the case, and where it makes sense.
struct Parameter {
    std::string_view name;
    std::string_view key;
    std::string_view unit;
    double& (*member)(Case&);
    double (*lower)(const Case&);
    double (*upper)(const Case&);
    bool (*applies)(const Case&);
    std::string_view applies_to;
};

bool spheres(const Case& c) { return c.bed.kind == BedKind::spheres; }

/// A new parameter is one entry here.
const std::array parameters{
    Parameter{"roughness_height", "bed.roughness_height", "m",
              [](Case& c) -> double& { return c.bed.roughness_height; },
              // What a valid case allows, the datum above the bed and the zone resolved by the particles,
              // with room for the difference quotients.
              [](const Case& c) { return std::max(1.01 * c.bed.datum_below_crest, c.numerics.spacing); },
              [](const Case& c) { return c.bed.sphere_diameter; }, spheres, "bed.kind = \"spheres\""},
    Parameter{"drag_coefficient", "bed.drag_coefficient", "",
              [](Case& c) -> double& { return c.bed.drag_coefficient; }, [](const Case&) { return 0.01; },
              [](const Case&) { return 10.0; }, spheres, "bed.kind = \"spheres\""},
    Parameter{"lambda", "turbulence.lambda", "", [](Case& c) -> double& { return c.turbulence.lambda; },
              [](const Case&) { return 0.01; }, [](const Case& c) { return c.turbulence.kappa; },
              [](const Case& c) { return c.turbulence.closure == ClosureKind::ramp; },
              "turbulence.closure = \"ramp\""},
};

const Parameter& find_parameter(const std::string& name) {
    const auto* const found = std::find_if(parameters.begin(), parameters.end(),
                                           [&name](const Parameter& p) { return p.name == name; });
    if (found == parameters.end()) {
        std::string known;
        for (const Parameter& p : parameters) known += fmt::format("{}{}", known.empty() ? "" : ", ", p.name);
        throw InputError(fmt::format("unknown parameter \"{}\" to fit: choose among {}", name, known));
    }
    return *found;
}

std::vector<Parameter> chosen_parameters(const Case& c, const std::vector<std::string>& names) {
    if (names.empty())
        throw InputError("no parameter to fit: name at least one, for example drag_coefficient");
    std::vector<Parameter> chosen;
    for (const std::string& name : names) {
        const Parameter& p = find_parameter(name);
        const auto same = [&p](const Parameter& other) { return other.name == p.name; };
        if (std::any_of(chosen.begin(), chosen.end(), same)) {
            throw InputError(fmt::format("parameter \"{}\" is named twice to be fitted: name it once", name));
        }
        if (!p.applies(c)) {
            throw InputError(
                fmt::format("{} cannot be fitted: it has an effect only with {}", p.name, p.applies_to));
        }
        Case copy = c;
        const double start = p.member(copy);
        if (start < p.lower(c) || start > p.upper(c)) {
            throw InputError(
                fmt::format("{} starts at {:.6g}, outside of its range {:.6g} to {:.6g}: change {}", p.name,
                            start, p.lower(c), p.upper(c), p.key));
        }
        chosen.push_back(p);
    }
    return chosen;
}

/// Residuals as a function of the parameters, each in units of its start value.
class Misfit {
  public:
    Misfit(const Case& c, const CalibrationTarget& target, const std::vector<Parameter>& chosen)
        : case_(c), target_(target), chosen_(chosen) {}

    [[nodiscard]] Case at(const Eigen::VectorXd& scaled) const {
        Case c = case_;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            chosen_[i].member(c) *= scaled(static_cast<Eigen::Index>(i));
        }
        return c;
    }

    /// None where there is no steady column: the minimiser turns back.
    std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& scaled) const {
        try {
            const Case c = at(scaled);
            const std::vector<double> values = target_.residuals(c, solve_centreline(c));
            return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
        } catch (const InputError&) {
            return std::nullopt;
        }
    }

  private:
    const Case& case_;
    const CalibrationTarget& target_;
    const std::vector<Parameter>& chosen_;
};

/// `covariance` of the scaled parameters; none where the measurements do not tell the parameters apart.
void describe_uncertainty(CalibrationResult& result, const std::optional<Eigen::MatrixXd>& covariance) {
    const std::size_t n = result.parameters.size();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    result.correlation.assign(n, std::vector<double>(n, not_a_number));
    for (std::size_t i = 0; i < n; ++i) {
        result.correlation[i][i] = 1.0;
        FittedParameter& p = result.parameters[i];
        if (!covariance) {
            p.standard_uncertainty = infinity;
            continue;
        }
        const auto row = static_cast<Eigen::Index>(i);
        const double variance = (*covariance)(row, row);
        p.standard_uncertainty = p.start * std::sqrt(variance) * result.scatter_factor;
        for (std::size_t j = 0; j < n; ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            result.correlation[i][j] =
                (*covariance)(row, column) / std::sqrt(variance * (*covariance)(column, column));
        }
    }
}

void add_warnings(CalibrationResult& result, bool determined, bool converged) {
    if (!converged) {
        result.warnings.emplace_back(
            "the fit did not converge: the values are the best found, not a minimum");
    }
    if (!determined) {
        result.warnings.emplace_back(
            "the measured values do not determine the parameters: fit fewer, or give more measurements");
    }
    constexpr double inseparable = 0.99;
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
        const FittedParameter& p = result.parameters[i];
        if (p.at_bound) {
            result.warnings.push_back(
                fmt::format("{} lies at the end {:.6g} of its range {:.6g} to {:.6g}: no minimum within the "
                            "range, and its "
                            "uncertainty means little",
                            p.name, p.value, p.lower, p.upper));
        }
        for (std::size_t j = i + 1; j < result.parameters.size(); ++j) {
            if (std::abs(result.correlation[i][j]) > inseparable) {
                result.warnings.push_back(
                    fmt::format("{} and {} cannot be told apart by these measurements (correlation {:.4f}): "
                                "fit one of them",
                                p.name, result.parameters[j].name, result.correlation[i][j]));
            }
        }
    }
}

}  // namespace

CalibrationResult calibrate_column(const Case& c, const CalibrationOptions& options) {
    const std::vector<Parameter> chosen = chosen_parameters(c, options.parameters);
    const CalibrationTarget target(c, options);
    const auto unknowns = static_cast<double>(chosen.size());
    if (target.independent_values() + 1e-9 < unknowns) {
        throw InputError(fmt::format(
            "{} parameters to fit, but the case has {:.0f} independent measured value(s): fit fewer, or "
            "give more in [measured]",
            chosen.size(), target.independent_values()));
    }
    const ColumnResult before = solve_centreline(c);

    const Misfit misfit(c, target, chosen);
    Case start = c;
    const auto size = static_cast<Eigen::Index>(chosen.size());
    Eigen::VectorXd lower(size);
    Eigen::VectorXd upper(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const Parameter& p = chosen[static_cast<std::size_t>(i)];
        lower(i) = p.lower(c) / p.member(start);
        upper(i) = p.upper(c) / p.member(start);
    }
    LeastSquaresOptions solver;
    // Wide enough that the changes of the grid with the parameters (1e-7 of the result) do not show.
    solver.difference_step = 1e-3;
    const std::optional<LeastSquaresFit> fit =
        minimise_least_squares(misfit, Eigen::VectorXd::Ones(size), lower, upper, solver);
    if (!fit) {
        throw InputError(
            "the calibration failed, the column has no steady state near the start: change the values "
            "of the case that the fit starts from");
    }

    CalibrationResult result;
    result.fitted = misfit.at(fit->parameters);
    result.column = solve_centreline(result.fitted);
    for (const double r : target.residuals(result.fitted, result.column)) result.chi_square += r * r;
    result.degrees_of_freedom = std::max(0.0, target.independent_values() - unknowns);
    if (result.degrees_of_freedom > 0.5) {
        result.scatter_factor = std::max(1.0, std::sqrt(result.chi_square / result.degrees_of_freedom));
    }
    for (const Parameter& p : chosen) {
        FittedParameter f{std::string(p.name), std::string(p.key), std::string(p.unit)};
        f.start = p.member(start);
        f.value = p.member(result.fitted);
        f.lower = p.lower(c);
        f.upper = p.upper(c);
        const double margin = 1e-6 * (f.upper - f.lower);
        f.at_bound = f.value < f.lower + margin || f.value > f.upper - margin;
        result.parameters.push_back(f);
    }
    const std::optional<Eigen::MatrixXd> covariance = parameter_covariance(fit->jacobian);
    describe_uncertainty(result, covariance);
    result.quantities = target.compare(c, before, result.fitted, result.column);
    add_warnings(result, covariance.has_value(), fit->converged);
    return result;
}

std::vector<Override> fitted_overrides(const CalibrationResult& result) {
    std::vector<Override> overrides;
    for (const FittedParameter& p : result.parameters) {
        // Six digits: more than the measurements determine, and readable.
        overrides.push_back({p.key, fmt::format("{:.6g}", p.value)});
    }
    return overrides;
}

}  // namespace riffle
