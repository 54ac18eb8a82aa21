#include "base/due_times.hpp"

#include <gtest/gtest.h>

namespace riffle::due_times_test {
namespace {

TEST(DueTimes, AreTheNextMultipleAlsoOfAStepThatPassesSeveral) {
    EXPECT_EQ(due_after(0.0, 0.25), 0.25);
    EXPECT_EQ(due_after(0.3, 0.25), 0.5);
    EXPECT_EQ(due_after(1.1, 0.25), 1.25);
    EXPECT_EQ(due_after_at_frequency(1.1, 4.0), 1.25);
}

TEST(DueTimes, StandStillForRounding) {
    // 3 * 0.1 is above 0.3; the time of the third sample must not be due twice, nor left out.
    double due = 0.0;
    for (int n = 1; n <= 100000; ++n) {
        due = due_after(due, 0.1);
        ASSERT_NEAR(due, 0.1 * n, 1e-9 * n);
        ASSERT_NEAR(due_after_at_frequency(0.1 * (n - 1), 10.0), 0.1 * n, 1e-9 * n);
    }
}

// 7 s of steps of 0.7 ms add up to 6.99999999999987 s.
TEST(DueTimes, HaveComeWhereOnlyRoundingIsMissing) {
    double time = 0.0;
    double due = due_after(0.0, 0.7);
    int passed = 0;
    for (int step = 1; step <= 10000; ++step) {
        time += 0.0007;
        if (!has_come(time, due, 0.7)) continue;
        ++passed;
        EXPECT_EQ(step, 1000 * passed);
        due = due_next(time, due, 0.7);
        EXPECT_FALSE(has_come(time, due, 0.7));
    }
    EXPECT_EQ(passed, 10);
}

}  // namespace
}  // namespace riffle::due_times_test
