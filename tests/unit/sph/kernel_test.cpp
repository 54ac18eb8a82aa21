#include "sph/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "case/words.hpp"
#include "sph/kernel_registry.hpp"
#include "sph/kernel_table.hpp"

namespace riffle::kernel_test {

namespace {

/// A number and its derivative: automatic differentiation in one variable.
struct Dual {
    double value = 0.0;
    double slope = 0.0;
    constexpr explicit Dual(double v, double d = 0.0) : value(v), slope(d) {}
    friend Dual operator+(Dual a, Dual b) { return Dual(a.value + b.value, a.slope + b.slope); }
    friend Dual operator-(Dual a, Dual b) { return Dual(a.value - b.value, a.slope - b.slope); }
    friend Dual operator*(Dual a, Dual b) {
        return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope);
    }
    friend Dual operator/(Dual a, Dual b) {
        return Dual(a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value);
    }
    friend bool operator<(Dual a, Dual b) { return a.value < b.value; }
    friend Dual exp(Dual a) { return Dual(std::exp(a.value), std::exp(a.value) * a.slope); }
};

/// Each that has a word: a new one is tested here from its first day. Pieces of a kernel must meet at
/// multiples of h/3, where those of the table and of the integrals below do.
const auto all_kernels = [] {
    std::array<KernelKind, Words<KernelKind>::list.size()> kinds{};
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = static_cast<KernelKind>(i);
    return kinds;
}();

/// Call f(kernel, name) for all kernels in D dimensions.
template <int D, class F>
void for_kernels(const F& f) {
    for (const KernelKind kind : all_kernels) {
        visit_kernel<D>(kind, [&](auto kernel) {
            f(kernel, std::string(word(kind)) + " in " + std::to_string(D) + " dimensions");
        });
    }
}

/// Integral of f over the line, the plane or the volume, h = 1. On thirds all kernels but the Gaussian are
/// polynomials, for which 15 Gauss points are exact; for the Gaussian their error is below rounding.
template <int D, class F>
double integral(const F& f) {
    constexpr double pi = std::numbers::pi;
    const auto shell = [&](double q) {
        return f(q) * (D == 1 ? 2.0 : (D == 2 ? 2.0 * pi * q : 4.0 * pi * q * q));
    };
    double sum = 0.0;
    for (int third = 0; third < 6; ++third) {
        sum += boost::math::quadrature::gauss<double, 15>::integrate(shell, third / 3.0, (third + 1) / 3.0);
    }
    return sum;
}

template <int D>
void check_integrals() {
    for_kernels<D>([](auto kernel, const std::string& name) {
        using Kernel = decltype(kernel);
        EXPECT_NEAR(integral<D>([](double q) { return Kernel::value(q); }), 1.0, 1e-12) << name;
        // The same by parts, with the gradient: in the continuum the matrix M is the identity.
        const double moment = -integral<D>([](double q) { return Kernel::gradient_factor(q) * q * q; }) / D;
        EXPECT_NEAR(moment, 1.0, 1e-11) << name;
    });
}
TEST(Kernel, IntegratesToOne) {
    check_integrals<1>();
    check_integrals<2>();
    check_integrals<3>();
}

/// Second moment of W along an axis, in h^2: the square of the length by which the kernel smooths.
template <int D>
double second_moment(KernelKind kind) {
    return visit_kernel<D>(kind, [](auto kernel) {
        return integral<D>([](double q) { return decltype(kernel)::value(q) * q * q; }) / D;
    });
}

// B-splines of n boxes have the variance n/12 of their boxes, of 1 h and 2/3 h; the parabola's integral is
// elementary; the Gaussian differs from the whole one, 2/9, by what is cut off: the table of docs/theory.md.
TEST(Kernel, SmoothsOverItsLength) {
    EXPECT_NEAR(second_moment<1>(KernelKind::cubic_spline), 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(second_moment<1>(KernelKind::quintic_spline), 0.5 * 4.0 / 9.0, 1e-12);
    EXPECT_NEAR(second_moment<1>(KernelKind::quadratic), 0.4, 1e-12);
    EXPECT_NEAR(second_moment<2>(KernelKind::gaussian), 2.0 / 9.0, 3e-3);
    const auto lengths = [](KernelKind kind) { return std::sqrt(second_moment<2>(kind)); };
    EXPECT_NEAR(lengths(KernelKind::wendland_c2), 0.527, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::cubic_spline), 0.562, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::gaussian), 0.470, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::quadratic), 0.632, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::quintic_spline), 0.463, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::wendland_c4), 0.461, 5e-4);
    EXPECT_NEAR(lengths(KernelKind::wendland_c6), 0.414, 5e-4);
}

