#include "hydraulics/law_fits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "statistics/root.hpp"
#include "statistics/separable_fit.hpp"

namespace riffle::inline hydraulics {

namespace {

using std::numbers::pi;
constexpr const char* dependent_points =
    "the points do not determine the parameters: too few different heights for the number of unknowns";

void require_positive(double value, const char* what) {
    if (!(value > 0.0)) throw InputError(std::string("profile fit: ") + what + " must be greater than 0");
}

/// u = steepness first(z) + offset + bend second(z), with the steepness given (u_*/kappa) or fitted.
/// Everything that the laws need of it.
struct Shape {
    FittedValue steepness;
    FittedValue offset_ratio;  ///< offset/steepness
    FittedValue bend_ratio;    ///< bend/steepness
    LinearFit fit;
    bool steepness_given = false;
};

std::optional<Shape> fit_shape(const FitPoints& points, const Eigen::VectorXd& first,
                               const Eigen::VectorXd& second, std::optional<double> steepness) {
    const Eigen::Index unknowns = steepness ? 2 : 3;
    Eigen::MatrixXd basis(first.size(), unknowns);
    basis.col(0).setOnes();
    basis.col(1) = second;
    if (!steepness) basis.col(2) = first;
    const Eigen::VectorXd target =
        steepness ? Eigen::VectorXd(points.velocity - *steepness * first) : points.velocity;
    auto fit = fit_linear(basis, target, points.uncertainty);
    if (!fit) return std::nullopt;
    Shape shape;
    shape.steepness_given = steepness.has_value();
    if (steepness) {
        shape.steepness = known_value(*steepness);
        shape.offset_ratio = linear_of(coefficient(*fit, 0), 1.0 / *steepness);
        shape.bend_ratio = linear_of(coefficient(*fit, 1), 1.0 / *steepness);
    } else {
        shape.steepness = coefficient(*fit, 2);
        shape.offset_ratio = coefficient_ratio(*fit, 0, 2);
        shape.bend_ratio = coefficient_ratio(*fit, 1, 2);
    }
    shape.fit = *std::move(fit);
    return shape;
}

template <class Fit>
Fit not_fitted(const FitPoints& points, std::string why_not) {
    Fit result;
    static_cast<FitQuality&>(result) = failed(points.quality(), std::move(why_not));
    return result;
}

/// Shape of a law of z/h, or the reason why there is none.
struct ShapeOrReason {
    std::optional<Shape> shape;
    std::string why_not;
};

ShapeOrReason shape_of_law(const FitPoints& points, const Eigen::VectorXd& first,
                           const Eigen::VectorXd& second, std::optional<double> steepness) {
    auto shape = fit_shape(points, first, second, steepness);
    if (!shape) return {std::nullopt, dependent_points};
    if (!(shape->steepness.value > 0.0)) {
        return {std::nullopt, "the velocity does not rise with the logarithm of the height"};
    }
    return {std::move(shape), {}};
}

Eigen::Index fewest_points(std::optional<double> friction_velocity) { return friction_velocity ? 3 : 4; }

std::optional<double> steepness_of(std::optional<double> friction_velocity, double kappa) {
    if (!friction_velocity) return std::nullopt;
    require_positive(*friction_velocity, "the friction velocity");
    return *friction_velocity / kappa;
}

/// h/(1 + alpha).
FittedValue maximum_of_dip(const FittedValue& dip, double depth) {
    if (!(dip.value > 0.0)) return {depth, 0.0, {depth / (1.0 + std::max(0.0, dip.interval.upper)), depth}};
    FittedValue result = linear_of(inverse_of(linear_of(dip, 1.0, 1.0)), depth);
    result.interval.upper = std::min(result.interval.upper, depth);
    return result;
}

/// The law (2.26) is u = u_*/kappa [first(xi) + alpha second(xi)] + offset.
double log_wake_first(double xi, double wake) { return std::log(xi) - wake * std::cos(pi * xi); }
double log_wake_second(double xi, double wake) {
    return std::log1p(-xi) - wake * std::cos(pi * xi) + pi * wake * sine_integral(pi * (1.0 - xi));
}

/// z0/h where the fitted law (2.26) vanishes, with its uncertainty by linear propagation; the interval is
/// symmetric in ln z0.
FittedValue zero_of_log_wake(const Shape& shape, double wake) {
    const double dip = shape.bend_ratio.value;
    const auto law = [&](double log_xi) {
        const double xi = std::exp(log_xi);
        return log_wake_first(xi, wake) + dip * log_wake_second(xi, wake) + shape.offset_ratio.value;
    };
    const double lowest = -60.0;
    const double highest = std::log(dip > 0.0 ? 1.0 / (1.0 + dip) : 0.999);
    if (!(law(lowest) < 0.0) || !(law(highest) > 0.0)) return {};
    const double xi = std::exp(root_between(law, lowest, highest));
    // law(ln xi; offset/steepness, bend/steepness) = 0 differentiated by the coefficients.
    const double slope = (1.0 - dip * xi / (1.0 - xi)) * (1.0 + pi * wake * xi * std::sin(pi * xi));
    const double steepness = shape.steepness.value;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(shape.fit.coefficients.size());
    const double second = log_wake_second(xi, wake);
    gradient(0) = -1.0 / (steepness * slope);
    gradient(1) = -second / (steepness * slope);
    if (!shape.steepness_given) gradient(2) = (shape.offset_ratio.value + dip * second) / (steepness * slope);
    const double half = propagated_half_width(shape.fit, gradient);
    return {xi, xi * half, {xi * std::exp(-half), xi * std::exp(half)}};
}

/// z0/h of the log law with secondary flow, kappa u/u_* = ln xi + offset + phase (alpha_1 ln xi + D sin^2):
/// ln xi0 = (alpha_2 phase - offset)/(1 + alpha_1 phase), with its uncertainty by linear propagation.
FittedValue zero_of_secondary_flow(const Shape& shape, const SecondaryFlowConstants& constants) {
    const double phase = shape.bend_ratio.value;
    const double offset = shape.offset_ratio.value;
    const double slope = 1.0 + constants.logarithm * phase;
    if (!(slope > 0.0)) return {};
    const double log_xi = (constants.offset * phase - offset) / slope;
    const double by_phase = (constants.offset + constants.logarithm * offset) / (slope * slope);
    const double by_offset = -1.0 / slope;
    const double steepness = shape.steepness.value;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(shape.fit.coefficients.size());
    gradient(0) = by_offset / steepness;
    gradient(1) = by_phase / steepness;
    if (!shape.steepness_given) gradient(2) = -(by_offset * offset + by_phase * phase) / steepness;
    return exponential_of({log_xi,
                           propagated_half_width(shape.fit, gradient),
                           {log_xi - propagated_half_width(shape.fit, gradient),
                            log_xi + propagated_half_width(shape.fit, gradient)}});
}

/// Fit of a law u = u_*/kappa [first(xi) + dip second(xi)] + offset; `zero` gives the z0/h at which the
/// fitted law vanishes.
template <class First, class Second, class Zero>
DipFit fit_law_with_dip(const VelocityPoints& points, FitRange range, double depth,
                        std::optional<double> friction_velocity, double kappa, const First& first,
                        const Second& second, const Zero& zero) {
    require_positive(depth, "the depth");
    const FitPoints used(points, range);
    if (const auto why = used.obstacle(fewest_points(friction_velocity), depth); !why.empty()) {
        return not_fitted<DipFit>(used, why);
    }
    const Eigen::ArrayXd xi = used.height.array() / depth;
    const auto [shape, why_not] =
        shape_of_law(used, first(xi), second(xi), steepness_of(friction_velocity, kappa));
    if (!shape) return not_fitted<DipFit>(used, why_not);
    DipFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), shape->fit.residuals);
    fit.dip = shape->bend_ratio;
    fit.friction_velocity = linear_of(shape->steepness, kappa);
    fit.zero_velocity_height = linear_of(zero(*shape), depth);
    fit.height_of_maximum = maximum_of_dip(fit.dip, depth);
    return fit;
}

}  // namespace

