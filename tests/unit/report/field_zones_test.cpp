// What the picture of the flow field shows of vegetation, porous zones and patches of the bed.

#include <gtest/gtest.h>

#include <string>

#include "report/field_data.hpp"

namespace riffle {
namespace {

Case channel(const std::string& more) {
    return parse_case(
        "[channel]\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"1 m\"\n" + more +
            "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = \"5 mm\"\n[start]\nkind = \"rest\"\n"
            "[run]\nuntil = \"1 s\"\n",
        "test");
}

const std::string rough = "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"2 mm\"\n";
const std::string stems = "stems_per_area = 400\nstem_diameter = \"6 mm\"\nheight = \"100 mm\"\n";

TEST(FieldZones, AreWhereTheCaseHasThem) {
    const Case c =
        channel(rough + "[[vegetation]]\nname = \"reeds\"\n" + stems + "x_to = \"0.3 m\"\n" +
                "[[bed_patch]]\nname = \"cobbles\"\nequivalent_roughness = \"6 mm\"\nx_from = \"0.4 m\"\n");
    const auto zones = field_zones(c, 0.0, 0.07);
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].kind, "vegetation");
    EXPECT_EQ(zones[0].name, "reeds");
    EXPECT_EQ(zones[0].outline.x, (std::vector<double>{0.0, 0.3, 0.3, 0.0}));
    // No higher than what is shown.
    EXPECT_EQ(zones[0].outline.z, (std::vector<double>{0.0, 0.0, 0.07, 0.07}));
    // A plane bed is a line.
    EXPECT_EQ(zones[1].kind, "bed");
    EXPECT_EQ(zones[1].outline.x, (std::vector<double>{0.4, 1.0}));
    EXPECT_EQ(zones[1].outline.z, (std::vector<double>{0.0, 0.0}));
}

TEST(FieldZones, OfASliceAreThoseThatItCuts) {
    const Case c = parse_case(
        "[channel]\ndimensions = 3\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"0.2 m\"\nwidth = \"0.2 m\"\n" +
            rough + "[[vegetation]]\nname = \"reeds\"\n" + stems +
            "y_to = \"50 mm\"\n[turbulence]\nclosure = \"nezu-rodi\"\n" +
            "[numerics]\nspacing = \"5 mm\"\n[start]\nkind = \"rest\"\n[run]\nuntil = \"1 s\"\n",
        "test");
    EXPECT_EQ(field_zones(c, 0.02, 0.07).size(), 1U);
    EXPECT_TRUE(field_zones(c, 0.1, 0.07).empty());
}

}  // namespace
}  // namespace riffle
