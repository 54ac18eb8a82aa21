#include "analysis/celerity_tracking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/peak.hpp"

namespace riffle::inline analysis {

namespace {

/// Columns that the smoothing reaches to each side.
std::size_t smoothing_reach(const SpaceTime& data, double deviation) {
    return static_cast<std::size_t>(std::ceil(3.0 * deviation / data.spacing));
}

std::vector<double> smoothed(const SpaceTime& data, std::size_t j, double deviation) {
    const std::span<const double> row = data.row(j);
    if (!(deviation > 0.0)) return {row.begin(), row.end()};
    const auto reach = static_cast<std::ptrdiff_t>(smoothing_reach(data, deviation));
    const auto n = static_cast<std::ptrdiff_t>(data.columns);
    std::vector<double> result(data.columns);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        double sum = 0.0;
        double weight = 0.0;
        for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
            std::ptrdiff_t other = i + d;
            if (data.periodic) other = ((other % n) + n) % n;
            if (other < 0 || other >= n || std::isnan(row[static_cast<std::size_t>(other)])) continue;
            const double q = static_cast<double>(d) * data.spacing / deviation;
            const double w = std::exp(-0.5 * q * q);
            sum += w * row[static_cast<std::size_t>(other)];
            weight += w;
        }
        result[static_cast<std::size_t>(i)] = sum / weight;
    }
    return result;
}

struct Crest {
    double position = 0.0;  ///< by the parabola through the three points about it, m
    /// Of the position by the parabola through the second neighbours, whose error is about four times as
    /// large, m.
    double shift = 0.0;
};

/// The local maxima above a height. None within
/// `margin` columns of the ends of a line, where the smoothing sees one side only and would shift them.
std::vector<Crest> crests(const SpaceTime& data, const std::vector<double>& row, double height,
                          std::size_t margin) {
    const std::size_t n = row.size();
    const std::size_t edge = data.periodic ? 0 : margin + 1;
    std::vector<Crest> result;
    for (std::size_t i = edge; i + edge < n; ++i) {
        const double before = row[(i + n - 1) % n];
        const double after = row[(i + 1) % n];
        if (!(row[i] > height) || !(row[i] > before) || !(row[i] >= after)) continue;
        const double offset = parabola_extreme(before, row[i], after).offset;
        double shift = 0.0;
        if (data.periodic || (i >= 2 && i + 2 < n)) {
            const double far_before = row[(i + n - 2) % n];
            const double far_after = row[(i + 2) % n];
            if (row[i] > far_before && row[i] > far_after) {
                shift = 2.0 * parabola_extreme(far_before, row[i], far_after).offset - offset;
            }
        }
        result.push_back({data.x(i) + offset * data.spacing, shift * data.spacing});
    }
    return result;
}

/// Median of the slopes between the points of a track, at most about 2000 pairs of them, without the first
/// and the last `ends` points.
double median_slope(const CrestTrack& track, std::size_t ends) {
    const std::size_t n = track.times.size() - ends;
    const std::size_t stride = std::max<std::size_t>(1, n / 64);
    std::vector<double> slopes;
    for (std::size_t a = ends; a < n; a += stride) {
        for (std::size_t b = a + stride; b < n; b += stride) {
            slopes.push_back((track.positions[b] - track.positions[a]) / (track.times[b] - track.times[a]));
        }
    }
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

struct Slope {
    double value = 0.0;
    double weight = 0.0;  ///< duration, s
    std::size_t block = 0;
};

/// The value below which a share of the weight lies.
double weighted_quantile(std::vector<Slope> slopes, double share) {
    std::sort(slopes.begin(), slopes.end(), [](const Slope& a, const Slope& b) { return a.value < b.value; });
    const double total = std::accumulate(slopes.begin(), slopes.end(), 0.0,
                                         [](double s, const Slope& x) { return s + x.weight; });
    double sum = 0.0;
    for (const Slope& s : slopes) {
        sum += s.weight;
        if (sum >= share * total) return s.value;
    }
    return not_a_number;
}

/// Standard deviation of a Gaussian of these quartiles.
double quartile_deviation(const std::vector<Slope>& slopes) {
    return (weighted_quantile(slopes, 0.75) - weighted_quantile(slopes, 0.25)) / 1.349;
}

/// Huber's mean with bounds of 1.5 standard deviations.
double robust_mean(const std::vector<Slope>& slopes) {
    if (slopes.empty()) return not_a_number;
    double mean = weighted_quantile(slopes, 0.5);
    const double bound = 1.5 * quartile_deviation(slopes);
    for (int pass = 0; pass < 50; ++pass) {
        double sum = 0.0;
        double weight = 0.0;
        for (const Slope& s : slopes) {
            const double distance = std::abs(s.value - mean);
            const double w = distance > bound ? s.weight * bound / distance : s.weight;
            sum += w * s.value;
            weight += w;
        }
        if (!(weight > 0.0)) return mean;
        const double next = sum / weight;
        if (std::abs(next - mean) <= 1e-9 * std::abs(next)) return next;
        mean = next;
    }
    return mean;
}

/// Half-width of the 95 % interval of the mean slope for the parabolas of the crests alone, each with a
/// quarter of its shift as its error: that of the slope through n points of a track of duration T is
/// sqrt(12/n) error/T.
double interpolation_half_width(const std::vector<CrestTrack>& tracks) {
    double squares = 0.0;
    double crests = 0.0;
    double factors = 0.0;
    double durations = 0.0;
    for (const CrestTrack& track : tracks) {
        for (const double shift : track.shifts) squares += shift * shift;
        crests += static_cast<double>(track.shifts.size());
        factors += 12.0 / static_cast<double>(track.shifts.size());
        durations += track.times.back() - track.times.front();
    }
    return 1.96 * 0.25 * std::sqrt(squares / crests * factors) / durations;
}

/// Link the crests of one time to the tracks that reach it: the closest pairs first.
void link(const SpaceTime& data, std::vector<CrestTrack>& active, std::vector<CrestTrack>& ended,
          const std::vector<Crest>& found, double t, double expected, double search) {
    struct Pair {
        double distance;
        std::size_t track, crest;
        double position;
    };
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < active.size(); ++a) {
        const double predicted = active[a].positions.back() + expected * (t - active[a].times.back());
        for (std::size_t c = 0; c < found.size(); ++c) {
            double offset = found[c].position - predicted;
            if (data.periodic) offset -= data.length() * std::nearbyint(offset / data.length());
            if (std::abs(offset) <= search) pairs.push_back({std::abs(offset), a, c, predicted + offset});
        }
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<bool> followed(active.size(), false), taken(found.size(), false);
    for (const Pair& p : pairs) {
        if (followed[p.track] || taken[p.crest]) continue;
        followed[p.track] = taken[p.crest] = true;
        active[p.track].times.push_back(t);
        active[p.track].positions.push_back(p.position);
        active[p.track].shifts.push_back(found[p.crest].shift);
    }
    std::vector<CrestTrack> next;
    for (std::size_t a = 0; a < active.size(); ++a) {
        (followed[a] ? next : ended).push_back(std::move(active[a]));
    }
    for (std::size_t c = 0; c < found.size(); ++c) {
        if (!taken[c]) next.push_back({{t}, {found[c].position}, {found[c].shift}, 0.0});
    }
    active = std::move(next);
}

}  // namespace

