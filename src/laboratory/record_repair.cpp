#include "laboratory/record_repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/not_a_number.hpp"
#include "statistics/record.hpp"

namespace riffle::inline laboratory {

namespace {

/// Standard deviation of a normal distribution over its median absolute deviation.
constexpr double deviation_of_median = 1.4826;

/// Robust standard deviation about zero.
double spread(std::span<const double> values) {
    std::vector<double> magnitude;
    magnitude.reserve(values.size());
    for (const double v : values) magnitude.push_back(std::abs(v));
    return deviation_of_median * median_of(magnitude);
}

/// Central differences per sample, one-sided at the ends.
std::vector<double> central_difference(std::span<const double> values) {
    std::vector<double> result(values.size(), 0.0);
    result.front() = values[1] - values[0];
    result.back() = values[values.size() - 1] - values[values.size() - 2];
    for (std::size_t i = 1; i + 1 < values.size(); ++i) result[i] = 0.5 * (values[i + 1] - values[i - 1]);
    return result;
}

/// Whether the differences of each sample take in a sample that the record does not have.
std::vector<bool> beside_gaps(std::span<const double> values) {
    constexpr std::size_t reach = 2;
    std::vector<bool> result(values.size(), false);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isnan(values[i])) continue;
        const std::size_t end = std::min(values.size(), i + reach + 1);
        for (std::size_t j = i < reach ? 0 : i - reach; j < end; ++j) result[j] = true;
    }
    return result;
}

/// How far each sample is outside of the ellipsoid: above 1 beyond it. Those beside gaps by their value
/// alone: their differences tell of the interpolation, not of the record.
std::vector<double> phase_space_distance(std::span<const double> values,
                                         const std::vector<bool>& value_alone) {
    const auto n = values.size();
    const double centre = median_of(values);
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = values[i] - centre;
    const std::vector<double> first = central_difference(x);
    std::vector<double> second = central_difference(first);
    second.front() = second[1];  // a one-sided second difference would be twice as large
    second.back() = second[n - 2];
    // The correlation of value and second difference, by a regression that spikes hardly turn: spikes lie on
    // the same side of it as any sample, since a second difference opposes its value.
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
        products += x[i] * second[i];
        squares += x[i] * x[i];
    }
    const double tilt = squares > 0.0 ? products / squares : 0.0;
    std::vector<double> rest(n);
    for (std::size_t i = 0; i < n; ++i) rest[i] = second[i] - tilt * x[i];

    const double threshold = std::sqrt(2.0 * std::log(static_cast<double>(n)));
    const double value_axis = threshold * spread(x);
    // Rounding must not be taken for a signal where a record is smoother than its digits.
    const double smallest = 1e-9 * value_axis;
    const double first_axis = std::max(smallest, threshold * spread(first));
    const double second_axis = std::max(smallest, threshold * spread(second));
    // In a narrow-banded record almost nothing of the second difference is left; of white noise 0.58 of it.
    const double rest_axis = std::max(0.5 * second_axis, threshold * spread(rest));
    std::vector<double> distance(n, 0.0);
    if (!(value_axis > 0.0)) return distance;
    for (std::size_t i = 0; i < n; ++i) {
        const double a = x[i] / value_axis;
        const double b = first[i] / first_axis;
        const double c = second[i] / second_axis;
        const double d = rest[i] / rest_axis;
        if (value_alone[i]) {
            distance[i] = std::abs(a);
            continue;
        }
        distance[i] = std::max({std::hypot(a, b), std::hypot(b, c), std::hypot(a, d)});
    }
    return distance;
}

/// Departure of a sample from the mean of its neighbours: largest at a spike itself.
double departure(std::span<const double> values, std::size_t i) {
    const double before = values[i == 0 ? 1 : i - 1];
    const double after = values[i + 1 == values.size() ? i - 1 : i + 1];
    return std::abs(values[i] - 0.5 * (before + after));
}

/// Of each group of flagged samples at most two apart, the one that departs most from its neighbours.
std::vector<std::size_t> worst_of_groups(std::span<const double> values, std::span<const double> distance) {
    std::vector<std::size_t> result;
    std::size_t last_flagged = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(distance[i] > 1.0)) continue;
        const bool same_group = !result.empty() && i - last_flagged <= 2;
        last_flagged = i;
        if (!same_group) {
            result.push_back(i);
        } else if (departure(values, i) > departure(values, result.back())) {
            result.back() = i;
        }
    }
    return result;
}

