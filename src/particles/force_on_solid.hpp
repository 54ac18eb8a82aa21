#pragma once

#include <array>
#include <cstddef>

namespace riffle::inline particles {

/// Force of the water on a solid along x, y and z, N, and its moment about a point of the solid, N m; in two
/// dimensions per width, N/m and N.
struct ForceOnSolid {
    std::array<double, 3> pressure{};  ///< by the pressure on its faces
    std::array<double, 3> friction{};
    std::array<double, 3> pressure_moment{};  ///< about the axes x, y and z; in two dimensions about y alone
    std::array<double, 3> friction_moment{};
};

inline constexpr std::array force_on_solid_parts{&ForceOnSolid::pressure, &ForceOnSolid::friction,
                                                 &ForceOnSolid::pressure_moment,
                                                 &ForceOnSolid::friction_moment};

inline ForceOnSolid& operator+=(ForceOnSolid& sum, const ForceOnSolid& other) {
    for (std::array<double, 3> ForceOnSolid::*const part : force_on_solid_parts) {
        for (std::size_t axis = 0; axis < 3; ++axis) (sum.*part)[axis] += (other.*part)[axis];
    }
    return sum;
}

}  // namespace riffle::inline particles
