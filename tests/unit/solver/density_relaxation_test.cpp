// The density that a particle carries goes to what the kernel's sum over the particles makes of it.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

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

// Where water has no neighbours above it, the kernel's sum is small without being sparse; in the corners of
// surface and walls the rows of the lattice are not quite those of a level surface without end.
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
        EXPECT_NEAR(surplus[i], 0.0, below < 2.0 ? 5e-3 : 2e-3) << below;
    }
}

// Gaps under the surface are seen, in the second row too: water of four fifths of the particles.
TEST(DensityRelaxation, SeesGapsUnderTheSurface) {
    Case c = test::still_water();
    c.channel.length = 0.1;
    c.numerics.spacing = 0.0025;
    c.numerics.density_relaxation = coefficient;
    Particles<2> water = initial_particles<2>(c, make_scheme(c, nullptr), nullptr);
    std::vector<std::int32_t> kept;
    const auto rows_below = [&](std::size_t i) {
        return static_cast<int>((c.channel.depth - water.position[1][i]) / c.numerics.spacing);
    };
    for (std::size_t i = 0; i < water.size(); ++i) {
        const int row = rows_below(i);
        const int column = static_cast<int>(water.position[0][i] / c.numerics.spacing);
        const bool gap = row >= 1 && row < 8 && (column + 2 * row) % 5 == 0;
        if (!gap) kept.push_back(static_cast<std::int32_t>(i));
    }
    water.permute(kept);
    const auto simulation = make_simulation<2>(c, nullptr, water);
    simulation->step();
    const Particles<2>& p = simulation->particles();
    std::array<double, 8> mean{};
    std::array<int, 8> count{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const int row = static_cast<int>((c.channel.depth - p.position[1][i]) / c.numerics.spacing);
        if (row >= 8) continue;
        mean.at(static_cast<std::size_t>(row)) += p.further[0].values[i];
        ++count.at(static_cast<std::size_t>(row));
    }
    EXPECT_NEAR(mean[0] / count[0], 0.0, 0.03);
    for (std::size_t row = 1; row < 7; ++row) EXPECT_LT(mean.at(row) / count.at(row), -0.03) << row;
}

TEST(DensityRelaxation, IsAPartOfTheState) {
    Case c = test::disordered_tank();
    c.numerics.density_relaxation = coefficient;
    for (const Stepping stepping : {Stepping::leapfrog, Stepping::predictor_corrector}) {
        c.numerics.stepping = stepping;
        test::expect_same_bits_after_resume(c, 60, 60);
    }
}

// What it sees of a wall that moves is where that stands now, in a run that goes on as in one that did not
// stop.
TEST(DensityRelaxation, BesideAMovingSolidIsAPartOfTheState) {
    Case c = test::disordered_tank();
    c.numerics.density_relaxation = coefficient;
    Solid piston = test::rectangle("piston", 0.0, 0.02, 0.0, 0.08);
    piston.motion = SolidMotion::constant;
    piston.velocity_x = 0.1;
    c.solids = {piston};
    c.start.packed = false;
    c.start.jitter = 0.1;
    for (const int before : {32, 48, 53}) test::expect_same_bits_after_resume(c, before, 30);
}

TEST(DensityRelaxation, GivesTheSameBitsForAnyNumberOfThreads) {
    Case c = test::small_channel(3);
    c.numerics.density_relaxation = coefficient;
    test::expect_same_bits_for_any_threads<3>(c, 40);
}

}  // namespace
}  // namespace riffle::density_relaxation_test