WakeFit fit_wake_strength(const VelocityPoints& points, double depth, std::optional<double> friction_velocity,
                          double kappa, FitRange range) {
    require_positive(depth, "the depth");
    const FitPoints used(points, range);
    if (const auto why = used.obstacle(fewest_points(friction_velocity)); !why.empty()) {
        return not_fitted<WakeFit>(used, why);
    }
    const auto [shape, why_not] =
        shape_of_law(used, used.height.array().log(), (0.5 * pi / depth * used.height.array()).sin().square(),
                     steepness_of(friction_velocity, kappa));
    if (!shape) return not_fitted<WakeFit>(used, why_not);
    WakeFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), shape->fit.residuals);
    // u = u_*/kappa [ln z + (8.5 kappa - ln k_s) + 2 Pi sin^2]
    fit.wake_strength = linear_of(shape->bend_ratio, 0.5);
    fit.friction_velocity = linear_of(shape->steepness, kappa);
    fit.equivalent_roughness =
        exponential_of(linear_of(shape->offset_ratio, -1.0, rough_log_law_constant * kappa));
    return fit;
}

PowerLawFit fit_power_law(const VelocityPoints& points, double depth, FitRange range) {
    require_positive(depth, "the depth");
    const FitPoints used(points, range);
    constexpr Eigen::Index fewest = 3;
    if (const auto why = used.obstacle(fewest); !why.empty()) return not_fitted<PowerLawFit>(used, why);
    const Eigen::ArrayXd xi = used.height.array() / depth;
    const auto basis = [&xi](double exponent) { return Eigen::MatrixXd(xi.pow(exponent)); };
    constexpr double smallest_m = 0.5;
    constexpr double largest_m = 50.0;
    const SeparableFit search(basis, used.velocity, used.uncertainty, 1.0 / largest_m, 1.0 / smallest_m);
    if (!search.determined()) {
        return not_fitted<PowerLawFit>(used,
                                       "no m between 0.5 and 50 fits best: the points follow no power law");
    }
    PowerLawFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), search.linear().residuals);
    fit.m = inverse_of(search.parameter());
    fit.maximum_velocity = search.coefficient(0);
    return fit;
}

