#include "hydraulics/log_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle {

namespace {

struct Points {
    std::vector<double> z;
    std::vector<double> velocity;
};

Points points_between(std::span<const double> z, std::span<const double> velocity, double from, double to) {
    if (z.size() != velocity.size()) {
        throw InputError("log-law fit: heights and velocities differ in number");
    }
    Points points;
    for (std::size_t i = 0; i < z.size(); ++i) {
        if (z[i] < from || z[i] > to) continue;
        points.z.push_back(z[i]);
        points.velocity.push_back(velocity[i]);
    }
    return points;
}

/// Least-squares line u = slope ln(z - zero_plane) + offset.
struct Line {
    double slope = 0;
    double offset = 0;
    double sum_of_squares = 0;
};

Line fit_line(const Points& points, double zero_plane) {
    const auto n = static_cast<double>(points.z.size());
    double mean_log = 0;
    double mean_velocity = 0;
    for (std::size_t i = 0; i < points.z.size(); ++i) {
        mean_log += std::log(points.z[i] - zero_plane) / n;
        mean_velocity += points.velocity[i] / n;
    }
    double spread = 0;
    double moment = 0;
    for (std::size_t i = 0; i < points.z.size(); ++i) {
        const double x = std::log(points.z[i] - zero_plane) - mean_log;
        spread += x * x;
        moment += x * (points.velocity[i] - mean_velocity);
    }
    Line line;
    line.slope = moment / spread;
    line.offset = mean_velocity - line.slope * mean_log;
    for (std::size_t i = 0; i < points.z.size(); ++i) {
        const double misfit =
            points.velocity[i] - line.offset - line.slope * std::log(points.z[i] - zero_plane);
        line.sum_of_squares += misfit * misfit;
    }
    return line;
}

/// Values and 95 % half widths from the fitted line. `unknowns` is 2, or 3 when the plane was fitted too.
LogLawFit describe(const Points& points, const Line& line, double zero_plane, double kappa, double from,
                   double to, int unknowns) {
    LogLawFit fit;
    fit.from = from;
    fit.to = to;
    fit.zero_plane = zero_plane;
    fit.friction_velocity = kappa * line.slope;
    // offset = u_* (8.5 - ln(k_s)/kappa) = slope (8.5 kappa - ln k_s)
    fit.equivalent_roughness = std::exp(rough_log_law_constant * kappa - line.offset / line.slope);
    const auto n = static_cast<Eigen::Index>(points.z.size());
    fit.residual_rms = std::sqrt(line.sum_of_squares / static_cast<double>(n));
    if (!(line.slope > 0.0) || !std::isfinite(fit.equivalent_roughness)) return fit;
    fit.valid = true;

    // Jacobian with respect to slope, offset and plane; parameter covariance by linear propagation.
    Eigen::MatrixXd jacobian(n, unknowns);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double height = points.z[static_cast<std::size_t>(i)] - zero_plane;
        jacobian(i, 0) = std::log(height);
        jacobian(i, 1) = 1.0;
        if (unknowns == 3) jacobian(i, 2) = -line.slope / height;
    }
    const auto freedom = static_cast<double>(n - unknowns);
    const Eigen::MatrixXd covariance =
        (line.sum_of_squares / freedom) * (jacobian.transpose() * jacobian).inverse();
    const double factor =
        boost::math::quantile(boost::math::complement(boost::math::students_t(freedom), 0.025));
    Eigen::VectorXd log_roughness_gradient = Eigen::VectorXd::Zero(unknowns);
    log_roughness_gradient(0) = line.offset / (line.slope * line.slope);
    log_roughness_gradient(1) = -1.0 / line.slope;
    const double log_roughness_variance = log_roughness_gradient.dot(covariance * log_roughness_gradient);
    fit.friction_velocity_half_width = factor * kappa * std::sqrt(covariance(0, 0));
    fit.equivalent_roughness_half_width =
        factor * fit.equivalent_roughness * std::sqrt(log_roughness_variance);
    if (unknowns == 3) fit.zero_plane_half_width = factor * std::sqrt(covariance(2, 2));
    return fit;
}

LogLawFit no_fit(double from, double to, double zero_plane) {
    LogLawFit fit;
    fit.from = from;
    fit.to = to;
    fit.zero_plane = zero_plane;
    return fit;
}

}  // namespace

LogLawFit fit_log_law(std::span<const double> z, std::span<const double> velocity, double kappa,
                      double zero_plane, double from, double to) {
    const Points points = points_between(z, velocity, from, to);
    constexpr std::size_t fewest = 3;
    const bool above_plane =
        std::all_of(points.z.begin(), points.z.end(), [zero_plane](double v) { return v > zero_plane; });
    if (points.z.size() < fewest || !above_plane) return no_fit(from, to, zero_plane);
    return describe(points, fit_line(points, zero_plane), zero_plane, kappa, from, to, 2);
}

LogLawFit fit_log_law_with_zero_plane(std::span<const double> z, std::span<const double> velocity,
                                      double kappa, double from, double to) {
    const Points points = points_between(z, velocity, from, to);
    constexpr std::size_t fewest = 4;
    if (points.z.size() < fewest) return no_fit(from, to, from);
    const auto extremes = std::minmax_element(points.z.begin(), points.z.end());
    const double lowest = *extremes.first;
    const double range = *extremes.second - lowest;

    // The misfit as a function of the distance of the plane below the lowest point, on a logarithmic scale:
    // scanned, because it may have more than one minimum, then refined.
    const auto misfit = [&](double log_distance) {
        return fit_line(points, lowest - std::exp(log_distance)).sum_of_squares;
    };
    const double nearest = std::log(1e-3 * range);
    const double farthest = std::log(3.0 * range);
    constexpr int steps = 200;
    const double step = (farthest - nearest) / steps;
    int best = 0;
    double smallest = misfit(nearest);
    for (int i = 1; i <= steps; ++i) {
        const double value = misfit(nearest + i * step);
        if (value < smallest) {
            smallest = value;
            best = i;
        }
    }
    const bool at_the_edge = best == 0 || best == steps;
    double log_distance = nearest + best * step;
    if (!at_the_edge) {
        constexpr int bits = 40;
        log_distance =
            boost::math::tools::brent_find_minima(misfit, log_distance - step, log_distance + step, bits)
                .first;
    }
    const double zero_plane = lowest - std::exp(log_distance);
    LogLawFit fit = describe(points, fit_line(points, zero_plane), zero_plane, kappa, from, to, 3);
    // A plane at the edge of the search is no minimum: the points do not lie on a log law.
    if (at_the_edge) fit.valid = false;
    return fit;
}

}  // namespace riffle
