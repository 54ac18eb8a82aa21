#include "analysis/space_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/not_a_number.hpp"

namespace riffle::inline analysis {

namespace {

/// Mean of the wet values; not-a-number where there is none.
double wet_mean(std::span<const double> values) {
    double sum = 0.0;
    std::size_t wet = 0;
    for (const double v : values) {
        if (std::isnan(v)) continue;
        sum += v;
        ++wet;
    }
    return wet == 0 ? not_a_number : sum / static_cast<double>(wet);
}

/// The wet ones of the values.
std::vector<double> wet_values(std::vector<double> values) {
    std::erase_if(values, [](double v) { return std::isnan(v); });
    return values;
}

/// Value at time t of the column, rows first and first + 1 around it.
double interpolate(const SpaceTime& data, std::size_t column, std::size_t first, double t) {
    const std::size_t begin = first == 0 ? 0 : first - 1;
    const std::size_t end = std::min(first + 3, data.rows());
    double cubic = 0.0;
    for (std::size_t a = begin; a < end; ++a) {
        double weight = data.at(a, column);
        for (std::size_t b = begin; b < end; ++b) {
            if (b != a) weight *= (t - data.times[b]) / (data.times[a] - data.times[b]);
        }
        cubic += weight;
    }
    if (!std::isnan(cubic)) return cubic;
    const double share = (t - data.times[first]) / (data.times[first + 1] - data.times[first]);
    if (share <= 0.0) return data.at(first, column);
    if (share >= 1.0) return data.at(first + 1, column);
    return (1.0 - share) * data.at(first, column) + share * data.at(first + 1, column);
}

}  // namespace

void remove_line(std::span<const double> places, std::vector<double>& record, bool trend) {
    const double mean = wet_mean(record);
    double mean_place = 0.0;
    double wet = 0.0;
    for (std::size_t j = 0; j < record.size(); ++j) {
        if (std::isnan(record[j])) continue;
        record[j] -= mean;
        mean_place += places[j];
        wet += 1.0;
    }
    if (!trend || wet < 3.0) return;
    mean_place /= wet;
    double moment = 0.0;
    double spread = 0.0;
    for (std::size_t j = 0; j < record.size(); ++j) {
        if (std::isnan(record[j])) continue;
        moment += (places[j] - mean_place) * record[j];
        spread += (places[j] - mean_place) * (places[j] - mean_place);
    }
    const double slope = moment / spread;
    for (std::size_t j = 0; j < record.size(); ++j) record[j] -= slope * (places[j] - mean_place);
}

std::vector<double> SpaceTime::record(std::size_t column) const {
    std::vector<double> result(rows());
    for (std::size_t j = 0; j < result.size(); ++j) result[j] = at(j, column);
    return result;
}

SpaceTime make_space_time(std::span<const double> x, std::span<const double> times,
                          std::span<const double> values, std::optional<double> period) {
    if (x.size() < 2) throw InputError("record along a line: at least two columns are needed");
    if (values.size() != x.size() * times.size()) {
        throw InputError(
            fmt::format("record along a line: {} values for {} columns and {} times; {} were expected",
                        values.size(), x.size(), times.size(), x.size() * times.size()));
    }
    SpaceTime data;
    data.first_x = x.front();
    data.columns = x.size();
    data.spacing = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    data.periodic = period.has_value();
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(std::abs(x[i] - data.x(i)) <= 1e-3 * data.spacing)) {
            throw InputError(fmt::format(
                "record along a line: column {} is at x = {:.6g} m, but {:.6g} m would continue the even "
                "spacing of {:.6g} m; choose evenly spaced columns in ascending order",
                i + 1, x[i], data.x(i), data.spacing));
        }
    }
    if (period && std::abs(*period - data.length()) > 0.01 * data.spacing) {
        throw InputError(fmt::format(
            "record along a line: the period {:.6g} m is not that of {} columns {:.6g} m apart, {:.6g} m",
            *period, data.columns, data.spacing, data.length()));
    }
    for (std::size_t j = 1; j < times.size(); ++j) {
        if (!(times[j] > times[j - 1])) {
            throw InputError(
                fmt::format("record along a line: time {:.6g} s (number {}) does not follow {:.6g} s",
                            times[j], j + 1, times[j - 1]));
        }
    }
    data.times.assign(times.begin(), times.end());
    data.values.assign(values.begin(), values.end());
    return data;
}

