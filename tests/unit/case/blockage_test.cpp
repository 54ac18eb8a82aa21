// Channels that solids close, and those that only look like it.

#include "case/blockage.hpp"

#include <gtest/gtest.h>

#include <string>

#include "case/solid_mesh.hpp"
#include "changed_cases.hpp"

namespace riffle::blockage_test {
namespace {

using test::open_channel;
using test::tank;
using test::with_keys;
using test::with_shape;

/// A channel of 200 mm with a slope of 0.004, periodic, 44 mm deep as the flume of the tests.
Case sloping(const std::string& keys) {
    Case c = tank();
    c.channel.ends = Ends::periodic;
    c.channel.slope = 0.004;
    return with_keys(c, keys);
}

std::string block(const char* z, int number = 0, const char* x = "[0.08, 0.12, 0.12, 0.08]") {
    const std::string solid = "solid[" + std::to_string(number) + "].";
    return solid + "name = b" + std::to_string(number) + "; " + solid + "x = " + x + "; " + solid +
           "z = " + z + "; ";
}

TEST(Blockage, IsABodyFromTheBedToAboveAnyLevel) {
    const Case c = sloping(block("[0, 0, 0.2, 0.2]"));
    const auto found = blockage(c);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->solid, 0U);
    EXPECT_NEAR(found->x, 0.08, c.numerics.spacing);
    EXPECT_NEAR(found->level, c.total_depth() + 0.5 * 0.004 * 0.2, 1e-12);
    // The same in a channel that stands level, or is a tank: nothing has to pass.
    EXPECT_FALSE(blockage(with_keys(c, "channel.slope = 0")).has_value());
    EXPECT_FALSE(blockage(with_keys(c, "channel.ends = walls")).has_value());
    // A weir, a gate that opens or that moves.
    EXPECT_FALSE(blockage(sloping(block("[0, 0, 0.03, 0.03]"))).has_value());
    EXPECT_FALSE(blockage(sloping(block("[0.006, 0.006, 0.2, 0.2]"))).has_value());
    EXPECT_FALSE(blockage(with_keys(c, "solid[0].motion = constant; solid[0].velocity_z = 0.1")).has_value());
}

TEST(Blockage, IsMadeByThoseThatMeet) {
    const auto pair = [](const char* upper) {
        return sloping(block("[0, 0, 0.02, 0.02]") + block(upper, 1));
    };
    const auto closed = blockage(pair("[0.02, 0.02, 0.2, 0.2]"));
    ASSERT_TRUE(closed.has_value());
    EXPECT_EQ(closed->solid, 1U);
    EXPECT_TRUE(blockage(pair("[0.01, 0.01, 0.2, 0.2]")).has_value());
    EXPECT_FALSE(blockage(pair("[0.026, 0.026, 0.2, 0.2]")).has_value());
    // Over the one and under the other.
    EXPECT_FALSE(blockage(sloping(block("[0, 0, 0.03, 0.03]") +
                                  block("[0.01, 0.01, 0.2, 0.2]", 1, "[0.15, 0.18, 0.18, 0.15]")))
                     .has_value());
}

TEST(Blockage, BetweenOpenEndsIsHigherThanTheyName) {
    Case c = open_channel();
    c = with_keys(c, block("[0, 0, 0.2, 0.2]", 0, "[0.13, 0.17, 0.17, 0.13]"));
    const auto closes = [&c](double depths) {
        const double top = depths * c.total_depth();
        c.solids[0].z = {0.0, 0.0, top, top};
        return blockage(c).has_value();
    };
    // The water of a discharge rises over a dam, as far as the channel has room.
    EXPECT_FALSE(closes(1.2));
    EXPECT_FALSE(closes(3.0));
    EXPECT_TRUE(closes(4.2));
    // A depth that is held does not rise.
    c.inflow.unit_discharge.reset();
    c.inflow.depth = c.channel.depth;
    EXPECT_FALSE(closes(1.2));
    EXPECT_TRUE(closes(3.0));
}

TEST(Blockage, InSpaceTakesTheWholeWidth) {
    Case c = with_shape(SolidShape::box);
    c.channel.slope = 0.004;
    const auto closes = [&](double width) {
        c.solids[0].centre = {0.1, 0.05, 0.1};
        c.solids[0].size = {0.03, width, 0.2};
        c.meshes.reset();
        c.meshes = meshes_of(c);
        return blockage(c).has_value();
    };
    EXPECT_TRUE(closes(0.1));
    EXPECT_FALSE(closes(0.09));
}

TEST(NarrowestWay, IsTheGapThatAllWaterPasses) {
    constexpr int most = 10;
    const auto gap = [](const std::string& keys) {
        return narrowest_way(sloping("numerics.spacing = 2 mm; " + keys), most);
    };
    const auto gate = gap(block("[0.012, 0.012, 0.2, 0.2]"));
    ASSERT_TRUE(gate.has_value());
    EXPECT_EQ(gate->width, 6);
    EXPECT_NEAR(gate->x, 0.08, sloping("").numerics.spacing);
    EXPECT_FALSE(gap(block("[0.020, 0.020, 0.2, 0.2]")).has_value());
    // A wider way beside a narrow one; a weir alone, over which water passes as it likes; a closed channel.
    EXPECT_FALSE(gap(block("[0, 0, 0.02, 0.02]") + block("[0.042, 0.042, 0.2, 0.2]", 1)).has_value());
    EXPECT_FALSE(gap(block("[0, 0, 0.03, 0.03]")).has_value());
    EXPECT_FALSE(gap(block("[0, 0, 0.2, 0.2]")).has_value());
    // The narrowest of two in a row.
    const auto both = gap(block("[0.016, 0.016, 0.2, 0.2]", 0, "[0.03, 0.05, 0.05, 0.03]") +
                          block("[0.008, 0.008, 0.2, 0.2]", 1));
    ASSERT_TRUE(both.has_value());
    EXPECT_EQ(both->width, 4);
}

}  // namespace
}  // namespace riffle::blockage_test
