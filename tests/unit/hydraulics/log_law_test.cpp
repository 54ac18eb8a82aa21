#include "hydraulics/log_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "coverage.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::log_law_test {
namespace {

using testing::Coverage;
using testing::coverage_band;
using testing::coverage_trials;
using testing::expected_covered;
using testing::noisy_profile;
using testing::NoisyProfile;

constexpr double kappa = 0.41;
constexpr double friction_velocity = 0.044;
constexpr double roughness = 0.035;
constexpr double plane = 0.006;

NoisyProfile rough_profile(int n, double noise, int seed) {
    const auto law = [](double z) { return rough_log_law(z - plane, friction_velocity, roughness); };
    return noisy_profile(law, 0.011, 0.041, n, noise, seed);
}

TEST(LogLaw, ExactProfileGivesItsParameters) {
    const NoisyProfile p = rough_profile(20, 0.0, 1);
    const LogLawFit given = fit_log_law(p.z, p.velocity, kappa, plane, 0.0, 1.0);
    ASSERT_TRUE(given.valid);
    EXPECT_NEAR(given.friction_velocity, friction_velocity, 1e-12);
    EXPECT_NEAR(given.equivalent_roughness, roughness, 1e-12);
    EXPECT_LT(given.friction_velocity_half_width, 1e-12);
    const LogLawFit free = fit_log_law_with_zero_plane(p.z, p.velocity, kappa, 0.0, 1.0);
    ASSERT_TRUE(free.valid);
    EXPECT_NEAR(free.zero_plane, plane, 1e-7);
    EXPECT_NEAR(free.friction_velocity, friction_velocity, 1e-6);
    EXPECT_NEAR(free.equivalent_roughness, roughness, 1e-6);
}

FittedValue friction_velocity_of(const LogLawFit& f) {
    return {f.friction_velocity, f.friction_velocity_half_width, f.friction_velocity_interval};
}
FittedValue roughness_of(const LogLawFit& f) {
    return {f.equivalent_roughness, f.equivalent_roughness_half_width, f.equivalent_roughness_interval};
}
FittedValue zero_plane_of(const LogLawFit& f) {
    return {f.zero_plane, f.zero_plane_half_width, f.zero_plane_interval};
}

/// Coverage of the three numbers over trials of profiles of `n` points.
struct LogLawCoverage {
    Coverage friction{friction_velocity}, equivalent{roughness}, plane{0.006};
    int valid = 0;

