#include "column/uniform_rating.hpp"

#include <gtest/gtest.h>

#include "column/twin_channel.hpp"

namespace riffle {
namespace {

Case plane_bed(const std::string& bed) {
    return parse_case(
        "[channel]\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"1 m\"\n[bed]\n" + bed +
            "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = \"3 mm\"\n[run]\nuntil = \"1 s\"\n",
        "test");
}

// The depth at which the twin of the bed carries the discharge, as one finds it for each discharge alone.
TEST(UniformRating, IsTheNormalDepthOfEachDischarge) {
    for (const char* const bed :
         {"kind = \"roughness\"\nequivalent_roughness = \"2 mm\"\n", "kind = \"smooth\"\n",
          "roughness_height = \"4 mm\"\nsphere_diameter = \"10 mm\"\n"}) {
        const Case c = plane_bed(bed);
        UniformRating rating(c);
        for (const double q : {0.004, 0.03, 0.07, 0.4}) {
            const double depth = *twin_normal_depth(c, q);
            EXPECT_NEAR(rating.depth(q), depth, 1e-5 * depth) << bed << q;
        }
    }
}

// Where the friction of the bed is not known the depth goes down to nothing with the discharge.
TEST(UniformRating, EndsWithADryBed) {
    UniformRating rating(plane_bed("kind = \"roughness\"\nequivalent_roughness = \"10 mm\"\n"));
    EXPECT_EQ(rating.depth(0.0), 0.0);
    double before = 0.0;
    for (const double q : {1e-7, 1e-5, 1e-4, 1e-3, 1e-2}) {
        const double depth = rating.depth(q);
        EXPECT_GT(depth, before);
        before = depth;
    }
    EXPECT_LT(rating.depth(1e-7), 1e-3);
}

}  // namespace
}  // namespace riffle
