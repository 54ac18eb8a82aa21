#include "solver/stirring.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_case.hpp"

namespace riffle {
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
        for (int i = 0; i < points; ++i) {
            stirring.add(i * c.channel.length / points, z, 0.37, ax, az);
        }
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

}  // namespace
}  // namespace riffle
