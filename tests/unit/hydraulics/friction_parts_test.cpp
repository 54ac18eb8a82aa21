// The decomposition of the friction factor against flows whose factor is known.

#include "hydraulics/friction_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.hpp"

namespace riffle::friction_parts_test {
namespace {

constexpr double density = 1000.0;
constexpr double crests = 0.01;
constexpr double surface = 0.06;
constexpr double depth = surface - crests;

std::vector<double> heights(int n) {
    std::vector<double> z;
    for (int i = 0; i < n; ++i) z.push_back(surface * (i + 0.5) / n);
    return z;
}

// f = 24/Re of laminar flow down a plane, Re = U h/nu.
TEST(FrictionParts, LaminarFlowHasTwentyFourOverReynolds) {
    constexpr double viscosity = 1e-6;
    constexpr double weight = 9.81e-4;
    std::vector<double> stress;
    const std::vector<double> z = heights(20);
    for (const double height : z) stress.push_back(density * weight * (surface - height));
    const double velocity = weight * depth * depth / (3.0 * viscosity);
    EXPECT_NEAR(friction_factor_of_stress(z, stress, crests, surface, density, velocity),
                24.0 * viscosity / (velocity * depth), 1e-12);
}

// Parts that share the weight give together what the weight alone gives, 8 u_*^2/U^2, and each what its own
// integral is: of tau_c (1 - xi) sin^2(pi xi/2), whose integral with 1 - xi is (1/6 - 1/pi^2) tau_c h.
TEST(FrictionParts, ShareTheFactorOfTheWhole) {
    constexpr double u_star = 0.04;
    constexpr double velocity = 0.35;
    const std::vector<double> z = heights(400);
    std::vector<double> turbulent;
    std::vector<double> other;
    for (const double height : z) {
        const double xi = (height - crests) / depth;
        const double line = density * u_star * u_star * (1.0 - xi);
        const double share = xi > 0.0 ? std::pow(std::sin(0.5 * std::numbers::pi * xi), 2) : 0.0;
        turbulent.push_back(line * share);
        other.push_back(line * (1.0 - share));
    }
    const auto factor = [&](const std::vector<double>& stress) {
        return friction_factor_of_stress(z, stress, crests, surface, density, velocity);
    };
    const double whole = 8.0 * u_star * u_star / (velocity * velocity);
    EXPECT_NEAR(factor(turbulent) + factor(other), whole, 1e-12);
    const double expected = 3.0 * (1.0 / 6.0 - 1.0 / std::pow(std::numbers::pi, 2));
    EXPECT_NEAR(factor(turbulent) / whole, expected, 1e-4);
}

TEST(FrictionParts, RefuseWhatHasNoFactor) {
    const std::vector<double> z = {0.01, 0.05};
    const std::vector<double> stress = {1.0, 0.0};
    EXPECT_THROW((void)friction_factor_of_stress(z, stress, 0.06, 0.05, density, 0.3), InputError);
    EXPECT_THROW((void)friction_factor_of_stress(z, stress, 0.0, 0.06, density, 0.0), InputError);
    EXPECT_THROW((void)friction_factor_of_stress(z, std::vector<double>{1.0}, 0.0, 0.06, density, 0.3),
                 InputError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)friction_factor_of_stress(z, stress, 0.0, nan, density, 0.3), InputError);
}

}  // namespace
}  // namespace riffle::friction_parts_test
