#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/kernel.hpp"

namespace riffle::inline sph {

// Kernels beside those of kernel.hpp, of the same interface. The pair loops take them from a table
// (kernel_table.hpp); these formulas serve whatever is not in a hurry.

/// Gaussian of length 2h/3, cut at three of its lengths and lowered there to zero, so that W is continuous
/// and its gradient the derivative of it (Colagrossi & Landrini 2003): W ~ exp(-(3q/2)^2) - exp(-9). The
/// gradient ends with a step of 0.09 % of its largest value.
template <int D>
struct Gaussian {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        constexpr double erf_3 = 0.99997790950300141456;
        constexpr double sqrt_pi = 1.77245385090551602730;
        // Integrals over s = 3q/2 < 3: sqrt(pi) erf(3) - 6 e^-9, pi (1 - 10 e^-9), pi^1.5 erf(3) - 42 pi
        // e^-9.
        return static_cast<R>(D == 1   ? 1.5 / (sqrt_pi * erf_3 - 6.0 * edge)
                              : D == 2 ? 2.25 / (pi * (1.0 - 10.0 * edge))
                                       : 3.375 / (pi * (sqrt_pi * erf_3 - 42.0 * edge)));
    }
    template <class T>
    static T value(T q) {
        using std::exp;
        return q < T(2) ? normalisation<T>() * (exp(T(-2.25) * q * q) - T(edge)) : T(0);
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(-4.5) * normalisation<R>();
    }
    template <class T>
    static T gradient_shape(T q) {
        using std::exp;
        return q < T(2) ? exp(T(-2.25) * q * q) : T(0);
    }
    template <class T>
    static T gradient_factor(T q) {
        return gradient_constant<T>() * gradient_shape(q);
    }

  private:
    static constexpr double edge = 1.2340980408667954949764e-4;  // exp(-9)
};

/// Parabola (Johnson, Stryk & Beissel 1996; SPHysics): W ~ (1 - q/2)^2, F unbounded at the centre.
template <int D>
struct Quadratic {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1 ? 3.0 / 4.0 : (D == 2 ? 3.0 / (2.0 * pi) : 15.0 / (16.0 * pi)));
    }
    template <class T>
    static T value(T q) {
        const T t = positive_part<T>(T(1) - T(0.5) * q);
        return normalisation<T>() * t * t;
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(-1) * normalisation<R>();
    }
    template <class T>
    static T gradient_shape(T q) {
        using std::max;
        return positive_part<T>(T(1) - T(0.5) * q) / max(q, T(1e-12));
    }
    template <class T>
    static T gradient_factor(T q) {
        return gradient_constant<T>() * gradient_shape(q);
    }
};

/// Quintic B-spline (Schoenberg 1946; Morris et al. 1997), its radius of three lengths made 2h:
/// W ~ (3-s)^5 - 6 (2-s)^5 + 15 (1-s)^5, positive parts, s = 3q/2. (In three dimensions the constant is
/// 1/(120 pi); the 3/(359 pi) of the literature is 0.3 % too large.)
template <int D>
struct QuinticSpline {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1   ? 1.5 / 120.0
                              : D == 2 ? 2.25 * 7.0 / (478.0 * pi)
                                       : 3.375 / (120.0 * pi));
    }
    template <class T>
    static T value(T q) {
        return normalisation<T>() * powers<5>(q);
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(-7.5) * normalisation<R>();
    }
    template <class T>
    static T gradient_shape(T q) {
        using std::max;
        return powers<4>(q) / max(q, T(1e-12));
    }
    template <class T>
    static T gradient_factor(T q) {
        return gradient_constant<T>() * gradient_shape(q);
    }

  private:
    template <int Exponent, class T>
    static T powers(T q) {
        const auto power = [](T x) {
            const T x2 = x * x;
            return Exponent == 5 ? x2 * x2 * x : x2 * x2;
        };
        const T s = T(1.5) * q;
        return power(positive_part<T>(T(3) - s)) - T(6) * power(positive_part<T>(T(2) - s)) +
               T(15) * power(positive_part<T>(T(1) - s));
    }
};

/// Wendland C4 (Wendland 1995; Dehnen & Aly 2012): W ~ (1 - q/2)^6 (35 q^2/12 + 3q + 1), in one dimension
/// (1 - q/2)^5 (2 q^2 + 5q/2 + 1).
template <int D>
struct WendlandC4 {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1 ? 3.0 / 4.0 : (D == 2 ? 9.0 / (4.0 * pi) : 495.0 / (256.0 * pi)));
    }
    template <class T>
    static T value(T q) {
        const T t = positive_part<T>(T(1) - T(0.5) * q);
        const T t2 = t * t;
        if constexpr (D == 1) {
            return normalisation<T>() * t2 * t2 * t * (T(2) * q * q + T(2.5) * q + T(1));
        } else {
            return normalisation<T>() * t2 * t2 * t2 * (T(35) / T(12) * q * q + T(3) * q + T(1));
        }
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(D == 1 ? -7.0 / 2.0 : -14.0 / 3.0) * normalisation<R>();
    }
    template <class T>
    static T gradient_shape(T q) {
        const T t = positive_part<T>(T(1) - T(0.5) * q);
        const T t2 = t * t;
        if constexpr (D == 1) {
            return t2 * t2 * (T(2) * q + T(1));
        } else {
            return t2 * t2 * t * (T(2.5) * q + T(1));
        }
    }
    template <class T>
    static T gradient_factor(T q) {
        return gradient_constant<T>() * gradient_shape(q);
    }
};

/// Wendland C6 (Wendland 1995; Dehnen & Aly 2012): W ~ (1 - q/2)^8 (4 q^3 + 25 q^2/4 + 4q + 1), in one
/// dimension (1 - q/2)^7 (21 q^3/8 + 19 q^2/4 + 7q/2 + 1).
template <int D>
struct WendlandC6 {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1 ? 55.0 / 64.0 : (D == 2 ? 39.0 / (14.0 * pi) : 1365.0 / (512.0 * pi)));
    }
    template <class T>
    static T value(T q) {
        const T t = positive_part<T>(T(1) - T(0.5) * q);
        const T t2 = t * t;
        if constexpr (D == 1) {
            return normalisation<T>() * t2 * t2 * t2 * t *
                   (((T(2.625) * q + T(4.75)) * q + T(3.5)) * q + T(1));
        } else {
            const T t4 = t2 * t2;
            return normalisation<T>() * t4 * t4 * (((T(4) * q + T(6.25)) * q + T(4)) * q + T(1));
        }
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(D == 1 ? -1.5 : -5.5) * normalisation<R>();
    }
    template <class T>
    static T gradient_shape(T q) {
        const T t = positive_part<T>(T(1) - T(0.5) * q);
        const T t2 = t * t;
        if constexpr (D == 1) {
            return t2 * t2 * t2 * ((T(8.75) * q + T(9)) * q + T(3));
        } else {
            return t2 * t2 * t2 * t * ((T(4) * q + T(3.5)) * q + T(1));
        }
    }
    template <class T>
    static T gradient_factor(T q) {
        return gradient_constant<T>() * gradient_shape(q);
    }
};

}  // namespace riffle::inline sph
