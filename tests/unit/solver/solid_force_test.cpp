// Forces of the water on each solid, and what the results say of solids and walls.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "output/results_file.hpp"
#include "small_case.hpp"
#include "solver/boundary_content.hpp"
#include "solver/snapshots.hpp"
#include "written_checkpoint.hpp"

namespace riffle::solid_force_test {
namespace {

/// Still water, 50 mm deep, over two blocks on the floor of a tank: 20 and 30 mm long, 20 and 10 mm high.
Case tank_with_blocks() {
    Case c;
    c.channel.depth = 0.05;
    c.channel.length = 0.12;
    c.channel.ends = Ends::walls;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.numerics.spacing = 0.0025;
    c.start.kind = StartKind::rest;
    c.solids = {test::rectangle("first", 0.02, 0.04, 0.0, 0.02),
                test::rectangle("second", 0.07, 0.1, 0.0, 0.01)};
    return c;
}

std::unique_ptr<Simulation> started(const Case& c) {
    auto simulation = test::simulation_of<2>(c);
    simulation->step();
    return simulation;
}

TEST(SolidForce, OfStillWaterIsTheWeightAboveEach) {
    const Case c = tank_with_blocks();
    const auto simulation = started(c);
    const std::vector<ForceOnSolid>& forces = simulation->solid_forces();
    ASSERT_EQ(forces.size(), 2U);
    const double weight = c.fluid.density * c.fluid.gravity;
    // Pressures on faces resolved by eight and twelve particles: a few percent of them.
    EXPECT_NEAR(forces[0].pressure[2], -weight * 0.03 * 0.02, 0.06 * weight * 0.03 * 0.02);
    EXPECT_NEAR(forces[1].pressure[2], -weight * 0.04 * 0.03, 0.06 * weight * 0.04 * 0.03);
    for (const ForceOnSolid& force : forces) {
        EXPECT_NEAR(force.pressure[0], 0.0, 0.01 * weight * 0.05 * 0.05);
        EXPECT_EQ(force.friction[0], 0.0);  // slip faces
        EXPECT_EQ(force.pressure[1], 0.0);
    }
}

// The particles of bed and side walls behind the foot of a gate push along them for it: without that share of
// the corners a gate under twenty rows lacks 2.7 % of its force.
TEST(SolidForce, OnAGateThatStandsOnTheBedIsThatOfItsPressure) {
    Case c = tank_with_blocks();
    c.solids = {test::rectangle("gate", 0.02, 0.05, 0.0, 0.08)};
    const double weight = c.fluid.density * c.fluid.gravity;
    const double left = started(c)->solid_forces()[0].pressure[0];
    EXPECT_NEAR(left, 0.0, 2e-3 * 0.5 * weight * 0.05 * 0.05);  // water on both sides
    c.start.water_x = {0.05, 0.12, 0.12, 0.05};
    c.start.water_z = {0.0, 0.0, 0.05, 0.05};
    const ForceOnSolid force = started(c)->solid_forces()[0];
    const double pressure = 0.5 * weight * 0.05 * 0.05;
    EXPECT_NEAR(force.pressure[0], -pressure, 5e-3 * pressure);
    EXPECT_NEAR(force.pressure[2], 0.0, 5e-3 * pressure);
}

// Through the thin toes of slopes the particles of the bed carry the water over them: without that share a
// hill of five spacings lacks 20 % of what lies on it.
TEST(SolidForce, OnSlopesWithThinToesIsThatOfTheirPressure) {
    Case c = tank_with_blocks();
    c.channel.depth = 0.1;
    c.channel.length = 0.8;
    c.numerics.spacing = 0.01;
    c.solids = {test::rectangle("hill", 0.2, 0.6, 0.0, 0.05), test::rectangle("beach", 0.65, 0.8, 0.0, 0.05)};
    c.solids[0].x = {0.2, 0.6, 0.4};
    c.solids[0].z = {0.0, 0.0, 0.05};
    c.solids[1].x = {0.65, 0.8, 0.8};
    c.solids[1].z = {0.0, 0.0, 0.05};
    const auto simulation = test::simulation_of<2>(c);
    // Sound goes to and fro at first: means over some of its periods.
    std::array<std::array<double, 3>, 2> force{};
    constexpr int steps = 400;
    for (int step = 0; step < 2 * steps; ++step) {
        simulation->step();
        if (step < steps) continue;
        ASSERT_EQ(simulation->solid_forces().size(), 2U);
        for (std::size_t solid = 0; solid < 2; ++solid) {
            for (std::size_t k = 0; k < 3; ++k) {
                force[solid][k] += simulation->solid_forces()[solid].pressure[k] / steps;
            }
        }
    }
    const double weight = c.fluid.density * c.fluid.gravity;
    const double on_hill = weight * 0.4 * (0.1 - 0.025);
    const double on_beach = weight * 0.15 * (0.1 - 0.025);
    const double along_beach = weight * 0.05 * (0.1 - 0.025);
    // The faces are five spacings high, and what presses on them goes up and down by 1 to 2 %.
    EXPECT_NEAR(force[0][2], -on_hill, 0.02 * on_hill);
    EXPECT_NEAR(force[1][2], -on_beach, 0.03 * on_beach);
    EXPECT_NEAR(force[1][0], along_beach, 0.03 * along_beach);
    EXPECT_NEAR(force[0][0], 0.0, 0.04 * along_beach);
}

TEST(SolidForce, OnAGateFromSideToSideIsThatOfItsPressure) {
    Case c = test::still_water(3);
    c.channel.dimensions = 3;
    c.channel.depth = 0.05;
    c.channel.length = 0.12;
    c.channel.width = 0.05;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.side_walls.drag_form = SideDragForm::none;
    c.bed.kind = BedKind::slip;
    c.numerics.spacing = 0.0025;
    c.start.water_x = {0.05, 0.12, 0.12, 0.05};
    c.start.water_z = {0.0, 0.0, 0.05, 0.05};
    Solid gate;
    gate.name = "gate";
    gate.shape = SolidShape::box;
    gate.centre = {0.035, 0.025, 0.04};
    gate.size = {0.03, 0.05, 0.08};
    gate.surface = SolidSurface::slip;
    c.solids = {gate};
    const auto simulation = test::simulation_of<3>(c);
    simulation->step();
    const ForceOnSolid& force = simulation->solid_forces()[0];
    const double pressure = 0.5 * c.fluid.density * c.fluid.gravity * 0.05 * 0.05 * 0.05;
    EXPECT_NEAR(force.pressure[0], -pressure, 0.01 * pressure);
    EXPECT_NEAR(force.pressure[1], 0.0, 0.01 * pressure);
    EXPECT_NEAR(force.pressure[2], 0.0, 0.01 * pressure);
}

TEST(SolidForce, MomentsOfStillWaterAreThoseOfItsPressure) {
    // The first block leans on the end wall: water on its top and on its right face alone.
    Case c = tank_with_blocks();
    c.solids[0].x = {0.0, 0.04, 0.04, 0.0};
    c.solids[0].moment_about = {0.0, 0.0};
    const auto simulation = started(c);
    const std::vector<ForceOnSolid>& forces = simulation->solid_forces();
    ASSERT_EQ(forces.size(), 2U);
    const double weight = c.fluid.density * c.fluid.gravity;
    const double depth = 0.05;
    const double height = 0.02;
    const double on_top = weight * (depth - height) * 0.04;
    const double on_side = weight * (depth * height - height * height / 2.0);
    EXPECT_NEAR(forces[0].pressure[0], -on_side, 0.05 * on_side);
    // About y: z F_x - x F_z. As exact as the forces above.
    const double side_moment = weight * (depth * height * height / 2.0 - height * height * height / 3.0);
    EXPECT_NEAR(forces[0].pressure_moment[1], 0.02 * on_top - side_moment, 0.05 * 0.02 * on_top);
    // The second one's about its centroid: its sides balance, and its top has the middle there.
    EXPECT_NEAR(forces[1].pressure_moment[1], 0.0, 0.01 * weight * 0.04 * 0.03 * 0.03);
    for (const ForceOnSolid& force : forces) {
        EXPECT_EQ(force.pressure_moment[0], 0.0);
        EXPECT_EQ(force.pressure_moment[2], 0.0);
        EXPECT_EQ(force.friction_moment[1], 0.0);  // slip faces
    }
}

TEST(SolidForce, OfAllWallsAsSolidsIsTheForceOfTheWalls) {
    // Two blocks that cover the whole bed, which no water reaches: what they bear is all that the walls bear.
    Case c = tank_with_blocks();
    c.channel.ends = Ends::periodic;
    c.solids = {test::rectangle("first", 0.0, 0.05, 0.0, 0.02),
                test::rectangle("second", 0.05, 0.12, 0.0, 0.02)};
    for (Solid& solid : c.solids) solid.surface = SolidSurface::no_slip;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.1;
    const auto simulation = started(c);
    const std::vector<ForceOnSolid>& forces = simulation->solid_forces();
    ASSERT_EQ(forces.size(), 2U);
    const ParticleFields& fields = simulation->fields();
    const auto& mass = simulation->particles().mass;
    double along = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        along -= mass[i] * fields.wall_acceleration_x[i];
        down -= mass[i] * fields.wall_acceleration_z[i];
    }
    const auto sum = [&](std::size_t axis) {
        return forces[0].pressure[axis] + forces[0].friction[axis] + forces[1].pressure[axis] +
               forces[1].friction[axis];
    };
    // To the rounding of sums in single precision.
    EXPECT_NEAR(sum(0), along, 1e-4 * std::abs(along));
    EXPECT_NEAR(sum(2), down, 1e-4 * std::abs(down));
    const double weight = c.fluid.density * c.fluid.gravity * 0.03 * c.channel.length;
    EXPECT_NEAR(down, -weight, 0.05 * weight);
    EXPECT_GT(forces[0].friction[0], 0.0);
    EXPECT_NEAR(forces[0].friction[0] / forces[1].friction[0], 5.0 / 7.0, 0.05);
}

const Dataset& dataset(const Content& content, const std::string& path) {
    for (const Dataset& each : content.datasets) {
        if (each.path == path) return each;
    }
    throw std::logic_error("no dataset " + path);
}

// Water that runs into a block comes through its face and is put back: what that takes from its momentum is a
// part of the forces that are recorded, so that they are its change.
// Through gravel water presses a wall as much as without it: between two pools of one level nothing is left.
TEST(SolidForce, OnAWallBesideGravelIsThatOfOpenWater) {
    Case c = tank_with_blocks();
    c.solids = {test::rectangle("wall", 0.05, 0.07, 0.0, 0.08)};
    Porous gravel;
    gravel.name = "gravel";
    gravel.porosity = 0.4;
    gravel.grain_size = 0.005;
    gravel.x_from = 0.07;
    c.porous = {gravel};
    const auto simulation = test::simulation_of<2>(c);
    double force = 0.0;
    constexpr int steps = 300;
    for (int step = 0; step < 2 * steps; ++step) {
        simulation->step();
        if (step >= steps) force += simulation->solid_forces()[0].pressure[0] / steps;
    }
    const double pressure = 0.5 * c.fluid.density * c.fluid.gravity * 0.05 * 0.05;
    EXPECT_NEAR(force, 0.0, 0.02 * pressure);
}

// What lies on a sill that carries the water through open ends is that of the channel, not of the buffers.
TEST(SolidForce, OnASillThroughOpenEndsIsThatOfTheChannel) {
    Case c = test::still_water();
    c.channel.length = 0.2;
    c.channel.depth = 0.06;
    c.channel.ends = Ends::open;
    c.inflow.unit_discharge = 1e-6;
    c.inflow.profile = InflowProfile::uniform;
    c.outflow.kind = OutflowKind::depth;
    c.outflow.depth = 0.04;  // over the sill
    c.solids = {test::rectangle("sill", -0.2, 0.4, 0.0, 0.02)};
    const auto simulation = test::simulation_of<2>(c);
    simulation->step();
    const double weight = c.fluid.density * c.fluid.gravity * 0.04 * c.channel.length;
    EXPECT_NEAR(simulation->solid_forces()[0].pressure[2], -weight, 0.06 * weight);
}

/// A bar that swings in still water of a periodic channel, its axis at `x`, after some steps.
ForceOnSolid on_swinging_bar(double x, SolidSurface surface) {
    Case c = test::still_water();
    c.channel.length = 0.12;
    c.channel.depth = 0.06;
    c.numerics.spacing = 0.0025;
    c.fluid.kinematic_viscosity = 1e-4;
    Solid bar = test::rectangle("bar", x - 0.02, x + 0.02, 0.025, 0.035);
    bar.surface = surface;
    bar.equivalent_roughness = 1e-4;
    bar.motion = SolidMotion::oscillating;
    bar.frequency = 2.0;
    bar.amplitude_angle = 20.0;
    c.solids = {bar};
    const auto simulation = test::simulation_of<2>(c);
    for (int step = 0; step < 120; ++step) simulation->step();
    return simulation->solid_forces()[0];
}

// Where the channel begins is a matter of drawing: a bar across its ends feels what one in its middle does.
TEST(SolidForce, OnABarThatSwingsAcrossPeriodicEndsIsThatInTheMiddle) {
    for (const SolidSurface surface : {SolidSurface::no_slip, SolidSurface::log_law}) {
        const ForceOnSolid middle = on_swinging_bar(0.06, surface);
        const ForceOnSolid ends = on_swinging_bar(0.0, surface);
        const double scale = std::abs(middle.pressure_moment[1]) + std::abs(middle.friction_moment[1]);
        EXPECT_GT(scale, 0.0);
        EXPECT_NEAR(ends.pressure_moment[1], middle.pressure_moment[1], 0.02 * scale);
        EXPECT_NEAR(ends.friction_moment[1], middle.friction_moment[1], 0.02 * scale);
        EXPECT_NEAR(ends.pressure[2], middle.pressure[2], 0.01 * std::abs(middle.pressure[2]));
    }
}

TEST(SolidForce, OfContactIsInTheChangeOfTheMomentum) {
    Case c = tank_with_blocks();
    c.channel.ends = Ends::periodic;
    c.channel.slope = 0.01;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 2.0;
    c.numerics.stepping = Stepping::semi_implicit_euler;
    const auto simulation = started(c);
    const auto momentum = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
            sum += simulation->particles().mass[i] * simulation->particles().velocity[0][i];
        }
        return sum;
    };
    const double mass =
        std::accumulate(simulation->particles().mass.begin(), simulation->particles().mass.end(), 0.0);
    double impulse = 0.0;
    const double before = momentum();
    double largest = 0.0;
    for (int step = 0; step < 80; ++step) {
        simulation->step(0.0);
        const ParticleFields& f = simulation->fields();
        double force = mass * simulation->scheme().streamwise_gravity;
        for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
            force +=
                simulation->particles().mass[i] * (f.pair_acceleration_x[i] + f.viscous_acceleration_x[i]);
        }
        impulse += force * simulation->clock().time_step;
        largest = std::max(largest, std::abs(force));
    }
    EXPECT_GT(largest, 1.0);  // N/m: it does run into them
    EXPECT_NEAR(impulse, momentum() - before, 1e-9 * std::abs(before));
}

