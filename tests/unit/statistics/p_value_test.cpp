#include "statistics/p_value.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace riffle {
namespace {

TEST(PValue, IsSaidNoFinerThanItIsKnown) {
    EXPECT_EQ(p_value_text(0.0123), "= 0.012");
    EXPECT_EQ(p_value_text(2e-16), "= 2e-16");
    EXPECT_EQ(p_value_text(std::numeric_limits<double>::denorm_min()), "< 1e-16");
    EXPECT_EQ(p_value_text(0.0), "< 1e-16");
}

}  // namespace
}  // namespace riffle
