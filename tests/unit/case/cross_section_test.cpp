// Channels of one cross-section by a word: that they hold the water of the textbook's formulas.

#include "case/cross_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/solid_mesh.hpp"
#include "changed_cases.hpp"

namespace riffle::cross_section_test {
namespace {

/// A channel 640 mm wide with water up to a level.
Case channel(double level) {
    Case c = test::with_mesh();
    c.solids.clear();
    c.channel.width = 0.64;
    c.channel.depth = level;
    c.channel.sides = Sides::walls;
    c.numerics.spacing = 0.005;
    return c;
}

Solid trapezoid() {
    Solid solid;
    solid.name = "canal";
    solid.shape = SolidShape::trapezoid;
    solid.bottom_width = 0.3;
    solid.bank_slope = 1.5;
    return solid;
}

Solid compound() {
    Solid solid = trapezoid();
    solid.shape = SolidShape::compound;
    solid.bottom_width = 0.1;
    solid.bank_slope = 1.0;
    solid.bank_height = 0.05;
    return solid;
}

TEST(CrossSection, OfATrapezoidIsThatOfTheTextbook) {
    const double h = 0.1;
    const WettedSection wet = wetted_section(cross_section(channel(h), trapezoid()), h);
    EXPECT_NEAR(wet.area, (0.3 + 1.5 * h) * h, 1e-12);
    EXPECT_NEAR(wet.perimeter, 0.3 + 2.0 * h * std::sqrt(1.0 + 1.5 * 1.5), 1e-12);
    EXPECT_NEAR(wet.top_width, 0.3 + 2.0 * 1.5 * h, 1e-12);
}

TEST(CrossSection, OfATriangleHasItsCornerInTheMiddle) {
    Solid ditch = trapezoid();
    ditch.bottom_width = 0.0;
    const CrossSection section = cross_section(channel(0.1), ditch);
    ASSERT_EQ(section.y.size(), 3U);
    EXPECT_DOUBLE_EQ(section.y[1], 0.32);
    EXPECT_DOUBLE_EQ(section.levels[1], 0.0);
    EXPECT_NEAR(wetted_section(section, 0.1).area, 1.5 * 0.1 * 0.1, 1e-12);
}

TEST(CrossSection, WithUprightBanksIsARectangle) {
    Solid canal = trapezoid();
    canal.bank_slope = 0.0;
    canal.bank_height = 0.2;
    const WettedSection wet = wetted_section(cross_section(channel(0.1), canal), 0.1);
    EXPECT_NEAR(wet.area, 0.3 * 0.1, 1e-12);
    EXPECT_NEAR(wet.perimeter, 0.3 + 2.0 * 0.1, 1e-12);
}

TEST(CrossSection, OfACompoundChannelHasFloodplainsAtTheHeightOfItsBanks) {
    const double h = 0.08;
    const double main = (0.1 + 0.05) * 0.05 + 0.2 * 0.03;  // up to the banks, and above them
    Solid canal = compound();
    // The floodplains reach to the sides.
    const WettedSection wide = wetted_section(cross_section(channel(h), canal), h);
    EXPECT_NEAR(wide.area, main + 2.0 * 0.22 * 0.03, 1e-12);
    EXPECT_NEAR(wide.perimeter, 0.1 + 2.0 * 0.05 * std::numbers::sqrt2 + 2.0 * 0.22, 1e-12);
    // Beyond them there are banks again.
    canal.floodplain_width = 0.15;
    const WettedSection banks = wetted_section(cross_section(channel(h), canal), h);
    EXPECT_NEAR(banks.area, main + 2.0 * (0.15 * 0.03 + 0.5 * 0.03 * 0.03), 1e-12);
    EXPECT_NEAR(banks.top_width, 0.2 + 2.0 * (0.15 + 0.03), 1e-12);
}

TEST(CrossSection, OfAPipeHoldsTheSegmentOfItsCircle) {
    Solid pipe = trapezoid();
    pipe.shape = SolidShape::pipe;
    pipe.diameter = 0.4;
    for (const double level : {0.05, 0.12, 0.2}) {
        const Case c = channel(level);
        const WettedSection wet = wetted_section(cross_section(c, pipe), level);
        const double angle = 2.0 * std::acos(1.0 - level / 0.2);
        // Its edges stand within a hundredth of a spacing from the circle.
        EXPECT_NEAR(wet.area, 0.5 * 0.2 * 0.2 * (angle - std::sin(angle)), 5e-5 * wet.top_width);
        EXPECT_NEAR(wet.perimeter, 0.2 * angle, 5e-3 * wet.perimeter);
        for (const double z : cross_section(c, pipe).levels) EXPECT_GE(z, 0.0);
    }
}

TEST(CrossSection, OfHalfAChannelIsItsHalf) {
    Solid pipe = trapezoid();
    pipe.shape = SolidShape::pipe;
    pipe.diameter = 0.4;
    for (const Solid& solid : {trapezoid(), compound(), pipe}) {
        Case c = channel(0.08);
        const WettedSection whole = wetted_section(cross_section(c, solid), 0.08);
        c.channel.sides = Sides::half;
        const CrossSection half = cross_section(c, solid);
        EXPECT_NEAR(half.y.back(), 0.32, 1e-12);
        EXPECT_NEAR(wetted_section(half, 0.08).area, 0.5 * whole.area, 1e-12);
    }
}

TEST(CrossSection, IsTheBedThatTheWordSays) {
    const Case c = channel(0.1);
    const SolidMesh mesh(c, trapezoid());
    EXPECT_FALSE(mesh.contains({0.1, 0.32, 0.001}));
    EXPECT_TRUE(mesh.contains({0.1, 0.32, -0.001}));
    EXPECT_TRUE(mesh.contains({0.1, 0.17 - 0.061, 0.04}));
    EXPECT_FALSE(mesh.contains({0.1, 0.17 - 0.059, 0.04}));
}

}  // namespace
}  // namespace riffle::cross_section_test
