// Where porous zones are, and how their porosity changes at their edges.

#include "case/porous_zone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/flow_kind.hpp"
#include "changed_cases.hpp"

namespace riffle::porous_zone_test {
namespace {

Porous medium(double porosity) {
    Porous zone;
    zone.name = "medium";
    zone.porosity = porosity;
    zone.permeability = 1e-8;
    zone.edge = 0.01;
    return zone;
}

Case with_zone(Porous zone) {
    Case c = test::tank();
    c.channel.length = 0.2;
    c.porous = {std::move(zone)};
    return c;
}

/// Mean of 1 - n over a stretch of x at a height.
double mean_solid(const PorosityField& field, double from, double to, double z) {
    constexpr int places = 4000;
    double sum = 0.0;
    for (int i = 0; i < places; ++i) {
        sum += 1.0 - field.porosity(from + (i + 0.5) / places * (to - from), 0.0, z);
    }
    return sum / places;
}

TEST(PorousZone, HasHalfOfItsSolidAtAnEdgeAndAllOfItWithin) {
    Porous zone = medium(0.4);
    zone.x_from = 0.05;
    zone.x_to = 0.1;
    const PorosityField field(with_zone(zone));
    EXPECT_NEAR(field.porosity(0.05, 0.0, 0.02), 0.7, 1e-12);
    EXPECT_NEAR(field.porosity(0.075, 0.0, 0.02), 0.4, 1e-12);
    EXPECT_EQ(field.porosity(0.04, 0.0, 0.02), 1.0);
    // What the edges take from one side they give to the other.
    EXPECT_NEAR(mean_solid(field, 0.0, 0.2, 0.02), 0.6 * 0.05 / 0.2, 1e-6);
}

TEST(PorousZone, ThinnerThanItsEdgeKeepsItsSolid) {
    Porous zone = medium(0.4);
    zone.x_from = 0.098;
    zone.x_to = 0.102;
    EXPECT_NEAR(mean_solid(PorosityField(with_zone(zone)), 0.0, 0.2, 0.02), 0.6 * 0.004 / 0.2, 1e-6);
}

TEST(PorousZone, HasNoEdgeAtEndsAndBed) {
    Porous zone = medium(0.4);
    zone.x_from = 0.0;
    zone.x_to = 0.1;
    zone.z_from = 0.0;
    const PorosityField field(with_zone(zone));
    EXPECT_NEAR(field.porosity(0.0, 0.0, 0.0), 0.4, 1e-12);
    EXPECT_NEAR(field.porosity(0.0, 0.0, 1.0), 0.4, 1e-12);
    EXPECT_NEAR(field.porosity(0.1, 0.0, 0.0), 0.7, 1e-12);
}

TEST(PorousZone, HasNoEdgeAtASolidAndEndsThere) {
    Case c = test::with_solid();  // from x = 80 to 120 mm, 30 mm high
    Porous zone = medium(0.4);
    zone.x_from = 0.04;
    zone.x_to = 0.08;
    zone.z_to = 0.02;
    c.porous = {zone};
    const PorosityField field(c);
    EXPECT_NEAR(field.porosity(0.0799, 0.0, 0.005), 0.4, 1e-12);
    EXPECT_EQ(field.porosity(0.125, 0.0, 0.005), 1.0);
    // Not so where the solid ends below the zone.
    c.porous.front().z_to = 0.05;
    EXPECT_NEAR(PorosityField(c).porosity(0.08, 0.0, 0.005), 0.7, 1e-12);
}

TEST(PorousZone, ByAnOutlineIsThatOfTheBox) {
    Porous box = medium(0.4);
    box.x_from = 0.05;
    box.x_to = 0.1;
    box.z_to = 0.03;
    Porous outlined = medium(0.4);
    outlined.x = {0.05, 0.1, 0.1, 0.05};
    outlined.z = {0.0, 0.0, 0.03, 0.03};
    for (int turn = 0; turn < 2; ++turn) {
        const PorosityField a(with_zone(box));
        const PorosityField b(with_zone(outlined));
        for (const double x : {0.02, 0.049, 0.051, 0.075, 0.1, 0.103}) {
            for (const double z : {0.0, 0.01, 0.027, 0.03, 0.034, 0.05}) {
                EXPECT_NEAR(a.porosity(x, 0.0, z), b.porosity(x, 0.0, z), 1e-12) << x << " " << z;
            }
        }
        std::reverse(outlined.x.begin(), outlined.x.end());
        std::reverse(outlined.z.begin(), outlined.z.end());
    }
}

/// A channel in space, 0.2 by 0.1 m in plan.
Case channel_in_space(std::vector<Porous> zones, Ends ends, Sides sides) {
    Case c = test::cell();
    c.channel.length = 0.2;
    c.channel.width = 0.1;
    c.channel.ends = ends;
    c.channel.sides = sides;
    c.porous = std::move(zones);
    return c;
}

Porous outlined_in_plan(std::vector<double> x, std::vector<double> y) {
    Porous zone = medium(0.4);
    zone.x = std::move(x);
    zone.y = std::move(y);
    return zone;
}

TEST(PorousZone, ByAnOutlineInPlanIsThatOfTheBox) {
    Porous box = medium(0.4);
    box.x_from = 0.05;
    box.x_to = 0.1;
    box.y_from = 0.03;
    box.z_to = 0.02;
    Porous outlined = outlined_in_plan({0.05, 0.1, 0.1, 0.05}, {0.03, 0.03, 0.1, 0.1});
    outlined.z_to = 0.02;
    const PorosityField a(channel_in_space({box}, Ends::walls, Sides::walls));
    const PorosityField b(channel_in_space({outlined}, Ends::walls, Sides::walls));
    for (const double x : {0.02, 0.049, 0.051, 0.075, 0.1, 0.103}) {
        for (const double y : {0.0, 0.027, 0.031, 0.06, 0.0999}) {
            for (const double z : {0.0, 0.018, 0.023}) {
                EXPECT_NEAR(a.porosity(x, y, z), b.porosity(x, y, z), 1e-12) << x << " " << y << " " << z;
            }
        }
    }
}

TEST(PorousZone, AroundAnOutlineInPlanKeepsItsSolid) {
    // A triangle that reaches beyond a periodic end, where it comes again.
    const Porous zone = outlined_in_plan({0.1, 0.2, 0.15}, {0.02, 0.04, 0.08});
    const PorosityField field(channel_in_space({zone}, Ends::periodic, Sides::periodic));
    constexpr int places = 400;
    double sum = 0.0;
    for (int i = 0; i < places; ++i) {
        for (int j = 0; j < places; ++j) {
            sum += 1.0 - field.porosity((i + 0.5) / places * 0.2, (j + 0.5) / places * 0.1, 0.01);
        }
    }
    const double area = std::abs(signed_area({zone.x, zone.y}));
    EXPECT_NEAR(sum / places / places, 0.6 * area / (0.2 * 0.1), 1e-6);
}

TEST(PorousZone, OfManyCornersHasTheShareOfItsArea) {
    constexpr int corners = 600;
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < corners; ++i) {
        x.push_back(0.1 + 0.03 * std::cos(2.0 * std::numbers::pi * i / corners));
        y.push_back(0.05 - 0.03 * std::sin(2.0 * std::numbers::pi * i / corners));
    }
    const PorosityField field(channel_in_space({outlined_in_plan(x, y)}, Ends::walls, Sides::walls));
    EXPECT_NEAR(field.porosity(0.1, 0.05, 0.01), 0.4, 1e-12);
    EXPECT_NEAR(field.porosity(0.12, 0.05, 0.01), 0.4, 1e-12);
    EXPECT_EQ(field.porosity(0.1, 0.086, 0.01), 1.0);
    // On a circle of the radius R somewhat less than half of a place lies within: p v/(2 R), where p is the
    // weight of places on a straight edge and v their mean square distance along it. Along the axes p = 1.5/e
    // and v = e^2/20, on diagonals p = 1.2 sqrt(2)/e and v = e^2/14, e the thickness of the edge.
    const auto share_at = [&](double turn) {
        return (1.0 - field.porosity(0.1 + 0.03 * std::cos(turn), 0.05 + 0.03 * std::sin(turn), 0.01)) / 0.6;
    };
    constexpr double edge = 0.01;
    constexpr double quarter = 0.5 * std::numbers::pi;
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(share_at(k * quarter), 0.5 - 1.5 * edge / 20 / 0.06, 0.001);
        EXPECT_NEAR(share_at((k + 0.5) * quarter), 0.5 - 1.2 * std::numbers::sqrt2 * edge / 14 / 0.06, 0.001);
    }
}

