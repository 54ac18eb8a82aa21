#include "analysis/even_series.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "record/flow_fields.hpp"

namespace riffle::even_series_test {
namespace {

/// Rows each 0.01 s up to 6 s, then each 0.2 s up to 14 s, of a velocity that grows with time: u = t.
SeriesTable resumed_at_another_interval() {
    std::vector<double> time;
    for (int i = 0; i <= 600; ++i) time.push_back(0.01 * i);
    for (int i = 1; i <= 40; ++i) time.push_back(6.0 + 0.2 * i);
    SeriesTable series;
    series.set(fields::time_series.depth_mean_velocity, time);
    series.set(fields::time_series.time, std::move(time));
    return series;
}

TEST(EvenSeries, RowsOfAnotherIntervalDoNotOutweighTheOthers) {
    SeriesTable series = resumed_at_another_interval();
    ASSERT_TRUE(make_even(series).has_value());
    const auto& time = series[fields::time_series.time];
    const auto& velocity = series[fields::time_series.depth_mean_velocity];
    ASSERT_EQ(time.size(), velocity.size());
    for (std::size_t i = 1; i < time.size(); ++i) EXPECT_NEAR(time[i] - time[i - 1], 0.2, 0.011) << i;
    // The mean over the time is that of the line, 7; the mean of the rows as written was 3.5.
    const double mean =
        std::accumulate(velocity.begin(), velocity.end(), 0.0) / static_cast<double>(velocity.size());
    EXPECT_NEAR(mean, 7.0, 0.05);
}

TEST(EvenSeries, LeavesEvenRowsAndSingleGapsAlone) {
    std::vector<double> time;
    for (int i = 0; i <= 1000; ++i) {
        if (i < 300 || i > 340) time.push_back(0.01 * i + 0.001 * (i % 3));
    }
    SeriesTable series;
    series.set(fields::time_series.time, time);
    EXPECT_FALSE(make_even(series).has_value());
    EXPECT_EQ(series[fields::time_series.time], time);
}

}  // namespace
}  // namespace riffle::even_series_test