/// F q against the derivative of W by automatic differentiation; 1e-12/q is added to some divisors.
template <int D>
void check_derivative() {
    for_kernels<D>([](auto kernel, const std::string& name) {
        using Kernel = decltype(kernel);
        for (int i = 1; i < 250; ++i) {
            const double q = 0.01 * i;
            const double derivative = Kernel::value(Dual(q, 1.0)).slope;
            const double allowed = 2e-14 + 2e-12 / q * std::abs(derivative);
            EXPECT_NEAR(Kernel::gradient_factor(q) * q, derivative, allowed) << name << ", q = " << q;
        }
    });
}
TEST(Kernel, GradientIsTheDerivative) {
    check_derivative<1>();
    check_derivative<2>();
    check_derivative<3>();
}

TEST(Kernel, VanishesBeyondTheSupport) {
    for_kernels<2>([](auto kernel, const std::string& name) {
        for (const double q : {2.0, 2.0001, 3.0, 100.0}) {
            EXPECT_EQ(decltype(kernel)::value(q), 0.0) << name;
            EXPECT_EQ(decltype(kernel)::gradient_factor(q), 0.0) << name;
        }
    });
}

TEST(Kernel, IsFiniteAtTheCentreAndFallsOutwards) {
    for_kernels<2>([](auto kernel, const std::string& name) {
        using Kernel = decltype(kernel);
        EXPECT_TRUE(std::isfinite(Kernel::gradient_factor(0.0))) << name;
        EXPECT_TRUE(std::isfinite(Kernel::gradient_factor(0.0F))) << name;
        for (int i = 1; i < 200; ++i) {
            EXPECT_LT(Kernel::value(0.01 * i), Kernel::value(0.01 * (i - 1))) << name;
        }
    });
}

// Lanes must give what scalars give, to the bit: one physics source.
TEST(Kernel, LanesEqualScalars) {
    Lanes<double> q;
    for (std::size_t l = 0; l < cluster_size; ++l) q[l] = 0.3 * static_cast<double>(l) + 0.05;
    const Lanes<double> value = WendlandC2<2>::value(q);
    const Lanes<double> factor = CubicSpline<2>::gradient_factor(q);
    for (std::size_t l = 0; l < cluster_size; ++l) {
        const double scalar = q[l];
        EXPECT_DOUBLE_EQ(value[l], WendlandC2<2>::value(scalar));
        EXPECT_DOUBLE_EQ(factor[l], CubicSpline<2>::gradient_factor(scalar));
    }
}

template <class Real>
double tabulated(const typename KernelTable<Real>::Polynomials& coefficients, double q) {
    using Table = KernelTable<Real>;
    const double place = std::min(q * static_cast<double>(Table::pieces_per_length), 1.0 * Table::pieces);
    const auto piece = static_cast<std::size_t>(place);
    const double t = 2.0 * (place - static_cast<double>(piece)) - 1.0;
    double sum = 0.0;
    for (std::size_t k = Table::degree + 1; k-- > 0;) {
        sum = sum * t + static_cast<double>(coefficients[k][piece]);
    }
    return sum;
}

/// Largest difference of table and formula, of the largest value. Each of the polynomial's coefficients is
/// rounded, and |t| <= 1: two roundings' worth in single precision; in double the formulas round as well.
template <int D, class Real>
void check_table(double allowed) {
    for (const KernelKind kind : all_kernels) {
        const KernelTable<Real>& table = kernel_table<D, Real>(kind);
        visit_kernel<D>(kind, [&](auto kernel) {
            using Kernel = decltype(kernel);
            double value = 0.0;
            double slope = 0.0;
            double largest_value = 0.0;
            double largest_slope = 0.0;
            for (int i = 0; i < 22000; ++i) {
                const double q = 1e-4 * i + 5e-5;
                const double w = Kernel::value(q);
                const double s = Kernel::gradient_factor(q) * q;
                largest_value = std::max(largest_value, std::abs(w));
                largest_slope = std::max(largest_slope, std::abs(s));
                value = std::max(value, std::abs(tabulated<Real>(table.value, q) - w));
                slope = std::max(slope, std::abs(tabulated<Real>(table.slope, q) - s));
            }
            EXPECT_LT(value, allowed * largest_value) << word(kind);
            EXPECT_LT(slope, allowed * largest_slope) << word(kind);
        });
    }
}

TEST(KernelTable, EqualsTheFormulaToRounding) {
    constexpr double single = std::numeric_limits<float>::epsilon();
    check_table<2, float>(single);
    check_table<3, float>(single);
    check_table<2, double>(2e-14);
    check_table<3, double>(2e-14);
}

}  // namespace
}  // namespace riffle::kernel_test
