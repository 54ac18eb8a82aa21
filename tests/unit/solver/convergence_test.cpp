#include "solver/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace riffle::convergence_test {
namespace {

struct Record {
    std::vector<double> time;
    std::vector<double> velocity;
    std::vector<double> fluctuation;

    [[nodiscard]] Convergence test(double fixed_start = -1.0) const {
        return test_convergence({time, velocity, fluctuation}, 5.0, 0.005, fixed_start);
    }
};

/// A flow that relaxes to 1 m/s from `start` with e-folding time 5 s, with white noise.
Record relaxing(double start, double noise, double duration) {
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    Record r;
    for (double t = 0.0; t < duration; t += 0.02) {
        r.time.push_back(t);
        r.velocity.push_back(1.0 + (start - 1.0) * std::exp(-t / 5.0) + noise * normal(generator));
        r.fluctuation.push_back(0.003 * std::exp(0.1 * normal(generator)));
    }
    return r;
}

TEST(Convergence, WaitsForFourRelaxationTimesEvenOfASteadyRecord) {
    const Record early = relaxing(1.0, 1e-4, 19.0);
    EXPECT_FALSE(early.test().converged);
    const Record later = relaxing(1.0, 1e-4, 20.1);
    const Convergence c = later.test();
    EXPECT_TRUE(c.converged);
    EXPECT_DOUBLE_EQ(c.window_start, 15.0);
    EXPECT_NEAR(c.mean.mean, 1.0, 1e-4);
}

// While the record grows, the expected end must be about where the test will be passed.
TEST(Convergence, TellsAboutWhereItWillEnd) {
    for (const double noise : {1e-4, 0.03}) {
        const Record whole = relaxing(0.9, noise, 200.0);
        const auto test_at = [&](double end) {
            const auto n = static_cast<std::size_t>(std::lround(end / 0.02));
            return test_convergence({std::span(whole.time).first(n), std::span(whole.velocity).first(n),
                                     std::span(whole.fluctuation).first(n)},
                                    5.0, 0.002);
        };
        double end = 1.0;
        while (!test_at(end).converged && end < 200.0) end += 1.0;
        ASSERT_LT(end, 200.0);
        for (const double now : {1.0, 10.0, 0.6 * end, 0.9 * end}) {
            const double expected = expected_end(test_at(now), now, 5.0, 0.002, 1000.0);
            EXPECT_GE(expected, now);
            EXPECT_LT(expected, 2.5 * end) << "at " << now << " of " << end;
            // Before the first test can be passed, no more is known than where that is: four relaxation
            // times.
            EXPECT_GE(expected, now < 20.0 ? 20.0 : 0.5 * end) << "at " << now << " of " << end;
        }
        EXPECT_EQ(expected_end(test_at(1.0), 1.0, 5.0, 0.002, 12.0), 12.0);
    }
}

TEST(Convergence, SeesTheDriftStillToComeOfAStartFromRest) {
    // At 20 s the flow from rest lacks 1.8 % of its velocity; a fixed waiting time would not know.
    const Record from_rest = relaxing(0.0, 1e-4, 20.1);
    EXPECT_FALSE(from_rest.test().converged);
    const Record long_after = relaxing(0.0, 1e-3, 45.0);
    const Convergence c = long_after.test();
    ASSERT_TRUE(c.converged);
    EXPECT_NEAR(c.mean.mean, 1.0, 0.005);
}

TEST(Convergence, IsNotReachedWhileTheMeanIsUncertain) {
    const Record noisy = relaxing(1.0, 0.5, 20.1);
    const Convergence c = noisy.test();
    EXPECT_FALSE(c.converged);
    EXPECT_FALSE(c.reason.empty());
}

TEST(Convergence, TakesTheAskedStartOfTheWindow) {
    const Record r = relaxing(1.0, 1e-4, 30.0);
    EXPECT_DOUBLE_EQ(r.test(12.0).window_start, 12.0);
}

TEST(Convergence, IsNotReachedByAMeanOfFewIndependentSamples) {
    // Slow wandering far below the tolerance, with a memory of 10 s: a window that holds a few of them says
    // nothing of their mean.
    Record r = relaxing(1.0, 1e-7, 40.0);
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal(0.0, 1.0);
    const double memory = std::exp(-0.02 / 10.0);
    double wandering = 0.0;
    for (double& velocity : r.velocity) {
        wandering = memory * wandering + std::sqrt(1.0 - memory * memory) * normal(generator);
        velocity += 1e-4 * wandering;
    }
    const Convergence c = r.test();
    EXPECT_FALSE(c.converged);
    EXPECT_LT(c.mean.effective_samples, fewest_effective_samples);
    EXPECT_NE(c.reason.find("independent samples"), std::string::npos) << c.reason;
}

TEST(Convergence, IsNotReachedWhileTheFluctuationGrows) {
    // Layers that slide past each other and break up in the end: the mean velocity does not know it yet.
    Record layered = relaxing(1.0, 1e-4, 40.0);
    for (std::size_t i = 0; i < layered.time.size(); ++i) {
        layered.fluctuation[i] *= 1e-4 * std::exp(0.3 * layered.time[i]);
    }
    const Convergence c = layered.test();
    EXPECT_FALSE(c.converged);
    EXPECT_NE(c.reason.find("fluctuation has grown"), std::string::npos) << c.reason;
    EXPECT_GT(c.fluctuation_growth - c.fluctuation_growth_half_width, 1.0);
    // One that decays, or swings, is none.
    Record decaying = relaxing(1.0, 1e-4, 40.0);
    Record swinging = decaying;
    for (std::size_t i = 0; i < decaying.time.size(); ++i) {
        decaying.fluctuation[i] *= std::exp(-0.3 * decaying.time[i]);
        swinging.fluctuation[i] *= 2.0 + std::sin(3.0 * swinging.time[i]);
    }
    EXPECT_TRUE(decaying.test().converged) << decaying.test().reason;
    EXPECT_TRUE(swinging.test().converged) << swinging.test().reason;
}

TEST(Convergence, TakesParticlesThatMoveAsOneForSteady) {
    Record r = relaxing(1.0, 1e-4, 40.0);
    r.fluctuation.assign(r.time.size(), 0.0);
    EXPECT_TRUE(r.test().converged);
}

/// A flow between open ends that has long been steady: 1 kg/m enters and leaves in a second.
struct OpenRecord {
    Record flow = relaxing(1.0, 1e-4, 40.0);
    std::vector<double> level, discharge, entered, left;

