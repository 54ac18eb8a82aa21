#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace riffle::inline statistics {

// Records are equally spaced in time or space. A gap of a record is a not-a-number in its place.

/// Mean of the samples that are there; not-a-number where there are none. A constant record gives its value
/// to the bit.
[[nodiscard]] double mean_of(std::span<const double> record);

/// Median of numbers, of an even number of them the mean of the two in the middle; not-a-number of none. They
/// must have no gaps.
[[nodiscard]] double median_of(std::span<const double> numbers);

/// The departures of a record from its mean.
struct Fluctuations {
    std::vector<double> values;  ///< zero in gaps
    std::vector<bool> present;
    std::size_t count = 0;  ///< of the samples that are there
    double mean = 0;        ///< of these
};

/// Throws InputError, naming `what`, where a sample is infinite or fewer than two are there.
[[nodiscard]] Fluctuations fluctuations_of(std::span<const double> record, std::string_view what);

/// The same of two records of the same length, with a gap in both where either has one; their means are those
/// of the samples that both have.
struct PairOfFluctuations {
    Fluctuations first, second;
};
[[nodiscard]] PairOfFluctuations fluctuations_of(std::span<const double> first,
                                                 std::span<const double> second, std::string_view what);

/// Throws InputError, naming `what`, where a sample is no finite number: for methods that need a whole
/// record.
void require_no_gaps(std::span<const double> record, std::string_view what);

/// Throws InputError, naming `what`, where the records differ in length.
void require_same_length(std::span<const double> first, std::span<const double> second,
                         std::string_view what);

}  // namespace riffle::inline statistics
