// Walls and bodies in three dimensions that two dimensions have as well: a piston, a lid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/parallel.hpp"
#include "check_run.hpp"
#include "solver/start.hpp"
#include "stl_box.hpp"
#include "temporary_folder.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

/// A tank 20 mm wide and 60 mm long, along the channel or across it, at one end of which a piston 12 mm thick
/// goes 12 mm into 40 mm of water and stops.
Case tank_with_piston(bool across) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.slope = 0.0;
    c.channel.depth = 0.04;
    c.channel.length = across ? 0.02 : 0.06;
    c.channel.width = across ? 0.06 : 0.02;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.channel.wall_height = 0.08;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.side_walls.drag_form = SideDragForm::none;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.kinematic_viscosity = 3e-4;
    c.numerics.spacing = 0.0025;
    c.numerics.sound_speed = 6.264;
    c.start.kind = StartKind::rest;
    c.run.until = RunUntil::time;
    c.run.time = 3.0;
    Solid piston;
    piston.name = "piston";
    piston.file = test::folder_of_this_process() / (across ? "across.stl" : "along.stl");
    test::write_stl_box(piston.file, {0.0, 0.0, 0.0}, {across ? 0.02 : 0.012, across ? 0.012 : 0.02, 0.07});
    piston.surface = SolidSurface::slip;
    piston.motion = SolidMotion::constant;
    (across ? piston.velocity_y : piston.velocity_x) = 0.01;
    piston.start = 0.5;
    piston.stop = 1.7;
    c.solids = {piston};
    return c;
}

// Level and bar as of the piston in the plane. Before crowds counted the walls, water that the piston had
// caught up with sank along the edges beside it, at 0.2 sqrt(gH) and more, until the run failed at 2.2 s
// (docs/theory.md, Crowds).
void push_water(bool across) {
    set_thread_count(1);
    const double exact = 0.04 * 48.0 / 36.0;
    const Case c = tank_with_piston(across);
    const std::size_t axis = across ? 1 : 0;
    const Scheme scheme = make_scheme(c, nullptr);
    const auto run = make_simulation<3>(c, nullptr, initial_particles<3>(c, scheme, nullptr));
    double still = 0.0;
    while (run->clock().time < 3.0) {
        run->step();
        if (run->clock().time < 0.5) still = largest_speed(run->particles());
    }
    const Particles<3>& p = run->particles();
    const double level = 2.0 * mass_mean(p, [&](std::size_t i) { return p.position[2][i]; });
    const double foremost = *std::min_element(p.position[axis].begin(), p.position[axis].end());
    const double wave = std::sqrt(scheme.normal_gravity * scheme.depth);
    const std::string name = across ? "piston across a channel" : "piston along a channel";
    expect_below(name, "largest velocity before it moves / sqrt(gH)", 1e-2, still / wave);
    expect_below(name, "rise of the level against the volume displaced / H", 5e-3,
                 std::abs(level - exact) / scheme.depth);
    expect_below(name, "deepest particle behind its face / dx", 1e-4,
                 (0.024 - foremost) / c.numerics.spacing);
    expect_below(name, "largest velocity 1.3 s after its stop / sqrt(gH)", 0.1, largest_speed(p) / wave);
}

// A duct of 1 mm by 1 mm, driven along it: the steady state is a series (White, Viscous Fluid Flow). Bed, lid
// and side walls hold the water, a plane of symmetry in its middle does not.
void flow_in_duct(const char* name, Sides sides, double bar) {
    set_thread_count(1);
    Case c = read_case(std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/checks/poiseuille.toml");
    c.channel.dimensions = 3;
    c.channel.width = 1e-3;
    c.channel.length = 0.4e-3;
    c.channel.sides = sides;
    c.side_walls.drag_form = SideDragForm::none;
    c.numerics.spacing = 5e-5;
    const Scheme scheme = make_scheme(c, nullptr);
    const auto run = make_simulation<3>(c, nullptr, initial_particles<3>(c, scheme, nullptr));
    while (run->clock().time < 0.6) run->step();
    const double side = c.channel.width;
    const double plates = c.streamwise_gravity() * side * side / (8.0 * c.fluid.kinematic_viscosity);
    const Particles<3>& p = run->particles();
    double largest = 0.0;
    double centre = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double y = p.position[1][i] / side - 0.5;
        const double z = p.position[2][i] / side;
        double u = 4.0 * z * (1.0 - z);
        for (int n = 1; n < 60; n += 2) {
            const double k = n * std::numbers::pi;
            u -= 32.0 / (k * k * k) * std::sin(k * z) * std::cosh(k * y) / std::cosh(0.5 * k);
        }
        largest = std::max(largest, std::abs(p.velocity[0][i] - u * plates));
        centre = std::max(centre, u * plates);
    }
    expect_below(name, "largest error of u / largest u", bar, largest / centre);
}

}  // namespace

TEST(PistonInSpace, AcrossAChannelDisplacesItsVolumeAndComesToRest) { push_water(true); }

TEST(PistonInSpace, AlongAChannelDisplacesItsVolumeAndComesToRest) { push_water(false); }

TEST(DuctInSpace, FlowsAsTheSeries) {
    flow_in_duct("duct between bed, lid and side walls", Sides::walls, 0.01);
}

// The particles behind the plane take no part in friction, so that the row beside it exchanges momentum up
// and down with half of its neighbours: 3.9 % with 20 rows, 1.8 % with 40 (docs/three-dimensions.md). Were
// the plane a wall, the water beside it would rest.
TEST(DuctInSpace, HalfOfItFlowsAsTheWhole) { flow_in_duct("half of a duct", Sides::half, 0.045); }
