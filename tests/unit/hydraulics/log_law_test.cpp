#include "hydraulics/log_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hydraulics/channel_laws.hpp"

namespace riffle {
namespace {

constexpr double kappa = 0.41;
constexpr double friction_velocity = 0.044;
constexpr double roughness = 0.035;
constexpr double plane = 0.006;

struct Profile {
    std::vector<double> z;
    std::vector<double> velocity;
};

Profile rough_profile(int n, double noise, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    Profile p;
    for (int i = 0; i < n; ++i) {
        const double z = 0.011 + 0.030 * i / (n - 1);
        p.z.push_back(z);
        p.velocity.push_back(rough_log_law(z - plane, friction_velocity, roughness) +
                             noise * normal(generator));
    }
    return p;
}

TEST(LogLaw, ExactProfileGivesItsParameters) {
    const Profile p = rough_profile(20, 0.0, 1);
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

// 1000 trials of a 95 % interval scatter by 0.7 %; the linear propagation to k_s is exact only in the limit
// of small noise, so it gets 93-97 % like the others: three standard deviations.
TEST(LogLaw, IntervalsCoverTheTruthInNinetyFiveOfAHundred) {
    constexpr int trials = 1000;
    int friction = 0;
    int equivalent = 0;
    for (int i = 0; i < trials; ++i) {
        const Profile p = rough_profile(15, 0.003, static_cast<std::uint64_t>(i));
        const LogLawFit fit = fit_log_law(p.z, p.velocity, kappa, plane, 0.0, 1.0);
        ASSERT_TRUE(fit.valid);
        friction += std::abs(fit.friction_velocity - friction_velocity) <= fit.friction_velocity_half_width;
        equivalent += std::abs(fit.equivalent_roughness - roughness) <= fit.equivalent_roughness_half_width;
    }
    std::printf("u_* covered %.1f %%, k_s %.1f %%\n", 100.0 * friction / trials, 100.0 * equivalent / trials);
    EXPECT_NEAR(friction, 0.95 * trials, 0.021 * trials);
    EXPECT_NEAR(equivalent, 0.95 * trials, 0.021 * trials);
}

TEST(LogLaw, IntervalsCoverTheTruthWithAFreePlane) {
    // Three parameters need a quieter profile before the linear propagation holds.
    constexpr int trials = 1000;
    int friction = 0;
    int zero_plane = 0;
    for (int i = 0; i < trials; ++i) {
        const Profile p = rough_profile(40, 0.0005, static_cast<std::uint64_t>(i));
        const LogLawFit fit = fit_log_law_with_zero_plane(p.z, p.velocity, kappa, 0.0, 1.0);
        ASSERT_TRUE(fit.valid);
        friction += std::abs(fit.friction_velocity - friction_velocity) <= fit.friction_velocity_half_width;
        zero_plane += std::abs(fit.zero_plane - plane) <= fit.zero_plane_half_width;
    }
    std::printf("u_* covered %.1f %%, plane %.1f %%\n", 100.0 * friction / trials,
                100.0 * zero_plane / trials);
    EXPECT_NEAR(friction, 0.95 * trials, 0.03 * trials);
    EXPECT_NEAR(zero_plane, 0.95 * trials, 0.03 * trials);
}

TEST(LogLaw, UsesOnlyTheRangeAskedFor) {
    Profile p = rough_profile(30, 0.0, 1);
    p.velocity.front() = 10.0;
    p.velocity.back() = -10.0;
    const LogLawFit fit = fit_log_law(p.z, p.velocity, kappa, plane, 0.0115, 0.0405);
    EXPECT_NEAR(fit.friction_velocity, friction_velocity, 1e-12);
    EXPECT_EQ(fit.from, 0.0115);
    EXPECT_EQ(fit.to, 0.0405);
}

TEST(LogLaw, SaysWhenThereIsNoFit) {
    const Profile p = rough_profile(30, 0.0, 1);
    EXPECT_FALSE(fit_log_law(p.z, p.velocity, kappa, plane, 0.5, 0.6).valid);  // no points
    EXPECT_FALSE(fit_log_law(p.z, p.velocity, kappa, 0.02, 0.0, 1.0).valid);   // plane within the points
    std::vector<double> falling;
    for (const double z : p.z) falling.push_back(1.0 - z);
    EXPECT_FALSE(fit_log_law(p.z, falling, kappa, plane, 0.0, 1.0).valid);
    std::vector<double> straight;  // no plane makes a straight line logarithmic
    for (const double z : p.z) straight.push_back(z);
    EXPECT_FALSE(fit_log_law_with_zero_plane(p.z, straight, kappa, 0.0, 1.0).valid);
}

}  // namespace
}  // namespace riffle
