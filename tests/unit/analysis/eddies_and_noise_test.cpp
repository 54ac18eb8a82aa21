#include "analysis/eddies_and_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace riffle {
namespace {

constexpr double spacing = 0.1;
constexpr int rows = 12;
constexpr double height = rows * spacing;

Domain<3> periodic_channel() {
    Domain<3> domain;
    domain.upper = {2.0, 1.0, 1.5 * height};
    domain.periodic = {true, true, false};
    return domain;
}

/// Particles about a lattice; velocities are for the test to give.
template <class Velocity>
ParticleVelocities water(const Velocity& velocity) {
    ParticleVelocities particles;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> jitter(-0.2 * spacing, 0.2 * spacing);
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 10; ++j) {
            for (int k = 0; k < rows; ++k) {
                const Vec<3> at = {(i + 0.5) * spacing + jitter(random), (j + 0.5) * spacing + jitter(random),
                                   (k + 0.5) * spacing + jitter(random)};
                const Vec<3> u = velocity(at);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    particles.position[axis].push_back(at[axis]);
                    particles.velocity[axis].push_back(u[axis]);
                }
            }
        }
    }
    return particles;
}

EddiesAndNoise split_of(const ParticleVelocities& particles) {
    NoiseSplit split(periodic_channel(), spacing, 1.5 * height);
    split.add(particles);
    return split.result();
}

// A wave of twenty spacings is a flow that neighbours share, at the periodic ends too.
TEST(EddiesAndNoise, LongWavesAreEddies) {
    const auto split = split_of(water([](const Vec<3>& x) {
        const double phase = std::numbers::pi * x[0];
        return Vec<3>{std::sin(phase), std::cos(phase), -0.5 * std::sin(phase)};
    }));
    ASSERT_EQ(split.z.size(), static_cast<std::size_t>(rows));
    EXPECT_DOUBLE_EQ(split.z[3], 3.5 * spacing);
    for (std::size_t l = 0; l < split.z.size(); ++l) {
        // The linear fit over 2.2 spacings leaves (k r)^2/10 or so of a wave: 0.05 times 0.7.
        EXPECT_NEAR(split.eddies[0][l], std::sqrt(0.5), 0.04);
        EXPECT_NEAR(split.eddies[2][l], 0.5 * std::sqrt(0.5), 0.02);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(split.noise[k][l], 0.04);
        EXPECT_NEAR(split.stress[l], 0.25, 0.02);
        EXPECT_NEAR(split.stress_of_eddies[l], split.stress[l], 0.02);
    }
}

// Velocities that each particle has for itself are noise, with the stress that they carry.
TEST(EddiesAndNoise, WhatNeighboursDoNotShareIsNoise) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const auto split = split_of(water([&](const Vec<3>& x) {
        const double own = normal(random);
        return Vec<3>{3.0 * x[2] + own, normal(random), -own};
    }));
    double noise = 0.0;
    double eddies = 0.0;
    double stress = 0.0;
    double of_eddies = 0.0;
    double count = 0.0;
    for (std::size_t l = 2; l + 2 < split.z.size(); ++l, ++count) {
        noise += split.noise[1][l];
        eddies += split.eddies[1][l];
        stress += split.stress[l];
        of_eddies += split.stress_of_eddies[l];
    }
    // The mean of some twenty neighbours that count has a fifth of their scatter.
    EXPECT_NEAR(noise / count, 1.0, 0.08);
    EXPECT_LT(eddies / count, 0.35);
    EXPECT_NEAR(stress / count, 1.0, 0.15);
    EXPECT_LT(of_eddies / count, 0.12);
    // It goes down the gradient of 3/s: a viscosity of a third.
    const double top = split.z[split.z.size() - 3];
    EXPECT_NEAR(noise_viscosity(split, split.z[1], top + 0.1 * spacing), 1.0 / 3.0, 0.06);
    EXPECT_EQ(noise_viscosity(split, top, top + 0.1 * spacing), 0.0);
}

TEST(EddiesAndNoise, DropsAndParticlesAboveTheLayersAreLeftOut) {
    auto particles = water([](const Vec<3>&) { return Vec<3>{1.0, 0.0, 0.0}; });
    for (const double z : {1.35 * height, 40.0}) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            particles.position[axis].push_back(axis == 2 ? z : 0.3);
            particles.velocity[axis].push_back(7.0);
        }
    }
    const auto split = split_of(particles);
    ASSERT_EQ(split.z.size(), static_cast<std::size_t>(rows));
    for (std::size_t l = 0; l < split.z.size(); ++l) {
        EXPECT_NEAR(split.noise[0][l], 0.0, 1e-12);
        EXPECT_NEAR(split.eddies[0][l], 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace riffle
