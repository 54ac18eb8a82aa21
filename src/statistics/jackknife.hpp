#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline statistics {

/// Half-width of the 95 % interval of an estimate from the estimates without one of its n blocks of data each
/// (delete-one jackknife: Quenouille 1956, Tukey 1958): variance (n-1)/n sum (v_i - mean)^2, Student's t on
/// n - 1 degrees of freedom. For smooth functions of means over blocks that are about equally long and much
/// longer than the correlation of the data, whatever the correlation inside of a block. Of ten blocks the
/// interval covers the truth in 90-95 % of cases, but for errors that the blocks share. Infinite for fewer
/// than two blocks or where a value is not finite.
[[nodiscard]] double jackknife_half_width(std::span<const double> without_one);

/// Means over all blocks but one, for estimators of them: blocks[b * width + i] are the values i of block b.
/// With left_out >= the number of blocks: over all of them. Not-a-number values are left out of the mean.
[[nodiscard]] std::vector<double> mean_without(std::span<const double> blocks, std::size_t width,
                                               std::size_t left_out);

}  // namespace riffle::inline statistics
