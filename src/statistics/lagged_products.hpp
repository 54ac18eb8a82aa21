#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline statistics {

/// sum over t of a(t) b(t + lag) for lag = -largest_lag ... largest_lag, values outside of the records being
/// zero; the value at lag zero stands at index largest_lag. Through zero-padded Fourier transforms.
[[nodiscard]] std::vector<double> lagged_products(std::span<const double> a, std::span<const double> b,
                                                  std::size_t largest_lag);

/// The same of a record with itself, for lag = 0 ... largest_lag.
[[nodiscard]] std::vector<double> lagged_products(std::span<const double> a, std::size_t largest_lag);

}  // namespace riffle::inline statistics
