// Uniform flow in canals by the equation of Colebrook and White.

#include "column/canal_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::canal_flow_test {
namespace {

/// A trapezoid 300 mm wide at the bottom, banks of one in one, 150 mm deep, k_s 1 mm.
Case canal() {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::walls;
    c.channel.depth = 0.15;
    c.channel.width = 0.64;
    c.channel.slope = 0.001;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.side_walls.drag_form = SideDragForm::none;
    Solid solid;
    solid.shape = SolidShape::trapezoid;
    solid.bottom_width = 0.3;
    solid.surface = SolidSurface::log_law;
    solid.equivalent_roughness = 1e-3;
    c.solids = {solid};
    return c;
}

TEST(CanalFlow, SolvesColebrookAndWhite) {
    const Case c = canal();
    const auto flow = canal_flow(c);
    ASSERT_TRUE(flow);
    const double area = (0.3 + 0.15) * 0.15;
    const double radius = area / (0.3 + 2.0 * std::sqrt(2.0) * 0.15);
    EXPECT_NEAR(flow->hydraulic_radius, radius, 1e-12);
    EXPECT_NEAR(flow->discharge, area * flow->velocity, 1e-12);
    // Explicit in the friction velocity: Re sqrt(f) = 4 sqrt(8) R u_*/nu.
    const double u_star = std::sqrt(c.streamwise_gravity() * radius);
    const double law = -2.0 * std::sqrt(8.0) *
                       std::log10(1e-3 / (14.83 * radius) + 2.52 * c.fluid.kinematic_viscosity /
                                                                (4.0 * std::sqrt(8.0) * radius * u_star));
    EXPECT_NEAR(flow->velocity, law * u_star, 1e-6 * flow->velocity);
}

TEST(CanalFlow, OfHalfACanalIsThatOfTheWhole) {
    Case c = canal();
    const auto whole = canal_flow(c);
    c.channel.sides = Sides::half;
    const auto half = canal_flow(c);
    ASSERT_TRUE(whole && half);
    EXPECT_NEAR(half->velocity, whole->velocity, 1e-12);
    EXPECT_NEAR(half->discharge, whole->discharge, 1e-12);
}

TEST(CanalFlow, CountsSidesThatRub) {
    Case c = canal();
    c.solids[0].bank_height = 0.1;
    c.solids[0].bottom_width = 0.44;  // the water stands 50 mm high against the sides
    const auto smooth = canal_flow(c);
    c.side_walls.drag_form = SideDragForm::log_law;
    const auto rough = canal_flow(c);
    ASSERT_TRUE(smooth && rough);
    EXPECT_NEAR(rough->wet.area / rough->hydraulic_radius - smooth->wet.area / smooth->hydraulic_radius, 0.1,
                1e-12);
}

TEST(CanalFlow, IsThatOfCanalsAlone) {
    Case c = canal();
    c.solids[0].surface = SolidSurface::no_slip;
    EXPECT_FALSE(canal_flow(c));
    c = canal();
    c.solids.push_back(c.solids[0]);
    EXPECT_FALSE(canal_flow(c));
    c = canal();
    c.channel.ends = Ends::open;
    EXPECT_FALSE(canal_flow(c));
}

}  // namespace
}  // namespace riffle::canal_flow_test
