#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "base/parallel.hpp"
#include "check_run.hpp"
#include "column/column.hpp"
#include "particles/lattice.hpp"
#include "solver/start.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

Case rough_bed(const std::vector<Override>& overrides) {
    return read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/rough-bed-2d/condition-2.toml", overrides);
}

/// Particles after some steps with a number of threads.
Particles<2> after_steps(const Case& c, int threads, int steps) {
    set_thread_count(threads);
    const ColumnResult column = solve_column(c);
    const auto simulation =
        make_simulation(c, &column, initial_particles(c, make_scheme(c, &column), &column));
    for (int i = 0; i < steps; ++i) simulation->step();
    set_thread_count(1);
    return simulation->particles();
}

}  // namespace

// 300 steps of the stirred channel, a dozen list builds: the same bits for 1, 2 and 3 threads.
TEST(Scheme, GivesTheSameBitsForAnyNumberOfThreads) {
    for (const char* precision : {"single", "double"}) {
        const Case c = rough_bed({{"stirring.acceleration", "0.3"}, {"numerics.precision", precision}});
        const Particles<2> one = after_steps(c, 1, 300);
        for (const int threads : {2, 3}) {
            const Particles<2> more = after_steps(c, threads, 300);
            EXPECT_EQ(one.position, more.position) << threads << " threads, " << precision;
            EXPECT_EQ(one.velocity, more.velocity) << threads << " threads, " << precision;
            EXPECT_EQ(one.density_deviation, more.density_deviation) << threads << " threads, " << precision;
            EXPECT_EQ(one.id, more.id) << threads << " threads, " << precision;
        }
    }
}

// Single precision against double: the pair arithmetic in float costs no more than its rounding. After 20
// steps (before disorder amplifies differences) velocities agree to 1e-5 of the surface velocity.
TEST(Scheme, SinglePrecisionFollowsDouble) {
    const Particles<2> a = after_steps(rough_bed({{"numerics.precision", "single"}}), 1, 20);
    const Particles<2> b = after_steps(rough_bed({{"numerics.precision", "double"}}), 1, 20);
    ASSERT_EQ(a.id, b.id);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            largest = std::max(largest, std::abs(a.velocity[k][i] - b.velocity[k][i]));
        }
    }
    EXPECT_LT(largest, 1e-5 * 0.45);
    EXPECT_GT(largest, 0.0);
}

// The velocity of a no-slip wall continues a linear profile through zero at the wall's surface, so that such
// a profile feels no viscous force: u = z between plates, rows beside the lower wall, in units of nu gamma /
// spacing.
TEST(NoSlipWall, IsExactForALinearProfile) {
    const Case c = read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/checks/poiseuille.toml",
                             {{"numerics.precision", "double"}, {"numerics.pressure_form", "symmetric"}});
    set_thread_count(1);
    const ColumnResult column = solve_column(c);
    Particles<2> particles = initial_particles(c, make_scheme(c, &column), &column);
    const double shear = 1e-3;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles.velocity[0][i] = shear * particles.position[1][i];
    }
    const auto simulation = make_simulation(c, &column, std::move(particles));
    simulation->step();
    const double unit = c.fluid.kinematic_viscosity * shear / c.numerics.spacing;
    double lower = 0.0;
    double upper = 0.0;
    for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
        const double force = std::abs(simulation->fields().viscous_acceleration_x[i]) / unit;
        (simulation->particles().position[1][i] < 0.5 * c.total_depth() ? lower : upper) =
            std::max(simulation->particles().position[1][i] < 0.5 * c.total_depth() ? lower : upper, force);
    }
    // Positions are rounded to 2^-31 of the domain, 7e-8 spacings here.
    EXPECT_LT(lower, 1e-6);
    EXPECT_GT(upper, 1.0);  // the upper wall, which does not move with the profile, does brake it
}

// A particle that leaves the domain or a state that is no number stops the run and says where.
TEST(Scheme, StopsAtANonsensicalState) {
    const Case c = rough_bed({});
    const ColumnResult column = solve_column(c);
    Particles<2> particles = initial_particles(c, make_scheme(c, &column), &column);
    particles.velocity[1][17] = std::numeric_limits<double>::quiet_NaN();
    try {
        const auto simulation = make_simulation(c, &column, std::move(particles));
        simulation->step();
        FAIL() << "the run went on";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("particle 17"), std::string::npos) << error.what();
    }
}
