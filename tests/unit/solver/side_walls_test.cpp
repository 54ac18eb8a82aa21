// Channels between side walls, over spheres at their places.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "roughness/side_wall_partition.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"
#include "solver/profile_blocks.hpp"

namespace riffle::side_walls_test {
namespace {

using test::expect_same_bits;
using Space = test::ChannelIn<3>;

/// Flow condition 2 at 4 mm, two spheres long and two rows of them wide.
Case walled_channel(Sides sides = Sides::walls) {
    Case c = test::small_channel(3);
    c.channel.dimensions = 3;
    c.channel.sides = sides;
    c.channel.length = 0.05;
    c.channel.width = 0.0433;
    c.bed.datum_below_crest = 0.004;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    return c;
}

Case disordered_channel() {
    Case c = walled_channel();
    c.start.jitter = 0.2;
    return c;
}

TEST(SideWalls, GiveTheSameBitsForAnyNumberOfThreads) {
    const auto state_after = [](int threads) {
        set_thread_count(threads);
        const Space channel(disordered_channel());
        channel.advance(40);
        EXPECT_GT(channel.simulation->clock().list_builds, 2);
        set_thread_count(0);
        return std::pair(channel.simulation->particles(),
                         channel.simulation->clock().side_wall_drag_coefficient);
    };
    const auto one = state_after(1);
    for (const int threads : {2, 3}) {
        const auto more = state_after(threads);
        expect_same_bits(one.first, more.first);
        EXPECT_EQ(one.second, more.second);
    }
    EXPECT_GT(one.second, 0.0);
}

TEST(SideWalls, GoOnFromARestoredStateWithTheSameBits) {
    test::expect_same_bits_after_resume<3>(disordered_channel(), 25, 25);
}

// Side walls carry a part of the weight: without a twin nothing tells the stress that is left above the bed.
TEST(SideWalls, LeaveNoAnalyticStressWithoutATwin) {
    const auto profiles_of = [](const Case& c, bool with_twin) {
        const Space channel(c);
        ProfileSampler sampler(c, with_twin ? &channel.column : nullptr);
        while (sampler.blocks().size() < 2) {
            channel.advance(1);
            sampler.sample(*channel.simulation);
        }
        return sampler.average(0.0, 1.0);
    };
    const Profiles walled = profiles_of(walled_channel(), false);
    EXPECT_FALSE(walled.total_stress.empty());
    EXPECT_TRUE(walled.analytic_stress.empty());
    EXPECT_FALSE(profiles_of(walled_channel(), true).analytic_stress.empty());
    EXPECT_FALSE(profiles_of(walled_channel(Sides::periodic), false).analytic_stress.empty());
}

/// Forces along x, N, of the last step.
struct Forces {
    double weight = 0.0;
    double bed = 0.0;
    double sides = 0.0;
    double wall_particles = 0.0;
    double momentum = 0.0;
};
Forces forces_of(const Space& channel) {
    const auto& p = channel.simulation->particles();
    const auto& f = channel.simulation->fields();
    Forces sum;
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum.weight += p.mass[i] * channel.simulation->scheme().streamwise_gravity;
        sum.bed += p.mass[i] * f.drag_acceleration_x[i];
        sum.sides += p.mass[i] * f.side_wall_acceleration_x[i];
        sum.wall_particles += p.mass[i] * f.wall_acceleration_x[i];
        sum.momentum += p.mass[i] * p.velocity[0][i];
    }
    return sum;
}

// The particles' momentum changes by weight, drags and wall particles alone.
TEST(SideWalls, KeepTheMomentumBudget) {
    for (const Stepping stepping : {Stepping::semi_implicit_euler, Stepping::predictor_corrector}) {
        Case c = disordered_channel();
        c.numerics.stepping = stepping;
        c.numerics.courant_number = 0.3;  // the predictor-corrector's
        const Space channel(c);
        channel.advance(10);
        double impulse = 0.0;
        double weight = 0.0;
        const double before = forces_of(channel).momentum;
        for (int i = 0; i < 30; ++i) {
            channel.advance(1);
            const Forces f = forces_of(channel);
            const double dt = channel.simulation->clock().time_step;
            weight += dt * f.weight;
            impulse += dt * (f.weight + f.bed + f.sides + f.wall_particles);
        }
        EXPECT_NEAR(forces_of(channel).momentum - before, impulse, 1e-3 * weight);
    }
}

// Each wall takes H/(k^2 W) of what the bed of the whole width takes: in the mirror's half one wall and half
// the bed, the same ratio. The coefficient is that of the step before, in which the flow changes little.
TEST(SideWalls, TakeTheirShareOfTheDrag) {
    for (const Sides sides : {Sides::walls, Sides::half}) {
        Case c = walled_channel(sides);
        c.channel.width = sides == Sides::half ? 0.0866 : 0.0433;
        const Space channel(c);
        EXPECT_GT(channel.simulation->clock().side_wall_drag_coefficient, 0.0);
        for (const int steps : {1, 30}) {
            channel.advance(steps);
            const Forces f = forces_of(channel);
            EXPECT_NEAR(f.sides / f.bed, 2.0 * side_wall_partition(c).wall_over_bed, 0.01 * f.sides / f.bed);
        }
    }
}

// What stands beyond open ends, to give the water there its neighbours, is neither held by the bed nor by the
// side walls, and has no part in what they share.
TEST(SideWalls, TakeTheirShareOfTheDragBetweenOpenEnds) {
    Case c = walled_channel(Sides::walls);
    c.channel.ends = Ends::open;
    c.channel.length = 0.1;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.3;
    c.inflow.unit_discharge = 0.3 * c.total_depth();
    c.inflow.profile = InflowProfile::uniform;
    c.outflow.kind = OutflowKind::depth;
    c.outflow.depth = c.channel.depth;
    const Space channel(c);
    channel.advance(5);
    const Forces f = forces_of(channel);
    EXPECT_NEAR(f.sides / f.bed, 2.0 * side_wall_partition(c).wall_over_bed, 0.02 * f.sides / f.bed);
}

// Walls that repel have no particles to count.
TEST(SideWalls, ThatRepelRun) {
    Case c = test::still_water(3);
    c.channel.sides = Sides::walls;
    c.numerics.wall = WallKind::repulsive;
    c.numerics.pressure_form = PressureForm::symmetric;
    const auto simulation = test::simulation_of<3>(c);
    for (int step = 0; step < 25; ++step) simulation->step();
    EXPECT_LT(test::rms_speed(simulation->particles()), 0.1);
}

TEST(SideWalls, ActInTheirLayersAlone) {
    const Case c = walled_channel(Sides::walls);
    const Space channel(c);
    channel.advance(3);
    const auto& p = channel.simulation->particles();
    const auto& f = channel.simulation->fields();
    int inside = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double d = std::min(p.position[1][i], c.channel.width - p.position[1][i]);
        if (d < 0.99 * c.side_layer()) {
            EXPECT_LT(f.side_wall_acceleration_x[i], 0.0);
            // Against the vertical motion too.
            EXPECT_LE(f.side_wall_acceleration_z[i] * p.velocity[2][i], 0.0);
            ++inside;
        } else if (d > 1.01 * c.side_layer()) {
            EXPECT_EQ(f.side_wall_acceleration_x[i], 0.0);
        }
        EXPECT_LE(f.drag_acceleration_y[i] * p.velocity[1][i], 0.0);
    }
    EXPECT_GT(inside, 100);
}

