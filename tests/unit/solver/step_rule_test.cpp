// The time step of Monaghan & Kos (1999; thesis 2.53) against its formula, over all pairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/scheme.hpp"
#include "small_case.hpp"

namespace riffle::step_rule_test {
namespace {

using test::Channel;
using test::small_channel;

/// Largest |h u.r / (r^2 + 0.01 h^2)| of all pairs nearer than 2h, periodic along x.
double largest_approach(const Particles<2>& p, double length, double h) {
    double largest = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double x = std::remainder(p.position[0][i] - p.position[0][j], length);
            const double z = p.position[1][i] - p.position[1][j];
            const double squared = x * x + z * z;
            if (squared < 4.0 * h * h) {
                const double along =
                    (p.velocity[0][i] - p.velocity[0][j]) * x + (p.velocity[1][i] - p.velocity[1][j]) * z;
                largest = std::max(largest, h * std::abs(along) / (squared + 0.01 * h * h));
            }
        }
    }
    return largest;
}

TEST(StepRule, OfMonaghanAndKosFollowsItsFormula) {
    Case c = small_channel();
    c.start.jitter = 0.2;
    c.numerics.sound_speed = 5.0;  // so that the pairs' velocities are felt
    c.numerics.step_rule = StepRule::monaghan_kos;
    const Channel channel(c);
    const Scheme scheme = make_scheme(c, &channel.column);
    const double h = scheme.smoothing_length;
    for (int step = 0; step < 20; ++step) {
        const double approach = largest_approach(channel.simulation->particles(), c.channel.length, h);
        const double acceleration = channel.simulation->clock().largest_acceleration;
        channel.advance(1);
        const double acoustic = h / (5.0 + approach);
        const double of_forces =
            acceleration > 0.0 ? std::sqrt(h / acceleration) : std::numeric_limits<double>::infinity();
        // The pairs' velocities are kept in single precision.
        EXPECT_NEAR(channel.simulation->clock().time_step,
                    c.numerics.courant_number * std::min(acoustic, of_forces), 1e-6 * h);
        EXPECT_GT(approach, 0.01);
    }
}

}  // namespace
}  // namespace riffle::step_rule_test
