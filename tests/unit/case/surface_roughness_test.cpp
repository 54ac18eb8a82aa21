// The roughness of surfaces by the log law and of the patches on them.

#include "case/surface_roughness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/bed_friction.hpp"

namespace riffle::surface_roughness_test {
namespace {

Case canal() {
    Case c;
    c.channel.depth = 0.15;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    Solid solid;
    solid.name = "canal";
    solid.surface = SolidSurface::log_law;
    solid.equivalent_roughness = 1e-3;
    c.solids = {solid};
    return c;
}

TEST(SurfaceRoughness, OfManningsNHasItsVelocity) {
    const Case c = canal();
    for (const double n : {0.009, 0.013, 0.02, 0.03}) {
        const double k_s = roughness_of_surface_manning(c, n).value();
        const double u_star = std::sqrt(c.fluid.gravity * 0.001 * 0.15);
        const double zero = zero_height_of_roughness(k_s, c.turbulence.kappa);
        const double manning = std::pow(0.15, 2.0 / 3.0) * std::sqrt(0.001) / n;
        EXPECT_NEAR(u_star * log_law_mean(0.15, zero, c.turbulence.kappa) / manning, 1.0, 1e-9) << n;
    }
    EXPECT_FALSE(roughness_of_surface_manning(c, 0.9));
    EXPECT_FALSE(roughness_of_surface_manning(c, 0.002));
}

TEST(SurfaceRoughness, OfAPlaceAcrossIsThatOfThePatchThere) {
    Case c = canal();
    c.channel.dimensions = 3;
    c.channel.width = 0.6;
    SurfacePatch bank;
    bank.name = "bank";
    bank.solid = "canal";
    bank.equivalent_roughness = 0.02;
    bank.y_to = 0.2;
    SurfacePatch of_another = bank;
    of_another.solid = "pier";
    of_another.y_to = 0.6;
    c.surface_patches = {of_another, bank};
    EXPECT_EQ(surface_roughness_at(c, c.solids[0], 0.1), 0.02);
    EXPECT_EQ(surface_roughness_at(c, c.solids[0], 0.3), 1e-3);
    EXPECT_TRUE(has_strips_alone(c, c.solids[0]));
    c.surface_patches[1].x_to = 0.5 * c.channel.length;
    EXPECT_FALSE(has_strips_alone(c, c.solids[0]));
}

}  // namespace
}  // namespace riffle::surface_roughness_test