SpaceTime block_of_rows(const SpaceTime& data, std::size_t first, std::size_t count) {
    if (first > data.rows() || count > data.rows() - first) {
        throw InputError(fmt::format("record along a line: rows {} to {} of {} were asked for", first + 1,
                                     first + count, data.rows()));
    }
    SpaceTime part = data;
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = static_cast<std::ptrdiff_t>(first + count);
    const auto width = static_cast<std::ptrdiff_t>(data.columns);
    part.times.assign(data.times.begin() + begin, data.times.begin() + end);
    part.values.assign(data.values.begin() + begin * width, data.values.begin() + end * width);
    return part;
}

SpaceTime fewer_columns(const SpaceTime& data, std::size_t most) {
    if (data.columns <= most) return data;
    std::size_t stride = (data.columns + most - 1) / most;
    if (data.periodic) {
        while (stride < data.columns && data.columns % stride != 0) ++stride;
    }
    const bool divides = !data.periodic || 2 * (data.columns / stride) >= most;
    SpaceTime result;
    result.first_x = data.first_x;
    result.periodic = data.periodic;
    result.times = data.times;
    result.columns = divides ? (data.columns + stride - 1) / stride : most;
    result.spacing =
        divides ? data.spacing * static_cast<double>(stride) : data.length() / static_cast<double>(most);
    result.values.reserve(result.columns * data.rows());
    for (std::size_t j = 0; j < data.rows(); ++j) {
        for (std::size_t i = 0; i < result.columns; ++i) {
            if (divides) {
                result.values.push_back(data.at(j, i * stride));
                continue;
            }
            const double place = static_cast<double>(i * data.columns) / static_cast<double>(most);
            const auto left = static_cast<std::size_t>(place);
            const double part = place - static_cast<double>(left);
            result.values.push_back((1.0 - part) * data.at(j, left) +
                                    part * data.at(j, (left + 1) % data.columns));
        }
    }
    return result;
}

MeanEstimate mean_level(const SpaceTime& data) {
    std::vector<double> level(data.rows());
    for (std::size_t j = 0; j < level.size(); ++j) level[j] = wet_mean(data.row(j));
    return mean_with_confidence(wet_values(std::move(level)));
}

double dry_share(const SpaceTime& data) {
    if (data.values.empty()) return 0.0;
    const auto dry =
        std::count_if(data.values.begin(), data.values.end(), [](double v) { return std::isnan(v); });
    return static_cast<double>(dry) / static_cast<double>(data.values.size());
}

SpaceTime fluctuation(const SpaceTime& data, const FluctuationOptions& options) {
    SpaceTime result = data;
    for (std::size_t i = 0; i < data.columns; ++i) {
        std::vector<double> record = data.record(i);
        remove_line(data.times, record, options.remove_trend);
        for (std::size_t j = 0; j < data.rows(); ++j) result.values[j * data.columns + i] = record[j];
    }
    if (options.remove_line_mean) {
        for (std::size_t j = 0; j < data.rows(); ++j) {
            const double mean = wet_mean(result.row(j));
            for (double& v : result.row(j)) v -= mean;
        }
    }
    return result;
}

DeviationEstimate standard_deviation(const SpaceTime& fluctuation) {
    std::vector<double> mean_square(fluctuation.rows());
    for (std::size_t j = 0; j < mean_square.size(); ++j) {
        std::vector<double> squares(fluctuation.row(j).begin(), fluctuation.row(j).end());
        for (double& v : squares) v *= v;
        mean_square[j] = wet_mean(squares);
    }
    const MeanEstimate variance = mean_with_confidence(wet_values(std::move(mean_square)));
    DeviationEstimate result;
    result.value = std::sqrt(variance.mean);
    if (!(variance.mean > 0.0)) return result;
    result.half_width =
        trusted_half_width(variance).value_or(std::numeric_limits<double>::infinity()) / (2.0 * result.value);
    const double error =
        variance.standard_deviation * variance.standard_deviation / variance.effective_samples;
    result.effective_samples = 2.0 * variance.mean * variance.mean / error;
    if (fluctuation.rows() > 1) {
        result.integral_time = variance.integral_time *
                               (fluctuation.times.back() - fluctuation.times.front()) /
                               static_cast<double>(fluctuation.rows() - 1);
    }
    return result;
}

