// The kind of flow of a case, and why it has no column twin.

#include "case/flow_kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

namespace riffle::flow_kind_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::filesystem::path cases = std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases";

Case check_case(const std::string& name) { return read_case(cases / "checks" / (name + ".toml")); }

TEST(FlowKind, OfEveryCheck) {
    const std::map<std::string, FlowKind> expected = {
        {"beach", FlowKind::tank},
        {"column-collapse", FlowKind::tank},
        {"couette", FlowKind::uniform_channel},
        {"dam-break", FlowKind::tank},
        {"flow-over-step", FlowKind::channel_with_bodies},
        {"gate", FlowKind::tank},
        {"hydrostatic-tank", FlowKind::tank},
        {"laminar-re10", FlowKind::uniform_channel},
        {"lid-driven-cavity", FlowKind::tank},
        {"piston", FlowKind::tank},
        {"poiseuille", FlowKind::uniform_channel},
        {"ramp-profile", FlowKind::uniform_channel},
        {"sloshing", FlowKind::tank},
        {"standing-wave", FlowKind::standing_wave},
        {"tank-with-wedge", FlowKind::tank},
        {"taylor-green", FlowKind::periodic_box},
        {"wavemaker", FlowKind::tank},
    };
    for (const auto& [name, kind] : expected) EXPECT_EQ(flow_kind(check_case(name)), kind) << name;
    EXPECT_EQ(flow_kind(read_case(cases / "rough-bed-2d/condition-2.toml")), FlowKind::uniform_channel);
    EXPECT_EQ(flow_kind(read_case(cases / "rough-bed-3d/condition-2-coarse.toml")),
              FlowKind::uniform_channel);
}

TEST(FlowKind, OnlyUniformChannelsHaveAColumn) {
    for (const auto& entry : std::filesystem::directory_iterator(cases / "checks")) {
        if (entry.path().extension() != ".toml") continue;
        const Case c = read_case(entry.path());
        EXPECT_TRUE(why_no_column(c) || flow_kind(c) == FlowKind::uniform_channel) << entry.path();
    }
    EXPECT_FALSE(why_no_column(check_case("poiseuille")));
    EXPECT_FALSE(why_no_column(read_case(cases / "rough-bed-2d/condition-2.toml")));
}

TEST(FlowKind, TheReasonIsTheTrueOne) {
    const auto reason = [](const std::string& name) { return why_no_column(check_case(name)).value_or(""); };
    EXPECT_THAT(reason("flow-over-step"), AllOf(HasSubstr("\"step\""), Not(HasSubstr("slope"))));
    EXPECT_THAT(reason("dam-break"), HasSubstr("channel.ends"));
    EXPECT_THAT(reason("sloshing"), HasSubstr("channel.ends"));
    EXPECT_THAT(reason("standing-wave"), HasSubstr("channel.slope = 0"));
    EXPECT_THAT(reason("couette"), HasSubstr("channel.lid_velocity"));
    EXPECT_THAT(reason("taylor-green"), HasSubstr("channel.top"));
    Case slip = check_case("laminar-re10");
    slip.bed.kind = BedKind::slip;
    EXPECT_THAT(why_no_column(slip).value_or(""), HasSubstr("nothing resists"));
    Case outlined = check_case("laminar-re10");
    outlined.start.water_x = {0.0, 0.1, 0.1, 0.0};
    outlined.start.water_z = {0.0, 0.0, 0.1, 0.1};
    EXPECT_THAT(why_no_column(outlined).value_or(""), HasSubstr("start.water_x"));
    EXPECT_EQ(flow_kind(outlined), FlowKind::tank);
}

// Spheres that lie on the ground are the bed of a uniform channel, a body that stands on them makes another
// flow.
TEST(FlowKind, SolidsThatArePartOfTheBedLeaveAUniformChannel) {
    Case c = read_case(cases / "rough-bed-3d/resolved-spheres.toml");
    EXPECT_EQ(flow_kind(c), FlowKind::uniform_channel);
    EXPECT_TRUE(has_rough_bed(c));
    EXPECT_FALSE(has_bodies(c));
    EXPECT_THAT(why_no_column(c).value_or(""), HasSubstr("the bed is made of solids (\"bed spheres\")"));
    Solid& pier = c.solids.emplace_back();
    pier.name = "pier";
    EXPECT_EQ(flow_kind(c), FlowKind::channel_with_bodies);
    EXPECT_THAT(why_no_column(c).value_or(""),
                AllOf(HasSubstr("the solid \"pier\","), Not(HasSubstr("more"))));
}

}  // namespace
}  // namespace riffle::flow_kind_test
