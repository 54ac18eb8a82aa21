#include "statistics/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace riffle::record_test {
namespace {

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoThere) {
    EXPECT_EQ(median_of(std::vector{5.0, -1.0, 2.0}), 2.0);
    EXPECT_EQ(median_of(std::vector{7.0, 1.0, 2.0, 4.0}), 3.0);
    EXPECT_EQ(median_of(std::vector{4.0}), 4.0);
    EXPECT_TRUE(std::isnan(median_of({})));
}

}  // namespace
}  // namespace riffle::record_test
