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

}  // namespace
}  // namespace riffle::due_times_test