DipFit fit_dip_modified_log_law(const VelocityPoints& points, double depth,
                                std::optional<double> friction_velocity, double kappa, FitRange range) {
    return fit_law_with_dip(
        points, range, depth, friction_velocity, kappa,
        [](const Eigen::ArrayXd& xi) { return Eigen::VectorXd(xi.log()); },
        [](const Eigen::ArrayXd& xi) { return Eigen::VectorXd((1.0 - xi).log()); },
        [](const Shape& shape) { return exponential_of(linear_of(shape.offset_ratio, -1.0)); });
}

DipFit fit_total_dip_log_wake_law(const VelocityPoints& points, double depth,
                                  std::optional<double> friction_velocity, double wake_strength, double kappa,
                                  FitRange range) {
    return fit_law_with_dip(
        points, range, depth, friction_velocity, kappa,
        [=](const Eigen::ArrayXd& xi) {
            return Eigen::VectorXd(xi.unaryExpr([=](double x) { return log_wake_first(x, wake_strength); }));
        },
        [=](const Eigen::ArrayXd& xi) {
            return Eigen::VectorXd(xi.unaryExpr([=](double x) { return log_wake_second(x, wake_strength); }));
        },
        [=](const Shape& shape) { return zero_of_log_wake(shape, wake_strength); });
}

