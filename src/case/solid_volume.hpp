#pragma once

#include <array>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// What the shape of a solid holds, as if it were of one density; in two dimensions an area, per width.
struct SolidVolume {
    double volume = 0.0;               ///< m3; in two dimensions m2
    std::array<double, 3> centroid{};  ///< at t = 0, m; y = 0 in two dimensions
    /// Integral of r_k r_l at 3 k + l, r from the centroid, m5; in two dimensions m4, nothing along y.
    std::array<double, 9> spread{};

    /// Moments of inertia about the centroid over the density, at 3 k + l: the trace of the spread on the
    /// diagonal less the spread, m5 or m4.
    [[nodiscard]] std::array<double, 9> inertia() const;
};

/// Of a solid of a case whose shape is known, by the parts of its outline or surface against a corner
/// (Mirtich 1996 gives the integrals over polyhedra). What lies in two shells of a surface counts twice.
[[nodiscard]] SolidVolume solid_volume(const Case& c, const Solid& solid);

/// Largest distance of a place of a solid from a point, both at t = 0, m.
[[nodiscard]] double reach_from(const Case& c, const Solid& solid, const std::array<double, 3>& point);

/// The point of a solid that moments of the water's forces on it are about, where it is at t = 0, m: the one
/// that the case gives, or the centroid.
[[nodiscard]] std::array<double, 3> moment_point(const Case& c, const Solid& solid);

}  // namespace riffle::inline case_file
