#include "hydraulics/log_law.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "hydraulics/channel_laws.hpp"
#include "statistics/separable_fit.hpp"

namespace riffle::inline hydraulics {

namespace {

// The law as a line: u = slope ln(z - z_0) + offset.
constexpr Eigen::Index slope = 0;
constexpr Eigen::Index offset = 1;

Eigen::MatrixXd line_basis(const Eigen::ArrayXd& height) {
    Eigen::MatrixXd basis(height.size(), 2);
    basis.col(slope) = height.log();
    basis.col(offset).setOnes();
    return basis;
}

LogLawFit start(const FitPoints& points, double zero_plane) {
    LogLawFit fit;
    static_cast<FitQuality&>(fit) = points.quality();
    fit.zero_plane = zero_plane;
    return fit;
}

void fail(LogLawFit& fit, const std::string& why_not) {
    static_cast<FitQuality&>(fit) = failed(fit, why_not);
}

/// Values and intervals from slope and offset/slope of the fitted line.
void describe(LogLawFit& fit, const FittedValue& steepness, const FittedValue& ratio, double kappa,
              const Eigen::VectorXd& residuals) {
    static_cast<FitQuality&>(fit) = succeeded(fit, residuals);
    const FittedValue friction = linear_of(steepness, kappa);
    // offset = u_* (8.5 - ln(k_s)/kappa) = slope (8.5 kappa - ln k_s)
    const FittedValue roughness = exponential_of(linear_of(ratio, -1.0, rough_log_law_constant * kappa));
    fit.friction_velocity = friction.value;
    fit.friction_velocity_half_width = friction.half_width;
    fit.friction_velocity_interval = friction.interval;
    fit.equivalent_roughness = roughness.value;
    fit.equivalent_roughness_half_width = roughness.half_width;
    fit.equivalent_roughness_interval = roughness.interval;
    if (!(steepness.value > 0.0)) {
        fail(fit, "the velocity does not rise with the logarithm of the height");
    } else if (!std::isfinite(fit.equivalent_roughness)) {
        fail(fit, "the fitted roughness is beyond all numbers: the velocity hardly rises with height");
    }
}

}  // namespace

LogLawFit fit_log_law(const VelocityPoints& points, double kappa, FitRange range) {
    const FitPoints used(points, range);
    LogLawFit fit = start(used, points.zero_plane);
    fit.zero_plane_interval = {points.zero_plane, points.zero_plane};
    constexpr Eigen::Index fewest = 3;
    if (const std::string why = used.obstacle(fewest); !why.empty()) {
        fail(fit, why);
        return fit;
    }
    const auto line = fit_linear(line_basis(used.height.array()), used.velocity, used.uncertainty);
    if (!line) {
        fail(fit, "the points do not determine a line: their heights must differ");
        return fit;
    }
    describe(fit, coefficient(*line, slope), coefficient_ratio(*line, offset, slope), kappa, line->residuals);
    return fit;
}

LogLawFit fit_log_law(std::span<const double> z, std::span<const double> velocity, double kappa,
                      double zero_plane, double from, double to) {
    return fit_log_law(VelocityPoints{z, velocity, {}, zero_plane}, kappa, {from, to});
}

LogLawFit fit_log_law_with_zero_plane(const VelocityPoints& points, double kappa, FitRange range) {
    VelocityPoints free = points;
    free.zero_plane = 0.0;
    const FitPoints used(free, range);
    LogLawFit fit = start(used, std::numeric_limits<double>::quiet_NaN());
    constexpr Eigen::Index fewest = 4;
    if (used.height.size() < fewest) {
        fail(fit, used.obstacle(fewest));
        return fit;
    }
    const double lowest = used.height.minCoeff();
    const double extent = used.height.maxCoeff() - lowest;
    if (!(extent > 0.0)) {
        fail(fit, "all points lie at one height");
        return fit;
    }
    // The nonlinear parameter is the logarithm of the plane's distance below the lowest point.
    const auto basis = [&](double log_distance) {
        return line_basis(used.height.array() - (lowest - std::exp(log_distance)));
    };
    const SeparableFit search(basis, used.velocity, used.uncertainty, std::log(1e-3 * extent),
                              std::log(3.0 * extent));
    if (!search.determined()) {
        fail(fit,
             "no zero plane between 0.001 and 3 times the height of the range below the lowest point fits "
             "best: the points do not lie on a log law, or scatter too much to tell its zero plane");
        return fit;
    }
    const FittedValue distance = exponential_of(search.parameter());
    const FittedValue plane = linear_of(distance, -1.0, lowest);
    fit.zero_plane = plane.value;
    fit.zero_plane_half_width = plane.half_width;
    fit.zero_plane_interval = plane.interval;
    describe(fit, search.coefficient(slope), search.coefficient_ratio(offset, slope), kappa,
             search.linear().residuals);
    return fit;
}

LogLawFit fit_log_law_with_zero_plane(std::span<const double> z, std::span<const double> velocity,
                                      double kappa, double from, double to) {
    return fit_log_law_with_zero_plane(VelocityPoints{z, velocity}, kappa, {from, to});
}

std::optional<double> profile_depth_mean(const VelocityPoints& points, double depth) {
    const FitRange whole{points.zero_plane, points.zero_plane + depth};
    const LogLawFit fit = fit_log_law(points, log_law_kappa, whole);
    if (!fit.valid || !(fit.friction_velocity > 0.0)) return std::nullopt;
    const FitPoints inside(points, whole);
    const double at_rest = fit.equivalent_roughness * std::exp(-log_law_kappa * rough_log_law_constant);
    // Integral of the law from where its velocity is zero.
    const auto below = [&](double z) {
        if (z <= at_rest) return 0.0;
        return fit.friction_velocity / log_law_kappa * (z * std::log(z / at_rest) - z + at_rest);
    };
    const Eigen::Index last = inside.height.size() - 1;
    double sum = below(inside.height(0)) + below(depth) - below(inside.height(last));
    for (Eigen::Index i = 0; i < last; ++i) {
        sum +=
            0.5 * (inside.velocity(i) + inside.velocity(i + 1)) * (inside.height(i + 1) - inside.height(i));
    }
    return sum / depth;
}

}  // namespace riffle::inline hydraulics
