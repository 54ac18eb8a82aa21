// The laws of the resistance of porous media.

#include "roughness/porous_resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::porous_resistance_test {
namespace {

Porous grains(double porosity, double size) {
    Porous medium;
    medium.name = "grains";
    medium.porosity = porosity;
    medium.grain_size = size;
    return medium;
}

TEST(PorousResistance, OfGrainsIsErguns) {
    // n = 0.4, d = 5 mm, nu = 1e-6 m2/s: 150 0.36 1e-6/(0.064 25e-6) = 33.75 1/s, 1.75 0.6/(0.064 0.005) =
    // 3281.25 1/m.
    const PorousResistance law(grains(0.4, 0.005), 1e-6);
    EXPECT_NEAR(law.linear(), 33.75, 1e-9);
    EXPECT_NEAR(law.quadratic(), 3281.25, 1e-7);
    EXPECT_NEAR(law.of(0.01), 0.3375 + 0.328125, 1e-12);
    EXPECT_NEAR(law.of(-0.01), -law.of(0.01), 1e-15);
    EXPECT_NEAR(law.discharge_at(law.of(0.01)), 0.01, 1e-12);
    EXPECT_NEAR(permeability_of(grains(0.4, 0.005)), 1e-6 / 33.75, 1e-18);
}

TEST(PorousResistance, ByPermeabilityIsDarcysAndForchheimers) {
    Porous medium;
    medium.porosity = 0.3;
    medium.permeability = 4e-8;
    medium.forchheimer = 0.5;
    const PorousResistance law(medium, 1e-6);
    EXPECT_NEAR(law.linear(), 25.0, 1e-9);
    EXPECT_NEAR(law.quadratic(), 2500.0, 1e-7);
}

TEST(PorousResistance, SlopeAndIntegralAreThoseOfTheLaw) {
    const PorousResistance law(grains(0.45, 0.01), 1e-6);
    constexpr double step = 1e-6;
    for (const double q : {-0.03, 0.002, 0.1}) {
        EXPECT_NEAR(law.slope(q), (law.of(q + step) - law.of(q - step)) / (2.0 * step), 1e-5 * law.slope(q));
        EXPECT_NEAR(law.of(q), (law.integral(q + step) - law.integral(q - step)) / (2.0 * step),
                    1e-5 * std::abs(law.of(q)));
    }
}

TEST(PorousResistance, OfTheGrainsOfAPermeabilityIsTheSame) {
    Porous medium = grains(0.4, 0.005);
    Porous other;
    other.porosity = 0.4;
    other.permeability = permeability_of(medium);
    EXPECT_NEAR(grain_size_of(other), 0.005, 1e-9);
}

TEST(PorousMedia, LimitTheMixingLength) {
    Case c;
    c.channel.length = 0.5;
    c.channel.depth = 0.1;
    c.porous = {grains(0.4, 0.02)};
    c.porous.front().z_to = 0.05;
    c.porous.front().edge = 0.01;
    const PorousMedia media(c);
    EXPECT_NEAR(media.limited(0.01, 0.1, 0.0, 0.02), 0.002, 1e-12);
    EXPECT_NEAR(media.limited(0.001, 0.1, 0.0, 0.02), 0.001, 1e-12);
    EXPECT_EQ(media.limited(0.01, 0.1, 0.0, 0.08), 0.01);
    EXPECT_NEAR(media.limited(0.01, 0.1, 0.0, 0.05), 0.006, 1e-12);
}

}  // namespace
}  // namespace riffle::porous_resistance_test
