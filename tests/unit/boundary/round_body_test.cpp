#include "boundary/round_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::round_body_test {
namespace {

Solid cylinder(SolidAxis axis) {
    Solid solid;
    solid.shape = SolidShape::cylinder;
    solid.centre = {0.1, 0.2, 0.3};
    solid.axis = axis;
    return solid;
}

/// A force, and a moment about the centre that no pressure on a round body has.
ForceOnSolid load() {
    ForceOnSolid force;
    force.pressure = {3.0, -1.0, 2.0};
    force.friction_moment = {0.5, 0.6, 0.7};
    return force;
}

TEST(RoundBody, HasNoMomentOfPressureAboutItsAxis) {
    const auto body = round_body(cylinder(SolidAxis::y));
    ASSERT_TRUE(body);
    ForceOnSolid force = load();
    force.pressure_moment = {4.0, 5.0, 6.0};
    body->clear_moment(force, {0.1, 0.2, 0.3}, {});
    EXPECT_EQ(force.pressure_moment, (std::array{4.0, 0.0, 6.0}));
    EXPECT_EQ(force.pressure, load().pressure);
    EXPECT_EQ(force.friction_moment, load().friction_moment);
}

// About another point it is that of the force through the axis.
TEST(RoundBody, AboutAPointBesideItsAxisHasTheMomentOfTheForce) {
    const auto body = round_body(cylinder(SolidAxis::z));
    ForceOnSolid force = load();
    force.pressure_moment = {0.0, 0.0, 5.0};
    body->clear_moment(force, {0.1, 0.4, 0.3}, {});
    // r x F with r from the point to the centre, (0, -0.2, 0).
    EXPECT_NEAR(force.pressure_moment[2], 0.2 * 3.0, 1e-14);
}

TEST(RoundBody, TurnsItsAxisWithIt) {
    BodyState turned;
    turned.turns = true;
    turned.centre = {0.1, 0.2, 0.3};
    turned.rotation = rotation_about({0.0, 1.0, 0.0}, std::acos(0.0));  // z to x
    ForceOnSolid force;
    force.pressure_moment = {4.0, 5.0, 6.0};
    round_body(cylinder(SolidAxis::z))->clear_moment(force, {0.1, 0.2, 0.3}, turned);
    EXPECT_NEAR(force.pressure_moment[0], 0.0, 1e-14);
    EXPECT_NEAR(force.pressure_moment[1], 5.0, 1e-14);
    EXPECT_NEAR(force.pressure_moment[2], 6.0, 1e-14);
}

TEST(RoundBody, OfASphereHasNoMomentAtAll) {
    Solid sphere = cylinder(SolidAxis::x);
    sphere.shape = SolidShape::sphere;
    ForceOnSolid force = load();
    force.pressure_moment = {4.0, 5.0, 6.0};
    round_body(sphere)->clear_moment(force, {0.1, 0.2, 0.3}, {});
    for (const double moment : force.pressure_moment) EXPECT_NEAR(moment, 0.0, 1e-14);
}

TEST(RoundBody, IsNoBox) {
    Solid box = cylinder(SolidAxis::x);
    box.shape = SolidShape::box;
    EXPECT_FALSE(round_body(box));
}

}  // namespace
}  // namespace riffle::round_body_test
