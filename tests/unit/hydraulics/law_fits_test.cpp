#include "hydraulics/law_fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "coverage.hpp"

namespace riffle::law_fits_test {
namespace {

using testing::Coverage;
using testing::coverage_band;
using testing::coverage_trials;
using testing::expected_covered;
using testing::noisy_profile;
using testing::NoisyProfile;

// Condition 2 of the thesis, with an ADV-like profile of 25 points and noise of 1 % of the velocity.
constexpr double depth = 0.05;
constexpr double u_star = 0.044;
constexpr double k_s = 0.035;
constexpr double lowest = 0.004;
constexpr double highest = 0.048;
constexpr int points = 25;
constexpr double noise = 0.003;

void expect_right_coverage(const Coverage& c, const char* what) {
    std::printf("%s: intervals %.1f %%, half-widths %.1f %%, bounded %.1f %%\n", what,
                100.0 * c.intervals() / c.trials(), 100.0 * c.half_widths() / c.trials(),
                100.0 * c.bounded() / c.trials());
    ASSERT_EQ(c.trials(), coverage_trials) << what;
    EXPECT_NEAR(c.intervals(), expected_covered, coverage_band) << what;
}

VelocityPoints points_of(const NoisyProfile& p) { return {p.z, p.velocity}; }

double wake_law(double z) { return rough_log_wake_law(z, depth, u_star, k_s, 0.2); }

TEST(WakeFit, ExactProfileGivesItsParameters) {
    const NoisyProfile p = noisy_profile(wake_law, lowest, highest, points, 0.0, 1);
    for (const bool given : {false, true}) {
        const WakeFit fit =
            fit_wake_strength(points_of(p), depth, given ? std::optional<double>(u_star) : std::nullopt);
        ASSERT_TRUE(fit.valid) << fit.why_not;
        EXPECT_NEAR(fit.wake_strength.value, 0.2, 1e-10);
        EXPECT_NEAR(fit.friction_velocity.value, u_star, 1e-12);
        EXPECT_NEAR(fit.equivalent_roughness.value, k_s, 1e-11);
        EXPECT_LT(fit.residual_rms, 1e-15);
        EXPECT_EQ(fit.points, 25U);
    }
}

TEST(WakeFit, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    Coverage wake(0.2), wake_given(0.2), friction(u_star), roughness(k_s);
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p = noisy_profile(wake_law, lowest, highest, points, noise, i);
        const WakeFit fit = fit_wake_strength(points_of(p), depth);
        ASSERT_TRUE(fit.valid);
        wake.add(fit.wake_strength);
        friction.add(fit.friction_velocity);
        roughness.add(fit.equivalent_roughness);
        wake_given.add(fit_wake_strength(points_of(p), depth, u_star).wake_strength);
    }
    expect_right_coverage(wake, "Pi");
    expect_right_coverage(wake_given, "Pi, u_* given");
    expect_right_coverage(friction, "u_*");
    expect_right_coverage(roughness, "k_s");
    // A linear problem: here the half-width is the interval.
    EXPECT_NEAR(wake_given.half_widths(), expected_covered, coverage_band);
}

TEST(PowerLawFit, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    Coverage m(3.0), maximum(0.4);
    const auto law = [](double z) { return power_law(z, depth, 0.4, 3.0); };
    const PowerLawFit exact =
        fit_power_law(points_of(noisy_profile(law, lowest, highest, points, 0.0, 1)), depth);
    ASSERT_TRUE(exact.valid);
    // The minimum of a sum of squares is found to the root of the precision of its sum.
    EXPECT_NEAR(exact.m.value, 3.0, 1e-6);
    EXPECT_NEAR(exact.maximum_velocity.value, 0.4, 1e-7);
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p = noisy_profile(law, lowest, highest, points, noise, i);
        const PowerLawFit fit = fit_power_law(points_of(p), depth);
        ASSERT_TRUE(fit.valid);
        m.add(fit.m);
        maximum.add(fit.maximum_velocity);
    }
    expect_right_coverage(m, "m");
    expect_right_coverage(maximum, "U_max");
    EXPECT_NEAR(m.half_widths(), expected_covered, coverage_band);
}

TEST(DipFit, ExactProfilesGiveTheirParameters) {
    const double z0 = 1.2e-3;
    const NoisyProfile log_law =
        noisy_profile([&](double z) { return dip_modified_log_law(z, depth, u_star, z0, 0.3); }, lowest,
                      highest, points, 0.0, 1);
    const NoisyProfile log_wake =
        noisy_profile([&](double z) { return total_dip_log_wake_law(z, depth, u_star, z0, 0.3, 0.2); },
                      lowest, highest, points, 0.0, 1);
    for (const bool given : {false, true}) {
        const auto known = given ? std::optional<double>(u_star) : std::nullopt;
        for (const DipFit& fit : {fit_dip_modified_log_law(points_of(log_law), depth, known),
                                  fit_total_dip_log_wake_law(points_of(log_wake), depth, known)}) {
            ASSERT_TRUE(fit.valid) << fit.why_not;
            EXPECT_NEAR(fit.dip.value, 0.3, 1e-9);
            EXPECT_NEAR(fit.friction_velocity.value, u_star, 1e-10);
            EXPECT_NEAR(fit.zero_velocity_height.value, z0, 1e-11);
            EXPECT_NEAR(fit.height_of_maximum.value, depth / 1.3, 1e-10);
        }
    }
}

