#include "case/stepping_validation.hpp"

#include <fmt/format.h>

#include "case/case.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {
/// Largest Courant number at which Verlet's method held the channel of condition 2 with density diffusion.
constexpr double verlet_courant_number = 0.2;
}  // namespace

void validate_stepping(const Case& c, const Places& places, Problems& problems) {
    const Numerics& n = c.numerics;
    const auto add = [&](const std::vector<std::string>& keys, std::string message) {
        problems.add(places.of_first(keys), std::move(message));
    };
    if (n.stepping == Stepping::verlet && n.density_diffusion != DensityDiffusion::none && !n.time_step &&
        n.courant_number > verlet_courant_number) {
        add({"numerics.courant_number", "numerics.stepping"},
            fmt::format(
                "[numerics] courant_number = {} with stepping = \"verlet\": its leap over two steps "
                "amplifies any diffusion of the density, and the run fails within 0.03 s at 0.3; make it {} "
                "or less, set density_diffusion = \"none\", or choose another stepping",
                n.courant_number, verlet_courant_number));
    }
}

}  // namespace riffle
