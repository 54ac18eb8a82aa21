#include "base/interpolation.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace riffle::interpolation_test {
namespace {

const std::vector<double> x = {0.0, 1.0, 3.0};
const std::vector<double> y = {2.0, 4.0, -4.0};

TEST(Interpolation, IsLinearBetweenTheEntriesAndExactAtThem) {
    EXPECT_EQ(place_in(x, 0.5).in(y), 3.0);
    EXPECT_EQ(place_in(x, 2.5).in(y), -2.0);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(place_in(x, x[i]).in(y), y[i]);
}

TEST(Interpolation, GoesOnWithTheEndsBeyondThem) {
    EXPECT_EQ(place_in(x, -7.0).in(y), 2.0);
    EXPECT_EQ(place_in(x, 7.0).in(y), -4.0);
    const std::vector<double> one = {5.0};
    EXPECT_EQ(place_in(one, 4.0).in(one), 5.0);
    EXPECT_EQ(place_in(one, 6.0).in(one), 5.0);
}

}  // namespace
}  // namespace riffle::interpolation_test
