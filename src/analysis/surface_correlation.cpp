#include "analysis/surface_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "analysis/stations.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/least_squares.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t none_left_out = std::numeric_limits<std::size_t>::max();

/// Mean product of the points `lag` columns apart over some rows.
double lagged_covariance(const SpaceTime& data, std::size_t begin, std::size_t end, std::size_t lag) {
    double sum = 0.0;
    double count = 0.0;
    const std::size_t pairs = data.periodic ? data.columns : data.columns - lag;
    for (std::size_t j = begin; j < end; ++j) {
        const std::span<const double> row = data.row(j);
        for (std::size_t i = 0; i < pairs; ++i) {
            const std::size_t other = i + lag < data.columns ? i + lag : i + lag - data.columns;
            const double product = row[i] * row[other];
            if (std::isnan(product)) continue;
            sum += product;
            count += 1.0;
        }
    }
    return sum / count;
}

std::vector<double> normalised(std::vector<double> covariance) {
    const double variance = covariance.front();
    for (double& v : covariance) v /= variance;
    return covariance;
}

/// Parameters (L0 and sigma_w over the largest distance, share).
struct Problem {
    const SpatialCorrelation& given;
    bool white_noise;
    std::vector<double> correlation;

    [[nodiscard]] double scale() const { return given.distance.back(); }
    [[nodiscard]] std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& p) const {
        const std::size_t first = 1;
        const std::size_t n = correlation.size() - first;
        Eigen::VectorXd r(static_cast<Eigen::Index>(n));
        const double share = white_noise ? p(2) : 1.0;
        for (std::size_t i = 0; i < n; ++i) {
            r(static_cast<Eigen::Index>(i)) =
                share * horoshenkov_correlation(given.distance[i + first], p(0) * scale(), p(1) * scale(),
                                                given.period) -
                correlation[i + first];
        }
        return r;
    }
};

/// The best of a table of starts; the share that fits each best is linear.
Eigen::VectorXd best_start(const Problem& problem) {
    const Eigen::Index size = problem.white_noise ? 3 : 2;
    Eigen::VectorXd best = Eigen::VectorXd::Ones(size);
    double least = infinity;
    for (double l0 = 0.05; l0 < 2.0; l0 *= 1.15) {
        for (double radius = 0.05; radius < 4.0; radius *= 1.2) {
            Eigen::VectorXd p = Eigen::VectorXd::Ones(size);
            p(0) = l0;
            p(1) = radius;
            const double sum = problem.residuals(p)->squaredNorm();
            if (sum < least) {
                least = sum;
                best = p;
            }
        }
    }
    return best;
}

std::optional<Eigen::VectorXd> solve(const Problem& problem, const Eigen::VectorXd& start) {
    Eigen::VectorXd lower = Eigen::VectorXd::Constant(start.size(), 1e-3);
    Eigen::VectorXd upper = Eigen::VectorXd::Constant(start.size(), 4.0);
    upper(0) = 2.0;
    if (start.size() == 3) upper(2) = 1.2;  // above 1 by chance only
    const auto fit = minimise_least_squares([&](const Eigen::VectorXd& p) { return problem.residuals(p); },
                                            start, lower, upper);
    if (!fit || !fit->converged) return std::nullopt;
    for (Eigen::Index i = 0; i < start.size(); ++i) {
        if (fit->parameters(i) <= lower(i) || fit->parameters(i) >= upper(i)) return std::nullopt;
    }
    if (fit->parameters(0) * problem.scale() < problem.given.shortest_period) return std::nullopt;
    return fit->parameters;
}

/// Correlation and intervals from the covariances of the blocks.
void evaluate(SpatialCorrelation& c) {
    const std::size_t lags = c.distance.size();
    c.correlation = normalised(mean_without(c.block_covariance, lags, none_left_out));
    std::vector<std::vector<double>> without(lags);
    for (std::size_t b = 0; b < c.blocks; ++b) {
        const std::vector<double> w = normalised(mean_without(c.block_covariance, lags, b));
        for (std::size_t lag = 0; lag < lags; ++lag) without[lag].push_back(w[lag]);
    }
    for (const std::vector<double>& values : without) c.half_width.push_back(jackknife_half_width(values));
}

void require_blocks(std::size_t times, std::size_t blocks) {
    if (blocks == 0 || times < 2 * blocks) {
        throw InputError(fmt::format(
            "spatial correlation: {} times do not make {} blocks; use a longer window or fewer blocks", times,
            blocks));
    }
}

/// Mean product over some samples that both records have.
double mean_product(const std::vector<double>& a, const std::vector<double>& b, std::size_t begin,
                    std::size_t end) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t j = begin; j < end; ++j) {
        const double product = a[j] * b[j];
        if (std::isnan(product)) continue;
        sum += product;
        count += 1.0;
    }
    return sum / count;
}

}  // namespace

