// Shares of particles that stand in a patch.

#include "roughness/patch_area.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "vegetated_channel.hpp"

namespace riffle {
namespace {

constexpr double spacing = 0.01;

Case channel() {
    Case c = test::slip_channel(0.001, 0.1);
    c.channel.dimensions = 3;
    c.channel.length = 0.5;
    c.channel.width = 0.3;
    c.numerics.spacing = spacing;
    return c;
}

/// Sum of the shares of squares that tile the channel, the first of which has its corner at a place, over the
/// area of a square.
double covered_area(const Case& c, const Vegetation& patch, double x, double y) {
    const PatchArea area(c, patch);
    double sum = 0.0;
    for (int i = 0; i < 50; ++i) {
        for (int j = 0; j < 30; ++j) {
            // As particles do, within the channel.
            const double along = std::fmod(x + (i + 0.5) * spacing, c.channel.length);
            const double across = std::fmod(y + (j + 0.5) * spacing, c.channel.width);
            sum += area.share(along, across, spacing) * spacing * spacing;
        }
    }
    return sum;
}

TEST(PatchArea, OfAnOutlineIsThatOfItsRectangle) {
    const Case c = channel();
    Vegetation rectangle = test::stems(400.0, 0.008, 0.05, 1.0);
    Vegetation outlined = rectangle;
    rectangle.x_from = 0.103;
    rectangle.x_to = 0.28;
    rectangle.y_from = 0.0;
    rectangle.y_to = 0.117;
    outlined.x = {0.103, 0.28, 0.28, 0.103};
    outlined.y = {0.0, 0.0, 0.117, 0.117};
    const PatchArea one(c, rectangle);
    const PatchArea other(c, outlined);
    for (double x = 0.0013; x < 0.5; x += 0.0037) {
        for (double y = 0.0011; y < 0.3; y += 0.0041) {
            EXPECT_NEAR(one.share(x, y, spacing), other.share(x, y, spacing), 1e-12) << x << " " << y;
        }
    }
}

// Whatever the places of the particles, together they stand on the whole patch: the drag of stems does not
// depend on how the lattice lies to an outline. One with a bay, another that touches the periodic edges.
TEST(PatchArea, SharesAddUpToTheOutline) {
    const Case c = channel();
    Vegetation bay = test::stems(400.0, 0.008, 0.05, 1.0);
    bay.x = {0.11, 0.42, 0.44, 0.3, 0.26, 0.2, 0.13};
    bay.y = {0.07, 0.05, 0.26, 0.25, 0.11, 0.24, 0.22};
    Vegetation wedge = bay;
    wedge.x = {0.0, 0.5, 0.5};
    wedge.y = {0.0, 0.0, 0.3};
    for (const Vegetation& patch : {bay, wedge}) {
        const double area = std::abs(signed_area({patch.x, patch.y}));
        for (const double x : {0.0, 0.0021, 0.0064}) {
            for (const double y : {0.0, 0.0035}) {
                EXPECT_NEAR(covered_area(c, patch, x, y), area, 1e-12) << x << " " << y;
            }
        }
    }
}

}  // namespace
}  // namespace riffle
