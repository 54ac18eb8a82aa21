#include "components/stirring_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_case.hpp"

namespace riffle::stirring_test {
namespace {

Case stirred_case() {
    Case c = test::small_channel();
    c.stirring.acceleration = 0.3;
    return c;
}

TEST(Stirring, HasNoMeanAlongTheChannelAtAnyHeight) {
    const Case c = stirred_case();
    const Stirring2D stirring(c, 0.3);
    constexpr int points = 64;
    for (double z = 0.0; z <= c.total_depth(); z += 0.1 * c.total_depth()) {
        double ax = 0.0;
        double az = 0.0;
        for (int i = 0; i < points; ++i) stirring.add(i * c.channel.length / points, z, 0.37, ax, az);
        EXPECT_NEAR(ax / points, 0.0, 1e-12);
        EXPECT_NEAR(az / points, 0.0, 1e-12);
    }
}

TEST(Stirring, VanishesAtTheBedAndTheSurface) {
    const Case c = stirred_case();
    const Stirring2D stirring(c, 0.3);
    for (const double z : {0.0, c.total_depth()}) {
        double ax = 0.0;
        double az = 0.0;
        stirring.add(0.013, z, 1.1, ax, az);
        EXPECT_NEAR(ax, 0.0, 1e-12);
        EXPECT_NEAR(az, 0.0, 1e-12);
    }
}

TEST(Stirring, IsFreeOfDivergence) {
    const Case c = stirred_case();
    const Stirring2D stirring(c, 0.3);
    const auto force = [&](double x, double z) {
        std::array<double, 2> a{};
        stirring.add(x, z, 0.2, a[0], a[1]);
        return a;
    };
    const double e = 1e-6;
    double largest = 0.0;
    for (double x = 0.0; x < c.channel.length; x += 0.007) {
        for (double z = 0.003; z < c.total_depth(); z += 0.005) {
            const double divergence = (force(x + e, z)[0] - force(x - e, z)[0]) / (2 * e) +
                                      (force(x, z + e)[1] - force(x, z - e)[1]) / (2 * e);
            EXPECT_NEAR(divergence, 0.0, 1e-6);
            largest = std::max(largest, std::hypot(force(x, z)[0], force(x, z)[1]));
        }
    }
    EXPECT_GT(largest, 0.1);
}

TEST(Stirring, OfZeroAccelerationIsOff) { EXPECT_FALSE(Stirring2D(test::small_channel(), 0.3).active()); }

Vec<3> stirring_at(const Stirring3D& stirring, const Vec<3>& x) {
    Vec<3> a{};
    stirring.add(x, 0.2, a);
    return a;
}

Case stirred_space(Sides sides) {
    Case c = test::small_channel(3);
    c.channel.dimensions = 3;
    c.channel.sides = sides;
    c.stirring.acceleration = 0.3;
    return c;
}

class Stirring3DTest : public testing::TestWithParam<Sides> {};

TEST_P(Stirring3DTest, HasNoMeanAlongTheChannelAndNoneAtBedAndSurface) {
    const Case c = stirred_space(GetParam());
    const Stirring3D stirring(c, 0.3);
    const double width = c.channel.simulated_width();
    constexpr int points = 64;
    for (double y = 0.0; y <= width; y += 0.17 * width) {
        for (double z = 0.0; z <= c.total_depth(); z += 0.125 * c.total_depth()) {
            Vec<3> sum{};
            for (int i = 0; i < points; ++i) {
                const Vec<3> a = stirring_at(stirring, {i * c.channel.length / points, y, z});
                for (std::size_t k = 0; k < 3; ++k) sum[k] += a[k] / points;
                if (z == 0.0 || z == c.total_depth()) {
                    EXPECT_NEAR(std::hypot(a[0], a[1], a[2]), 0.0, 1e-12);
                }
            }
            EXPECT_NEAR(std::hypot(sum[0], sum[1], sum[2]), 0.0, 1e-12);
        }
    }
}

TEST_P(Stirring3DTest, IsFreeOfDivergenceAndMovesTheWaterAcross) {
    const Case c = stirred_space(GetParam());
    const Stirring3D stirring(c, 0.3);
    const double e = 1e-7;
    double across = 0.0;
    for (double x = 0.0; x < c.channel.length; x += 0.011) {
        for (double y = 0.001; y < c.channel.width; y += 0.004) {
            for (double z = 0.003; z < c.total_depth(); z += 0.009) {
                double divergence = 0.0;
                for (std::size_t k = 0; k < 3; ++k) {
                    Vec<3> up{x, y, z};
                    Vec<3> down = up;
                    up[k] += e;
                    down[k] -= e;
                    divergence += (stirring_at(stirring, up)[k] - stirring_at(stirring, down)[k]) / (2.0 * e);
                }
                EXPECT_NEAR(divergence, 0.0, 1e-6);
                across = std::max(across, std::abs(stirring_at(stirring, {x, y, z})[1]));
            }
        }
    }
    EXPECT_GT(across, 0.05);
}

INSTANTIATE_TEST_SUITE_P(, Stirring3DTest, testing::Values(Sides::periodic, Sides::walls, Sides::half),
                         [](const auto& chosen) {
                             return chosen.param == Sides::periodic ? "periodic"
                                    : chosen.param == Sides::walls  ? "walls"
                                                                    : "half";
                         });

TEST(Stirring, DrivesNothingThroughSideWalls) {
    for (const Sides sides : {Sides::walls, Sides::half}) {
        const Case c = stirred_space(sides);
        const Stirring3D stirring(c, 0.3);
        for (const double y : {0.0, c.channel.simulated_width()}) {
            EXPECT_NEAR(stirring_at(stirring, {0.013, y, 0.02})[1], 0.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace riffle::stirring_test
