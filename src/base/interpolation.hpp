#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace riffle::inline base {

/// Where a value stands among rising ones: the entries before and behind it, and the share of the latter.
struct TablePlace {
    std::size_t low = 0;
    std::size_t high = 0;
    double share = 0.0;

    /// The value there of a quantity given at the entries, linear between them.
    template <class Values>
    [[nodiscard]] double in(const Values& values) const {
        return values[low] + share * (values[high] - values[low]);
    }
};

/// The place of `at` among the rising values `x`, which must not be empty; the nearest end beyond them, so
/// that a table goes on with its first and last value.
[[nodiscard]] inline TablePlace place_in(std::span<const double> x, double at) {
    const auto above = std::upper_bound(x.begin(), x.end(), at);
    if (above == x.begin()) {
        return {};
    }
    if (above == x.end()) {
        return {x.size() - 1, x.size() - 1, 0.0};
    }
    const auto i = static_cast<std::size_t>(above - x.begin());
    return {i - 1, i, (at - x[i - 1]) / (x[i] - x[i - 1])};
}

/// The same among `count` values evenly apart, counted in them from the first one.
[[nodiscard]] inline TablePlace place_among(double at, std::size_t count) {
    const double inside = std::clamp(at, 0.0, static_cast<double>(count - 1));
    const auto low = static_cast<std::size_t>(inside);
    return {low, std::min(low + 1, count - 1), inside - static_cast<double>(low)};
}

}  // namespace riffle::inline base