TEST(PorousZone, OutlinesThatFillThePlanLeaveNoGapAndNoExcess) {
    // Six wedges about a corner in the middle of the plan, of all angles.
    const std::vector<double> x{0.0, 0.0, 0.0, 0.2, 0.2, 0.2};
    const std::vector<double> y{0.1, 0.06, 0.0, 0.0, 0.03, 0.1};
    std::vector<Porous> zones;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t j = (i + 1) % x.size();
        zones.push_back(outlined_in_plan({0.13, x[i], x[j]}, {0.06, y[i], y[j]}));
    }
    for (const Sides sides : {Sides::walls, Sides::periodic}) {
        const Ends ends = sides == Sides::walls ? Ends::walls : Ends::periodic;
        const PorosityField field(channel_in_space(zones, ends, sides));
        for (const double along : {0.0, 0.003, 0.06, 0.127, 0.13, 0.135, 0.199, 0.2}) {
            for (const double across : {0.0, 0.002, 0.031, 0.057, 0.06, 0.064, 0.0999}) {
                EXPECT_NEAR(field.porosity(along, across, 0.01), 0.4, 1e-12) << along << " " << across;
            }
        }
    }
}

// Both corners of an edge at bounds, but not at the same one.
TEST(PorousZone, FromBoundToBoundKeepsItsEdges) {
    Porous dam = outlined_in_plan({0.06, 0.14, 0.14, 0.06}, {0.0, 0.0, 0.1, 0.1});
    const PorosityField across(channel_in_space({dam}, Ends::walls, Sides::walls));
    Porous bank = outlined_in_plan({0.0, 0.2, 0.2, 0.0}, {0.0, 0.0, 0.04, 0.04});
    const PorosityField along(channel_in_space({bank}, Ends::walls, Sides::walls));
    for (const double y : {0.0, 0.05, 0.1}) {
        EXPECT_NEAR(across.porosity(0.06, y, 0.01), 0.7, 1e-12);
        EXPECT_EQ(across.porosity(0.054, y, 0.01), 1.0);
        EXPECT_NEAR(across.porosity(0.066, y, 0.01), 0.4, 1e-12);
    }
    for (const double x : {0.0, 0.1, 0.2}) {
        EXPECT_NEAR(along.porosity(x, 0.04, 0.01), 0.7, 1e-12);
        EXPECT_EQ(along.porosity(x, 0.046, 0.01), 1.0);
    }
    Porous layer = medium(0.4);
    layer.x = {0.0, 0.2, 0.2, 0.0};
    layer.z = {0.0, 0.0, 0.03, 0.03};
    const PorosityField plane(with_zone(layer));
    EXPECT_NEAR(plane.porosity(0.1, 0.0, 0.03), 0.7, 1e-12);
    EXPECT_EQ(plane.porosity(0.1, 0.0, 0.036), 1.0);
}

