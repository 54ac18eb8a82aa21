#pragma once

#include <array>

namespace riffle {

/// Force of the water on a solid along x, y and z, N; in two dimensions per width, N/m.
struct ForceOnSolid {
    std::array<double, 3> pressure{};  ///< by the pressure on its faces
    std::array<double, 3> friction{};
};

}  // namespace riffle
