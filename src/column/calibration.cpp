#include "column/calibration.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "case/flow_kind.hpp"
#include "column/calibration_parameter.hpp"
#include "column/calibration_target.hpp"
#include "column/centreline.hpp"
#include "column/section.hpp"
#include "statistics/least_squares.hpp"
#include "statistics/linear_fit.hpp"

namespace riffle::inline column {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An unknown of the fit: a parameter of all conditions or of one.
struct Unknown {
    const CalibrationParameter* parameter = nullptr;
    std::optional<std::size_t> condition;
    double start = 0;
    double scale = 1;  ///< change of the value for a change of the unknown by one
    double lower = 0;
    double upper = 0;

    /// The unknowns are 1 at the start.
    [[nodiscard]] double value(double unknown) const { return start + scale * (unknown - 1.0); }
    [[nodiscard]] double unknown_of(double value) const { return 1.0 + (value - start) / scale; }
    [[nodiscard]] bool concerns(std::size_t i) const { return !condition || *condition == i; }
};

std::string name_of(const Case& c, std::size_t i) {
    return c.title.empty() ? fmt::format("condition {}", i + 1) : c.title;
}

void check_parameter(const CalibrationParameter& p, const Case& c) {
    if (!p.applies(c)) {
        throw InputError(
            fmt::format("{} cannot be fitted: it has an effect only with {}", p.name, p.applies_to));
    }
    const double start = p.value(c);
    if (start < p.lower(c) || start > p.upper(c)) {
        throw InputError(fmt::format("{} starts at {:.6g}, outside of its range {:.6g} to {:.6g}: change {}",
                                     p.name, start, p.lower(c), p.upper(c), p.key));
    }
}

Unknown make_unknown(const CalibrationParameter& p, std::span<const Case> cases,
                     std::optional<std::size_t> condition) {
    const std::size_t first = condition.value_or(0);
    Unknown u{&p, condition, 0.0, 1.0, -infinity, infinity};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!u.concerns(i)) continue;
        check_parameter(p, cases[i]);
        u.lower = std::max(u.lower, p.lower(cases[i]));
        u.upper = std::min(u.upper, p.upper(cases[i]));
    }
    u.start = p.value(cases[first]);
    if (u.start < u.lower || u.start > u.upper) {
        throw InputError(fmt::format(
            "{} starts at {:.6g}, outside of the range {:.6g} to {:.6g} that all conditions allow: "
            "change {}, or fit it for each with --each",
            p.name, u.start, u.lower, u.upper, p.key));
    }
    u.scale = p.scale == nullptr ? u.start : p.scale(cases[first]);
    return u;
}

std::vector<Unknown> unknowns_of(std::span<const Case> cases, const CalibrationOptions& options) {
    if (options.parameters.empty() && options.each.empty()) {
        throw InputError("no parameter to fit: name at least one, for example drag_coefficient");
    }
    std::vector<Unknown> unknowns;
    const auto add = [&](const std::string& name, std::optional<std::size_t> condition) {
        const CalibrationParameter& p = find_calibration_parameter(name);
        for (const Unknown& other : unknowns) {
            if (other.parameter != &p || (condition && other.condition && other.condition != condition)) {
                continue;
            }
            throw InputError(fmt::format("parameter \"{}\" is named twice to be fitted: name it once", name));
        }
        unknowns.push_back(make_unknown(p, cases, condition));
    };
    for (const std::string& name : options.parameters) add(name, std::nullopt);
    for (const std::string& name : options.each) {
        for (std::size_t i = 0; i < cases.size(); ++i) add(name, i);
    }
    return unknowns;
}

/// Residuals of all conditions as a function of the unknowns.
class Misfit {
  public:
    Misfit(std::span<const Case> cases, const std::vector<CalibrationTarget>& targets,
           const std::vector<Unknown>& unknowns)
        : cases_(cases), targets_(targets), unknowns_(unknowns) {}

    /// The case of a condition with these unknowns.
    [[nodiscard]] Case at(const Eigen::VectorXd& values, std::size_t condition) const {
        Case c = cases_[condition];
        for (std::size_t k = 0; k < unknowns_.size(); ++k) {
            const Unknown& unknown = unknowns_[k];
            if (unknown.concerns(condition)) {
                unknown.parameter->member(c) = unknown.value(values(static_cast<Eigen::Index>(k)));
            }
        }
        return c;
    }

    /// None where there is no steady column: the minimiser turns back.
    std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& values) const {
        std::vector<double> all;
        try {
            for (std::size_t i = 0; i < cases_.size(); ++i) {
                const Case c = at(values, i);
                const std::vector<double> own = targets_[i].residuals(c, solve_centreline_and_section(c));
                all.insert(all.end(), own.begin(), own.end());
            }
        } catch (const InputError&) {
            return std::nullopt;
        }
        return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }

  private:
    std::span<const Case> cases_;
    const std::vector<CalibrationTarget>& targets_;
    const std::vector<Unknown>& unknowns_;
};

