#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Periods of the lattice of the bed's spheres, m: along and across the channel. Hexagonal: rows along the
/// channel, D from sphere to sphere, every other row shifted by D/2.
struct LatticePeriods {
    double x = 0.0;
    double y = 0.0;
};
[[nodiscard]] inline LatticePeriods lattice_periods(const Bed& bed) {
    const double d = bed.sphere_diameter;
    return bed.packing == Packing::hexagonal ? LatticePeriods{d, std::numbers::sqrt3 * d}
                                             : LatticePeriods{d, d};
}

/// Number of periods of the lattice in a periodic extent: the nearest whole number, at least one.
[[nodiscard]] inline double whole_periods(double extent, double period) {
    return std::max(1.0, std::round(extent / period));
}

/// Largest relative stretch of the lattice that makes it fit a periodic channel.
inline constexpr double largest_stretch = 0.01;

}  // namespace riffle::inline case_file
