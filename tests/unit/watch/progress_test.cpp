#include "watch/progress.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace riffle::progress_test {
namespace {

Progress progress(double time, std::int64_t steps, double wall_seconds) {
    Progress p;
    p.time = time;
    p.end_time = 100;
    p.steps = steps;
    p.wall_seconds = wall_seconds;
    p.particles = 1000;
    // Two force evaluations per step.
    p.updates_per_second = 2.0 * 1000.0 * static_cast<double>(steps) / wall_seconds;
    return p;
}

TEST(Speed, IsThatSinceTheStartUntilThereAreTwoWrites) {
    const auto speed = speed_of(progress(10, 20'000, 40), {});
    ASSERT_TRUE(speed);
    EXPECT_DOUBLE_EQ(speed->steps_per_second, 500);
    EXPECT_DOUBLE_EQ(speed->time_per_second, 0.25);
    EXPECT_DOUBLE_EQ(speed->updates_per_second, 1e6);
    EXPECT_FALSE(speed_of(Progress{}, {}));
}

TEST(Speed, IsThatBetweenTheLastTwoWrites) {
    // The first 40 s at 500 steps/s, the next 10 s at 2000.
    const auto speed = speed_of(progress(20, 40'000, 50), progress(10, 20'000, 40));
    ASSERT_TRUE(speed);
    EXPECT_DOUBLE_EQ(speed->steps_per_second, 2000);
    EXPECT_DOUBLE_EQ(speed->time_per_second, 1);
    EXPECT_DOUBLE_EQ(speed->updates_per_second, 4e6);
}

TEST(Speed, AnotherRunInTheSameFolderIsNoEarlierWrite) {
    const auto restarted = speed_of(progress(1, 2'000, 4), progress(10, 20'000, 40));
    ASSERT_TRUE(restarted);
    EXPECT_DOUBLE_EQ(restarted->steps_per_second, 500);
    Progress finer = progress(20, 40'000, 50);
    finer.particles = 4000;
    EXPECT_DOUBLE_EQ(speed_of(finer, progress(10, 20'000, 40))->steps_per_second, 800);
}

TEST(ProgressJson, CountsTheTimeLeftAtThePresentSpeed) {
    Progress p = progress(10, 20'000, 40);
    p.until_converged = true;
    p.earliest_end = 18;
    auto json = nlohmann::json::parse(progress_json(p, {}));
    EXPECT_DOUBLE_EQ(json["seconds_left"], 360);
    EXPECT_DOUBLE_EQ(json["seconds_left_at_least"], 32);
    p.time = 100.001;
    json = nlohmann::json::parse(progress_json(p, {}));
    EXPECT_DOUBLE_EQ(json["seconds_left"], 0);
    json = nlohmann::json::parse(progress_json(Progress{}, {}));
    EXPECT_TRUE(json["seconds_left"].is_null());
    EXPECT_TRUE(json["half_width"].is_null());
}

}  // namespace
}  // namespace riffle::progress_test
