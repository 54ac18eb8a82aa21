#include "column/twin_reaches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;

Case over_beds(const std::string& patch) {
    return parse_case(
        "[channel]\nslope = 0.003\ndepth = \"60 mm\"\nlength = \"1.5 m\"\nends = \"open\"\n"
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n"
        "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n[[bed_patch]]\nname = \"middle\"\n" +
            patch + "x_from = \"0.5 m\"\nx_to = \"0.9 m\"\n" +
            "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = \"6 mm\"\n[start]\nkind = \"uniform\"\n"
            "[run]\nuntil = \"8 s\"\n",
        "test");
}

// The bed of the channel before and behind a patch that covers its width, and to the end of a longer one.
TEST(TwinReaches, AreTheBedsOneBehindTheOther) {
    const Case c = over_beds("equivalent_roughness = \"12 mm\"\n");
    const auto reaches = twin_reaches(c, 0.03, 4.0);
    ASSERT_EQ(reaches.size(), 3U);
    EXPECT_EQ(reaches[0].name, "");
    EXPECT_EQ(reaches[1].name, "middle");
    EXPECT_DOUBLE_EQ(reaches[1].from, 0.5);
    EXPECT_DOUBLE_EQ(reaches[1].to, 0.9);
    EXPECT_DOUBLE_EQ(reaches[2].to, 4.0);
    EXPECT_GT(reaches[1].channel.state(0.06).friction_slope,
              1.5 * reaches[2].channel.state(0.06).friction_slope);
}

// Each bed is known by its friction; which one has none is said.
TEST(TwinReaches, NeedFrictionOverEachBed) {
    try {
        static_cast<void>(twin_reaches(over_beds("kind = \"slip\"\n"), 0.03, 1.5));
        FAIL() << "a slip bed has no varied flow";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nothing resists the flow over [[bed_patch]] middle"));
    }
}

// What lies beside another bed at one place would be left out of the friction.
TEST(TwinReaches, AreNotOfStrips) {
    Case c = over_beds("equivalent_roughness = \"12 mm\"\n");
    c.channel.dimensions = 3;
    c.bed_patches.front().y_to = 0.5 * c.channel.width;
    try {
        static_cast<void>(twin_reaches(c, 0.03, 1.5));
        FAIL() << "a patch beside another bed has no varied flow";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("[[bed_patch]] middle lies in a part of the width"));
    }
}

}  // namespace
}  // namespace riffle
