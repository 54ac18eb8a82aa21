// The drag of stems, where they stand, and the mixing length of a canopy.

#include "roughness/vegetation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vegetated_channel.hpp"

namespace riffle::vegetation_test {
namespace {

Vegetation reeds() { return test::stems(400.0, 0.008, 0.1, 1.2); }

Vegetation flexible(double exponent) {
    Vegetation stems = reeds();
    stems.vogel_exponent = exponent;
    stems.reference_velocity = 0.1;
    return stems;
}

Vegetation by_reynolds_number() {
    Vegetation stems = reeds();
    stems.drag_coefficient.reset();
    return stems;
}

Case channel() { return test::slip_channel(0.001, 0.3); }

TEST(StemDrag, HoldsTheWaterBetweenTheStemsWithTheForceOnAll) {
    const Vegetation stems = reeds();
    EXPECT_DOUBLE_EQ(stems.frontal_area(), 3.2);
    EXPECT_NEAR(stems.solid_fraction(), 0.0201062, 1e-7);
    const StemDrag drag(stems, 1e-6);
    // Of a volume V of water and stems: 1/2 rho C_D a u^2 V on the mass rho (1 - phi) V.
    const double u = 0.2;
    const double force = 0.5 * 1000.0 * 1.2 * 3.2 * u * u;
    EXPECT_NEAR(drag.deceleration(u), force / (1000.0 * (1.0 - stems.solid_fraction())), 1e-12);
    EXPECT_EQ(drag.deceleration(-u), -drag.deceleration(u));
    EXPECT_NEAR(drag.speed_at(drag.deceleration(u)), u, 1e-12);
}

TEST(StemDrag, OfChengAndNguyen) {
    // 50/1000^0.43 = 2.56431, 0.7 (1 - exp(-1/15)) = 0.04515.
    EXPECT_NEAR(cheng_nguyen_drag_coefficient(1000.0), 2.60946, 2e-5);
    // Thick Reynolds numbers: 0.7 and the rest of the power law.
    EXPECT_NEAR(cheng_nguyen_drag_coefficient(5e5), 0.7 + 50.0 * std::pow(5e5, -0.43), 1e-9);
    // r_v is the volume of the water over the frontal area of the stems.
    const Vegetation stems = by_reynolds_number();
    EXPECT_NEAR(vegetation_radius(stems.solid_fraction(), stems.stem_diameter),
                (1.0 - stems.solid_fraction()) / stems.frontal_area(), 1e-12);
    const StemDrag drag(stems, 1e-6);
    const double u = 0.15;
    EXPECT_NEAR(drag.drag_coefficient(u),
                cheng_nguyen_drag_coefficient(
                    u * vegetation_radius(stems.solid_fraction(), stems.stem_diameter) / 1e-6),
                1e-12);
    EXPECT_NEAR(drag.speed_at(drag.deceleration(u)), u, 1e-9);
    EXPECT_EQ(drag.deceleration(0.0), 0.0);
}

TEST(StemDrag, OfFlexibleStemsGrowsWithThePowerOfVogel) {
    const StemDrag rigid(reeds(), 1e-6);
    const StemDrag bends(flexible(-0.7), 1e-6);
    EXPECT_EQ(bends.deceleration(0.05), rigid.deceleration(0.05));
    EXPECT_NEAR(bends.deceleration(0.1 + 1e-9), rigid.deceleration(0.1), 1e-7);
    EXPECT_NEAR(bends.deceleration(0.4) / bends.deceleration(0.2), std::pow(2.0, 1.3), 1e-12);
}

TEST(StemDrag, KnowsItsSlopeAndItsIntegral) {
    for (const Vegetation& stems : {reeds(), by_reynolds_number(), flexible(-0.7), flexible(-1.5)}) {
        const StemDrag drag(stems, 1e-6);
        for (const double u : {0.003, 0.07, 0.2, 0.9}) {
            const double h = 1e-5 * u;
            const double slope = (drag.deceleration(u + h) - drag.deceleration(u - h)) / (2.0 * h);
            EXPECT_NEAR(drag.deceleration_slope(u), slope, 1e-6 * slope) << u;
            EXPECT_EQ(drag.deceleration_slope(-u), drag.deceleration_slope(u));
            const double fall =
                (drag.deceleration_integral(u + h) - drag.deceleration_integral(u - h)) / (2.0 * h);
            EXPECT_NEAR(fall, drag.deceleration(u), 1e-4 * fall) << u;
            EXPECT_EQ(drag.deceleration_integral(-u), drag.deceleration_integral(u));
        }
    }
}

TEST(VegetationPatch, ActsBelowTheTopsWhereverTheRowsStand) {
    const VegetationPatch patch(channel(), reeds());
    const double row = 0.007;
    for (double offset = 0.0; offset < row; offset += 0.1 * row) {
        double height = 0.0;
        for (double z = offset - row; z < 0.3; z += row) {
            const double cut = std::clamp(z + 0.5 * row, 0.0, row);  // of the row above the bed
            height += cut * patch.share_below_top(z, row);
        }
        EXPECT_NEAR(height, 0.1, 1e-12) << offset;
    }
    EXPECT_EQ(patch.share_in_plan(0.123, 0.0, row), 1.0);
}

TEST(VegetationPatch, SharesAParticleWithItsNeighbours) {
    Case c = channel();
    Vegetation first = reeds();
    first.x_from = 0.0;
    first.x_to = 0.2;
    Vegetation second = first;
    second.x_from = 0.2;
    second.x_to = 0.5;
    c.vegetation = {first, second};
    const auto patches = vegetation_patches(c);
    // Across the periodic ends as well.
    for (const double x : {0.0, 0.001, 0.1, 0.199, 0.203, 0.4, 0.498, 0.4999}) {
        EXPECT_NEAR(patches[0].share_in_plan(x, 0.0, 0.01) + patches[1].share_in_plan(x, 0.0, 0.01), 1.0,
                    1e-12)
            << x;
    }
    EXPECT_NEAR(patches[0].share_in_plan(0.499, 0.0, 0.01), 0.4, 1e-12);
    c.channel.ends = Ends::walls;
    EXPECT_EQ(vegetation_patches(c)[0].share_in_plan(0.499, 0.0, 0.01), 0.0);
}

TEST(CanopyClosure, StartsAtTheDisplacementHeightAboveTheTops) {
    const Case c = channel();
    const Vegetation stems = reeds();
    // a k = 0.32: s = sqrt(4.8) = 2.1909, d/k = 1 - (1 - exp(-s))/s = 0.5946.
    EXPECT_NEAR(displacement_height(stems), 0.05946, 1e-5);
    const auto canopy = make_canopy_closure(c, stems, make_closure(c));
    const double d = displacement_height(stems);
    const double z = 0.15;
    EXPECT_NEAR(canopy->mixing_length(z), 0.41 * (z - d) * std::sqrt(1.0 - (z - d) / (0.3 - d)), 1e-12);
    // Continuous at the tops, the same between the stems, limited by the bed.
    EXPECT_NEAR(canopy->mixing_length(0.1 - 1e-9), canopy->mixing_length(0.1), 1e-9);
    EXPECT_EQ(canopy->mixing_length(0.06), canopy->mixing_length(0.1));
    EXPECT_EQ(canopy->mixing_length(0.01), make_closure(c)->mixing_length(0.01));
}

TEST(CanopyClosure, IsTheOneOfTheBedWithoutStems) {
    const Case c = channel();
    Vegetation stems = reeds();
    stems.stems_per_area = 1e-6;
    const auto canopy = make_canopy_closure(c, stems, make_closure(c));
    const auto bare = make_closure(c);
    for (const double z : {0.01, 0.05, 0.12, 0.29}) {
        EXPECT_NEAR(canopy->mixing_length(z), bare->mixing_length(z), 1e-3 * bare->mixing_length(z));
    }
    // No mixing length: the closure's own.
    Case eddies = c;
    eddies.turbulence.closure = ClosureKind::sps;
    EXPECT_EQ(make_canopy_closure(eddies, reeds(), make_closure(eddies))->mixing_length(0.05),
              make_closure(eddies)->mixing_length(0.05));
}

TEST(CanopyClosure, AmongEmergentStemsIsThatOfTheirWakes) {
    const Case c = channel();
    Vegetation stems = reeds();
    stems.height = 0.5;
    const auto canopy = make_canopy_closure(c, stems, make_closure(c));
    EXPECT_EQ(canopy->mixing_length(0.15), stems.stem_diameter);
    EXPECT_LT(canopy->mixing_length(0.001), stems.stem_diameter);
}

}  // namespace
}  // namespace riffle::vegetation_test
