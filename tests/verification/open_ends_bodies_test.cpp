// Free bodies between open ends: they drift with the stream and are held back before the ends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "boundary/body_racks.hpp"
#include "drifting_log.hpp"
#include "open_run.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;

struct Drift : test::OpenRun<2> {
    using OpenRun::OpenRun;
    [[nodiscard]] const FreeBodyState& log() const { return simulation->clock().free_bodies.front(); }
};

// With a stream of one velocity all over a body goes as fast as the water: nothing brakes or pushes it.
TEST(OpenEndsBodies, ALogDriftsWithTheStream) {
    Drift drift(test::drifting_log(0.3));
    drift.advance_to(0.1);
    const double from = drift.log().displacement[0];
    drift.advance_to(0.6);
    EXPECT_NEAR((drift.log().displacement[0] - from) / 0.5, 0.3, 0.02 * 0.3);
    // Half in the water, as Archimedes has it.
    EXPECT_NEAR(drift.log().displacement[2], 0.0, 0.05 * 0.02);
    EXPECT_TRUE(drift.simulation->particles().lost.empty());
}

/// Velocity of the stream from which on a floating block of this thickness and relative density is turned
/// under where it is held (Ashton 1974), m/s.
double underturning_velocity(double thickness, double depth, double density) {
    const double gap = 1.0 - thickness / depth;
    return 2.0 * gap / std::sqrt(5.0 - 3.0 * gap * gap) * std::sqrt(9.81 * thickness * (1.0 - density));
}

// Before the outflow it is held, afloat in a stream slower than that which turns it under, and the water goes
// on.
TEST(OpenEndsBodies, ALogIsHeldBeforeTheOutflow) {
    constexpr double velocity = 0.15;
    ASSERT_LT(velocity, 0.75 * underturning_velocity(0.02, 0.06, 0.5));
    Drift drift(test::drifting_log(velocity));
    const auto racks = body_racks(drift.c);
    ASSERT_EQ(racks.size(), 2U);
    RackWatch watch(drift.c);
    const auto news = [&] {
        return watch.news(drift.simulation->clock().time, drift.simulation->clock().free_bodies);
    };
    drift.advance_to(1.2);
    EXPECT_TRUE(news().empty());
    drift.advance_to(4.0);
    const double front = 0.12 + drift.log().displacement[0];
    EXPECT_NEAR(front, racks[1].place, drift.c.numerics.spacing);
    EXPECT_LT(std::abs(drift.log().velocity[0]), 0.1 * velocity);
    const auto told = news();
    ASSERT_EQ(told.size(), 1U);
    EXPECT_THAT(told.front(), HasSubstr("\"log\" has come to the rack at x = 376 mm before the outflow"));
    EXPECT_TRUE(news().empty());
    EXPECT_TRUE(drift.simulation->particles().lost.empty());
}

// A faster stream turns it under, until it stands upright at the rack.
TEST(OpenEndsBodies, AFastStreamTurnsALogUnder) {
    constexpr double velocity = 0.3;
    ASSERT_GT(velocity, 1.3 * underturning_velocity(0.02, 0.06, 0.5));
    Drift drift(test::drifting_log(velocity));
    drift.advance_to(2.0);
    const BodyState state = WallMotion(drift.c).at(2.0, drift.simulation->clock().free_bodies)[first_solid];
    EXPECT_GT(std::abs(state.turned({1.0, 0.0, 0.0})[2]), 0.9);
}

}  // namespace
}  // namespace riffle
