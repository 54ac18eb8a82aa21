#include "case/solid_stretches.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "case/winding.hpp"

namespace riffle::inline case_file {

std::vector<SolidStretch> upright_stretches(const SolidMesh& mesh, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // Beside round numbers, on which corners like to stand.
    const double u = x + 1.234567e-9 * (mesh.upper()[0] - mesh.lower()[0]);
    const double v = y + 2.718282e-9 * (mesh.upper()[1] - mesh.lower()[1]);
    std::vector<std::pair<double, int>> passes;
    mesh.tree().in_box({u, v, -infinity}, {u, v, infinity}, [&](std::size_t i) {
        const Triangle& t = mesh.tree().triangles()[i];
        if (const int turns = turns_around(t, u, v); turns != 0) {
            passes.emplace_back(height_at(t, u, v), turns);
        }
    });
    std::sort(passes.begin(), passes.end());
    std::vector<SolidStretch> stretches;
    int inside = 0;
    for (const auto& [z, turns] : passes) {
        const int now = inside - turns;  // the underside of a body goes around with the clock
        if (inside == 0 && now != 0) {
            stretches.push_back({z, z});
        } else if (inside != 0 && now == 0) {
            stretches.back().high = z;
        }
        inside = now;
    }
    return stretches;
}

}  // namespace riffle::inline case_file
