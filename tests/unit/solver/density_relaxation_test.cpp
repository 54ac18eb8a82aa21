// The density that a particle carries goes to what the kernel's sum over the particles makes of it.

#include <gtest/gtest.h>

#include <cmath>

#include "same_bits.hpp"
#include "small_case.hpp"

namespace riffle::density_relaxation_test {
namespace {

constexpr double shear = 4.0;        // 1/s
constexpr double coefficient = 0.3;  // of the relaxation

/// Water between two plates, the upper one of which moves as fast as the shear asks for, without weight.
Case sheared_water(int dimensions) {
    Case c = test::still_water(dimensions);
    c.bed.kind = BedKind::no_slip;
    c.channel.top = Top::wall;
    c.channel.depth = 0.04;
    c.channel.lid_velocity = shear * c.channel.depth;
    c.fluid.gravity = 0.0;
    c.fluid.kinematic_viscosity = 1e-4;
    c.numerics.spacing = 0.004;
    c.numerics.sound_speed = 3.0;
    c.numerics.density_relaxation = coefficient;
    return c;
}

/// The start of sheared water whose particles carry another density than their masses have in their room.
template <int D>
Particles<D> with_wrong_density(const Case& c, double deviation) {
    Particles<D> p = initial_particles<D>(c, make_scheme(c, nullptr), nullptr);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.mass[i] /= 1.0 + p.density_deviation[i];
        p.density_deviation[i] = deviation;
        p.velocity[0][i] = shear * p.position[D - 1][i];
    }
    return p;
}

template <int D>
double mean_deviation(const Particles<D>& p) {
    double sum = 0.0;
    for (const double s : p.density_deviation) sum += s;
    return sum / static_cast<double>(p.size());
}

/// The density that is wrong by 1 % decays as exp(-C |S| t); without the relaxation nothing changes it. The
/// rows that slide change the kernel's sum by some thousandths.
template <int D>
void expect_decay() {
    Case c = sheared_water(D);
    const double wrong = 0.01;
    const double time = D == 2 ? 1.0 : 0.3;
    for (const double c_s : {coefficient, 0.0}) {
        c.numerics.density_relaxation = c_s;
        const auto simulation = make_simulation<D>(c, nullptr, with_wrong_density<D>(c, wrong));
        while (simulation->clock().time < time) simulation->step();
        EXPECT_NEAR(mean_deviation(simulation->particles()), wrong * std::exp(-c_s * shear * time), 0.001)
            << c_s;
    }
}

TEST(DensityRelaxation, TakesAWrongDensityAwayAtTheRateOfTheStrain) { expect_decay<2>(); }

TEST(DensityRelaxation, DoesSoInSpace) { expect_decay<3>(); }

// Where water has no neighbours above it, the kernel's sum tells nothing of its density.
TEST(DensityRelaxation, LeavesTheSurfaceAlone) {
    Case c = test::still_water();
    c.channel.length = 0.1;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.0025;
    c.numerics.density_relaxation = coefficient;
    const auto simulation = test::simulation_of<2>(c);
    simulation->step();
    const Particles<2>& p = simulation->particles();
    ASSERT_EQ(p.further.size(), 1U);
    const std::vector<double>& surplus = p.further[0].values;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double below = (c.channel.depth - p.position[1][i]) / c.numerics.spacing;
        // On the lattice nothing is crowded, beside bed and end walls neither.
        EXPECT_NEAR(surplus[i], 0.0, 2e-3) << below;
        if (below < 2.0) {
            EXPECT_EQ(surplus[i], 0.0) << below;
        }
    }
}

TEST(DensityRelaxation, IsAPartOfTheState) {
    Case c = test::disordered_tank();
    c.numerics.density_relaxation = coefficient;
    for (const Stepping stepping : {Stepping::leapfrog, Stepping::predictor_corrector}) {
        c.numerics.stepping = stepping;
        test::expect_same_bits_after_resume(c, 60, 60);
    }
}

TEST(DensityRelaxation, GivesTheSameBitsForAnyNumberOfThreads) {
    Case c = test::small_channel(3);
    c.numerics.density_relaxation = coefficient;
    test::expect_same_bits_for_any_threads<3>(c, 40);
}

}  // namespace
}  // namespace riffle::density_relaxation_test
