#include "case/end_floor.hpp"

#include <gtest/gtest.h>

#include "changed_cases.hpp"

namespace riffle {
namespace {

Solid block(std::vector<double> x, std::vector<double> z) {
    Solid solid;
    solid.name = "block";
    solid.x = std::move(x);
    solid.z = std::move(z);
    return solid;
}

TEST(EndFloor, IsTheTopOfWhatStandsOnTheBed) {
    Case c = test::open_channel();
    c.solids = {block({-0.2, 0.1, 0.1, -0.2}, {-0.01, -0.01, 0.01, 0.01}),
                block({0.05, 0.15, 0.15, 0.05}, {0.0, 0.0, 0.02, 0.02}),
                block({0.2, 0.25, 0.25, 0.2}, {0.02, 0.02, 0.03, 0.03})};
    EXPECT_EQ(floor_at(c, 0.02), 0.01);
    EXPECT_EQ(floor_at(c, 0.07), 0.02);  // the higher of two
    EXPECT_EQ(floor_at(c, 0.18), 0.0);
    EXPECT_EQ(floor_at(c, 0.22), 0.0);  // it does not stand on the bed
    EXPECT_EQ(end_floors(c).upstream, 0.01);
    EXPECT_EQ(end_floors(c).downstream, 0.0);
    c.channel.ends = Ends::periodic;
    EXPECT_EQ(end_floors(c).upstream, 0.0);
}

TEST(EndFloor, CarriesTheWaterWhereItsTopIsLevel) {
    const auto carries = [](const Solid& solid) { return carries_through(solid, -0.05, 0.03); };
    EXPECT_TRUE(carries(block({-0.2, 0.1, 0.1, -0.2}, {0.0, 0.0, 0.01, 0.01})));
    EXPECT_TRUE(carries(block({-0.2, 0.1, 0.05, -0.05}, {0.0, -0.01, 0.01, 0.01})));
    // A top of several level faces, as a bed of heights has where the channel begins.
    EXPECT_TRUE(carries(block({-0.2, 0.1, 0.1, 0.0, -0.2}, {0.0, 0.0, 0.01, 0.01, 0.01})));
    EXPECT_FALSE(
        carries(block({-0.2, 0.1, 0.1, 0.01, 0.01, -0.2}, {0.0, 0.0, 0.01, 0.01, 0.02, 0.02})));  // a step
    EXPECT_FALSE(carries(block({-0.2, 0.02, 0.02, -0.2}, {0.0, 0.0, 0.01, 0.01})));               // too short
    EXPECT_FALSE(carries(block({-0.04, 0.1, 0.1, -0.04}, {0.0, 0.0, 0.01, 0.01})));    // not through the end
    EXPECT_FALSE(carries(block({-0.2, 0.1, 0.1, -0.2}, {0.0, 0.0, 0.01, 0.012})));     // sloping
    EXPECT_FALSE(carries(block({-0.2, 0.1, 0.1, -0.2}, {0.005, 0.005, 0.01, 0.01})));  // above the bed
    EXPECT_FALSE(carries(block({-0.2, 0.1, 0.1, 0.0, -0.2}, {0.0, 0.0, 0.01, 0.02, 0.01})));  // a ridge
}

}  // namespace
}  // namespace riffle
