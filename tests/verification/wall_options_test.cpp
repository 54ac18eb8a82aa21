// The kinds of walls other than dummy particles, in flows with exact solutions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact_flows.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

struct StillWater {
    double speed = 0.0;            ///< largest speed of any particle at the end over sqrt(g H)
    double level = 0.0;            ///< twice the height of the centre of mass over H, less 1
    double pressure = 0.0;         ///< rms of p - rho g (H - z) over rho g H, more than 2h below the surface
    double nearest = 0.0;          ///< of a particle to bed or end wall, spacings; negative: behind it
    double weight_on_walls = 0.0;  ///< vertical force of the walls over the weight, less 1
    double force_along = 0.0;      ///< sum of the forces of the end walls over the weight
};

StillWater still_tank(double time, const std::vector<Override>& overrides) {
    // The density at a ghost node is not smoothed, so these walls need the diffusion that the case leaves
    // out.
    std::vector<Override> all{{"numerics.density_diffusion", "fourtakas"}};
    all.insert(all.end(), overrides.begin(), overrides.end());
    CheckRun run("hydrostatic-tank", all);
    run.advance_to(time);
    const Particles<2>& p = run.particles();
    const Scheme& scheme = run.simulation().scheme();
    const ParticleFields& fields = run.simulation().fields();
    const double length = run.parameters().channel.length;
    StillWater water;
    water.speed = largest_speed(p) / std::sqrt(scheme.normal_gravity * scheme.depth);
    water.level = 2.0 * mass_mean(p, [&](std::size_t i) { return p.position[1][i]; }) / scheme.depth - 1.0;
    water.nearest = length;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = p.position[0][i];
        const double z = p.position[1][i];
        water.nearest = std::min({water.nearest, z, x, length - x});
    }
    water.pressure = hydrostatic_error(run);
    water.nearest /= run.parameters().numerics.spacing;
    const auto wall_force = [&](const SparseValues& acceleration) {
        return mass_mean(p, [&](std::size_t i) { return acceleration[i]; }) / scheme.normal_gravity;
    };
    water.weight_on_walls = wall_force(fields.wall_acceleration_z) - 1.0;
    water.force_along = wall_force(fields.wall_acceleration_x);
    return water;
}

}  // namespace

// As HydrostaticTank.StaysAtRest: at the ghost nodes water at rest is met exactly, corners included.
TEST(ModifiedDynamicWalls, HoldStillWater) {
    const StillWater water = still_tank(5.0, {{"numerics.wall", "modified-dynamic"}});
    expect_below("tank, modified-dynamic", "largest velocity at 5 s / sqrt(gH)", 1e-4, water.speed);
    expect_below("tank, modified-dynamic", "change of level / H", 5e-3, std::abs(water.level));
    expect_below("tank, modified-dynamic", "rms of p - rho g (H - z) / (rho g H)", 0.01, water.pressure);
}

TEST(ModifiedDynamicWalls, FollowPoiseuille) {
    CheckRun run("poiseuille", {{"numerics.wall", "modified-dynamic"}});
    const double nu = run.parameters().fluid.kinematic_viscosity;
    const double width = run.parameters().total_depth();
    const double force = run.parameters().streamwise_gravity();
    const auto exact = [&](double z) { return start_up_poiseuille(force, nu, width, z, run.time()); };
    double largest = 0.0;
    for (int sample = 1; sample <= 20; ++sample) {
        run.advance_to(0.05 * sample * width * width / nu);
        largest = std::max(largest, profile_error(run, exact).largest);
    }
    expect_below("Poiseuille, modified-dynamic", "largest error of u / U_max", 0.01,
                 largest / (force * width * width / (8.0 * nu)));
}

const std::vector<Override> repulsive{{"numerics.wall", "repulsive"},
                                      {"numerics.pressure_form", "symmetric"}};

// On a bed they hold the water and its weight, a part of the spacing above the place of a dummy wall.
TEST(RepulsiveWalls, HoldStillWater) {
    std::vector<Override> bed = repulsive;
    bed.push_back({"channel.ends", "periodic"});
    const StillWater water = still_tank(5.0, bed);
    expect_below("still water, repulsive bed", "largest velocity at 5 s / sqrt(gH)", 0.01, water.speed);
    expect_below("still water, repulsive bed", "change of level / H", 0.01, std::abs(water.level));
    expect_below("still water, repulsive bed", "rms of p - rho g (H - z) / (rho g H)", 0.05, water.pressure);
    expect_below("still water, repulsive bed", "force on the bed over the weight, less 1", 0.01,
                 std::abs(water.weight_on_walls));
    EXPECT_GT(water.nearest, 0.0) << "nothing leaks";
}

// The force of an end wall grows with depth and falls with distance: it has no potential, and stirs the water
// beside it. It holds it none the less, and what it pushes with is counted.
TEST(RepulsiveWalls, HoldATank) {
    const StillWater water = still_tank(5.0, repulsive);
    expect_below("tank, repulsive", "largest velocity at 5 s / sqrt(gH)", 0.2, water.speed);
    expect_below("tank, repulsive", "change of level / H", 0.02, std::abs(water.level));
    expect_below("tank, repulsive", "force on the bed over the weight, less 1", 0.05,
                 std::abs(water.weight_on_walls));
    expect_below("tank, repulsive", "force of both end walls over the weight", 0.05,
                 std::abs(water.force_along));
    EXPECT_GT(water.nearest, 0.0) << "nothing leaks";
}