TEST(PorousZone, OutlinesThatMeetAWallInACornerFillIt) {
    std::vector<Porous> zones{outlined_in_plan({0.0, 0.12, 0.0}, {0.0, 0.0, 0.036}),
                              outlined_in_plan({0.12, 0.2, 0.2}, {0.0, 0.0, 0.036}),
                              outlined_in_plan({0.12, 0.2, 0.2, 0.0, 0.0}, {0.0, 0.036, 0.1, 0.1, 0.036})};
    const PorosityField field(channel_in_space(zones, Ends::walls, Sides::walls));
    for (const double x : {0.0, 0.1, 0.118, 0.12, 0.125, 0.2}) {
        for (const double y : {0.0, 0.001, 0.004, 0.03, 0.0999}) {
            EXPECT_NEAR(field.porosity(x, y, 0.01), 0.4, 1e-12) << x << " " << y;
        }
    }
}

TEST(PorousZone, RoundAgainstAWallHasItsMediumThere) {
    for (const int corners : {8, 16, 24, 36}) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < corners; ++i) {
            const double turn = 2.0 * std::numbers::pi * (i + 0.5) / corners;
            x.push_back(0.1 + 0.03 * std::sin(turn));
            y.push_back(0.03 * (std::cos(std::numbers::pi / corners) - std::cos(turn)));
        }
        const PorosityField field(channel_in_space({outlined_in_plan(x, y)}, Ends::walls, Sides::walls));
        EXPECT_LT(field.porosity(0.1, 0.0, 0.01), 0.55) << corners;
        EXPECT_NEAR(field.porosity(0.1, 0.02, 0.01), 0.4, 1e-12) << corners;
    }
}

TEST(PorousZone, ByAnOutlineEndsAtASolidAndNotBeyond) {
    Case c = test::with_solid();  // from x = 80 to 120 mm, 30 mm high
    Porous zone = medium(0.4);
    zone.edge = 0.024;
    zone.x = {0.04, 0.08, 0.08, 0.04};
    zone.z = {0.0, 0.0, 0.02, 0.02};
    c.porous = {zone};
    const PorosityField field(c);
    EXPECT_NEAR(field.porosity(0.0799, 0.0, 0.002), 0.4, 1e-12);
    EXPECT_NEAR(field.porosity(0.07, 0.0, 0.002), 0.4, 1e-12);
    EXPECT_EQ(field.porosity(0.1, 0.0, 0.005), 1.0);
    // A wall of 10 mm holds nothing of it back, as an edge would, on its other side.
    c.solids.front().x = {0.08, 0.09, 0.09, 0.08};
    const PorosityField thin(c);
    EXPECT_NEAR(thin.porosity(0.0799, 0.0, 0.002), 0.4, 1e-12);
    EXPECT_EQ(thin.porosity(0.0901, 0.0, 0.005), 1.0);
}

