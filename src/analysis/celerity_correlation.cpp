#include "analysis/celerity_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/stations.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "base/parallel.hpp"
#include "statistics/cross_correlation.hpp"
#include "statistics/fourier.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/peak.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* purpose = "celerity of stations";

/// Pairs of records a distance apart.
struct PairsAtDistance {
    double distance = 0.0;  ///< m
    std::vector<std::pair<std::size_t, std::size_t>> records;
};

/// Normalised cross-correlations of all distances, distance after distance, each over the lags.
struct Correlations {
    std::vector<PairsAtDistance> pairs;  ///< the first of distance zero
    std::size_t lags = 0;                ///< to each side
    double interval = 0.0;               ///< s
    std::vector<double> values;

    [[nodiscard]] std::size_t width() const { return 2 * lags + 1; }
    [[nodiscard]] std::span<const double> of(std::size_t d) const {
        return std::span(values).subspan(d * width(), width());
    }
    [[nodiscard]] double distance(std::size_t d) const { return pairs[d].distance; }
};

/// Sums of the squares of a record's samples from `begin` on: 0, 1, 2 ... of them, added to `sum`.
void add_running_squares(std::span<const double> record, std::vector<double>& sum) {
    double squares = 0.0;
    for (std::size_t j = 0; j < record.size(); ++j) {
        squares += record[j] * record[j];
        sum[j + 1] += squares;
    }
}

/// Mean products over the pairs of each distance within a block, for each lag over the samples that it
/// leaves; after those of all distances the mean squares of the same samples of the first records, then of
/// the second. Through the transforms of the records, padded with zeros: their products are summed over the
/// pairs before going back.
std::vector<double> block_products(std::span<const std::vector<double>> records, const Correlations& shape,
                                   std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    const std::size_t width = shape.pairs.size() * shape.width();
    const FourierTransform transform(fast_length(n + shape.lags + 1));
    std::vector<std::vector<Complex>> spectra;
    std::vector<double> padded(transform.length(), 0.0);
    for (const std::vector<double>& record : records) {
        std::copy_n(record.begin() + static_cast<std::ptrdiff_t>(begin), n, padded.begin());
        spectra.push_back(transform.forward_real(padded));
    }
    std::vector<double> result(3 * width);
    for (std::size_t d = 0; d < shape.pairs.size(); ++d) {
        std::vector<Complex> sum(spectra.front().size());
        std::vector<double> squares_first(n + 1, 0.0);
        std::vector<double> squares_second(n + 1, 0.0);
        for (const auto& [first, second] : shape.pairs[d].records) {
            const std::vector<Complex>& a = spectra[first];
            const std::vector<Complex>& b = spectra[second];
            for (std::size_t m = 0; m < sum.size(); ++m) sum[m] += std::conj(a[m]) * b[m];
            add_running_squares(std::span(records[first]).subspan(begin, n), squares_first);
            add_running_squares(std::span(records[second]).subspan(begin, n), squares_second);
        }
        const std::vector<double> products = transform.inverse_real(sum);
        for (std::size_t k = 0; k < shape.width(); ++k) {
            // Negative lags stand at the end of the transform. The later record gives its last samples.
            const bool negative = k < shape.lags;
            const std::size_t lag = negative ? shape.lags - k : k - shape.lags;
            const std::vector<double>& earlier = negative ? squares_second : squares_first;
            const std::vector<double>& later = negative ? squares_first : squares_second;
            const double count =
                static_cast<double>(shape.pairs[d].records.size()) * static_cast<double>(n - lag);
            const std::size_t at = d * shape.width() + k;
            result[at] = products[negative ? products.size() - lag : lag] / count;
            result[at + width] = earlier[n - lag] / count;
            result[at + 2 * width] = (later[n] - later[lag]) / count;
        }
    }
    return result;
}

/// About half the period of a record's own oscillation: twice the lag at which its correlation first falls
/// below zero, at most the lags.
double oscillation(const Correlations& c) {
    const std::span<const double> own = c.of(0);
    for (std::size_t k = c.lags; k < own.size(); ++k) {
        if (own[k] < 0.0) return std::min(2.0 * static_cast<double>(k - c.lags), static_cast<double>(c.lags));
    }
    return static_cast<double>(c.lags);
}

struct Extreme {
    double lag = not_a_number;  ///< in intervals
    double correlation = 0.0;
};

