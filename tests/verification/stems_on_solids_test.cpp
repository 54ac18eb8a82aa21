// Stems that stand on solids.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "check_run.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"

namespace riffle::verification {
namespace {

/// A channel whose one half is a floodplain, with emergent stems in both, twice as many on the floodplain.
Case compound_channel() {
    return parse_case(R"([channel]
dimensions = 3
slope = 0.02
depth = "80 mm"
length = "56 mm"
width = "0.24 m"
sides = "walls"
[side_walls]
drag_form = "none"
[bed]
kind = "slip"
[[solid]]
name = "floodplain"
shape = "box"
centre = ["28 mm", "60 mm", "20 mm"]
size = ["56 mm", "120 mm", "40 mm"]
surface = "slip"
[[vegetation]]
name = "plain"
stems_per_area = "800 1/m2"
stem_diameter = "6 mm"
height = "60 mm"
drag_coefficient = 1
y_to = "0.12 m"
stands_on = "floodplain"
[[vegetation]]
name = "main"
stems_per_area = "400 1/m2"
stem_diameter = "6 mm"
height = "0.2 m"
drag_coefficient = 1
y_from = "0.12 m"
[turbulence]
closure = "none"
[numerics]
spacing = "8 mm"
[start]
kind = "uniform"
velocity = "0.34 m/s"
[run]
until = "6 s"
)",
                      "floodplain.toml");
}

// Far from the edge the water runs as fast as the stems at each place let it: they reach through its depth,
// which over the floodplain they do from its top alone (from the bed their 60 mm would end 20 mm above it,
// and the water run 40 % faster). The bar is what rows lose that leave their order at h = 1.5 dx over a slip
// bed, 0.7 to 1.2 % (docs/vegetation.md), and some more.
TEST(StemsOnSolids, HoldTheWaterOverAFloodplainAsOverTheBed) {
    const Case c = compound_channel();
    const auto run =
        make_simulation<3>(c, nullptr, initial_particles<3>(c, make_scheme(c, nullptr), nullptr));
    double sums[2] = {};
    int counts[2] = {};
    while (run->clock().time < 6.0) {
        run->step();
        if (run->clock().time > 4.0 && run->clock().steps % 20 == 0) {
            const Particles<3>& p = run->particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (std::abs(p.position[1][i] - 0.12) > 0.08) {
                    const int half = p.position[1][i] < 0.12 ? 0 : 1;
                    sums[half] += p.velocity[0][i];
                    ++counts[half];
                }
            }
        }
    }
    for (const int half : {0, 1}) {
        const Vegetation& stems = c.vegetation[static_cast<std::size_t>(half)];
        const double exact = std::sqrt(2.0 * c.streamwise_gravity() * (1.0 - stems.solid_fraction()) /
                                       (*stems.drag_coefficient * stems.frontal_area()));
        expect_below("emergent stems on a floodplain and beside it: " + stems.name,
                     "mean velocity against sqrt(2 g S0 (1 - phi)/(C_D a)), less one", 0.015,
                     std::abs(sums[half] / counts[half] / exact - 1.0));
    }
}

}  // namespace
}  // namespace riffle::verification