// Water in flight that hits an edge far above the floor: all that pushes it is that solid, what it puts back
// too.
TEST(SolidForce, OfContactIsInTheForceOnTheSolid) {
    Case c = tank_with_blocks();
    c.channel.ends = Ends::periodic;
    c.channel.depth = 0.08;
    c.solids = {test::rectangle("edge", 0.07, 0.09, 0.04, 0.05)};
    c.solids[0].x = {0.07, 0.09, 0.09};
    c.solids[0].z = {0.0437, 0.04, 0.05};
    c.start.kind = StartKind::uniform;
    c.start.velocity = 2.0;
    c.start.water_x = {0.045, 0.065, 0.065, 0.045};
    c.start.water_z = {0.03, 0.03, 0.06, 0.06};
    const auto simulation = started(c);
    double on_solid = 0.0;
    double on_walls = 0.0;
    for (int step = 0; step < 200; ++step) {
        simulation->step(0.0);
        const ParticleFields& f = simulation->fields();
        const ForceOnSolid& solid = simulation->solid_forces().front();
        on_solid += solid.pressure[0] + solid.friction[0];
        for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
            on_walls -= simulation->particles().mass[i] * f.wall_acceleration_x[i];
        }
    }
    EXPECT_GT(on_walls, 200 * 1.0);  // N/m
    EXPECT_NEAR(on_solid, on_walls, 1e-5 * on_walls);
}