    void print(const char* what) const {
        std::printf(
            "%s: valid %d of %d; intervals u_* %d, k_s %d, plane %d (bounded %d); half-widths %d, %d, %d\n",
            what, valid, coverage_trials, friction.intervals(), equivalent.intervals(), plane.intervals(),
            plane.bounded(), friction.half_widths(), equivalent.half_widths(), plane.half_widths());
    }
};

template <class Fit>
LogLawCoverage coverage_of(int n, double noise, Fit fit_of) {
    LogLawCoverage c;
    for (int i = 0; i < coverage_trials; ++i) {
        const LogLawFit fit = fit_of(rough_profile(n, noise, i));
        if (!fit.valid) continue;
        ++c.valid;
        c.friction.add(friction_velocity_of(fit));
        c.equivalent.add(roughness_of(fit));
        c.plane.add(zero_plane_of(fit));
    }
    return c;
}

// Noise of 1 % of the velocity: u_* to 8 %, k_s to 12 %.
TEST(LogLaw, IntervalsCoverTheTruthInNinetyFiveOfAHundred) {
    const LogLawCoverage c = coverage_of(15, 0.003, [](const NoisyProfile& p) {
        return fit_log_law(p.z, p.velocity, kappa, plane, 0.0, 1.0);
    });
    c.print("plane given");
    EXPECT_EQ(c.valid, coverage_trials);
    EXPECT_NEAR(c.friction.intervals(), expected_covered, coverage_band);
    EXPECT_NEAR(c.equivalent.intervals(), expected_covered, coverage_band);
    EXPECT_NEAR(c.friction.half_widths(), expected_covered, coverage_band);
    EXPECT_NEAR(c.equivalent.half_widths(), expected_covered, coverage_band);
}

// A fine bed is far below the points: k_s, extrapolated, is known to a factor only. The interval still holds
// 95 %, the linear half-width less.
TEST(LogLaw, IntervalsHoldWhereTheLinearHalfWidthDoesNot) {
    constexpr double fine = 0.5e-3;
    Coverage equivalent(fine);
    for (int i = 0; i < coverage_trials; ++i) {
        const auto law = [](double z) { return rough_log_law(z - plane, friction_velocity, fine); };
        const NoisyProfile p = noisy_profile(law, 0.011, 0.041, 15, 0.04, i);
        const LogLawFit fit = fit_log_law(p.z, p.velocity, kappa, plane, 0.0, 1.0);
        ASSERT_TRUE(fit.valid);
        EXPECT_GT(fit.equivalent_roughness_interval.lower, 0.0);
        equivalent.add(roughness_of(fit));
    }
    std::printf("k_s of a fine bed: intervals %d, half-widths %d\n", equivalent.intervals(),
                equivalent.half_widths());
    EXPECT_NEAR(equivalent.intervals(), expected_covered, coverage_band);
    EXPECT_LT(equivalent.half_widths(), expected_covered - coverage_band);
}

TEST(LogLaw, IntervalsCoverTheTruthWithAFreePlane) {
    const LogLawCoverage quiet = coverage_of(40, 0.0005, [](const NoisyProfile& p) {
        return fit_log_law_with_zero_plane(p.z, p.velocity, kappa, 0.0, 1.0);
    });
    quiet.print("plane free, quiet");
    EXPECT_EQ(quiet.valid, coverage_trials);
    for (const Coverage* c : {&quiet.friction, &quiet.equivalent, &quiet.plane}) {
        EXPECT_NEAR(c->intervals(), expected_covered, coverage_band);
        EXPECT_NEAR(c->half_widths(), expected_covered, coverage_band);
    }
    // Noise of 0.5 % of the velocity: the plane is known to millimetres.
    const LogLawCoverage noisy = coverage_of(40, 0.0015, [](const NoisyProfile& p) {
        return fit_log_law_with_zero_plane(p.z, p.velocity, kappa, 0.0, 1.0);
    });
    noisy.print("plane free");
    EXPECT_GE(noisy.valid, 0.99 * coverage_trials);
    for (const Coverage* c : {&noisy.friction, &noisy.equivalent, &noisy.plane}) {
        EXPECT_NEAR(c->intervals(), expected_covered, coverage_band);
    }
}

// Every other point four times as noisy, as stated: the fit must weigh them, and a common factor must not
// matter.
TEST(LogLaw, UncertaintiesOfThePointsAreWeights) {
    Coverage friction(friction_velocity);
    double weighted_width = 0;
    double plain_width = 0;
    for (int i = 0; i < coverage_trials; ++i) {
        NoisyProfile p = rough_profile(16, 0.001, i);
        const NoisyProfile exact = rough_profile(16, 0.0, 1);
        std::vector<double> uncertainty(16, 0.001);
        for (std::size_t j = 0; j < 16; j += 2) {
            p.velocity[j] = exact.velocity[j] + 4.0 * (p.velocity[j] - exact.velocity[j]);
            uncertainty[j] *= 4.0;
        }
        const LogLawFit fit = fit_log_law({p.z, p.velocity, uncertainty, plane}, kappa);
        friction.add(friction_velocity_of(fit));
        weighted_width += fit.friction_velocity_half_width;
        plain_width += fit_log_law({p.z, p.velocity, {}, plane}, kappa).friction_velocity_half_width;
        for (double& u : uncertainty) u *= 7.0;
        const LogLawFit scaled = fit_log_law({p.z, p.velocity, uncertainty, plane}, kappa);
        EXPECT_NEAR(scaled.friction_velocity_half_width, fit.friction_velocity_half_width, 1e-12);
    }
    EXPECT_NEAR(friction.intervals(), expected_covered, coverage_band);
    // Of errors 4 and 1 in turn the harmonic mean square is 1.37, the mean square 2.92: half the width.
    EXPECT_NEAR(weighted_width / plain_width, 1.37 / 2.92, 0.05);
}

TEST(LogLaw, UsesOnlyTheRangeAskedFor) {
    NoisyProfile p = rough_profile(30, 0.0, 1);
    p.velocity.front() = 10.0;
    p.velocity.back() = -10.0;
    const LogLawFit fit = fit_log_law(p.z, p.velocity, kappa, plane, 0.0115, 0.0405);
    EXPECT_NEAR(fit.friction_velocity, friction_velocity, 1e-12);
    EXPECT_EQ(fit.from, 0.0115);
    EXPECT_EQ(fit.to, 0.0405);
}

TEST(LogLaw, SaysWhenThereIsNoFit) {
    const NoisyProfile p = rough_profile(30, 0.0, 1);
    EXPECT_FALSE(fit_log_law(p.z, p.velocity, kappa, plane, 0.5, 0.6).valid);  // no points
    EXPECT_FALSE(fit_log_law(p.z, p.velocity, kappa, 0.02, 0.0, 1.0).valid);   // plane within the points
    std::vector<double> falling;
    for (const double z : p.z) falling.push_back(1.0 - z);
    EXPECT_FALSE(fit_log_law(p.z, falling, kappa, plane, 0.0, 1.0).valid);
    std::vector<double> straight;  // no plane makes a straight line logarithmic
    for (const double z : p.z) straight.push_back(z);
    const LogLawFit no_plane = fit_log_law_with_zero_plane(p.z, straight, kappa, 0.0, 1.0);
    EXPECT_FALSE(no_plane.valid);
    EXPECT_NE(no_plane.why_not.find("zero plane"), std::string::npos);
}

TEST(LogLaw, DepthMeanOfAProfileIsThatOfTheLaw) {
    const NoisyProfile p = rough_profile(60, 0.0, 1);
    const double depth = 0.05;
    const auto mean = profile_depth_mean({p.z, p.velocity, {}, plane}, depth);
    ASSERT_TRUE(mean);
    // Above its height of zero velocity; below it the law is negative, the water at rest.
    const double at_rest = roughness * std::exp(-kappa * rough_log_law_constant);
    const double expected = rough_log_law_depth_mean(depth, friction_velocity, roughness) +
                            friction_velocity / kappa * at_rest / depth;
    // Trapezoids over steps of 0.5 mm: u* / kappa / z dz^2 / 12 of the range.
    EXPECT_NEAR(*mean, expected, 1e-5);
    EXPECT_FALSE(profile_depth_mean({std::vector<double>{0.01}, std::vector<double>{0.2}, {}, 0.0}, depth));
}

}  // namespace
}  // namespace riffle::log_law_test
