// Drops: particles out of reach of all others.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_case.hpp"

namespace riffle::falling_drop_test {
namespace {

/// Still water with one particle above it, `height` spacings over the surface. The water's columns hold whole
/// clusters (8 rows), so that the drop is a cluster of its own.
template <int D>
struct WaterWithDrop {
    Case parameters = test::still_water(D);
    std::int64_t drop = 0;
    std::unique_ptr<SimulationIn<D>> simulation;

    WaterWithDrop(double height, double velocity) {
        Case& c = parameters;
        c.channel.depth = 0.032;
        Particles<D> particles =
            test::water_and<D>(c, {test::place<D>(0.5 * c.channel.length, 0.5 * c.channel.width,
                                                  c.total_depth() + height * c.numerics.spacing)});
        drop = particles.id.back();
        particles.velocity[D - 1].back() = velocity;
        simulation = make_simulation<D>(c, nullptr, particles);
    }
    [[nodiscard]] std::size_t place() const {
        const auto& id = simulation->particles().id;
        return static_cast<std::size_t>(std::find(id.begin(), id.end(), drop) - id.begin());
    }
    [[nodiscard]] double height() const { return simulation->particles().position[D - 1][place()]; }
    [[nodiscard]] double velocity() const { return simulation->particles().velocity[D - 1][place()]; }
    /// Distance of the drop to the nearest other particle, in smoothing lengths.
    [[nodiscard]] double nearest() const {
        const Particles<D>& p = simulation->particles();
        double nearest = 1e300;
        for (std::size_t j = 0; j < p.size(); ++j) {
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                squared += std::pow(p.position[k][j] - p.position[k][place()], 2);
            }
            nearest = j == place() ? nearest : std::min(nearest, squared);
        }
        return std::sqrt(nearest) / simulation->scheme().smoothing_length;
    }
};

// Without neighbours every sum is zero and M singular: what remains is free fall.
template <int D>
void check_free_fall() {
    WaterWithDrop<D> water(5.0, 0.0);
    const double g = water.parameters.fluid.gravity;
    for (int i = 0; i < 10; ++i) {
        ASSERT_GT(water.nearest(), 2.0);
        water.simulation->step();
        // The leapfrog's velocity is that of the middle of the step.
        const SimulationClock& clock = water.simulation->clock();
        EXPECT_NEAR(water.velocity(), -g * (clock.time - 0.5 * clock.time_step), 1e-12);
    }
}

TEST(Drop, FallsFreely2D) { check_free_fall<2>(); }
TEST(Drop, FallsFreely3D) { check_free_fall<3>(); }

// A cluster that was out of reach of all others when the lists were built stands in none of them; the drop
// must be seen all the same. From one smoothing length on the water must push a drop back.
template <int D>
void check_impact() {
    WaterWithDrop<D> water(4.0, -2.0);
    const double g = water.parameters.fluid.gravity;
    int near = 0;
    for (int i = 0; i < 20 && near == 0; ++i) {
        const bool within = water.nearest() < 1.0;
        const double before = water.velocity();
        water.simulation->step();
        const double acceleration = (water.velocity() - before) / water.simulation->clock().time_step;
        near += within ? 1 : 0;
        EXPECT_TRUE(!within || acceleration > 0.0)
            << "at z = " << water.height() << " m, " << acceleration / g << " g, after "
            << water.simulation->clock().list_builds << " builds of the lists";
    }
    EXPECT_GT(near, 0);
}

TEST(Drop, IsFeltByTheWater2D) { check_impact<2>(); }
TEST(Drop, IsFeltByTheWater3D) { check_impact<3>(); }

}  // namespace
}  // namespace riffle::falling_drop_test
