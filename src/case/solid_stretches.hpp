#pragma once

#include <vector>

#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

/// A stretch of a line that lies in a solid, m.
struct SolidStretch {
    double low = 0.0;
    double high = 0.0;
};

/// The stretches of the upright line at (x, y) that lie in a closed surface, from below upward.
[[nodiscard]] std::vector<SolidStretch> upright_stretches(const SolidMesh& mesh, double x, double y);

}  // namespace riffle::inline case_file