/// The record without holes: those at the ends take the nearest value.
std::vector<double> without_gaps(std::span<const double> values) {
    std::vector<double> whole(values.begin(), values.end());
    interpolate_gaps(whole, whole.size());
    const auto known = [](double v) { return !std::isnan(v); };
    const auto first = std::find_if(whole.begin(), whole.end(), known);
    if (first == whole.end()) return {};
    std::fill(whole.begin(), first, *first);
    const auto last = std::find_if(whole.rbegin(), whole.rend(), known);
    std::fill(whole.rbegin(), last, *last);
    return whole;
}

}  // namespace

std::string describe(const RecordQuality& q, std::string_view name) {
    std::string parts;
    const auto add = [&parts](std::string part) {
        if (!parts.empty()) parts += ", ";
        parts += part;
    };
    if (q.missing > 0) add(fmt::format("{} missing", q.missing));
    if (q.refused > 0) add(fmt::format("{} of poor quality", q.refused));
    if (q.gaps > 0) {
        parts += fmt::format(" (in {} gap{}, longest {})", q.gaps, q.gaps == 1 ? "" : "s", q.longest_gap);
    }
    if (q.spikes > 0) add(fmt::format("{} spike{}", q.spikes, q.spikes == 1 ? "" : "s"));
    if (parts.empty()) return {};
    add(fmt::format("{} interpolated", q.interpolated));
    if (q.left > 0) add(fmt::format("{} left without a value", q.left));
    return fmt::format("{}: of {} samples {}", name, q.samples, parts);
}

std::size_t interpolate_gaps(std::span<double> values, std::size_t longest) {
    std::size_t replaced = 0;
    std::size_t i = 0;
    while (i < values.size()) {
        if (!std::isnan(values[i])) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < values.size() && std::isnan(values[i])) ++i;
        const std::size_t length = i - begin;
        if (begin == 0 || i == values.size() || length > longest) continue;
        const double before = values[begin - 1];
        const double step = (values[i] - before) / static_cast<double>(length + 1);
        for (std::size_t j = 0; j < length; ++j) {
            values[begin + j] = before + static_cast<double>(j + 1) * step;
        }
        replaced += length;
    }
    return replaced;
}

Gaps find_gaps(std::span<const double> values) {
    Gaps gaps;
    std::size_t run = 0;
    for (const double v : values) {
        run = std::isnan(v) ? run + 1 : 0;
        if (run == 0) continue;
        ++gaps.missing;
        if (run == 1) ++gaps.runs;
        gaps.longest = std::max(gaps.longest, run);
    }
    return gaps;
}

std::vector<std::size_t> find_spikes(std::span<const double> values) {
    constexpr std::size_t fewest = 20;  // for a median absolute deviation to mean something
    constexpr int most_passes = 100;
    std::vector<double> marked(values.begin(), values.end());
    if (values.size() < fewest) return {};
    const std::vector<bool> value_alone = beside_gaps(values);
    for (int pass = 0; pass < most_passes; ++pass) {
        const std::vector<double> whole = without_gaps(marked);
        if (whole.empty()) break;
        const std::vector<double> distance = phase_space_distance(whole, value_alone);
        bool found = false;
        for (const std::size_t i : worst_of_groups(whole, distance)) {
            found = found || !std::isnan(marked[i]);
            marked[i] = not_a_number;
        }
        if (!found) break;
    }
    std::vector<std::size_t> spikes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(marked[i]) && !std::isnan(values[i])) spikes.push_back(i);
    }
    return spikes;
}

RecordQuality repair_record(std::span<double> values, const RepairOptions& options, std::size_t refused) {
    const Gaps gaps = find_gaps(values);
    RecordQuality quality;
    quality.samples = values.size();
    quality.missing = gaps.missing - refused;
    quality.refused = refused;
    quality.gaps = gaps.runs;
    quality.longest_gap = gaps.longest;
    if (options.despike) {
        const std::vector<std::size_t> spikes = find_spikes(values);
        quality.spikes = spikes.size();
        for (const std::size_t i : spikes) values[i] = not_a_number;
    }
    quality.interpolated = interpolate_gaps(values, options.longest_interpolated);
    quality.left = find_gaps(values).missing;
    return quality;
}

}  // namespace riffle::inline laboratory