TEST(SideWalls, HaveTheirOtherForms) {
    Case c = walled_channel();
    c.side_walls.drag_form = SideDragForm::thesis;
    const Space printed(c);
    printed.advance(2);
    EXPECT_EQ(printed.simulation->clock().side_wall_drag_coefficient, printed_side_wall_coefficient(c));
    EXPECT_LT(forces_of(printed).sides, 0.0);
    c.side_walls.drag_form = SideDragForm::none;
    const Space none(c);
    none.advance(2);
    EXPECT_EQ(none.simulation->clock().side_wall_drag_coefficient, 0.0);
    EXPECT_EQ(forces_of(none).sides, 0.0);
}

// A start that is the mirror image of another about the centreline, under which a row of spheres stands, goes
// on as its mirror image, to the rounding of the positions that disorder has not yet made to grow.
TEST(SideWalls, KeepTheSymmetryOfTheChannel) {
    Case c = disordered_channel();
    c.numerics.precision = Precision::double_precision;
    const ColumnResult column = solve_column(c);
    const Particles<3> start = initial_particles<3>(c, make_scheme(c, &column), &column);
    Particles<3> mirrored = start;
    for (double& y : mirrored.position[1]) y = c.channel.width - y;
    const auto advance = [&](const Particles<3>& particles) {
        const auto simulation = make_simulation<3>(c, &column, particles);
        for (int i = 0; i < 30; ++i) simulation->step();
        return simulation->particles();
    };
    const Particles<3> a = advance(start);
    const Particles<3> b = advance(mirrored);
    const auto place = test::places_by_id<3>(b);
    double largest_across = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::size_t j = place[static_cast<std::size_t>(a.id[i])];
        EXPECT_NEAR(b.position[1][j], c.channel.width - a.position[1][i], 1e-9);
        EXPECT_NEAR(b.velocity[0][j], a.velocity[0][i], 1e-7);
        EXPECT_NEAR(b.velocity[1][j], -a.velocity[1][i], 1e-7);
        EXPECT_NEAR(b.velocity[2][j], a.velocity[2][i], 1e-7);
        largest_across = std::max(largest_across, std::abs(a.velocity[1][i]));
    }
    EXPECT_GT(largest_across, 1e-3);
}

