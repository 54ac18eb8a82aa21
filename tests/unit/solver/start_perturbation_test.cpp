// The velocity that is added to a start: its size, its divergence, and the stress that the streaks of a
// resolved flow carry from the first moment.

#include "solver/start_perturbation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/flow_kind.hpp"
#include "small_case.hpp"
#include "solver/start_streaks.hpp"

namespace riffle::start_perturbation_test {
namespace {

/// A cell of resolved eddies, three depths long and some two wide.
Case resolved_cell(int seed) {
    Case c = test::small_channel(3);
    c.channel.length = 0.168;
    c.channel.width = 0.0888;
    c.turbulence.closure = ClosureKind::wale;
    c.start.kind = StartKind::power_law;
    c.start.velocity = 0.35;
    c.start.seed = seed;
    return c;
}

struct Moments {
    Vec<3> mean{};            ///< By mass.
    Vec<3> squares{};         ///< Mean over all particles.
    double stress_low = 0.0;  ///< Mean of -u'w' from 0.15 to 0.3 of the depth, above the crests of the bed.
    double stress_mid = 0.0;  ///< The same in the middle third.
    double largest_through = 0;  ///< Largest |w'| of the rows beside floor and surface.
};

/// What the perturbation of a case adds to its start.
Moments added(Case c) {
    const auto perturbed = test::simulation_of<3>(c)->particles();
    c.start.perturbation = 0.0;
    const auto plain = test::simulation_of<3>(c)->particles();
    Moments result;
    const auto n = perturbed.size();
    EXPECT_EQ(plain.size(), n);
    const double depth = c.total_depth();
    double low = 0.0;
    double in_the_middle = 0.0;
    double mass = 0.0;
    for (const double m : plain.mass) mass += m;
    for (std::size_t i = 0; i < n; ++i) {
        Vec<3> u{};
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = perturbed.velocity[k][i] - plain.velocity[k][i];
            result.mean[k] += plain.mass[i] / mass * u[k];
            result.squares[k] += u[k] * u[k] / static_cast<double>(n);
        }
        const double z = perturbed.position[2][i] / depth;
        if (z > 1.0 / 3.0 && z < 2.0 / 3.0) {
            in_the_middle += 1.0;
            result.stress_mid -= u[0] * u[2];
        }
        if (z > 0.15 && z < 0.3) {
            low += 1.0;
            result.stress_low -= u[0] * u[2];
        }
        if (z < 0.06 || z > 0.94) result.largest_through = std::max(result.largest_through, std::abs(u[2]));
    }
    result.stress_low /= low;
    result.stress_mid /= in_the_middle;
    return result;
}

TEST(StartPerturbation, OfResolvedEddiesCarriesTheStressOfTheFlowAtOnce) {
    for (const int seed : {1, 2, 3, 4}) {
        const Case c = resolved_cell(seed);
        const double friction_velocity = std::sqrt(c.streamwise_gravity() * c.channel.depth);
        const Moments m = added(c);
        const double energy = m.squares[0] + m.squares[1] + m.squares[2];
        EXPECT_NEAR(std::sqrt(energy / 3.0), friction_velocity, 0.1 * friction_velocity) << "seed " << seed;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(m.mean[k], 0.0, 1e-9) << "seed " << seed;
        // In uniform flow it is u*^2 (1 - z/h): less would let the water run away from the bed, which gets
        // none of its momentum, for as long as eddies take to grow.
        const double weight = friction_velocity * friction_velocity;
        EXPECT_GT(m.stress_low, 0.5 * weight) << "seed " << seed;
        EXPECT_LT(m.stress_low, 2.0 * weight) << "seed " << seed;
        EXPECT_GT(m.stress_mid, 0.5 * weight) << "seed " << seed;
        EXPECT_LT(m.stress_mid, 2.0 * weight) << "seed " << seed;
        EXPECT_LT(m.largest_through, 0.25 * friction_velocity) << "seed " << seed;
    }
}

TEST(StartPerturbation, OfOtherFlowsHasNoStreaks) {
    EXPECT_TRUE(starts_with_streaks(resolved_cell(1)));
    Case mean_flow = resolved_cell(1);
    mean_flow.turbulence.closure = ClosureKind::ramp;
    EXPECT_FALSE(starts_with_streaks(mean_flow));
    Case vortices = resolved_cell(1);
    vortices.start.kind = StartKind::taylor_green;
    EXPECT_FALSE(starts_with_streaks(vortices));
    Case tank = resolved_cell(1);
    tank.channel.ends = Ends::walls;
    EXPECT_FALSE(starts_with_streaks(tank));
}

TEST(StartStreaks, HaveNoDivergence) {
    const Case c = resolved_cell(3);
    const double depth = c.total_depth();
    const double width = c.channel.width;
    const StartStreaks streaks(c, depth, width);
    // An envelope that changes in all directions.
    const auto velocity = [&](double x, double y, double z) {
        const double a = 20.0;
        const double value = std::sin(a * x) * std::cos(1.5 * a * y) * std::sin(2.0 * a * z);
        return streaks.curl({x, y, z}, value,
                            {a * std::cos(a * x) * std::cos(1.5 * a * y) * std::sin(2.0 * a * z),
                             -1.5 * a * std::sin(a * x) * std::sin(1.5 * a * y) * std::sin(2.0 * a * z),
                             2.0 * a * std::sin(a * x) * std::cos(1.5 * a * y) * std::cos(2.0 * a * z)});
    };
    const double d = 1e-6;
    for (int k = 0; k < 40; ++k) {
        const double x = 0.0041 * k;
        const double y = 0.0023 * k;
        const double z = 0.0013 * k;
        const double along = (velocity(x + d, y, z)[0] - velocity(x - d, y, z)[0]) / (2.0 * d);
        const double across = (velocity(x, y + d, z)[1] - velocity(x, y - d, z)[1]) / (2.0 * d);
        const double up = (velocity(x, y, z + d)[2] - velocity(x, y, z - d)[2]) / (2.0 * d);
        EXPECT_NEAR(along + across + up, 0.0,
                    1e-5 * (std::abs(along) + std::abs(across) + std::abs(up) + 1.0));
    }
    // The same at both ends and sides, which are periodic.
    const auto here = streaks.curl({0.01, 0.02, 0.03}, 1.0, {});
    const auto there = streaks.curl({0.01 + c.channel.length, 0.02 - width, 0.03}, 1.0, {});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(here[k], there[k], 1e-12);
}

}  // namespace
}  // namespace riffle::start_perturbation_test
