#include "turbulence/closure.hpp"

#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "turbulence/nezu_rodi.hpp"
#include "turbulence/nikuradse.hpp"
#include "turbulence/ramp.hpp"
#include "turbulence/sps.hpp"

namespace riffle::closure_test {
namespace {

Case rough_bed() {
    Case c;
    c.channel.depth = 0.050;
    c.bed.roughness_height = 0.010;
    return c;
}

/// Largest value of f on (0, 1) and where it is.
template <class F>
std::pair<double, double> maximum(F f) {
    const auto [x, y] = boost::math::tools::brent_find_minima([&](double s) { return -f(s); }, 0.3, 0.95, 40);
    return {x, -y};
}

TEST(Ramp, IsKappaZThenLambdaH) {
    EXPECT_DOUBLE_EQ(ramp_mixing_length(0.1, 0.0, 1.0, 0.41, 0.09), 0.041);
    EXPECT_DOUBLE_EQ(ramp_mixing_length(0.5, 0.0, 1.0, 0.41, 0.09), 0.09);
    EXPECT_DOUBLE_EQ(ramp_mixing_length(1.2, 0.0, 1.0, 0.41, 0.09), 0.09);
    // Continuous at the kink xi = lambda/kappa.
    const double kink = 0.09 / 0.41;
    EXPECT_NEAR(ramp_mixing_length(kink * (1 + 1e-12), 0.0, 1.0, 0.41, 0.09),
                ramp_mixing_length(kink * (1 - 1e-12), 0.0, 1.0, 0.41, 0.09), 1e-12);
}

TEST(NezuRodi, HasItsPublishedMaxima) {
    // Thesis 2.21: 0.158 at xi 0.667 without wake, 0.1159 at 0.696 with Pi = 0.2.
    const auto plain = maximum([](double xi) { return nezu_rodi_mixing_length(xi, 0.0, 1.0, 0.41, 0.0); });
    EXPECT_NEAR(plain.first, 2.0 / 3.0, 1e-4);
    EXPECT_NEAR(plain.second, 0.158, 5e-4);
    const auto wake = maximum([](double xi) { return nezu_rodi_mixing_length(xi, 0.0, 1.0, 0.41, 0.2); });
    EXPECT_NEAR(wake.first, 0.696, 1e-3);
    EXPECT_NEAR(wake.second, 0.1159, 1e-4);
}

TEST(NezuRodi, ReproducesTheLogLawWithoutWake) {
    // l_m^2 u'^2 = u_*^2 (1 - xi) must give u' = u_*/(kappa z).
    for (const double xi : {0.01, 0.2, 0.5, 0.9, 0.999}) {
        const double length = nezu_rodi_mixing_length(xi, 0.0, 1.0, 0.41, 0.0);
        EXPECT_NEAR(std::sqrt(1 - xi) / length, 1 / (0.41 * xi), 1e-10 / xi);
    }
}

TEST(Nikuradse, HasItsPublishedEnds) {
    EXPECT_DOUBLE_EQ(nikuradse_mixing_length(1.0, 0.0, 1.0), 0.14);
    EXPECT_DOUBLE_EQ(nikuradse_mixing_length(1.5, 0.0, 1.0), 0.14);
    EXPECT_NEAR(nikuradse_mixing_length(1e-6, 0.0, 1.0) / 1e-6, 0.40, 1e-5);
}

TEST(Sps, UsesTheFilterWidthOfTheCase) {
    Case c = rough_bed();
    c.turbulence.closure = ClosureKind::sps;
    c.turbulence.smagorinsky_constant = 0.15;
    c.numerics.spacing = 0.002;
    EXPECT_NEAR(make_closure(c)->mixing_length(0.01), 0.15 * 0.002 / std::sqrt(2.0), 1e-15);
    c.turbulence.filter_width = 0.002;  // the comparison run of the paper
    EXPECT_DOUBLE_EQ(make_closure(c)->mixing_length(0.03), 0.15 * 0.002);
}

TEST(Smagorinsky, IsDampedAtTheBedAndBesideSideWalls) {
    Case c = rough_bed();
    c.channel.dimensions = 3;
    c.channel.width = 0.5;
    c.channel.sides = Sides::walls;
    c.turbulence.closure = ClosureKind::smagorinsky;
    c.turbulence.smagorinsky_constant = 0.17;
    c.turbulence.zero = 0.004;
    c.numerics.spacing = 0.003;
    const auto closure = make_closure(c);
    const double of_filter = 0.17 * 0.003;
    EXPECT_EQ(closure->mixing_length(0.004), 0.0);
    EXPECT_EQ(closure->mixing_length(-0.01), 0.0);
    // Close to the zero plane kappa z, far from it that of the filter, where both are alike a root of it.
    EXPECT_NEAR(closure->mixing_length(0.004 + 1e-6), c.turbulence.kappa * 1e-6, 1e-12);
    EXPECT_NEAR(closure->mixing_length(1.0), of_filter, 1e-6 * of_filter);
    EXPECT_NEAR(closure->mixing_length(0.004 + of_filter / c.turbulence.kappa), of_filter / std::sqrt(2.0),
                1e-12);
    EXPECT_TRUE(closure->varies_across());
    EXPECT_NEAR(closure->side_factor(0.25), 1.0, 1e-4);
    EXPECT_NEAR(closure->side_factor(0.5 - 1e-6), c.turbulence.kappa * 1e-6 / of_filter, 1e-6);
    EXPECT_EQ(closure->side_factor(0.0), 0.0);
}

TEST(Closure, NoneIsLaminar) {
    Case c = rough_bed();
    c.turbulence.closure = ClosureKind::none;
    EXPECT_EQ(make_closure(c), nullptr);
}

class EveryMixingLength : public testing::TestWithParam<ClosureKind> {};

TEST_P(EveryMixingLength, StartsAtTheZeroScalesWithTheDepthAndIsFinite) {
    Case c = rough_bed();
    c.turbulence.closure = GetParam();
    c.turbulence.wake_strength = 0.2;
    const auto from_bed = make_closure(c);
    c.turbulence.zero = 0.0045;
    const auto raised = make_closure(c);
    const double depth = c.total_depth();
    EXPECT_DOUBLE_EQ(depth, 0.056);
    EXPECT_EQ(from_bed->mixing_length(0.0), 0.0);
    EXPECT_EQ(from_bed->mixing_length(-0.001), 0.0);
    EXPECT_EQ(raised->mixing_length(0.0045), 0.0);
    EXPECT_EQ(raised->mixing_length(0.002), 0.0);
    for (const double xi : {0.05, 0.3, 0.8}) {
        const double h = depth - 0.0045;
        EXPECT_NEAR(raised->mixing_length(0.0045 + xi * h) / h, from_bed->mixing_length(xi * depth) / depth,
                    1e-12);
    }
    for (const double z : {-1.0, 0.0, 1e-300, depth, depth * (1 + 1e-9), 2 * depth}) {
        EXPECT_TRUE(std::isfinite(raised->mixing_length(z))) << z;
        EXPECT_GE(raised->mixing_length(z), 0.0) << z;
    }
}

TEST_P(EveryMixingLength, BatchAndScalarAgreeToTheBit) {
    Case c = rough_bed();
    c.turbulence.closure = GetParam();
    c.turbulence.zero = 0.001;
    const auto closure = make_closure(c);
    std::vector<double> z;
    for (int i = -5; i < 130; ++i) z.push_back(0.0005 * i);
    std::vector<double> batch(z.size(), std::numeric_limits<double>::quiet_NaN());
    closure->mixing_lengths(z, batch);
    for (std::size_t i = 0; i < z.size(); ++i) {
        EXPECT_EQ(batch[i], closure->mixing_length(z[i]));
        EXPECT_EQ(closure->eddy_viscosity(z[i], 10.0), batch[i] * batch[i] * 10.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Closures, EveryMixingLength,
                         testing::Values(ClosureKind::ramp, ClosureKind::nezu_rodi, ClosureKind::nikuradse));

}  // namespace
}  // namespace riffle::closure_test
