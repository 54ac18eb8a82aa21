#include "turbulence/czernuszenko_rylov.hpp"

#include <gtest/gtest.h>

#include <array>

#include "turbulence/closure.hpp"
#include "turbulence/nezu_rodi.hpp"

namespace riffle::czernuszenko_rylov_test {
namespace {

TEST(CzernuszenkoRylov, EdgeZoneJoinsTheMiddleContinuously) {
    const double zone = 0.014;
    EXPECT_EQ(edge_zone_factor(zone, zone), 1.0);
    EXPECT_EQ(edge_zone_factor(5.0 * zone, zone), 1.0);
    EXPECT_NEAR(edge_zone_factor(zone * (1.0 - 1e-9), zone), 1.0, 1e-9);
    EXPECT_EQ(edge_zone_factor(0.0, zone), 0.0);
    EXPECT_EQ(edge_zone_factor(-0.001, zone), 0.0);
    double last = 0.0;
    for (int i = 1; i <= 100; ++i) {
        const double factor = edge_zone_factor(0.01 * i * zone, zone);
        EXPECT_GT(factor, last);
        last = factor;
    }
    // Nikuradse's slope at the wall: 0.4 over 0.14.
    EXPECT_NEAR(edge_zone_factor(1e-7 * zone, zone) / 1e-7, 0.4 / 0.14, 1e-5);
}

Case channel(Sides sides) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.depth = 0.050;
    c.channel.sides = sides;
    c.bed.roughness_height = 0.010;
    c.bed.datum_below_crest = 0.004;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    return c;
}

TEST(CzernuszenkoRylov, ShrinksBesideEachSideWall) {
    const Case c = channel(Sides::walls);
    const auto closure = make_closure(c);
    ASSERT_TRUE(closure->varies_across());
    const double zone = 0.5 * 0.5 * c.total_depth();
    for (const double d : {0.0, 0.3, 0.9, 1.1}) {
        const double factor = edge_zone_factor(d * zone, zone);
        EXPECT_DOUBLE_EQ(closure->side_factor(d * zone), factor);
        EXPECT_NEAR(closure->side_factor(c.channel.width - d * zone), factor, 1e-12);
    }
    // Beside the plane of symmetry there is no wall.
    EXPECT_EQ(make_closure(channel(Sides::half))->side_factor(0.5 * c.channel.width), 1.0);
    EXPECT_FALSE(make_closure(channel(Sides::periodic))->varies_across());
    EXPECT_EQ(make_closure(channel(Sides::periodic))->side_factor(0.0), 1.0);
}

TEST(CzernuszenkoRylov, HasNezuAndRodisLengthAndHalfOfItAcross) {
    const Case c = channel(Sides::walls);
    const auto closure = make_closure(c);
    EXPECT_EQ(closure->spanwise_ratio(), 0.5);
    EXPECT_EQ(closure->mixing_length(0.02), nezu_rodi_mixing_length(0.02, 0.0, c.total_depth(), 0.41, 0.2));
    // 1/2 (l_i^2 + l_j^2) of the six components, over l_x^2.
    EXPECT_EQ(stress_weight(false, false, 0.5), 1.0);
    EXPECT_EQ(stress_weight(false, true, 0.5), 0.625);
    EXPECT_EQ(stress_weight(true, false, 0.5), 0.625);
    EXPECT_EQ(stress_weight(true, true, 0.5), 0.25);
}

// The weights that a prototype found: K_u = K_w = 1.1875 - 0.9375 e_y^2, K_v = K_u - 0.375.
TEST(CzernuszenkoRylov, WeighsPairsByTheirDirection) {
    const auto half = pair_direction_weights(0.5);
    EXPECT_DOUBLE_EQ(half.slope, 0.9375);
    EXPECT_DOUBLE_EQ(half.level, 1.1875);
    EXPECT_DOUBLE_EQ(half.level_across, 0.8125);
    const auto isotropic = pair_direction_weights(1.0);
    EXPECT_EQ(isotropic.slope, 0.0);
    EXPECT_EQ(isotropic.level, 1.0);
    EXPECT_EQ(isotropic.level_across, 1.0);
}

}  // namespace
}  // namespace riffle::czernuszenko_rylov_test
