#pragma once

#include <cmath>

namespace riffle::inline base {

/// Whether a is b or several times it, up to a share `tolerance` of a.
[[nodiscard]] inline bool is_multiple(double a, double b, double tolerance) {
    const double times = std::round(a / b);
    return times >= 1.0 && std::abs(times * b - a) <= tolerance * std::abs(a);
}

}  // namespace riffle::inline base
