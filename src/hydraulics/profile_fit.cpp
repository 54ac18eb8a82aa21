#include "hydraulics/profile_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace riffle::inline hydraulics {

FitPoints::FitPoints(const VelocityPoints& points, FitRange range) {
    const std::size_t n = points.z.size();
    const bool weighted = !points.uncertainty.empty();
    if (points.velocity.size() != n || (weighted && points.uncertainty.size() != n)) {
        throw InputError(
            fmt::format("profile fit: {} heights, {} velocities and {} uncertainties differ in number", n,
                        points.velocity.size(), points.uncertainty.size()));
    }
    std::vector<double> z;
    std::vector<double> u;
    std::vector<double> s;
    for (std::size_t i = 0; i < n; ++i) {
        if (!(points.z[i] >= range.from && points.z[i] <= range.to) || !std::isfinite(points.velocity[i]) ||
            (weighted && std::isnan(points.uncertainty[i]))) {
            continue;
        }
        z.push_back(points.z[i] - points.zero_plane);
        u.push_back(points.velocity[i]);
        if (!weighted) continue;
        if (!(points.uncertainty[i] > 0.0)) {
            throw InputError(fmt::format(
                "profile fit: the uncertainty at z = {:.6g} m must be greater than 0, is {:.6g} m/s",
                points.z[i], points.uncertainty[i]));
        }
        s.push_back(points.uncertainty[i]);
    }
    const auto vector = [](const std::vector<double>& values) {
        return Eigen::VectorXd(
            Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
    };
    height = vector(z);
    velocity = vector(u);
    uncertainty = vector(s);
    quality_.from = range.from;
    quality_.to = range.to;
    quality_.points = z.size();
}

std::string FitPoints::obstacle(Eigen::Index fewest, std::optional<double> depth) const {
    if (height.size() < fewest) {
        return fmt::format("{} points within the range z = {:.4g} to {:.4g} m; {} are needed", height.size(),
                           quality_.from, quality_.to, fewest);
    }
    if (!(height.minCoeff() > 0.0)) {
        return "a point of the range lies on or below the zero plane, where the law has no value";
    }
    if (depth && !(height.maxCoeff() < *depth)) {
        return "a point of the range lies on or above the surface, where the law has no value";
    }
    return {};
}

FitQuality succeeded(FitQuality quality, const Eigen::VectorXd& residuals) {
    quality.residual_rms = std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
    quality.valid = true;
    quality.why_not.clear();
    return quality;
}

FitQuality failed(FitQuality quality, std::string why_not) {
    quality.valid = false;
    quality.why_not = std::move(why_not);
    return quality;
}

FittedValue linear_of(const FittedValue& fitted, double factor, double offset) {
    const double a = offset + factor * fitted.interval.lower;
    const double b = offset + factor * fitted.interval.upper;
    return {offset + factor * fitted.value,
            std::abs(factor) * fitted.half_width,
            {std::min(a, b), std::max(a, b)}};
}

FittedValue exponential_of(const FittedValue& fitted) {
    const double value = std::exp(fitted.value);
    return {
        value, value * fitted.half_width, {std::exp(fitted.interval.lower), std::exp(fitted.interval.upper)}};
}

FittedValue inverse_of(const FittedValue& fitted) {
    FittedValue result;
    result.value = 1.0 / fitted.value;
    result.half_width = fitted.half_width / (fitted.value * fitted.value);
    result.interval.lower = 1.0 / fitted.interval.upper;
    if (fitted.interval.lower > 0.0) result.interval.upper = 1.0 / fitted.interval.lower;
    return result;
}

FittedValue known_value(double value) { return {value, 0.0, {value, value}}; }

}  // namespace riffle::inline hydraulics
