#include "solver/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace riffle {
namespace {

struct Record {
    std::vector<double> time;
    std::vector<double> velocity;
};

/// A flow that relaxes to 1 m/s from `start` with e-folding time 5 s, with white noise.
Record relaxing(double start, double noise, double duration) {
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    Record r;
    for (double t = 0.0; t < duration; t += 0.02) {
        r.time.push_back(t);
        r.velocity.push_back(1.0 + (start - 1.0) * std::exp(-t / 5.0) + noise * normal(generator));
    }
    return r;
}

TEST(Convergence, WaitsForFourRelaxationTimesEvenOfASteadyRecord) {
    const Record early = relaxing(1.0, 1e-4, 19.0);
    EXPECT_FALSE(test_convergence(early.time, early.velocity, 5.0, 0.005).converged);
    const Record later = relaxing(1.0, 1e-4, 20.1);
    const Convergence c = test_convergence(later.time, later.velocity, 5.0, 0.005);
    EXPECT_TRUE(c.converged);
    EXPECT_DOUBLE_EQ(c.window_start, 15.0);
    EXPECT_NEAR(c.mean.mean, 1.0, 1e-4);
}

TEST(Convergence, SeesTheDriftStillToComeOfAStartFromRest) {
    // At 20 s the flow from rest lacks 1.8 % of its velocity; a fixed waiting time would not know.
    const Record from_rest = relaxing(0.0, 1e-4, 20.1);
    EXPECT_FALSE(test_convergence(from_rest.time, from_rest.velocity, 5.0, 0.005).converged);
    const Record long_after = relaxing(0.0, 1e-4, 45.0);
    const Convergence c = test_convergence(long_after.time, long_after.velocity, 5.0, 0.005);
    ASSERT_TRUE(c.converged);
    EXPECT_NEAR(c.mean.mean, 1.0, 0.005);
}

TEST(Convergence, IsNotReachedWhileTheMeanIsUncertain) {
    const Record noisy = relaxing(1.0, 0.5, 20.1);
    const Convergence c = test_convergence(noisy.time, noisy.velocity, 5.0, 0.005);
    EXPECT_FALSE(c.converged);
    EXPECT_FALSE(c.reason.empty());
}

TEST(Convergence, TakesTheAskedStartOfTheWindow) {
    const Record r = relaxing(1.0, 1e-4, 30.0);
    EXPECT_DOUBLE_EQ(test_convergence(r.time, r.velocity, 5.0, 0.005, 12.0).window_start, 12.0);
}

TEST(Convergence, OfNothingIsNotReached) { EXPECT_FALSE(test_convergence({}, {}, 5.0, 0.005).converged); }

}  // namespace
}  // namespace riffle