SecondaryFlowFit fit_secondary_flow_log_law(const VelocityPoints& points, double depth,
                                            std::optional<double> friction_velocity, double kappa,
                                            FitRange range) {
    require_positive(depth, "the depth");
    const FitPoints used(points, range);
    if (const auto why = used.obstacle(fewest_points(friction_velocity), depth); !why.empty()) {
        return not_fitted<SecondaryFlowFit>(used, why);
    }
    const SecondaryFlowConstants constants;
    const Eigen::ArrayXd xi = used.height.array() / depth;
    const Eigen::VectorXd cell =
        constants.logarithm * xi.log() + constants.wake * (0.5 * pi * xi).sin().square();
    const auto [shape, why_not] = shape_of_law(used, xi.log(), cell, steepness_of(friction_velocity, kappa));
    if (!shape) return not_fitted<SecondaryFlowFit>(used, why_not);
    SecondaryFlowFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), shape->fit.residuals);
    fit.phase = shape->bend_ratio;
    fit.friction_velocity = linear_of(shape->steepness, kappa);
    fit.zero_velocity_height = linear_of(zero_of_secondary_flow(*shape, constants), depth);
    return fit;
}

RoughnessFit fit_roughness(const VelocityPoints& points, double friction_velocity,
                           double friction_velocity_half_width, double kappa, FitRange range) {
    require_positive(friction_velocity, "the friction velocity");
    require_positive(kappa, "kappa");
    const FitPoints used(points, range);
    constexpr Eigen::Index fewest = 2;
    if (const auto why = used.obstacle(fewest); !why.empty()) return not_fitted<RoughnessFit>(used, why);
    // u kappa/u_* - ln z = 8.5 kappa - ln k_s at every point.
    const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(used.height.size(), 1);
    const Eigen::VectorXd rest =
        used.velocity * (kappa / friction_velocity) - used.height.array().log().matrix();
    const auto mean = fit_linear(constant, rest, used.uncertainty);
    if (!mean) return not_fitted<RoughnessFit>(used, dependent_points);
    FittedValue logarithm = linear_of(coefficient(*mean, 0), -1.0, kappa * rough_log_law_constant);
    const double more =
        kappa * used.velocity.mean() * friction_velocity_half_width / std::pow(friction_velocity, 2);
    logarithm.half_width = std::hypot(logarithm.half_width, more);
    logarithm.interval = {logarithm.value - logarithm.half_width, logarithm.value + logarithm.half_width};
    RoughnessFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), mean->residuals * (friction_velocity / kappa));
    fit.equivalent_roughness = exponential_of(logarithm);
    return fit;
}

KappaFit fit_kappa(const VelocityPoints& points, double friction_velocity,
                   double friction_velocity_half_width, double length, FitRange range) {
    require_positive(friction_velocity, "the friction velocity");
    require_positive(length, "the length");
    const FitPoints used(points, range);
    constexpr Eigen::Index fewest = 3;
    if (const auto why = used.obstacle(fewest); !why.empty()) return not_fitted<KappaFit>(used, why);
    Eigen::MatrixXd basis(used.height.size(), 2);
    basis.col(0) = (used.height.array() / length).log();
    basis.col(1).setOnes();
    const auto line = fit_linear(basis, used.velocity, used.uncertainty);
    if (!line) return not_fitted<KappaFit>(used, dependent_points);
    if (!(line->coefficients(0) > 0.0)) {
        return not_fitted<KappaFit>(used, "the velocity does not rise with the logarithm of the height");
    }
    const double relative = friction_velocity_half_width / friction_velocity;
    const auto widened = [relative](FittedValue fitted) {
        const double more = relative * std::abs(fitted.value);
        fitted.interval.lower = fitted.value - std::hypot(fitted.value - fitted.interval.lower, more);
        fitted.interval.upper = fitted.value + std::hypot(fitted.interval.upper - fitted.value, more);
        fitted.half_width = std::hypot(fitted.half_width, more);
        return fitted;
    };
    KappaFit fit;
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), line->residuals);
    fit.kappa = widened(linear_of(inverse_of(coefficient(*line, 0)), friction_velocity));
    fit.constant = widened(linear_of(coefficient(*line, 1), 1.0 / friction_velocity));
    return fit;
}

}  // namespace riffle::inline hydraulics