TEST(Boundaries, OutlinesStandWhereTheCaseHasThemAndMoveWithTheirMotion) {
    Case c = tank_with_blocks();
    c.solids[1].motion = SolidMotion::constant;
    c.solids[1].velocity_z = 0.1;
    c.solids[1].start = 0.5;
    const BoundaryContent boundaries(c);
    EXPECT_EQ(boundaries.vertices(), 8U);
    EXPECT_EQ(boundaries.corners(), (std::vector<std::size_t>{4, 4}));
    EXPECT_TRUE(boundaries.moves());
    Content content;
    boundaries.add(content);
    const auto& start = std::get<std::vector<float>>(dataset(content, "/boundaries/solids/vertices").values);
    EXPECT_FLOAT_EQ(start[3 * 1], 0.04F);
    Content later;
    boundaries.add_moved(later, "/snapshots/00007", 0.7);
    const auto& moved =
        std::get<std::vector<float>>(dataset(later, "/snapshots/00007/solid_vertices").values);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const float rise = corner < 4 ? 0.0F : 0.02F;  // 0.1 m/s for 0.2 s
        EXPECT_FLOAT_EQ(moved[3 * corner], start[3 * corner]);
        EXPECT_NEAR(moved[3 * corner + 2], start[3 * corner + 2] + rise, 1e-6F);
    }
    const auto& bodies =
        std::get<std::vector<std::int32_t>>(dataset(content, "/boundaries/walls/body").values);
    const auto& walls = std::get<std::vector<float>>(dataset(later, "/snapshots/00007/wall_position").values);
    ASSERT_EQ(walls.size(), 3 * bodies.size());
    EXPECT_GT(std::count(bodies.begin(), bodies.end(), first_solid + 1), 0);
}

TEST(Snapshots, TheLastStateIsKeptAndForgottenOnResume) {
    const Case c = tank_with_blocks();
    const auto simulation = started(c);
    SnapshotRecorder snapshots(c);
    snapshots.record(*simulation);
    snapshots.record_last(*simulation);  // the same instant: nothing to add
    EXPECT_EQ(snapshots.entries().size(), 1U);
    simulation->step();
    snapshots.record_last(*simulation);
    ASSERT_EQ(snapshots.entries().size(), 2U);
    EXPECT_EQ(snapshots.entries().back().time, simulation->clock().time);
    Content checkpoint;
    snapshots.save(checkpoint);
    SnapshotRecorder resumed(c);
    resumed.restore(test::WrittenCheckpoint(checkpoint).reader());
    EXPECT_EQ(resumed.entries().size(), 1U);
}

}  // namespace
}  // namespace riffle::solid_force_test