/// "drag_coefficient", "roughness_height of condition 2".
std::string label_of(const CalibrationResult& result, const FittedParameter& p) {
    return p.condition ? fmt::format("{} of {}", p.name, result.conditions[*p.condition].name) : p.name;
}

/// `covariance` of the unknowns; none where the measurements do not tell the parameters apart.
void describe_uncertainty(CalibrationResult& result, const std::vector<Unknown>& unknowns,
                          const std::optional<Eigen::MatrixXd>& covariance) {
    const std::size_t n = result.parameters.size();
    constexpr double normal_95 = 1.959964;
    result.correlation.assign(n, std::vector<double>(n, not_a_number));
    const bool from_scatter = result.scatter_factor > 1.0 && result.degrees_of_freedom >= 1.0;
    const double quantile =
        from_scatter ? student_quantile(static_cast<Eigen::Index>(result.degrees_of_freedom)) : normal_95;
    for (std::size_t i = 0; i < n; ++i) {
        result.correlation[i][i] = 1.0;
        FittedParameter& p = result.parameters[i];
        if (!covariance) {
            p.standard_uncertainty = infinity;
            continue;
        }
        const auto row = static_cast<Eigen::Index>(i);
        const double variance = (*covariance)(row, row);
        p.standard_uncertainty = std::abs(unknowns[i].scale) * std::sqrt(variance) * result.scatter_factor;
        p.half_width = quantile * p.standard_uncertainty;
        for (std::size_t j = 0; j < n; ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            result.correlation[i][j] =
                (*covariance)(row, column) / std::sqrt(variance * (*covariance)(column, column));
        }
    }
}

/// The parameters that only act together: those of the direction in which the residuals do not change.
std::string inseparable_parameters(const CalibrationResult& result, const Eigen::MatrixXd& jacobian) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> values(jacobian, Eigen::ComputeThinV);
    const Eigen::VectorXd flat = values.matrixV().col(values.matrixV().cols() - 1);
    std::string names;
    for (Eigen::Index i = 0; i < flat.size(); ++i) {
        constexpr double counts = 0.1;
        if (std::abs(flat(i)) < counts) continue;
        names +=
            (names.empty() ? "" : ", ") + label_of(result, result.parameters[static_cast<std::size_t>(i)]);
    }
    return names;
}

void warn_of_parameters(CalibrationResult& result, bool determined, const Eigen::MatrixXd& jacobian) {
    if (!determined) {
        const std::string names = inseparable_parameters(result, jacobian);
        result.warnings.push_back(fmt::format(
            "the measured values do not determine {}: {}; fit fewer, or give more measurements", names,
            names.find(',') == std::string::npos
                ? "it does not change what was measured"
                : "changed together they leave all that was measured as it is"));
    }
    constexpr double inseparable = 0.99;
    constexpr double hardly = 0.95;
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
        const FittedParameter& p = result.parameters[i];
        if (p.at_bound) {
            result.warnings.push_back(
                fmt::format("{} lies at the end {:.6g} of its range {:.6g} to {:.6g}: no minimum within "
                            "the range, and its uncertainty means little",
                            label_of(result, p), p.value, p.lower, p.upper));
        }
        for (std::size_t j = i + 1; j < result.parameters.size(); ++j) {
            const double correlation = result.correlation[i][j];
            if (!(std::abs(correlation) > hardly)) continue;
            result.warnings.push_back(
                fmt::format("{} and {} {} be told apart by these measurements (correlation {:.4f}): fit "
                            "one of them{}",
                            label_of(result, p), label_of(result, result.parameters[j]),
                            std::abs(correlation) > inseparable ? "cannot" : "can hardly", correlation,
                            result.conditions.size() == 1 ? ", or fit several conditions together" : ""));
        }
    }
}

void warn_of_quantities(CalibrationResult& result) {
    const bool several = result.conditions.size() > 1;
    for (const CalibratedCondition& condition : result.conditions) {
        for (const FittedQuantity& q : condition.quantities) {
            if (!q.worsened()) continue;
            result.warnings.push_back(fmt::format(
                "the fit makes the {}{} worse: {:+.1f} % before, {:+.1f} % after, known to {:.1f} %{}",
                q.name, several ? " of " + condition.name : "", 100.0 * q.relative_misfit_before,
                100.0 * q.relative_misfit_after, 100.0 * q.uncertainty / std::abs(q.measured),
                q.fitted_to ? "" : " (not fitted to)"));
        }
    }
}

}  // namespace

bool FittedQuantity::worsened() const {
    const double more = std::abs(relative_misfit_after) - std::abs(relative_misfit_before);
    constexpr double noticeable = 0.1;
    return more * std::abs(measured) > noticeable * uncertainty;
}

