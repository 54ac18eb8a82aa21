// Particles that leave the domain: the ledger, and that the others go on as if nothing had happened.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::losses_test {
namespace {

/// Still water and some drops over it that fly up and out of the domain, one after the other.
template <int D>
struct WaterWithDrops {
    Case parameters = test::still_water(D);
    std::size_t water = 0;
    std::unique_ptr<SimulationIn<D>> simulation;

    explicit WaterWithDrops(Stepping stepping = Stepping::semi_implicit_euler, double speed = 4.0) {
        Case& c = parameters;
        c.start.jitter = 0.1;
        c.numerics.stepping = stepping;
        c.numerics.courant_number = stepping == Stepping::verlet ? 0.2 : 0.4;
        std::vector<Vec<D>> drops;
        for (int n = 0; n < 3; ++n) {
            drops.push_back(test::place<D>(0.02 * n + 0.01, 0.5 * c.channel.width,
                                           c.total_depth() + (6.0 + 3.0 * n) * c.numerics.spacing));
        }
        Particles<D> p = test::water_and<D>(c, drops);
        water = p.size() - drops.size();
        std::fill(p.velocity[D - 1].begin() + static_cast<std::ptrdiff_t>(water), p.velocity[D - 1].end(),
                  speed);
        simulation = make_simulation<D>(c, nullptr, p);
    }
    void advance(int steps) const {
        for (int i = 0; i < steps; ++i) simulation->step();
    }
    [[nodiscard]] const Particles<D>& particles() const { return simulation->particles(); }
};

template <int D>
void check_ledger(Stepping stepping) {
    const WaterWithDrops<D> water(stepping);
    const auto sum = [](const std::vector<double>& mass) {
        return std::accumulate(mass.begin(), mass.end(), 0.0);
    };
    const double before = sum(water.particles().mass);
    std::size_t last = 0;
    for (int i = 0; i < 300 && last < 3; ++i) {
        water.advance(1);
        last = water.particles().lost.size();
        // Everything by particle has as many rows.
        ASSERT_EQ(water.particles().size() + last, water.water + 3);
        ASSERT_EQ(water.particles().position[0].size(), water.particles().size());
        ASSERT_EQ(water.simulation->fields().pressure.size(), water.particles().size());
        ASSERT_EQ(test::saved_particles(*water.simulation).mass.size(), water.particles().size());
    }
    const auto& lost = water.particles().lost;
    ASSERT_EQ(lost.size(), 3U);
    // The leapfrog has the velocity of the middle of each step.
    const double behind = stepping == Stepping::leapfrog ? 0.5 * water.simulation->clock().time_step : 0.0;
    water.advance(20);
    double mass = sum(water.particles().mass);
    double time = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        // The highest left first.
        EXPECT_EQ(lost[i].id, static_cast<std::int32_t>(water.water + 2 - i));
        EXPECT_EQ(lost[i].exit, Exit::above);
        EXPECT_GT(lost[i].position[2], 2.0 * water.parameters.total_depth());
        EXPECT_NEAR(lost[i].velocity[2], 4.0 - 9.81 * (lost[i].time - behind), 1e-9);
        EXPECT_GT(lost[i].time, time);
        time = lost[i].time;
        mass += lost[i].mass;
    }
    EXPECT_NEAR(mass, before, 1e-12 * before);
    auto ids = water.particles().id;
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < ids.size(); ++i) ASSERT_EQ(ids[i], static_cast<std::int32_t>(i));
}

class Ledger : public testing::TestWithParam<Stepping> {};

TEST_P(Ledger, HoldsTheLossesIn2D) { check_ledger<2>(GetParam()); }
TEST_P(Ledger, HoldsTheLossesIn3D) { check_ledger<3>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Losses, Ledger,
                         testing::Values(Stepping::semi_implicit_euler, Stepping::predictor_corrector,
                                         Stepping::verlet, Stepping::symplectic, Stepping::beeman,
                                         Stepping::leapfrog),
                         [](const auto& chosen) {
                             return "method" + std::to_string(static_cast<int>(chosen.param));
                         });

TEST(Losses, LeaveTheSameBitsForAnyNumberOfThreads) {
    set_thread_count(1);
    const WaterWithDrops<2> one;
    one.advance(300);
    set_thread_count(2);
    const WaterWithDrops<2> two;
    two.advance(300);
    set_thread_count(0);
    ASSERT_EQ(one.particles().lost.size(), 3U);
    EXPECT_EQ(one.particles().lost, two.particles().lost);
    test::expect_same_bits(one.particles(), two.particles());
}

// Saved between the loss and the next step, when the lists still count the particle, and after it.
TEST(Losses, LeaveTheSameBitsAfterAResume) {
    for (const int later : {0, 1, 7}) {
        const WaterWithDrops<2> straight;
        while (straight.particles().lost.empty()) straight.advance(1);
        straight.advance(later);
        const Particles<2> saved = test::saved_particles(*straight.simulation);
        const SimulationClock clock = straight.simulation->clock();
        const auto walls = straight.simulation->wall_density_deviation();
        const WaterWithDrops<2> resumed;
        resumed.simulation->restore(saved, clock, walls);
        straight.advance(150);
        resumed.advance(150);
        test::expect_same_bits(straight.particles(), resumed.particles());
        EXPECT_EQ(straight.particles().lost, resumed.particles().lost);
        EXPECT_EQ(straight.simulation->clock().time, resumed.simulation->clock().time);
        EXPECT_EQ(straight.simulation->clock().list_builds, resumed.simulation->clock().list_builds);
    }
}

// A step that throws a particle out by more than a smoothing length is no flight but a failure.
TEST(Losses, OfAWildStepAreAnError) {
    const WaterWithDrops<2> water(Stepping::semi_implicit_euler, 500.0);
    EXPECT_THROW(water.advance(50), RunError);
}

// Fields of a sample before particles came or went are of no use for those that stay.
TEST(ParticleFields, KeepsWhatIsOfTheseParticlesAlone) {
    ParticleFields fields;
    fields.reset<float>(5, 2, 1000.0);
    fields.pressure.set(3, 2.0F);
    fields.shear_stress[3] = 4.0;
    fields.keep({0, 3}, 5);
    ASSERT_EQ(fields.pressure.size(), 2U);
    EXPECT_EQ(fields.pressure[1], 2000.0);
    EXPECT_EQ(fields.shear_stress, std::vector<double>({0.0, 4.0}));
    // There are six now, of which one leaves.
    fields.keep({0, 1, 2, 4, 5}, 6);
    EXPECT_EQ(fields.pressure.size(), 0U);
    EXPECT_EQ(fields.eddy_viscosity.size(), 0U);
    EXPECT_TRUE(fields.shear_stress.empty());
    EXPECT_EQ(fields.wall_acceleration_x.size(), 0U);
}

}  // namespace
}  // namespace riffle::losses_test
