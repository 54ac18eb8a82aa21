#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

namespace riffle::inline statistics {

/// The root of a continuous function between two places, in any order, where it has opposite signs (Alefeld,
/// Potra & Shi 1995), to so many bits; where it has not, the end at which it is nearer to zero.
template <class Function>
[[nodiscard]] double root_between(Function function, double from, double to, unsigned bits = 45) {
    if (from > to) std::swap(from, to);
    const double at_from = function(from);
    const double at_to = function(to);
    if (at_from == 0.0 || at_to == 0.0 || (at_from > 0.0) == (at_to > 0.0)) {
        return std::abs(at_from) <= std::abs(at_to) ? from : to;
    }
    std::uintmax_t iterations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        function, from, to, at_from, at_to, boost::math::tools::eps_tolerance<double>(bits), iterations);
    return 0.5 * (low + high);
}

}  // namespace riffle::inline statistics
