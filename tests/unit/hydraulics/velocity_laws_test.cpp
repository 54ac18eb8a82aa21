#include "hydraulics/velocity_laws.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle::velocity_laws_test {
namespace {

TEST(SineIntegral, KnownValuesAndDifferentialEquation) {
    // Abramowitz & Stegun, table 5.1, ten digits; the Gibbs value Si(pi).
    EXPECT_NEAR(sine_integral(0.5), 0.4931074180, 5e-11);
    EXPECT_NEAR(sine_integral(1.0), 0.9460830704, 5e-11);
    EXPECT_NEAR(sine_integral(5.0), 1.5499312449, 5e-11);
    EXPECT_NEAR(sine_integral(10.0), 1.6583475942, 5e-11);
    EXPECT_NEAR(sine_integral(std::numbers::pi), 1.851937051982466, 1e-14);
    EXPECT_EQ(sine_integral(0.0), 0.0);
    EXPECT_EQ(sine_integral(-2.0), -sine_integral(2.0));
    EXPECT_THROW((void)sine_integral(10.1), InputError);
}

TEST(VelocityLaws, SmoothLogLaw) {
    // u+ at z+ = e^(4.1 kappa) is 4.1 + B.
    const double nu = 1e-6;
    const double u_star = 0.02;
    const double z = nu / u_star * std::exp(10 * log_law_kappa);
    EXPECT_NEAR(smooth_log_law(z, u_star, nu) / u_star, 15.0, 1e-12);
    // Smooth and rough law are one with k_s+ = exp(kappa (8.5 - 5.0)), about 4.2.
    const double k_s = nu / u_star * std::exp(log_law_kappa * (rough_log_law_constant - 5.0));
    EXPECT_NEAR(rough_log_law(0.03, u_star, k_s), smooth_log_law(0.03, u_star, nu), 1e-14);
}

TEST(VelocityLaws, WakeRisesToTwoPiOverKappaAtTheSurface) {
    EXPECT_NEAR(coles_wake(0.07, 0.07, 0.2), 0.4 / log_law_kappa, 1e-14);
    EXPECT_NEAR(coles_wake(0.035, 0.07, 0.2), 0.2 / log_law_kappa, 1e-14);
    EXPECT_EQ(coles_wake(0.0, 0.07, 0.2), 0.0);
    EXPECT_NEAR(rough_log_wake_law(0.07, 0.07, 0.04, 0.03, 0.2),
                rough_log_law(0.07, 0.04, 0.03) + 0.04 * 0.4 / log_law_kappa, 1e-14);
}

TEST(VelocityLaws, PowerLaw) {
    EXPECT_EQ(power_law(0.05, 0.05, 0.4, 3.0), 0.4);
    EXPECT_NEAR(power_law(0.05 / 8, 0.05, 0.4, 3.0), 0.2, 1e-15);
}

TEST(VelocityLaws, DipModifiedLogLawHasItsMaximumBelowTheSurface) {
    const double depth = 0.1;
    const double dip = dip_parameter_near_wall(0.15, depth);
    EXPECT_NEAR(dip, 1.3 * std::exp(-1.5), 1e-15);
    const double top = depth / (1 + dip);
    EXPECT_NEAR(dip_parameter_of_maximum(top, depth), dip, 1e-14);
    const auto u = [&](double z) { return dip_modified_log_law(z, depth, 0.04, 1e-3, dip); };
    EXPECT_GT(u(top), u(top - 1e-3));
    EXPECT_GT(u(top), u(top + 1e-3));
    // Without dip the log law: steepness u_*/kappa, zero at z0.
    EXPECT_NEAR(dip_modified_log_law(0.05, depth, 0.04, 1e-3, 0.0), 0.04 / log_law_kappa * std::log(50),
                1e-14);
}

/// The closed form (2.26) against the integral of its differential form.
TEST(VelocityLaws, TotalDipLogWakeLawIsTheIntegralOfItsGradient) {
    const double depth = 0.09;
    const double z0 = 2e-4;
    for (const double wake : {0.0, 0.2, 0.55}) {
        for (const double dip : {0.0, 0.15, 0.8}) {
            for (const double z : {0.001, 0.02, 0.06, 0.089}) {
                // In ln z the integrand is smooth.
                const auto integrand = [&](double log_z) {
                    const double height = std::exp(log_z);
                    return height * total_dip_log_wake_gradient(height, depth, 0.05, dip, wake);
                };
                const double integral = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                    integrand, std::log(z0), std::log(z), 15, 1e-12);
                const double closed = total_dip_log_wake_law(z, depth, 0.05, z0, dip, wake);
                EXPECT_NEAR(closed, integral, 1e-11) << wake << ' ' << dip << ' ' << z;
            }
        }
    }
    EXPECT_NEAR(total_dip_log_wake_law(z0, depth, 0.05, z0, 0.3, 0.2), 0.0, 1e-15);
}

TEST(VelocityLaws, TotalDipLawWithoutDipIsLogLawAndColesWake) {
    // (1 - cos(pi xi)) Pi/kappa is 2 Pi/kappa sin^2(pi xi/2), less its value at z0.
    const double depth = 0.09;
    const double expected = 0.05 * (std::log(0.03 / 2e-4) / log_law_kappa + coles_wake(0.03, depth, 0.2) -
                                    coles_wake(2e-4, depth, 0.2));
    EXPECT_NEAR(total_dip_log_wake_law(0.03, depth, 0.05, 2e-4, 0.0, 0.2), expected, 1e-13);
}

TEST(TurbulenceLaws, IntensitiesAndStresses) {
    const TurbulenceIntensities bed = nezu_intensities(0.0, 0.1, 0.04);
    EXPECT_DOUBLE_EQ(bed.streamwise, 2.30 * 0.04);
    EXPECT_DOUBLE_EQ(bed.vertical, 1.27 * 0.04);
    EXPECT_DOUBLE_EQ(bed.spanwise, 1.63 * 0.04);
    // The turbulence energy of (2.12-2.14) is 4.78 u_*^2 exp(-2 z/h) (Nezu 1977).
    const TurbulenceIntensities t = nezu_intensities(0.05, 0.1, 1.0);
    const double energy =
        0.5 * (t.streamwise * t.streamwise + t.vertical * t.vertical + t.spanwise * t.spanwise);
    EXPECT_NEAR(energy, 4.78 * std::exp(-1.0), 0.005);
    EXPECT_DOUBLE_EQ(linear_reynolds_stress(0.025, 0.1), 0.75);
    EXPECT_DOUBLE_EQ(reynolds_stress_with_secondary_flow(0.025, 0.1, 0.4, -0.001, 0.02), 0.75 - 1.0);
    // H - d_h = h_w - 4 mm: condition 2, 46 mm.
    EXPECT_NEAR(crest_stress(1000, 9.81 * 0.004, 0.056, 0.010), 1000 * 9.81 * 0.004 * 0.046, 1e-12);
    EXPECT_EQ(relative_stress_above_crest(0.010, 0.056, 0.010), 1.0);
    EXPECT_EQ(relative_stress_above_crest(0.056, 0.056, 0.010), 0.0);
}

}  // namespace
}  // namespace riffle::velocity_laws_test