namespace {

/// The median of the intervals between the samples, s, which missing samples do not move.
double median_interval(const SpaceTime& data) {
    if (data.rows() < 2) throw InputError("record along a line: at least two times are needed");
    std::vector<double> intervals(data.rows());
    std::adjacent_difference(data.times.begin(), data.times.end(), intervals.begin());
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>((intervals.size() + 1) / 2);
    std::nth_element(intervals.begin() + 1, middle, intervals.end());
    return *middle;
}

constexpr double missing_from = 1.9;  ///< of the median: an interval so long lacks a sample

}  // namespace

double sampling_interval(const SpaceTime& data) {
    const double longest = missing_from * median_interval(data);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t j = 1; j < data.rows(); ++j) {
        const double interval = data.times[j] - data.times[j - 1];
        if (interval > longest) continue;
        sum += interval;
        count += 1.0;
    }
    return sum / count;
}

SpaceTime resample_evenly(const SpaceTime& data, double largest_gap) {
    const double median = median_interval(data);
    for (std::size_t j = 1; j < data.rows(); ++j) {
        const double gap = data.times[j] - data.times[j - 1];
        if (gap > largest_gap * median) {
            throw InputError(
                fmt::format("record along a line: no sample between {:.6g} s and {:.6g} s, where the "
                            "interval is {:.3g} s; "
                            "choose a window that begins at {:.6g} s or ends at {:.6g} s",
                            data.times[j - 1], data.times[j], median, data.times[j], data.times[j - 1]));
        }
    }
    const double interval = sampling_interval(data);
    const double start = data.times.front();
    const double duration = data.times.back() - start;
    const auto intervals = static_cast<std::size_t>(std::max(1.0, std::round(duration / interval)));
    SpaceTime result = data;
    result.times.resize(intervals + 1);
    result.values.resize(result.times.size() * data.columns);
    std::size_t first = 0;
    for (std::size_t j = 0; j <= intervals; ++j) {
        const double t = start + duration * static_cast<double>(j) / static_cast<double>(intervals);
        while (first + 2 < data.rows() && data.times[first + 1] <= t) ++first;
        result.times[j] = t;
        for (std::size_t i = 0; i < data.columns; ++i) {
            result.values[j * data.columns + i] = interpolate(data, i, first, t);
        }
    }
    return result;
}

void require_wet(const SpaceTime& data, const char* purpose) {
    for (std::size_t n = 0; n < data.values.size(); ++n) {
        if (std::isnan(data.values[n])) {
            throw InputError(fmt::format(
                "{}: no surface at x = {:.6g} m, t = {:.6g} s ({:.2g} % of the points are dry); choose "
                "columns and a window that stay wet",
                purpose, data.x(n % data.columns), data.times[n / data.columns], 100.0 * dry_share(data)));
        }
    }
}

void require_even_times(const SpaceTime& data, const char* purpose, double tolerance) {
    if (data.rows() < 2) throw InputError(fmt::format("{}: at least two times are needed", purpose));
    const double interval = (data.times.back() - data.times.front()) / static_cast<double>(data.rows() - 1);
    for (std::size_t j = 0; j < data.rows(); ++j) {
        const double even = data.times.front() + interval * static_cast<double>(j);
        if (std::abs(data.times[j] - even) > tolerance * interval) {
            throw InputError(
                fmt::format("{}: time {:.6g} s stands where {:.6g} s would be even; resample first", purpose,
                            data.times[j], even));
        }
    }
}

}  // namespace riffle::inline analysis
