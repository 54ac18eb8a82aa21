#include "analysis/even_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "record/flow_fields.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

std::optional<std::string> make_even(SeriesTable& series) {
    const std::vector<double> time = series[fields::time_series.time];
    constexpr std::size_t fewest = 5;  // intervals of another length that are no gaps
    constexpr double wider = 1.5;
    constexpr double least_share = 0.02;
    if (time.size() < 2 * fewest) return std::nullopt;
    std::vector<double> intervals(time.size() - 1);
    for (std::size_t i = 0; i < intervals.size(); ++i) intervals[i] = time[i + 1] - time[i];
    // Of a few wide ones among many the median is narrow, and of few narrow ones the other way round.
    std::vector<double> sorted = intervals;
    std::sort(sorted.begin(), sorted.end());
    const double narrow = sorted[fewest - 1];
    std::vector<double> wide;
    double covered = 0.0;
    for (const double interval : intervals) {
        if (interval <= wider * narrow) continue;
        wide.push_back(interval);
        covered += interval;
    }
    const double whole = time.back() - time.front();
    if (wide.size() < fewest || covered < least_share * whole) return std::nullopt;
    const double even = median_of(wide);
    std::vector<std::size_t> rows{0};
    double next = time.front() + even;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] + 0.5 * (time[i] - time[i - 1]) < next) continue;
        rows.push_back(i);
        next = time[i] + even;
    }
    if (rows.size() == time.size()) return std::nullopt;
    series.keep_rows(rows);
    return fmt::format(
        "the time series has rows each {:.3g} s in a part of the run and each {:.3g} s in another: it is thinned to "
        "these",
        narrow, even);
}

}  // namespace riffle::inline analysis