// tau_xz = rho (nu0 + nu_t)(du/dz + dw/dx), tau_xy = rho (nu0 + A_xy nu_t)(du/dy + dv/dx), A_xy = 0.625: in
// the first step v and w are still nothing beside u.
TEST(SideWalls, ReportTheStressesOfTheClosure) {
    const Case c = walled_channel(Sides::periodic);
    const Space column(c);
    Particles<3> start = column.simulation->particles();
    const double across = 3.0;
    for (std::size_t i = 0; i < start.size(); ++i) start.velocity[0][i] += across * start.position[1][i];
    const auto simulation = make_simulation<3>(c, &column.column, start);
    simulation->step();
    const auto& p = simulation->particles();
    const auto& f = simulation->fields();
    int checked = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        // Away from the seam across, where this velocity jumps, and from the surface.
        if (std::abs(p.position[1][i] - 0.5 * c.channel.width) > 0.006 || p.position[2][i] > 0.045) continue;
        const double density = 1000.0 * (1.0 + p.density_deviation[i]);
        const double shear = density * (1e-6 + f.eddy_viscosity[i]) * f.shear[i];
        const double lateral = density * (1e-6 + 0.625 * f.eddy_viscosity[i]) * across;
        EXPECT_NEAR(f.shear_stress[i], shear, 0.01 * std::abs(shear) + 1e-6);
        EXPECT_NEAR(f.lateral_shear_stress[i], lateral, 0.02 * std::abs(lateral) + 1e-6);
        ++checked;
    }
    EXPECT_GT(checked, 100);
}

TEST(SectionStart, TakesItsVelocityOverTheCrossSection) {
    Case c = walled_channel();
    c.start.kind = StartKind::section;
    const ColumnResult column = solve_column(c);
    const Scheme scheme = make_scheme(c, &column);
    const auto flow = [](double y, double z) { return y + 10.0 * z; };
    const Particles<3> particles = initial_particles<3>(c, scheme, &column, flow);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        EXPECT_EQ(particles.velocity[0][i], flow(particles.position[1][i], particles.position[2][i]));
        EXPECT_EQ(particles.velocity[1][i], 0.0);
    }
    EXPECT_THROW(static_cast<void>(initial_particles<3>(c, scheme, &column)), InputError);
}

}  // namespace
}  // namespace riffle::side_walls_test
