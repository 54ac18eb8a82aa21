// Flow with cells of secondary flow: the laws, and that their fits find what profiles are made with.

#include "hydraulics/secondary_flow_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coverage.hpp"
#include "hydraulics/law_fits.hpp"
#include "hydraulics/velocity_laws.hpp"

namespace riffle::secondary_flow_test {
namespace {

using testing::Coverage;
using testing::coverage_band;
using testing::coverage_trials;
using testing::expected_covered;
using testing::noisy_profile;
using testing::NoisyProfile;

constexpr double depth = 0.075;
constexpr double u_star = 0.03;
constexpr double z0 = 3e-5;

TEST(SecondaryFlowLaws, BetweenTheCellsAreTheLogLawAndTheLinearStress) {
    EXPECT_NEAR(secondary_flow_phase(0.5 * depth, depth), 0.0, 1e-15);
    EXPECT_EQ(secondary_flow_phase(0.0, depth), 1.0);
    EXPECT_NEAR(secondary_flow_phase(depth, depth), -1.0, 1e-15);
    for (const double z : {0.005, 0.03, 0.07}) {
        EXPECT_NEAR(secondary_flow_log_law(z, depth, u_star, z0, 0.0), u_star / 0.41 * std::log(z / z0),
                    1e-15);
        EXPECT_NEAR(secondary_flow_stress(z, depth, 0.0), 1.0 - z / depth, 1e-15);
    }
}

TEST(SecondaryFlowLaws, KnownValues) {
    // At the surface ln(2500) = 7.824, less (0.3 * 7.824 - 0.8 - 1.7) = -0.1528 of it, over kappa.
    EXPECT_NEAR(secondary_flow_log_law(depth, depth, u_star, z0, 1.0) / u_star, (7.82405 - 0.15279) / 0.41,
                1e-4);
    // alpha_3 = 1.18, alpha_4 = 2.44 at phase 1: half way up 1.18 - 1.22 + 1.26/4.
    EXPECT_NEAR(secondary_flow_stress(0.5 * depth, depth, 1.0), 1.18 - 1.22 + 0.315, 1e-12);
    EXPECT_NEAR(secondary_flow_stress(0.5 * depth, depth, -1.0), 0.82 + 0.22 - 0.315, 1e-12);
}

// What Wang & Cheng say of their measurements.
TEST(SecondaryFlowLaws, MeetTheMeasurementsInWords) {
    EXPECT_NEAR(secondary_flow_stress(depth, depth, 1.0), 0.0, 1e-15);
    EXPECT_NEAR(secondary_flow_stress(0.0, depth, 1.0), secondary_flow_bed_stress(1.0), 1e-15);
    EXPECT_GT(secondary_flow_stress(0.05 * depth, depth, 1.0),
              secondary_flow_stress(0.05 * depth, depth, -1.0));
    EXPECT_LT(secondary_flow_stress(0.4 * depth, depth, 1.0),
              secondary_flow_stress(0.4 * depth, depth, -1.0));
    const auto u = [](double z, double phase) { return secondary_flow_log_law(z, depth, u_star, z0, phase); };
    const auto rise = [&](double phase) { return u(0.1 * depth, phase) - u(0.02 * depth, phase); };
    EXPECT_GT(rise(1.0), 1.3 * rise(-1.0));
    EXPECT_GT(u(0.4 * depth, 1.0), u(0.4 * depth, -1.0));
    EXPECT_LT(u(5.0 * z0, 1.0), u(5.0 * z0, -1.0));
    // In the downflow alone a faster layer lies below a slower one: the slope of kappa u/u_*, 1.3 h/z less
    // 1.7 pi/2 sin(pi z/h), is negative between about 0.48 h and 0.79 h.
    EXPECT_GT(u(0.48 * depth, 1.0), u(0.79 * depth, 1.0));
    for (double z = 2.0 * z0; z < depth; z += 0.01 * depth) {
        EXPECT_LT(u(z, -1.0), u(z + 0.01 * depth, -1.0)) << z;
    }
}

TEST(SecondaryFlowFit, ExactProfilesGiveTheirPhase) {
    const auto law = [](double z) { return secondary_flow_log_law(z, depth, u_star, z0, -0.6); };
    const NoisyProfile p = noisy_profile(law, 0.004, 0.072, 25, 0.0, 1);
    for (const bool given : {false, true}) {
        const SecondaryFlowFit fit = fit_secondary_flow_log_law(
            {p.z, p.velocity}, depth, given ? std::optional<double>(u_star) : std::nullopt);
        ASSERT_TRUE(fit.valid) << fit.why_not;
        EXPECT_NEAR(fit.phase.value, -0.6, 1e-10);
        EXPECT_NEAR(fit.friction_velocity.value, u_star, 1e-12);
        EXPECT_NEAR(fit.zero_velocity_height.value, z0, 1e-13);
    }
    const NoisyProfile stress =
        noisy_profile([](double z) { return secondary_flow_stress(z, depth, 0.4); }, 0.004, 0.07, 9, 0.0, 1);
    const SecondaryStressFit fit = fit_secondary_flow_stress(stress.z, stress.velocity, depth);
    ASSERT_TRUE(fit.valid) << fit.why_not;
    EXPECT_NEAR(fit.phase.value, 0.4, 1e-12);
    EXPECT_FALSE(fit_secondary_flow_stress(stress.z, stress.velocity, depth, {0.0, 0.015}).valid);
}

TEST(SecondaryFlowFit, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    Coverage phase(0.5), zero(z0), given(0.5), of_stress(0.5);
    const auto law = [](double z) { return secondary_flow_log_law(z, depth, u_star, z0, 0.5); };
    const auto stress_law = [](double z) { return secondary_flow_stress(z, depth, 0.5); };
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p = noisy_profile(law, 0.004, 0.072, 25, 0.003, i);
        const SecondaryFlowFit fit = fit_secondary_flow_log_law({p.z, p.velocity}, depth);
        ASSERT_TRUE(fit.valid);
        phase.add(fit.phase);
        const SecondaryFlowFit with = fit_secondary_flow_log_law({p.z, p.velocity}, depth, u_star);
        given.add(with.phase);
        zero.add(with.zero_velocity_height);
        const NoisyProfile s = noisy_profile(stress_law, 0.004, 0.07, 20, 0.05, coverage_trials + i);
        of_stress.add(fit_secondary_flow_stress(s.z, s.velocity, depth).phase);
    }
    for (const Coverage* const c : {&phase, &zero, &given, &of_stress}) {
        EXPECT_NEAR(c->intervals(), expected_covered, coverage_band);
    }
}

TEST(BedStressFit, FindsTheCells) {
    std::vector<double> y;
    std::vector<double> stress;
    std::mt19937_64 generator(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    for (double at = 0.01; at < 0.45; at += 0.01) {
        y.push_back(at);
        stress.push_back(2.0 * secondary_flow_bed_stress(secondary_flow_phase(at - 0.03, 0.06)) +
                         noise(generator));
    }
    const BedStressFit fit = fit_bed_stress(y, stress);
    ASSERT_TRUE(fit.valid) << fit.why_not;
    EXPECT_TRUE(fit.mean.interval.contains(2.0));
    EXPECT_TRUE(fit.cell_width.interval.contains(0.06));
    // 44 values of noise 1 % of the mean: the amplitude is known to sqrt(2/44) %.
    EXPECT_NEAR(fit.amplitude, secondary_flow_bed_amplitude, 3.0 * 0.01 * std::sqrt(2.0 / 44.0));
    EXPECT_NEAR(fit.downflow, 0.03, 0.004);
    EXPECT_NEAR(fit.at(0.03), 2.36, 0.02);
    EXPECT_FALSE(fit_bed_stress(std::span(y).first(5), std::span(stress).first(5)).valid);
}

}  // namespace
}  // namespace riffle::secondary_flow_test
