#pragma once

#include <cmath>
#include <numbers>

#include "sph/lanes.hpp"

namespace riffle::inline sph {

// Smoothing kernels W(r, h) = value(q) / h^D, q = r/h, of support 2h, and the factor F of the gradient
// grad W = F r (r the vector from j to i), F = gradient_factor(q) / h^(D+2). Both vanish for q >= 2 without
// a branch. gradient_factor(q) = gradient_constant() gradient_shape(q): the loops sum the shape, and multiply
// the sum by the constant. `T` is a scalar or a vector of lanes; `R` its scalar type.

/// Wendland C2 (Wendland 1995): W ~ (1 - q/2)^4 (2q + 1).
template <int D>
struct WendlandC2 {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1 ? 5.0 / 8.0 : (D == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi)));
    }
    template <class T>
    RIFFLE_INLINE static T value(T q) {
        using R = scalar_of<T>;
        if constexpr (D == 1) {  // in one dimension C2 is (1 - q/2)^3 (3q/2 + 1)
            const T t = positive_part<T>(R(1) - R(0.5) * q);
            return normalisation<R>() * t * t * t * (R(1.5) * q + R(1));
        } else {
            const T t = positive_part<T>(R(1) - R(0.5) * q);
            const T t2 = t * t;
            return normalisation<R>() * t2 * t2 * (R(2) * q + R(1));
        }
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(D == 1 ? -3 : -5) * normalisation<R>();
    }
    template <class T>
    RIFFLE_INLINE static T gradient_shape(T q) {
        using R = scalar_of<T>;
        const T t = positive_part<T>(R(1) - R(0.5) * q);
        if constexpr (D == 1) {
            return t * t;
        } else {
            return t * t * t;
        }
    }
    template <class T>
    RIFFLE_INLINE static T gradient_factor(T q) {
        return gradient_constant<scalar_of<T>>() * gradient_shape(q);
    }
};

/// Cubic spline (Monaghan & Lattanzio 1985; thesis 2.36 f.): W ~ (1/4) [(2-q)^3 - 4 (1-q)^3], positive parts.
template <int D>
struct CubicSpline {
    template <class R>
    static constexpr R normalisation() {
        static_assert(D >= 1 && D <= 3);
        constexpr double pi = std::numbers::pi;
        return static_cast<R>(D == 1 ? 2.0 / 3.0 : (D == 2 ? 10.0 / (7.0 * pi) : 1.0 / pi));
    }
    template <class T>
    RIFFLE_INLINE static T value(T q) {
        using R = scalar_of<T>;
        const T a = positive_part<T>(R(2) - q);
        const T b = positive_part<T>(R(1) - q);
        return normalisation<R>() * R(0.25) * (a * a * a - R(4) * b * b * b);
    }
    template <class R>
    static constexpr R gradient_constant() {
        return R(-0.75) * normalisation<R>();
    }
    template <class T>
    RIFFLE_INLINE static T gradient_shape(T q) {
        using R = scalar_of<T>;
        const T a = positive_part<T>(R(2) - q);
        const T b = positive_part<T>(R(1) - q);
        // At q = 0 the bracket vanishes like 4q; the tiny number only keeps the quotient finite.
        return (a * a - R(4) * b * b) / (q + R(1e-12));
    }
    template <class T>
    RIFFLE_INLINE static T gradient_factor(T q) {
        return gradient_constant<scalar_of<T>>() * gradient_shape(q);
    }
};

}  // namespace riffle::inline sph
