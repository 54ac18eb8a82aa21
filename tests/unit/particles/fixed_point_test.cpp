#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <cmath>
#include <cstdint>

#include "particles/domain.hpp"

namespace riffle::fixed_point_test {
namespace {

Domain<2> domain() { return {.lower = {0.0, -0.02}, .upper = {0.2, 0.13}, .periodic = {true, false}}; }

/// A number in [0, 1).
rc::Gen<double> fraction() {
    return rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 40),
                        [](std::int64_t i) { return std::ldexp(static_cast<double>(i), -40); });
}

TEST(FixedPoint, DecodesToHalfAUnit) {
    EXPECT_TRUE(rc::check("decode(encode(x)) is within half a unit of x", [] {
        const Domain<2> d = domain();
        const FixedPoint<2> fixed(d);
        for (std::size_t k = 0; k < 2; ++k) {
            const double x = d.lower[k] + *fraction() * (d.upper[k] - d.lower[k]);
            RC_PRE(fixed.in_range(x, k));
            // Half a unit and the rounding of the subtraction and division, 1e-5 units.
            RC_ASSERT(std::abs(fixed.decode(fixed.encode(x, k), k) - x) <= 0.5001 * fixed.unit(k));
        }
    }));
}

TEST(FixedPoint, WrapsToTheNearestImage) {
    EXPECT_TRUE(rc::check("the wrapped difference is the distance to the nearest periodic image", [] {
        const Domain<2> d = domain();
        const FixedPoint<2> fixed(d);
        const double a = *fraction() * 0.2;
        const double b = *fraction() * 0.2;
        double exact = a - b;
        exact -= 0.2 * std::nearbyint(exact / 0.2);
        RC_PRE(std::abs(std::abs(exact) - 0.1) > 1e-8);
        const double measured = wrapped_difference(fixed.encode(a, 0), fixed.encode(b, 0)) * fixed.unit(0);
        RC_ASSERT(std::abs(measured - exact) <= 1.001 * fixed.unit(0));
    }));
}

TEST(FixedPoint, DoesNotOverflowAcrossAClosedAxis) {
    const Domain<2> d = domain();
    const FixedPoint<2> fixed(d);
    const double low = d.lower[1] + 1e-9;
    const double high = d.upper[1] - 1e-9;
    const double difference = wrapped_difference(fixed.encode(high, 1), fixed.encode(low, 1)) * fixed.unit(1);
    EXPECT_NEAR(difference, high - low, 2.0 * fixed.unit(1));
}

TEST(FixedPoint, KnowsItsRange) {
    const Domain<2> d = domain();
    const FixedPoint<2> fixed(d);
    EXPECT_TRUE(fixed.in_range(0.0, 0));
    EXPECT_FALSE(fixed.in_range(0.2, 0));
    EXPECT_FALSE(fixed.in_range(-1e-6, 0));
    EXPECT_TRUE(fixed.in_range(-0.02 + 1e-9, 1));
    EXPECT_FALSE(fixed.in_range(-0.0201, 1));
    EXPECT_FALSE(fixed.in_range(0.1301, 1));
    EXPECT_FALSE(fixed.in_range(std::nan(""), 0));
    EXPECT_FALSE(fixed.in_range(std::nan(""), 1));
}

}  // namespace
}  // namespace riffle::fixed_point_test
