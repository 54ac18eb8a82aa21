#include "hydraulics/channel_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace riffle::channel_laws_test {
namespace {

TEST(ChannelLaws, FrictionMeasuresAgreeWithEachOther) {
    // sqrt(8/f) = C/sqrt(g) = R^(1/6)/(n sqrt(g)) = U/u_* (thesis 2.6-2.8).
    const double g = 9.81;
    const double slope = 0.004;
    const double radius = 0.05;
    const double velocity = 0.35;
    const double ratio = velocity / friction_velocity_from_slope(g * slope, radius);
    EXPECT_NEAR(std::sqrt(8 / friction_factor(g * slope, radius, velocity)), ratio, 1e-12);
    EXPECT_NEAR(chezy_coefficient(slope, radius, velocity) / std::sqrt(g), ratio, 1e-12);
    EXPECT_NEAR(std::pow(radius, 1.0 / 6) / (manning_coefficient(slope, radius, velocity) * std::sqrt(g)),
                ratio, 1e-12);
}

TEST(ChannelLaws, TableOfTheThesis) {
    // Table 3.1, condition 1: Re 11200, Fr 0.447, u_* 0.039.
    EXPECT_NEAR(reynolds_number(0.28, 0.040, 1e-6), 11200, 1);
    EXPECT_NEAR(froude_number(0.28, 9.81, 0.040), 0.447, 5e-4);
    EXPECT_NEAR(friction_velocity_from_slope(9.81 * 0.004, 0.040), 0.039, 1e-3);
    EXPECT_DOUBLE_EQ(hydraulic_radius(0.5, 1.0), 0.25);
}

TEST(ChannelLaws, DepthMeanOfTheLogLawOfTheTable) {
    // Thesis Table 3.1, conditions 1 to 8, printed to three digits; u_* = sqrt(g h_w S0) unrounded.
    const double depth[] = {.04, .05, .06, .07, .07, .08, .09, .10};
    const double slope[] = {.004, .004, .002, .002, .003, .003, .003, .002};
    const double k_s[] = {.035, .035, .030, .028, .030, .028, .026, .022};
    const double mean[] = {.253, .307, .266, .307, .369, .418, .468, .432};
    for (int i = 0; i < 8; ++i) {
        const double u_star = friction_velocity_from_slope(9.81 * slope[i], depth[i]);
        EXPECT_NEAR(rough_log_law_depth_mean(depth[i], u_star, k_s[i]), mean[i], 6e-4) << i + 1;
        EXPECT_NEAR(equivalent_roughness_from_mean(depth[i], u_star,
                                                   rough_log_law_depth_mean(depth[i], u_star, k_s[i])),
                    k_s[i], 1e-12);
    }
}

TEST(ColebrookWhite, SolvesItsEquation) {
    for (const double k : {0.0, 1e-5, 1e-3, 0.03}) {
        for (const double re : {1e3, 1e5, 1e7}) {
            const double f = colebrook_white_friction_factor(k, 0.05, re);
            const double right = -2.0 * std::log10(k / (12 * 0.05) + 2.5 / (re * std::sqrt(f)));
            EXPECT_NEAR(1 / std::sqrt(f), right, 1e-12 * right) << k << ' ' << re;
        }
    }
    // The fully rough limit is close to the depth mean of the rough log law.
    const double ratio = std::sqrt(8 / colebrook_white_friction_factor(0.002, 0.05, 1e9));
    EXPECT_NEAR(ratio, rough_log_law_depth_mean(0.05, 1.0, 0.002), 0.03 * ratio);
    EXPECT_THROW((void)colebrook_white_friction_factor(0.01, 0.0, 1e5), InputError);
    EXPECT_THROW((void)colebrook_white_friction_factor(-0.01, 0.1, 1e5), InputError);
}

TEST(ColebrookWhite, SolvesItsEquationWithTheConstantsOfEachSource) {
    for (const ColebrookWhiteConstants& c :
         {henderson_wide_channel, full_pipe, keulegan_channel, rouse_channel}) {
        for (const double k : {0.0, 1e-4, 0.1, 0.499}) {
            const double f = colebrook_white_friction_factor(k, 0.05, 5e4, c);
            const double right = -c.c1 * std::log10(k / (c.c2 * 0.05) + c.c3 / (5e4 * std::sqrt(f)));
            EXPECT_NEAR(1 / std::sqrt(f), right, 1e-11) << c.source << ' ' << k;
        }
        // A roughness so large that the logarithm of (2.9) vanishes has no friction factor.
        EXPECT_THROW((void)colebrook_white_friction_factor(1.01 * c.c2, 1.0, 1e5, c), InputError);
    }
}

// The velocity is that of the friction factor at its own Reynolds number.
TEST(ColebrookWhite, HasTheVelocityOfItsFrictionFactor) {
    for (const double roughness : {0.0, 1e-4, 5e-3}) {
        const double radius = 0.08;
        const double velocity = colebrook_white_velocity(0.0098, roughness, radius, 1e-6, full_pipe);
        const double reynolds = reynolds_number(velocity, 4.0 * radius, 1e-6);
        const double factor = colebrook_white_friction_factor(roughness, radius, reynolds, full_pipe);
        EXPECT_NEAR(velocity, velocity_from_friction_factor(0.0098, radius, factor), 1e-12);
    }
}

TEST(ColebrookWhite, GivesTheVelocityThatHasItsFrictionFactor) {
    const double f = colebrook_white_friction_factor(0.02, 0.05, 4 * 0.05 * 0.3 / 1e-6);
    const double velocity = velocity_from_friction_factor(9.81 * 0.004, 0.05, f);
    EXPECT_NEAR(friction_factor(9.81 * 0.004, 0.05, velocity), f, 1e-14);
    EXPECT_NEAR(velocity_ratio(f), velocity / friction_velocity_from_slope(9.81 * 0.004, 0.05), 1e-12);
}

TEST(RoughnessClass, HasItsLimits) {
    EXPECT_EQ(roughness_class(4.9), RoughnessClass::smooth);
    EXPECT_EQ(roughness_class(5.0), RoughnessClass::transitional);
    EXPECT_EQ(roughness_class(70.0), RoughnessClass::transitional);
    EXPECT_EQ(roughness_class(70.1), RoughnessClass::rough);
    EXPECT_NEAR(roughness_reynolds_number(0.035, 0.044, 1e-6), 1540, 1e-9);
}

}  // namespace
}  // namespace riffle::channel_laws_test