SpatialCorrelation spatial_correlation(const SpaceTime& fluctuation, double largest_distance,
                                       std::size_t blocks) {
    const std::size_t rows = fluctuation.rows();
    require_blocks(rows, blocks);
    const std::size_t most = fluctuation.periodic ? fluctuation.columns / 2 : fluctuation.columns - 1;
    const auto wanted =
        static_cast<std::size_t>(std::max(0.0, largest_distance / fluctuation.spacing + 1e-6));
    const std::size_t lags = std::min(wanted, most) + 1;
    if (lags < 2) {
        throw InputError(
            fmt::format("spatial correlation: the largest distance {:.4g} m is below the spacing {:.4g} m",
                        largest_distance, fluctuation.spacing));
    }
    SpatialCorrelation result;
    result.blocks = blocks;
    if (fluctuation.periodic) result.period = fluctuation.length();
    result.shortest_period = 4.0 * fluctuation.spacing;
    for (std::size_t b = 0; b < blocks; ++b) {
        for (std::size_t lag = 0; lag < lags; ++lag) {
            result.block_covariance.push_back(
                lagged_covariance(fluctuation, b * rows / blocks, (b + 1) * rows / blocks, lag));
        }
    }
    for (std::size_t lag = 0; lag < lags; ++lag) {
        result.distance.push_back(static_cast<double>(lag) * fluctuation.spacing);
    }
    evaluate(result);
    return result;
}

SpatialCorrelation spatial_correlation(std::span<const StationRecord> stations, std::size_t blocks) {
    const std::vector<StationRecord> scaled = normalised_stations(stations, "spatial correlation");
    const std::size_t rows = scaled.front().values.size();
    require_blocks(rows, blocks);
    const std::vector<StationPair> pairs = pairs_by_distance(scaled);
    SpatialCorrelation result;
    result.blocks = blocks;
    result.distance.push_back(0.0);
    for (const StationPair& pair : pairs) result.distance.push_back(pair.distance);
    if (!pairs.empty()) result.shortest_period = 2.0 * pairs.front().distance;
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t begin = b * rows / blocks;
        const std::size_t end = (b + 1) * rows / blocks;
        double own = 0.0;
        for (const StationRecord& s : scaled) own += mean_product(s.values, s.values, begin, end);
        result.block_covariance.push_back(own / static_cast<double>(scaled.size()));
        for (const StationPair& pair : pairs) {
            result.block_covariance.push_back(
                mean_product(scaled[pair.upstream].values, scaled[pair.downstream].values, begin, end));
        }
    }
    evaluate(result);
    return result;
}

double horoshenkov_correlation(double rho, double characteristic_period, double correlation_radius) {
    const double q = rho / correlation_radius;
    return std::exp(-q * q) * std::cos(2.0 * std::numbers::pi * rho / characteristic_period);
}

double horoshenkov_correlation(double rho, double characteristic_period, double correlation_radius,
                               const std::optional<double>& period) {
    if (!period) return horoshenkov_correlation(rho, characteristic_period, correlation_radius);
    double sum = 0.0;
    double at_zero = 0.0;
    for (int image = -2; image <= 2; ++image) {
        sum += horoshenkov_correlation(rho + image * *period, characteristic_period, correlation_radius);
        at_zero += horoshenkov_correlation(image * *period, characteristic_period, correlation_radius);
    }
    return sum / at_zero;
}

SurfaceCorrelationFit fit_surface_correlation(const SpatialCorrelation& correlation,
                                              const SurfaceCorrelationOptions& options) {
    const Estimate unknown{not_a_number, infinity};
    SurfaceCorrelationFit result{unknown, unknown, unknown, not_a_number};
    if (correlation.distance.size() < 5) return result;
    Problem problem{correlation, options.white_noise, correlation.correlation};
    const auto fitted = solve(problem, best_start(problem));
    if (!fitted) return result;
    const double scale = problem.scale();
    result.residual = std::sqrt(problem.residuals(*fitted)->squaredNorm() /
                                static_cast<double>(correlation.distance.size() - 1));

    std::vector<double> l0, radius, share;
    for (std::size_t b = 0; b < correlation.blocks; ++b) {
        problem.correlation =
            normalised(mean_without(correlation.block_covariance, correlation.distance.size(), b));
        const auto p = solve(problem, *fitted);
        l0.push_back(p ? (*p)(0) * scale : not_a_number);
        radius.push_back(p ? (*p)(1) * scale : not_a_number);
        share.push_back(!options.white_noise ? 1.0 : (p ? (*p)(2) : not_a_number));
    }
    result.characteristic_period = {(*fitted)(0) * scale, jackknife_half_width(l0)};
    result.correlation_radius = {(*fitted)(1) * scale, jackknife_half_width(radius)};
    result.correlated_share = {options.white_noise ? (*fitted)(2) : 1.0, jackknife_half_width(share)};
    return result;
}

}  // namespace riffle::inline analysis
