// Particles that stand closer than there is room for them are driven apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "same_bits.hpp"
#include "small_case.hpp"
#include "sph/crowding.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle::crowding_test {
namespace {

/// Still water in a tank that is periodic along, with as many particles more at nearly one place in its
/// middle, of whom no density knows.
template <int D>
struct CrowdedWater {
    Case parameters = test::still_water(D);
    std::unique_ptr<SimulationIn<D>> simulation;

    CrowdedWater(std::size_t more, double impact_dissipation) {
        Case& c = parameters;
        c.numerics.impact_dissipation = impact_dissipation;
        c.start.jitter = more == 0 ? 0.1 : 0.0;
        std::vector<Vec<D>> places;
        for (std::size_t n = 0; n < more; ++n) {
            const double angle = 2.4 * static_cast<double>(n);
            const double radius = 0.05 * c.numerics.spacing * std::sqrt(static_cast<double>(n) + 0.5);
            places.push_back(test::place<D>(0.5 * c.channel.length + radius * std::cos(angle),
                                            0.5 * c.channel.width + radius * std::sin(3.0 * angle),
                                            0.5 * c.total_depth() + radius * std::sin(angle)));
        }
        Particles<D> p = test::water_and<D>(c, places);
        const Scheme scheme = make_scheme(c, nullptr);
        for (std::size_t i = p.size() - more; i < p.size(); ++i) {
            p.density_deviation[i] = scheme.hydrostatic_deviation(p.position[D - 1][i]);
        }
        simulation = make_simulation<D>(c, nullptr, p);
    }

    /// The largest sum of V W over a particle and its neighbours.
    [[nodiscard]] double fill() const {
        const Particles<D>& p = simulation->particles();
        const double h = simulation->scheme().smoothing_length;
        const ScalarKernel kernel = scalar_kernel<D>(parameters.numerics.kernel);
        double largest = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            double sum = 0.0;
            for (std::size_t j = 0; j < p.size(); ++j) {
                double squared = 0.0;
                for (std::size_t k = 0; k < D; ++k) {
                    const double r = p.position[k][i] - p.position[k][j];
                    squared += r * r;
                }
                const double q = std::sqrt(squared) / h;
                if (q < 2.0) {
                    const double density = parameters.fluid.density * (1.0 + p.density_deviation[j]);
                    sum += p.mass[j] / density * kernel.value(q) / std::pow(h, D);
                }
            }
            largest = std::max(largest, sum);
        }
        return largest;
    }
    [[nodiscard]] double fastest() const {
        const Particles<D>& p = simulation->particles();
        double squared = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            double sum = 0.0;
            for (std::size_t k = 0; k < D; ++k) sum += p.velocity[k][i] * p.velocity[k][i];
            squared = std::max(squared, sum);
        }
        return std::sqrt(squared);
    }
    [[nodiscard]] double sound_speed() const { return simulation->scheme().state.sound_speed; }
    /// Some times the crowd's own, 100 h/c0.
    void advance(double times, double& speed) const {
        const double end = times * 100.0 * simulation->scheme().smoothing_length / sound_speed();
        while (simulation->clock().time < end) {
            simulation->step();
            speed = std::max(speed, fastest());
        }
    }
};

// Six particles more at one place: they part within some hundred h/c0, and do not burst.
template <int D>
void expect_dissolved(std::size_t more) {
    const CrowdedWater<D> water(more, 3.0);
    EXPECT_GT(water.fill(), 1.8);
    double speed = 0.0;
    water.advance(5.0, speed);
    EXPECT_LT(water.fill(), 1.2);
    EXPECT_LT(speed, 0.2 * water.sound_speed());
}

TEST(Crowding, DissolvesACrowdWithoutABurst2D) { expect_dissolved<2>(6); }
TEST(Crowding, DissolvesACrowdWithoutABurst3D) { expect_dissolved<3>(12); }

// Without the rule they stay together: there is something to cure.
TEST(Crowding, IsNotDissolvedByTheSumsAlone) {
    const CrowdedWater<2> water(6, 0.0);
    double speed = 0.0;
    water.advance(5.0, speed);
    EXPECT_GT(water.fill(), 1.5);
}

// What the rule sees of a wall that moves is where that stands now, in a run that goes on too.
TEST(Crowding, BesideAMovingSolidInSpaceIsAPartOfTheState) {
    Case c = test::still_water(3);
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.start.jitter = 0.1;
    Solid piston;
    piston.name = "piston";
    piston.shape = SolidShape::box;
    piston.centre = {0.01, 0.014, 0.05};
    piston.size = {0.02, 0.06, 0.12};
    piston.motion = SolidMotion::constant;
    piston.velocity_x = 0.2;
    c.solids = {piston};
    // It looks at each sixteenth step: also at the first one after the resume.
    for (const int before : {32, 48}) test::expect_same_bits_after_resume<3>(c, before, 24);
}

// Water in order knows nothing of the rule.
TEST(Crowding, LeavesWaterInOrderAlone) {
    const CrowdedWater<2> water(0, 3.0);
    EXPECT_LT(water.fill(), crowding_begin);
    EXPECT_EQ(crowding_rate(crowding_begin), 0.0);
    EXPECT_EQ(crowding_rate(0.5), 0.0);
}

}  // namespace
}  // namespace riffle::crowding_test
