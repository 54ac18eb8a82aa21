#include "column/canal_channel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/case.hpp"
#include "case/cross_section.hpp"
#include "column/twin_channel.hpp"
#include "column/uniform_rating.hpp"
#include "hydraulics/varied_flow.hpp"

namespace riffle::canal_channel_test {
namespace {

/// A compound canal with open ends: main channel 200 mm wide and 75 mm deep, banks and floodplains of 125 mm.
Case compound() {
    return parse_case(
        "[channel]\ndimensions = 3\nsides = \"walls\"\nends = \"open\"\nslope = 0.001\ndepth = 0.15\nwidth = 0.79\n"
        "length = 3\n[inflow]\ndischarge = 0.03\n[bed]\nkind = \"slip\"\n[side_walls]\ndrag_form = \"none\"\n"
        "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = 0.012\n[run]\nuntil = 1\n[[solid]]\n"
        "name = \"canal\"\nshape = \"compound\"\nbottom_width = 0.2\nbank_slope = 1\nbank_height = 0.075\n"
        "floodplain_width = 0.125\nsurface = \"log-law\"\nequivalent_roughness = 0.001\n",
        "compound");
}

// Discharge of the normal depth, and the depth of that discharge: over the banks as below.
TEST(CanalChannel, NormalDepthAndUniformDischargeAreOfEachOther) {
    const Case c = compound();
    UniformRating rating(c);
    for (const double depth : {0.03, 0.06, 0.12, 0.15, 0.2}) {
        const double q = canal_uniform_discharge(c, depth);
        EXPECT_NEAR(normal_depth(twin_channel(c, q)).value() / depth, 1.0, 1e-6) << depth;
        EXPECT_NEAR(rating.depth(q) / depth, 1.0, 1e-4) << depth;
    }
}

/// The same with floodplains rougher than the main channel.
Case with_rough_floodplains() {
    Case c = compound();
    for (const bool right : {false, true}) {
        SurfacePatch plain;
        plain.name = right ? "right" : "left";
        plain.solid = "canal";
        plain.equivalent_roughness = 0.01;
        (right ? plain.y_from : plain.y_to) = right ? 0.57 : 0.22;
        c.surface_patches.push_back(plain);
    }
    return c;
}

// Patches that the water does not reach change nothing; under all of it they are another roughness of the
// canal; between, the discharge is between.
TEST(CanalChannel, PatchesHoldBackTheWaterThatWetsThem) {
    const Case smooth = compound();
    const Case patched = with_rough_floodplains();
    Case rough = compound();
    rough.solids[0].equivalent_roughness = 0.01;
    EXPECT_NEAR(canal_uniform_discharge(patched, 0.06) / canal_uniform_discharge(smooth, 0.06), 1.0, 1e-9);
    for (const double depth : {0.1, 0.15, 0.2}) {
        const double q = canal_uniform_discharge(patched, depth);
        EXPECT_LT(q, 0.98 * canal_uniform_discharge(smooth, depth)) << depth;
        EXPECT_GT(q, 1.02 * canal_uniform_discharge(rough, depth)) << depth;
        EXPECT_NEAR(normal_depth(twin_channel(patched, q)).value() / depth, 1.0, 2e-3) << depth;
    }
    // Rough water on the floodplains makes the velocities across more uneven.
    const auto alpha = [](const Case& c) {
        return twin_channel(c, canal_uniform_discharge(c, 0.15)).state(0.15).energy_coefficient;
    };
    EXPECT_GT(alpha(patched), alpha(smooth) + 0.02);
}

TEST(CanalChannel, HasATwinWherePatchesLieAllAlongTheChannelAlone) {
    Case c = with_rough_floodplains();
    EXPECT_NE(canal_of(c), nullptr);
    c.surface_patches[0].x_to = 1.0;
    EXPECT_EQ(canal_of(c), nullptr);
}

// As water spills onto the floodplains the law has a smaller discharge than just below them: the rating of a
// flood goes on without turning back.
TEST(CanalChannel, TheRatingRisesOverTheBanks) {
    const Case c = compound();
    ASSERT_LT(canal_uniform_discharge(c, 0.076), canal_uniform_discharge(c, 0.0749));
    UniformRating rating(c);
    const double full = canal_uniform_discharge(c, 0.075);
    double before = 0.0;
    for (double q = 0.1 * full; q < 4.0 * full; q *= 1.01) {
        const double depth = rating.depth(q);
        EXPECT_GE(depth, before);
        before = depth;
        if (q < 0.98 * full) {
            EXPECT_LT(depth, 0.075);
        }
        if (q > 1.02 * full) {
            EXPECT_GT(depth, 0.078);
            EXPECT_NEAR(canal_uniform_discharge(c, depth) / q, 1.0, 2e-3);
        }
    }
}

// The water on the floodplains is slow: alpha and beta are more than 1, just over the banks most.
TEST(CanalChannel, FloodplainsMakeTheCoefficientsOfTheSection) {
    const Case c = compound();
    const SteadyChannel channel = twin_channel(c, 0.05);
    const SectionState deep = channel.state(0.2);
    const SectionState shallow = channel.state(0.09);
    EXPECT_GT(shallow.momentum_coefficient, deep.momentum_coefficient);
    EXPECT_GT(deep.momentum_coefficient, 1.0);
    EXPECT_GT(shallow.energy_coefficient - 1.0, 2.0 * (shallow.momentum_coefficient - 1.0));
    EXPECT_LT(shallow.energy_coefficient, 2.0);
}

}  // namespace
}  // namespace riffle::canal_channel_test
