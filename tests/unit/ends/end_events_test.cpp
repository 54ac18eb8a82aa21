#include "ends/end_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riffle::end_events_test {
namespace {

constexpr double gravity = 9.81;
constexpr double film = 0.002;

OpenEndsState ends(double depth_in, double velocity_in, double watched_in, double depth_out,
                   double velocity_out) {
    OpenEndsState state;
    state.begun = true;
    state.upstream.depth = depth_in;
    state.upstream.velocity = velocity_in;
    state.upstream.watched_depth = watched_in;
    state.downstream.depth = depth_out;
    state.downstream.watched_depth = depth_out;
    state.downstream.velocity = velocity_out;
    return state;
}

TEST(EndEvents, AChannelThatFlowsHasNone) {
    EndEvents events(gravity, film, false);
    EXPECT_TRUE(events.news(OpenEndsState{}, 0.0).empty());
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.05, 0.05, 0.3), 0.0).empty());
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.09, 0.05, 0.0), 1.0).empty());   // a level that rises
    EXPECT_TRUE(events.news(ends(0.02, 1.4, 0.022, 0.07, 0.4), 2.0).empty());  // shooting
}

TEST(EndEvents, AnOutflowThatRunsDryIsToldOnceAndThatWaterComesBack) {
    EndEvents events(gravity, film, false);
    // A bed that was dry from the beginning has not run dry.
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.05, 0.0, 0.0), 0.0).empty());
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.05, 0.03, 0.3), 1.0).empty());
    EXPECT_THAT(events.news(ends(0.05, 0.3, 0.05, 0.001, 0.3), 2.0),
                testing::ElementsAre(testing::HasSubstr("the outflow ran dry at t = 2 s")));
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.05, 0.003, 0.3), 3.0).empty());
    EXPECT_THAT(events.news(ends(0.05, 0.3, 0.05, 0.01, 0.3), 4.0),
                testing::ElementsAre(testing::HasSubstr("water at the outflow again")));
}

// A depth that is held waits for water.
TEST(EndEvents, AnOutflowThatIsDryAtTheStartHoldsNothing) {
    EndEvents events(gravity, film, true);
    EXPECT_THAT(
        events.news(ends(0.05, 0.3, 0.05, 0.0, 0.0), 0.0),
        testing::ElementsAre(testing::HasSubstr("the outflow is dry at t = 0 s: it holds the depth")));
    EXPECT_TRUE(events.news(ends(0.05, 0.3, 0.05, 0.0, 0.0), 1.0).empty());
    EXPECT_THAT(events.news(ends(0.05, 0.3, 0.05, 0.03, 0.3), 2.0),
                testing::ElementsAre("there is water at the outflow at t = 2 s"));
}

// A run that is resumed says nothing again, and when it is over what had begun before.
TEST(EndEvents, AResumedRunGoesOn) {
    EndEvents turned(gravity, film, true);
    turned.go_on(ends(0.05, 0.0, 0.05, 0.05, -0.1));
    EXPECT_TRUE(turned.news(ends(0.05, 0.0, 0.05, 0.05, -0.1), 31.0).empty());
    EXPECT_THAT(turned.news(ends(0.05, 0.0, 0.05, 0.05, 0.1), 32.0),
                testing::ElementsAre(testing::HasSubstr("leaves through the outflow again from t = 32 s")));
    EndEvents dry(gravity, film, false);
    dry.go_on(ends(0.05, 0.3, 0.05, 0.001, 0.3));
    EXPECT_TRUE(dry.news(ends(0.05, 0.3, 0.05, 0.001, 0.3), 31.0).empty());
    EXPECT_THAT(dry.news(ends(0.05, 0.3, 0.05, 0.01, 0.3), 32.0),
                testing::ElementsAre(testing::HasSubstr("water at the outflow again")));
}

TEST(EndEvents, WaterThatComesBackIsTold) {
    EndEvents events(gravity, film, false);
    EXPECT_TRUE(events.news(ends(0.05, 0.0, 0.05, 0.05, -0.005), 1.0).empty());
    EXPECT_THAT(events.news(ends(0.05, 0.0, 0.05, 0.05, -0.1), 2.0),
                testing::ElementsAre(testing::HasSubstr("comes in through the outflow")));
    EXPECT_TRUE(events.news(ends(0.05, 0.0, 0.05, 0.05, 0.005), 3.0).empty());
    EXPECT_THAT(events.news(ends(0.05, 0.0, 0.05, 0.05, 0.1), 4.0),
                testing::ElementsAre(testing::HasSubstr("leaves through the outflow again")));
}

TEST(EndEvents, AJumpThatReachesTheInflowIsTold) {
    EndEvents events(gravity, film, false);
    EXPECT_THAT(events.news(ends(0.02, 2.6, 0.06, 0.15, 0.3), 5.0),
                testing::ElementsAre(testing::HasSubstr("a jump has reached the inflow")));
    EXPECT_TRUE(events.news(ends(0.02, 2.6, 0.065, 0.15, 0.3), 6.0).empty());
    EXPECT_THAT(events.news(ends(0.02, 2.6, 0.021, 0.15, 0.3), 7.0),
                testing::ElementsAre(testing::HasSubstr("shoots again")));
}

}  // namespace
}  // namespace riffle::end_events_test
