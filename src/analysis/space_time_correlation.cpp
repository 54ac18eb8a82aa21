#include "analysis/space_time_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "statistics/fourier.hpp"

namespace riffle::inline analysis {

namespace {

constexpr const char* purpose = "correlation in space and time";

/// Transforms of the records of all columns, each less its mean and over its standard deviation, padded with
/// zeros.
std::vector<std::vector<Complex>> spectra_of(const SpaceTime& data, const FourierTransform& transform) {
    std::vector<std::vector<Complex>> spectra;
    std::vector<double> padded(transform.length(), 0.0);
    const auto n = static_cast<double>(data.rows());
    for (std::size_t i = 0; i < data.columns; ++i) {
        const std::vector<double> record = data.record(i);
        double sum = 0.0;
        double squares = 0.0;
        for (const double value : record) {
            sum += value;
            squares += value * value;
        }
        const double mean = sum / n;
        const double variance = squares / n - mean * mean;
        // What is left of the difference of two equal numbers is rounding.
        if (!(variance > 1e-14 * squares / n)) {
            throw InputError(fmt::format("{}: the record at x = {:.4g} m is constant", purpose, data.x(i)));
        }
        const double scale = 1.0 / std::sqrt(variance);
        for (std::size_t j = 0; j < record.size(); ++j) padded[j] = (record[j] - mean) * scale;
        spectra.push_back(transform.forward_real(padded));
    }
    return spectra;
}

}  // namespace

SpaceTimeCorrelation space_time_correlation(const SpaceTime& data, const CorrelationReach& reach) {
    require_wet(data, purpose);
    require_even_times(data, purpose, 0.5);
    if (data.columns < 2 || data.rows() < 4) {
        throw InputError(fmt::format("{}: {} places and {} times; at least two and four are needed", purpose,
                                     data.columns, data.rows()));
    }
    const double interval = (data.times.back() - data.times.front()) / static_cast<double>(data.rows() - 1);
    const double duration = static_cast<double>(data.rows()) * interval;
    const double wanted_lag = reach.largest_lag > 0.0 ? reach.largest_lag : 0.25 * duration;
    const auto lags =
        std::clamp<std::size_t>(static_cast<std::size_t>(wanted_lag / interval + 1e-6), 1, data.rows() - 1);
    const double wanted = reach.largest_distance > 0.0 ? reach.largest_distance
                          : data.periodic              ? 0.5 * data.length()
                                                       : data.length();
    const auto furthest =
        std::clamp<std::size_t>(static_cast<std::size_t>(wanted / data.spacing + 1e-6), 1, data.columns - 1);
    const auto step = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::lround(reach.step / data.spacing)), 1, furthest);

    const FourierTransform transform(fast_length(data.rows() + lags + 1));
    const std::vector<std::vector<Complex>> spectra = spectra_of(data, transform);
    SpaceTimeCorrelation result;
    for (std::size_t k = 0; k <= lags; ++k) result.lag.push_back(static_cast<double>(k) * interval);
    for (std::size_t apart = 0; apart <= furthest; apart += step) {
        result.distance.push_back(static_cast<double>(apart) * data.spacing);
        const std::size_t pairs = data.periodic ? data.columns : data.columns - apart;
        std::vector<Complex> sum(spectra.front().size());
        for (std::size_t i = 0; i < pairs; ++i) {
            const std::vector<Complex>& up = spectra[i];
            const std::vector<Complex>& down = spectra[(i + apart) % data.columns];
            for (std::size_t m = 0; m < sum.size(); ++m) sum[m] += std::conj(up[m]) * down[m];
        }
        const std::vector<double> products = transform.inverse_real(sum);
        for (std::size_t k = 0; k <= lags; ++k) {
            const auto samples = static_cast<double>(data.rows() - k);
            result.correlation.push_back(products[k] / (static_cast<double>(pairs) * samples));
        }
    }
    return result;
}

LagExtreme extreme_over_lag(const SpaceTimeCorrelation& correlation, std::size_t d, double largest_lag) {
    const std::span<const double> r = correlation.of(d);
    LagExtreme best{0.0, r.front()};
    for (std::size_t k = 1; k < r.size() && correlation.lag[k] <= largest_lag; ++k) {
        if (std::abs(r[k]) > std::abs(best.correlation)) best = {correlation.lag[k], r[k]};
    }
    return best;
}

StreamwiseCorrelation streamwise_correlation(double z, const SpaceTime& vertical_velocity,
                                             const CorrelationReach& reach, double velocity,
                                             double significance) {
    const SpaceTimeCorrelation correlation = space_time_correlation(vertical_velocity, reach);
    StreamwiseCorrelation result;
    result.z = z;
    for (std::size_t d = 0; d < correlation.distance.size(); ++d) {
        const double distance = correlation.distance[d];
        // The water arrives after distance/velocity; some intervals beside that for the nearest places.
        const double travel = 2.0 * distance / std::max(velocity, 1e-12) + 4.0 * correlation.lag[1];
        const LagExtreme extreme =
            extreme_over_lag(correlation, d, velocity > 0.0 ? travel : correlation.lag.back());
        result.distance.push_back(distance);
        result.extreme.push_back(extreme.correlation);
        result.lag.push_back(extreme.lag);
    }
    for (std::size_t d = 1; d < result.extreme.size() && !result.zero; ++d) {
        const double before = result.extreme[d - 1];
        const double behind = result.extreme[d];
        if (!(before > 0.0) || behind > 0.0) continue;
        if (behind > -significance) break;
        result.zero = result.distance[d - 1] +
                      before / (before - behind) * (result.distance[d] - result.distance[d - 1]);
    }
    return result;
}

std::optional<double> deepest_zero(std::span<const StreamwiseCorrelation> heights) {
    std::vector<const StreamwiseCorrelation*> down;
    for (const StreamwiseCorrelation& height : heights) down.push_back(&height);
    std::sort(down.begin(), down.end(), [](const auto* a, const auto* b) { return a->z > b->z; });
    std::optional<double> deepest;
    for (const StreamwiseCorrelation* const height : down) {
        if (!height->zero) break;
        deepest = height->z;
    }
    return deepest;
}

}  // namespace riffle::inline analysis
