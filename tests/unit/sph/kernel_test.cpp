#include "sph/kernel.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace riffle {
namespace {

/// Integral of W over the line, the plane or the volume, h = 1. Both kernels are polynomials on [0, 1] and
/// [1, 2], for which 15 Gauss points are exact.
template <class Kernel, int D>
double integral() {
    constexpr double pi = std::numbers::pi;
    const auto shell = [](double q) { return D == 1 ? 2.0 : (D == 2 ? 2.0 * pi * q : 4.0 * pi * q * q); };
    const auto f = [&](double q) { return Kernel::value(q) * shell(q); };
    using Gauss = boost::math::quadrature::gauss<double, 15>;
    return Gauss::integrate(f, 0.0, 1.0) + Gauss::integrate(f, 1.0, 2.0);
}

TEST(Kernel, IntegratesToOne) {
    EXPECT_NEAR((integral<WendlandC2<1>, 1>()), 1.0, 1e-12);
    EXPECT_NEAR((integral<WendlandC2<2>, 2>()), 1.0, 1e-12);
    EXPECT_NEAR((integral<WendlandC2<3>, 3>()), 1.0, 1e-12);
    EXPECT_NEAR((integral<CubicSpline<1>, 1>()), 1.0, 1e-12);
    EXPECT_NEAR((integral<CubicSpline<2>, 2>()), 1.0, 1e-12);
    EXPECT_NEAR((integral<CubicSpline<3>, 3>()), 1.0, 1e-12);
}

/// F q against the derivative of W by central differences of fourth order; their error is about 1e-11 for the
/// step 1e-3, and below 1e-8 on a kink of the third derivative.
template <class Kernel>
void check_derivative() {
    constexpr double step = 1e-3;
    for (int i = 1; i < 250; ++i) {
        const double q = 0.01 * i;
        const double derivative = (8.0 * (Kernel::value(q + step) - Kernel::value(q - step)) -
                                   (Kernel::value(q + 2.0 * step) - Kernel::value(q - 2.0 * step))) /
                                  (12.0 * step);
        const bool knot = std::abs(q - 1.0) < 3.0 * step || std::abs(q - 2.0) < 3.0 * step;
        EXPECT_NEAR(Kernel::gradient_factor(q) * q, derivative, knot ? 1e-5 : 1e-10) << "q = " << q;
    }
}

TEST(Kernel, GradientIsTheDerivative) {
    check_derivative<WendlandC2<1>>();
    check_derivative<WendlandC2<2>>();
    check_derivative<WendlandC2<3>>();
    check_derivative<CubicSpline<1>>();
    check_derivative<CubicSpline<2>>();
    check_derivative<CubicSpline<3>>();
}

TEST(Kernel, VanishesBeyondTheSupport) {
    for (const double q : {2.0, 2.0001, 3.0, 100.0}) {
        EXPECT_EQ(WendlandC2<2>::value(q), 0.0);
        EXPECT_EQ(WendlandC2<2>::gradient_factor(q), 0.0);
        EXPECT_EQ(CubicSpline<2>::value(q), 0.0);
        EXPECT_EQ(CubicSpline<2>::gradient_factor(q), 0.0);
    }
}

TEST(Kernel, IsFiniteAtTheCentreAndFallsOutwards) {
    EXPECT_TRUE(std::isfinite(WendlandC2<2>::gradient_factor(0.0)));
    EXPECT_TRUE(std::isfinite(CubicSpline<2>::gradient_factor(0.0)));
    EXPECT_TRUE(std::isfinite(CubicSpline<2>::gradient_factor(0.0F)));
    for (int i = 1; i < 200; ++i) {
        EXPECT_LT(WendlandC2<2>::value(0.01 * i), WendlandC2<2>::value(0.01 * (i - 1)));
        EXPECT_LT(CubicSpline<2>::value(0.01 * i), CubicSpline<2>::value(0.01 * (i - 1)));
    }
}

// Lanes must give what scalars give, to the bit: one physics source.
TEST(Kernel, LanesEqualScalars) {
    Lanes<double> q;
    for (std::size_t l = 0; l < cluster_size; ++l) {
        q[l] = 0.3 * static_cast<double>(l) + 0.05;
    }
    const Lanes<double> value = WendlandC2<2>::value(q);
    const Lanes<double> factor = CubicSpline<2>::gradient_factor(q);
    for (std::size_t l = 0; l < cluster_size; ++l) {
        const double scalar = q[l];
        EXPECT_DOUBLE_EQ(value[l], WendlandC2<2>::value(scalar));
        EXPECT_DOUBLE_EQ(factor[l], CubicSpline<2>::gradient_factor(scalar));
    }
}

}  // namespace
}  // namespace riffle