/// The largest |R| that is a local extreme within `reach` of the expected lag, by the parabola through it and
/// the lags `step` away to each side. Of those as good, a maximum before a minimum, and the nearest: the
/// correlation of a regular wave has both in each period.
Extreme extreme_near(std::span<const double> r, double expected, double reach, std::size_t step) {
    const std::size_t centre = r.size() / 2;
    const auto middle = static_cast<double>(centre);
    std::vector<std::size_t> extremes;
    double largest = 0.0;
    for (std::size_t k = 1; k + 1 < r.size(); ++k) {
        if (std::abs(static_cast<double>(k) - middle - expected) > reach) continue;
        const double size = std::abs(r[k]);
        const double sign = r[k] < 0.0 ? -1.0 : 1.0;
        if (size < sign * r[k - 1] || size < sign * r[k + 1] || size == 0.0) continue;
        extremes.push_back(k);
        largest = std::max(largest, size);
    }
    const auto rank = [&](std::size_t k) {
        return std::pair(r[k] < 0.0, std::abs(static_cast<double>(k) - middle - expected));
    };
    std::erase_if(extremes, [&](std::size_t k) { return std::abs(r[k]) < as_good_correlation * largest; });
    if (extremes.empty()) return {};
    const std::size_t k = *std::min_element(extremes.begin(), extremes.end(),
                                            [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });
    const std::size_t apart = k >= step && k + step < r.size() ? step : 1;
    const ParabolaExtreme p = parabola_extreme(r[k - apart], r[k], r[k + apart]);
    return {static_cast<double>(k) - middle + p.offset * static_cast<double>(apart), p.value};
}

struct Line {
    double celerity = not_a_number;
    std::vector<Extreme> extremes;  ///< of the distances that were found
};

/// Follow the extreme from the shortest distance on, and fit the line through the origin: lag =
/// distance/celerity. `apart`: steps of lag between the points of the parabola of an extreme.
Line follow(const Correlations& c, double smallest_correlation, std::size_t apart = 1) {
    Line line;
    const double step = oscillation(c);
    double moment = 0.0;
    double spread = 0.0;
    for (std::size_t d = 1; d < c.pairs.size(); ++d) {
        const double slowness = spread > 0.0 ? moment / spread : 0.0;
        // Nothing is known of the first: it may be up to the half oscillation away.
        const Extreme e = extreme_near(c.of(d), slowness * c.distance(d), d == 1 ? step : 0.67 * step, apart);
        if (!(std::abs(e.correlation) >= smallest_correlation)) break;
        const double weight = e.correlation * e.correlation;
        moment += weight * c.distance(d) * e.lag;
        spread += weight * c.distance(d) * c.distance(d);
        line.extremes.push_back(e);
    }
    if (moment != 0.0) line.celerity = spread / (moment * c.interval);
    return line;
}

/// Mean products over the roots of the mean squares that belong to them.
std::vector<double> normalised(std::vector<double> means) {
    const std::size_t width = means.size() / 3;
    for (std::size_t i = 0; i < width; ++i) means[i] /= std::sqrt(means[i + width] * means[i + 2 * width]);
    means.resize(width);
    return means;
}

/// Pairs of columns of a line, at evenly spread distances.
std::vector<PairsAtDistance> pairs_of_line(const SpaceTime& data, const StationOptions& options) {
    const double wanted = options.largest_distance > 0.0 ? options.largest_distance : 0.5 * data.length();
    const std::size_t most = data.periodic ? data.columns / 2 : data.columns - 1;
    const auto largest = std::min(static_cast<std::size_t>(wanted / data.spacing + 1e-6), most);
    const std::size_t count = std::min(options.distances, largest);
    std::vector<PairsAtDistance> result;
    for (std::size_t d = 0; d <= count; ++d) {
        const std::size_t apart = count == 0 ? 0 : d * largest / count;
        PairsAtDistance pairs{static_cast<double>(apart) * data.spacing, {}};
        for (std::size_t i = 0; i < (data.periodic ? data.columns : data.columns - apart); ++i) {
            pairs.records.emplace_back(i, (i + apart) % data.columns);
        }
        result.push_back(std::move(pairs));
    }
    return result;
}

/// Every pair of stations a distance of its own, after all stations with themselves.
std::vector<PairsAtDistance> pairs_of_stations(std::span<const StationRecord> stations,
                                               double largest_distance) {
    std::vector<PairsAtDistance> result(1);
    for (std::size_t i = 0; i < stations.size(); ++i) result[0].records.emplace_back(i, i);
    for (const StationPair& pair : pairs_by_distance(stations)) {
        if (largest_distance > 0.0 && pair.distance > largest_distance) break;
        result.push_back({pair.distance, {{pair.upstream, pair.downstream}}});
    }
    return result;
}

