// The moving surface of a report: which maps it shows, and of which points.

#include "report/surface_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sample_results.hpp"
#include "sample_space.hpp"
#include "temporary_folder.hpp"

namespace riffle::surface_frames_test {
namespace {

// 150 maps of 6 x 8 points: a slope across, of 1 mm, and a pattern of the deviation times sqrt(2).
TEST(SurfaceFrames, AreAboutTheMeanOfEachMoment) {
    const test::TemporaryFolder folder;
    testing::write_sample_space(folder / "results.h5");
    const RunResults results(folder / "results.h5");
    const auto surface = read_surface_frames(results, results.flow());
    ASSERT_TRUE(surface.has_value());
    EXPECT_EQ(surface->time.size(), 150U);
    EXPECT_FALSE(surface->earlier_left_out);
    ASSERT_EQ(surface->elevation.size(), 150U * 48U);
    for (std::size_t frame = 0; frame < 150; ++frame) {
        const auto from = surface->elevation.begin() + static_cast<std::ptrdiff_t>(48 * frame);
        EXPECT_NEAR(std::accumulate(from, from + 48, 0.0), 0.0, 1e-12);
        const double pattern = std::sqrt(2.0) * 4e-5 * std::sin(1.7 * surface->time[frame]);
        EXPECT_NEAR(*from, pattern + 1e-3 * (1.0 / 16.0 - 0.5), 1e-9);
    }
}

TEST(SurfaceFrames, AreTheLastOnesAndOfFewerPointsWhereTheyWouldBeTooMany) {
    const test::TemporaryFolder folder;
    testing::write_sample_space(folder / "results.h5");
    const RunResults results(folder / "results.h5");
    const auto last = read_surface_frames(results, results.flow(), 400'000, 20);
    ASSERT_TRUE(last.has_value());
    EXPECT_EQ(last->time.size(), 20U);
    EXPECT_DOUBLE_EQ(last->time.back(), 30.0);
    EXPECT_TRUE(last->earlier_left_out);
    // 60 maps are to move: of 1000 values, every second point along and across is left.
    const auto coarse = read_surface_frames(results, results.flow(), 1000);
    ASSERT_TRUE(coarse.has_value());
    EXPECT_EQ(coarse->x.size(), 3U);
    EXPECT_EQ(coarse->y.size(), 4U);
    EXPECT_EQ(coarse->time.size(), 83U);
    EXPECT_EQ(coarse->elevation.size(), 83U * 12U);
}

TEST(SurfaceFrames, AreNoneInTwoDimensions) {
    const test::TemporaryFolder folder;
    testing::write_sample_results(folder / "results.h5", {});
    const RunResults results(folder / "results.h5");
    EXPECT_FALSE(read_surface_frames(results, results.flow()).has_value());
}

}  // namespace
}  // namespace riffle::surface_frames_test
