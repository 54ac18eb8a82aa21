#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace riffle::inline laboratory {

/// The even grid of times that a record was sampled on.
struct EvenSampling {
    double start = 0;      ///< time of the first sample, s
    double frequency = 0;  ///< Hz
    /// Place of each row on the grid; rows that the file lacks leave places free.
    std::vector<std::size_t> slots;
    std::size_t samples = 0;       ///< places in all: last slot + 1
    double largest_departure = 0;  ///< of a time from its place, in sampling intervals
};

/// Find the even grid of times (s): the interval is the median of the differences, each difference counts as
/// the nearest whole number of intervals, and a least-squares line then gives start and interval. Throws
/// FileError, which `row_name` tells the place of a row for ("PATH:LINE"), if there are fewer than two times,
/// if they do not rise, if fifty times as many samples would be needed to fill the gaps, or if a time is more
/// than `tolerance` intervals from its place: the record was sampled unevenly, and a spectrum or correlation
/// of it would be wrong.
[[nodiscard]] EvenSampling find_even_sampling(std::span<const double> times, double tolerance,
                                              const std::function<std::string(std::size_t)>& row_name);

/// Values at the places of the grid, not a number where the file has no row.
[[nodiscard]] std::vector<double> on_even_grid(const EvenSampling& sampling, std::span<const double> values);

}  // namespace riffle::inline laboratory