StationCelerity celerity_of(std::span<const std::vector<double>> records, Correlations c,
                            const StationOptions& options) {
    const std::size_t rows = records.front().size();
    if (options.blocks < 2 || rows / options.blocks < 16) {
        throw InputError(fmt::format("{}: {} times in {} blocks; at least two blocks of 16 are needed",
                                     purpose, rows, options.blocks));
    }
    c.lags = rows / options.blocks / 2;
    if (options.largest_lag > 0.0) {
        c.lags =
            std::clamp<std::size_t>(static_cast<std::size_t>(options.largest_lag / c.interval), 2, c.lags);
    }
    const std::size_t width = 3 * c.pairs.size() * c.width();
    std::vector<double> blocks(options.blocks * width);
    parallel_blocks(options.blocks, 1, [&](std::size_t b, std::size_t) {
        const std::vector<double> products =
            block_products(records, c, b * rows / options.blocks, (b + 1) * rows / options.blocks);
        std::copy(products.begin(), products.end(), blocks.begin() + static_cast<std::ptrdiff_t>(b * width));
    });

    std::vector<double> without;
    std::vector<std::vector<double>> lags_without(c.pairs.size());
    for (std::size_t b = 0; b < options.blocks; ++b) {
        c.values = normalised(mean_without(blocks, width, b));
        const Line line = follow(c, options.smallest_correlation);
        without.push_back(line.celerity);
        for (std::size_t d = 1; d < c.pairs.size(); ++d) {
            lags_without[d].push_back(d <= line.extremes.size() ? line.extremes[d - 1].lag * c.interval
                                                                : not_a_number);
        }
    }
    c.values = normalised(mean_without(blocks, width, options.blocks));
    const Line line = follow(c, options.smallest_correlation);

    StationCelerity result;
    // The blocks share the error of the parabola. That through every second lag has about four times it.
    const double wide = follow(c, options.smallest_correlation, 2).celerity;
    result.celerity = {line.celerity, jackknife_half_width(without)};
    if (std::isfinite(wide)) {
        result.celerity.half_width = std::hypot(result.celerity.half_width, wide - line.celerity);
    }
    result.used = line.extremes.size();
    for (std::size_t d = 0; d < c.pairs.size(); ++d) {
        StationCorrelation s;
        s.distance = c.distance(d);
        s.correlation.assign(c.of(d).begin(), c.of(d).end());
        for (std::size_t k = 0; k < c.width(); ++k) {
            s.lag.push_back((static_cast<double>(k) - static_cast<double>(c.lags)) * c.interval);
        }
        s.extreme_lag = {d == 0 ? 0.0 : not_a_number, d == 0 ? 0.0 : infinity};
        s.extreme_correlation = d == 0 ? 1.0 : not_a_number;
        if (d > 0 && d <= line.extremes.size()) {
            s.extreme_lag = {line.extremes[d - 1].lag * c.interval, jackknife_half_width(lags_without[d])};
            s.extreme_correlation = line.extremes[d - 1].correlation;
        }
        result.stations.push_back(std::move(s));
    }
    return result;
}

}  // namespace

StationCelerity station_celerity(const SpaceTime& fluctuation, const StationOptions& options) {
    require_wet(fluctuation, purpose);
    require_even_times(fluctuation, purpose, 0.5);
    Correlations c;
    c.pairs = pairs_of_line(fluctuation, options);
    c.interval =
        (fluctuation.times.back() - fluctuation.times.front()) / static_cast<double>(fluctuation.rows() - 1);
    std::vector<std::vector<double>> records;
    for (std::size_t i = 0; i < fluctuation.columns; ++i) records.push_back(fluctuation.record(i));
    return celerity_of(records, std::move(c), options);
}

StationCelerity station_celerity(std::span<const StationRecord> stations, double interval,
                                 const StationOptions& options) {
    if (!(interval > 0.0)) {
        throw InputError(fmt::format("{}: the interval {:.4g} s is not above 0", purpose, interval));
    }
    const std::vector<StationRecord> scaled = normalised_stations(stations, purpose);
    Correlations c;
    c.pairs = pairs_of_stations(scaled, options.largest_distance);
    c.interval = interval;
    std::vector<std::vector<double>> records;
    for (const StationRecord& s : scaled) {
        if (std::any_of(s.values.begin(), s.values.end(), [](double v) { return std::isnan(v); })) {
            throw InputError(fmt::format("{}: the record at x = {:.6g} m has gaps; choose a window without",
                                         purpose, s.x));
        }
        records.push_back(s.values);
    }
    return celerity_of(records, std::move(c), options);
}

}  // namespace riffle::inline analysis