TEST(DipFit, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    const double z0 = 1.2e-3;
    Coverage dip(0.3), dip_given(0.3), zero(z0), top(depth / 1.3);
    Coverage wake_dip(0.3), wake_dip_given(0.3), wake_zero(z0);
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p =
            noisy_profile([&](double z) { return dip_modified_log_law(z, depth, u_star, z0, 0.3); }, lowest,
                          highest, points, noise, i);
        const DipFit fit = fit_dip_modified_log_law(points_of(p), depth);
        ASSERT_TRUE(fit.valid);
        dip.add(fit.dip);
        zero.add(fit.zero_velocity_height);
        const DipFit given = fit_dip_modified_log_law(points_of(p), depth, u_star);
        dip_given.add(given.dip);
        top.add(given.height_of_maximum);

        const NoisyProfile q =
            noisy_profile([&](double z) { return total_dip_log_wake_law(z, depth, u_star, z0, 0.3, 0.2); },
                          lowest, highest, points, noise, coverage_trials + i);
        const DipFit wake = fit_total_dip_log_wake_law(points_of(q), depth);
        ASSERT_TRUE(wake.valid);
        wake_dip.add(wake.dip);
        const DipFit wake_given = fit_total_dip_log_wake_law(points_of(q), depth, u_star);
        wake_dip_given.add(wake_given.dip);
        wake_zero.add(wake_given.zero_velocity_height);
    }
    expect_right_coverage(dip, "alpha (2.25)");
    expect_right_coverage(dip_given, "alpha (2.25), u_* given");
    expect_right_coverage(zero, "z0 (2.25)");
    expect_right_coverage(top, "height of the maximum (2.25), u_* given");
    expect_right_coverage(wake_dip, "alpha (2.26)");
    expect_right_coverage(wake_dip_given, "alpha (2.26), u_* given");
    expect_right_coverage(wake_zero, "z0 (2.26), u_* given");
}

TEST(KappaFit, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    // u_* of the stress carries an error of its own, stated by its half-width.
    const double relative_error = 0.02;
    Coverage exact_kappa(0.41), kappa(0.41), constant(rough_log_law_constant);
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p = noisy_profile([](double z) { return rough_log_law(z, u_star, k_s); }, lowest,
                                             highest, points, noise, i);
        exact_kappa.add(fit_kappa(points_of(p), u_star, 0.0, k_s).kappa);
        const double measured = u_star * (1.0 + relative_error * normal(generator));
        const KappaFit fit = fit_kappa(points_of(p), measured, 1.96 * relative_error * measured, k_s);
        ASSERT_TRUE(fit.valid);
        kappa.add(fit.kappa);
        constant.add(fit.constant);
    }
    expect_right_coverage(exact_kappa, "kappa, u_* exact");
    expect_right_coverage(kappa, "kappa, u_* within 4 %");
    expect_right_coverage(constant, "constant, u_* within 4 %");
}

// With u_* from a stress that is known to some percent the roughness and its interval are right, too.
TEST(RoughnessFit, IsRightWithAFrictionVelocityThatIsGiven) {
    constexpr double relative_error = 0.02;
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal;
    Coverage exact(k_s), roughness(k_s);
    for (int i = 0; i < coverage_trials; ++i) {
        const NoisyProfile p = noisy_profile([](double z) { return rough_log_law(z, u_star, k_s); }, lowest,
                                             highest, points, noise, i);
        exact.add(fit_roughness(points_of(p), u_star, 0.0).equivalent_roughness);
        const double measured = u_star * (1.0 + relative_error * normal(generator));
        const RoughnessFit fit = fit_roughness(points_of(p), measured, 1.96 * relative_error * measured);
        ASSERT_TRUE(fit.valid);
        roughness.add(fit.equivalent_roughness);
    }
    expect_right_coverage(exact, "k_s, u_* exact");
    expect_right_coverage(roughness, "k_s, u_* within 2 %");
    const NoisyProfile p = noisy_profile([](double z) { return rough_log_law(z, u_star, k_s); }, lowest,
                                         highest, points, 0.0, 1);
    EXPECT_NEAR(fit_roughness(points_of(p), u_star, 0.0).equivalent_roughness.value, k_s, 1e-12);
    EXPECT_FALSE(fit_roughness(points_of(p), u_star, 0.0, log_law_kappa, {0.5, 0.6}).valid);
}

TEST(LawFits, SayWhyThereIsNoFit) {
    const NoisyProfile p = noisy_profile(wake_law, lowest, highest, points, 0.0, 1);
    const auto mentions = [](const FitQuality& fit, const char* words) {
        EXPECT_FALSE(fit.valid);
        EXPECT_NE(fit.why_not.find(words), std::string::npos) << fit.why_not;
    };
    mentions(fit_wake_strength(points_of(p), depth, {}, log_law_kappa, {0.5, 0.6}), "0 points");
    mentions(fit_dip_modified_log_law(points_of(p), 0.03), "surface");
    mentions(fit_total_dip_log_wake_law({p.z, p.velocity, {}, 0.01}, depth), "zero plane");
    std::vector<double> falling;
    for (const double z : p.z) falling.push_back(1.0 - z);
    mentions(fit_kappa({p.z, falling}, u_star, 0.0, k_s), "does not rise");
    mentions(fit_power_law({p.z, falling}, depth), "no power law");
    const std::vector<double> same(p.z.size(), 0.01);
    mentions(fit_wake_strength({same, p.velocity}, depth), "do not determine");
    EXPECT_THROW((void)fit_power_law(points_of(p), 0.0), InputError);
    EXPECT_THROW((void)fit_power_law({p.z, std::vector<double>{1.0}}, depth), InputError);
}

}  // namespace
}  // namespace riffle::law_fits_test