bool FittedQuantity::missed_after() const { return std::abs(relative_misfit_after * measured) > uncertainty; }

bool CalibrationResult::worsened() const {
    return std::any_of(conditions.begin(), conditions.end(), [](const CalibratedCondition& condition) {
        return std::any_of(
            condition.quantities.begin(), condition.quantities.end(),
            [](const FittedQuantity& q) { return q.fitted_to && q.worsened() && q.missed_after(); });
    });
}

std::vector<std::string> calibration_parameters() {
    std::vector<std::string> names;
    for (const CalibrationParameter& p : calibration_parameter_table()) {
        names.push_back(fmt::format("{} ({})", p.name, p.key));
    }
    return names;
}

CalibrationResult calibrate_columns(std::span<const Case> cases, const CalibrationOptions& options) {
    if (cases.empty()) throw InputError("nothing to calibrate: name at least one case");
    if (options.sections.size() > cases.size()) {
        throw InputError(
            fmt::format("{} files of cross-sections for {} cases: give one for each, in their order",
                        options.sections.size(), cases.size()));
    }
    for (const Case& c : cases) {
        const auto reason = why_no_column(c);
        if (reason && why_no_section(c)) throw InputError("the case has no twin to fit: " + *reason);
    }
    const std::vector<Unknown> unknowns = unknowns_of(cases, options);
    std::vector<CalibrationTarget> targets;
    std::vector<Centreline> before;
    double independent = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        targets.emplace_back(cases[i], options,
                             i < options.sections.size() ? options.sections[i] : std::filesystem::path());
        independent += targets.back().independent_values();
    }
    const auto count = static_cast<double>(unknowns.size());
    if (independent + 1e-9 < count) {
        throw InputError(
            fmt::format("{} parameters to fit, but {} {:.0f} independent measured value(s): fit fewer, or "
                        "give more in [measured]",
                        unknowns.size(), cases.size() == 1 ? "the case has" : "the cases have", independent));
    }
    for (const Case& c : cases) before.push_back(solve_centreline_and_section(c));

    const Misfit misfit(cases, targets, unknowns);
    const auto size = static_cast<Eigen::Index>(unknowns.size());
    Eigen::VectorXd lower(size);
    Eigen::VectorXd upper(size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
        lower(k) = unknown.unknown_of(unknown.lower);
        upper(k) = unknown.unknown_of(unknown.upper);
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
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CalibratedCondition condition;
        condition.name = name_of(cases[i], i);
        condition.fitted = misfit.at(fit->parameters, i);
        const Centreline after = solve_centreline_and_section(condition.fitted);
        condition.column = after.column;
        condition.quantities = targets[i].compare(cases[i], before[i], condition.fitted, after);
        for (const double r : targets[i].residuals(condition.fitted, after)) result.chi_square += r * r;
        result.conditions.push_back(std::move(condition));
    }
    result.degrees_of_freedom = std::max(0.0, independent - count);
    if (result.degrees_of_freedom > 0.5) {
        result.scatter_factor = std::max(1.0, std::sqrt(result.chi_square / result.degrees_of_freedom));
    }
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        const Unknown& unknown = unknowns[k];
        const CalibrationParameter& p = *unknown.parameter;
        FittedParameter f{std::string(p.name), std::string(p.key), std::string(p.unit)};
        f.start = unknown.start;
        f.value = unknown.value(fit->parameters(static_cast<Eigen::Index>(k)));
        f.lower = unknown.lower;
        f.upper = unknown.upper;
        f.condition = unknown.condition;
        const double margin = 1e-6 * (f.upper - f.lower);
        f.at_bound = f.value < f.lower + margin || f.value > f.upper - margin;
        result.parameters.push_back(f);
    }
    const std::optional<Eigen::MatrixXd> covariance = parameter_covariance(fit->jacobian);
    describe_uncertainty(result, unknowns, covariance);
    if (!fit->converged) {
        result.warnings.emplace_back(
            "the fit did not converge: the values are the best found, not a minimum");
    }
    warn_of_parameters(result, covariance.has_value(), fit->jacobian);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string contradiction = targets[i].contradiction();
        if (!contradiction.empty()) {
            result.warnings.push_back(cases.size() > 1 ? result.conditions[i].name + ": " + contradiction
                                                       : contradiction);
        }
    }
    warn_of_quantities(result);
    return result;
}

CalibrationResult calibrate_column(const Case& c, const CalibrationOptions& options) {
    return calibrate_columns(std::span(&c, 1), options);
}

std::vector<Override> fitted_overrides(const CalibrationResult& result, std::size_t condition) {
    std::vector<Override> overrides;
    for (const FittedParameter& p : result.parameters) {
        if (p.condition && *p.condition != condition) continue;
        // Six digits: more than the measurements determine, and readable.
        overrides.push_back({p.key, fmt::format("{:.6g}", p.value)});
    }
    return overrides;
}

}  // namespace riffle::inline column