    OpenRecord() {
        std::mt19937_64 generator(11);
        std::normal_distribution<double> normal(0.0, 1.0);
        for (const double t : flow.time) {
            level.push_back(0.05 + 1e-5 * normal(generator));
            discharge.push_back(1e-3 + 1e-5 * normal(generator));
            entered.push_back(t);
            left.push_back(t);
        }
    }
    [[nodiscard]] Convergence test() const {
        return test_convergence({.time = flow.time,
                                 .depth_mean_velocity = flow.velocity,
                                 .velocity_fluctuation = flow.fluctuation,
                                 .ends = EndsRecord{level, discharge, entered, left}},
                                5.0, 0.005);
    }
};

TEST(Convergence, BetweenOpenEndsIsReachedBySteadyWater) {
    const Convergence c = OpenRecord().test();
    EXPECT_TRUE(c.converged) << c.reason;
    EXPECT_NE(c.reason.find("the mean level 0.05 m +- "), std::string::npos) << c.reason;
    // Ducts have no level.
    OpenRecord duct;
    duct.level.clear();
    EXPECT_TRUE(duct.test().converged);
}

TEST(Convergence, BetweenOpenEndsIsNotReachedWhileTheLevelOrTheDischargeChanges) {
    OpenRecord filling;
    OpenRecord emptying;
    OpenRecord unknown;
    for (std::size_t i = 0; i < filling.level.size(); ++i) {
        // The velocity stays what it is.
        filling.level[i] *= 1.0 + 2e-3 * filling.flow.time[i];
        emptying.discharge[i] *= 1.0 + 2e-3 * emptying.flow.time[i];
        unknown.discharge[i] = 1e-3 * (1.0 + std::sin(0.3 * unknown.flow.time[i]));
    }
    for (const auto& [record, name] : {std::pair(filling, "the mean level may still drift"),
                                       std::pair(emptying, "the discharge at the outflow may still drift"),
                                       std::pair(unknown, "the discharge at the outflow")}) {
        const Convergence c = record.test();
        EXPECT_FALSE(c.converged);
        EXPECT_NE(c.reason.find(name), std::string::npos) << c.reason;
    }
    EXPECT_GT(filling.test().remaining_drift, 0.008);
}

TEST(Convergence, BetweenOpenEndsIsNotReachedWhileLessLeavesThanEnters) {
    OpenRecord record;
    for (double& mass : record.left) mass *= 0.99;
    const Convergence c = record.test();
    EXPECT_FALSE(c.converged);
    EXPECT_NE(c.reason.find("1.00 % less water leaves than enters"), std::string::npos) << c.reason;
}

TEST(Convergence, OfNothingIsNotReached) { EXPECT_FALSE(test_convergence({}, 5.0, 0.005).converged); }

}  // namespace
}  // namespace riffle::convergence_test