TEST(PorousZone, UnderALidHasNoEdgeThere) {
    Porous zone = medium(0.4);
    zone.x = {0.06, 0.14, 0.14, 0.06};
    Case c = with_zone(zone);
    c.channel.top = Top::wall;
    c.porous.front().z = {0.0, 0.0, c.total_depth(), c.total_depth()};
    EXPECT_NEAR(PorosityField(c).porosity(0.1, 0.0, 0.999 * c.total_depth()), 0.4, 1e-12);
}

TEST(PorousZone, WithHalfAnOutlineIsNoneYet) {
    Porous zone = medium(0.4);
    zone.x = {0.01, 0.04, 0.04};
    EXPECT_TRUE(std::isfinite(PorosityField(with_zone(zone)).porosity(0.02, 0.0, 0.01)));
}

TEST(PorousZone, HasATopByHeights) {
    Porous zone = medium(0.4);
    zone.top_x = {0.0, 0.1, 0.2};
    zone.top_z = {0.02, 0.04, 0.04};
    const PorousZone shape(with_zone(zone), zone);
    EXPECT_NEAR(shape.share(0.05, 0.0, 0.03), 0.5, 1e-6);
    EXPECT_NEAR(shape.share(0.15, 0.0, 0.04), 0.5, 1e-6);
    EXPECT_TRUE(shape.holds(0.15, 0.0, 0.039));
    EXPECT_FALSE(shape.holds(0.05, 0.0, 0.031));
    EXPECT_NEAR(shape.top_at(0.05), 0.03, 1e-12);
}

TEST(PorousZone, ComesAgainAtPeriodicEnds) {
    Porous zone = medium(0.4);
    zone.x_from = 0.15;
    zone.x_to = 0.2;
    Case c = with_zone(zone);
    c.channel.ends = Ends::periodic;
    const PorosityField field(c);
    EXPECT_NEAR(field.porosity(0.0, 0.0, 0.02), 0.7, 1e-12);
    EXPECT_NEAR(field.porosity(0.2, 0.0, 0.02), 0.7, 1e-12);
    EXPECT_NEAR(field.porosity(0.199, 0.0, 0.02), field.porosity(0.151, 0.0, 0.02), 1e-12);
}

TEST(PorousZone, ZonesBesideEachOtherMeetWithoutAGap) {
    const PorosityField field(with_zone(medium(1.0)));
    EXPECT_EQ(field.porosity(0.1, 0.0, 0.02), 1.0);
    Case c = test::with_porous();
    c.porous.back().porosity = 0.4;
    for (const double x : {0.095, 0.1, 0.1003}) {
        EXPECT_NEAR(PorosityField(c).porosity(x, 0.0, 0.02), 0.4, 1e-12) << x;
    }
}

TEST(PorousZone, AllAlongTheChannelIsALayer) {
    Porous zone = medium(0.4);
    zone.z_to = 0.02;
    Case c = with_zone(zone);
    EXPECT_FALSE(porosity_varies_along(c));
    c.channel.ends = Ends::periodic;
    c.channel.slope = 0.01;
    EXPECT_EQ(flow_kind(c), FlowKind::uniform_channel);
    EXPECT_FALSE(why_no_column(c).has_value());
    c.porous.front().x_from = 0.1;
    EXPECT_TRUE(porosity_varies_along(c));
    EXPECT_EQ(flow_kind(c), FlowKind::channel_with_bodies);
}

TEST(PorousZone, HasAnOutlineToDraw) {
    Porous zone = medium(0.4);
    zone.x_from = 0.05;
    zone.z_to = 0.04;
    const Case box = with_zone(zone);
    const Outline outline = porous_cuts_along(box, zone, 0.0, 0.1).at(0);
    EXPECT_EQ(outline.x, (std::vector<double>{0.05, 0.2, 0.2, 0.05}));
    EXPECT_EQ(outline.z, (std::vector<double>{0.0, 0.0, 0.04, 0.04}));
    // A top that changes along it, no higher than what is shown.
    zone.z_to.reset();
    zone.top_x = {0.05, 0.2};
    zone.top_z = {0.02, 0.08};
    const Outline ramp = porous_cuts_along(with_zone(zone), zone, 0.0, 0.05).at(0);
    EXPECT_NEAR(ramp.z.back(), 0.02, 1e-12);
    EXPECT_DOUBLE_EQ(*std::max_element(ramp.z.begin(), ramp.z.end()), 0.05);
}

}  // namespace
}  // namespace riffle::porous_zone_test
