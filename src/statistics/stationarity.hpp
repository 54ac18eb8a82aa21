#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "statistics/moments.hpp"

namespace riffle::inline statistics {

// Tests of whether independent numbers in order come from one distribution (J. S. Bendat & A. G. Piersol,
// 2010, Random Data, section 4.5). Exact for numbers that all differ.

/// Chance that numbers without a trend have a count of reverse arrangements (earlier ones above later ones;
/// ties count half) at least as far from its mean n (n - 1)/4, on either side. Sees monotonic change. 1 for
/// fewer than two.
[[nodiscard]] double reverse_arrangements_p_value(std::span<const double> numbers);

/// Chance that numbers in random order change sides of their median as seldom or more so (A. Wald & J.
/// Wolfowitz, 1940). Sees slow change of any shape. Numbers equal to the median are left out. 1 for fewer
/// than two sides.
[[nodiscard]] double runs_p_value(std::span<const double> numbers);

/// Whether a record is statistically steady. Small p-values speak against it.
struct Stationarity {
    /// Change of the linear trend over the whole record, correlation taken into account.
    Estimate drift;
    double trend_p_value = 1;

    /// Tests on means and on mean squares of blocks that are long enough to be independent: 20 integral
    /// scales (of the record without its linear trend, and of its square), at most 40 blocks. None where the
    /// record holds fewer than ten such blocks: it is too short to tell.
    struct OfBlocks {
        double mean_arrangements = 1, mean_runs = 1;
        double variance_arrangements = 1, variance_runs = 1;
    };
    std::optional<OfBlocks> blocks;
    std::size_t block_count = 0;   ///< the record would hold; used are at most 40
    std::size_t block_length = 0;  ///< samples

    /// The smallest of the p-values times their number (Bonferroni), at most 1: below 0.05 in at most one of
    /// twenty steady records.
    double p_value = 1;
};

/// Throws InputError for gaps or fewer than ten samples.
[[nodiscard]] Stationarity stationarity(std::span<const double> record);

}  // namespace riffle::inline statistics