CrestCelerity track_crests(const SpaceTime& fluctuation, const CrestOptions& options) {
    if (options.blocks < 2 || fluctuation.rows() < options.blocks * options.smallest_rows) {
        throw InputError(
            fmt::format("crest tracking: {} times are too few for {} blocks of tracks of {} times",
                        fluctuation.rows(), options.blocks, options.smallest_rows));
    }
    if (options.smoothing < 0.0 || options.search_distance < 0.0) {
        throw InputError("crest tracking: smoothing and search distance must not be negative");
    }
    require_even_times(fluctuation, "crest tracking", 0.5);
    SpaceTime smooth = fluctuation;
    for (std::size_t j = 0; j < smooth.rows(); ++j) {
        const std::vector<double> row = smoothed(fluctuation, j, options.smoothing);
        std::copy(row.begin(), row.end(), smooth.row(j).begin());
    }
    const double height = options.smallest_height * standard_deviation(smooth).value;
    std::vector<std::vector<Crest>> found;
    std::size_t count = 0;
    for (std::size_t j = 0; j < smooth.rows(); ++j) {
        const std::span<const double> row = smooth.row(j);
        found.push_back(
            crests(smooth, {row.begin(), row.end()}, height, smoothing_reach(smooth, options.smoothing)));
        count += found.back().size();
    }
    const double mean_distance = fluctuation.length() * static_cast<double>(fluctuation.rows()) /
                                 static_cast<double>(std::max<std::size_t>(count, 1));
    const double search = options.search_distance > 0.0
                              ? options.search_distance
                              : std::max(1.5 * fluctuation.spacing, 0.25 * mean_distance);

    CrestCelerity result;
    std::vector<CrestTrack> active, ended;
    for (std::size_t j = 0; j < found.size(); ++j) {
        link(fluctuation, active, ended, found[j], fluctuation.times[j], options.expected_celerity, search);
    }
    ended.insert(ended.end(), active.begin(), active.end());
    const double start = fluctuation.times.front();
    const double duration = fluctuation.times.back() - start;
    std::vector<Slope> slopes;
    // Near the ends of a line noise decides whether a crest is on it: those that are found lie too far
    // inside, and tracks with them would be too slow.
    const std::size_t ends = fluctuation.periodic ? 0 : 1;
    for (CrestTrack& track : ended) {
        if (track.times.size() < options.smallest_rows) continue;
        track.celerity = median_slope(track, ends);
        const double middle = 0.5 * (track.times.front() + track.times.back());
        const auto block =
            static_cast<std::size_t>(static_cast<double>(options.blocks) * (middle - start) / duration);
        slopes.push_back({track.celerity, track.times.back() - track.times.front(), block});
        result.tracks.push_back(std::move(track));
    }
    result.celerity = {robust_mean(slopes), std::numeric_limits<double>::infinity()};
    if (slopes.empty()) return result;
    result.scatter = quartile_deviation(slopes);
    std::vector<double> without;
    for (std::size_t b = 0; b < options.blocks; ++b) {
        std::vector<Slope> rest = slopes;
        std::erase_if(rest, [b](const Slope& s) { return s.block == b; });
        without.push_back(robust_mean(rest));
    }
    // The places of the crests between the samples repeat themselves, and with them what the blocks share.
    result.celerity.half_width =
        std::hypot(jackknife_half_width(without), interpolation_half_width(result.tracks));
    return result;
}

}  // namespace riffle::inline analysis
