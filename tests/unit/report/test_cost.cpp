// What runs cost beside the thesis', and what a report of a run in three dimensions holds.

#include "report/cost.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "sample_results.hpp"
#include "sample_space.hpp"

namespace riffle::cost_test {
namespace {

class Costs : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
        testing::write_sample_results(folder_ / "plane.h5");
        testing::write_sample_space(folder_ / "space.h5");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
};

TEST_F(Costs, StandBesideTheThesisInTheSameDimensions) {
    const std::vector<CostRow> rows =
        cost_rows(collect_runs({{folder_ / "plane.h5", {}}, {folder_ / "space.h5", {}}}));
    const auto row = [&](const std::string& key) {
        for (const CostRow& each : rows) {
            if (each.key == key) return each.values;
        }
        return std::vector<std::string>{};
    };
    EXPECT_THAT(row("dimensions"), ::testing::ElementsAre("2", "3"));
    // 87.5 s for 30 s.
    EXPECT_THAT(row("seconds_per_second"), ::testing::ElementsAre("2.9 s", "2.9 s"));
    EXPECT_THAT(row("thesis"), ::testing::ElementsAre(::testing::StartsWith("6 days for 130 s"),
                                                      ::testing::StartsWith("70 days for 6 s")));
    EXPECT_TRUE(cost_rows(collect_runs({{folder_ / "plane.h5", {}}})).empty());
}

TEST_F(Costs, ReportOfThreeDimensionsShowsASliceAlongTheCentreline) {
    const ReportData data = collect_report_data(folder_ / "space.h5");
    ASSERT_TRUE(data.field.has_value());
    ASSERT_TRUE(data.field->y.has_value());
    // In the middle of the file of particles beside it: between two files a slice has none or both.
    EXPECT_NEAR(*data.field->y, data.flow.channel.centreline(), 0.51 * data.flow.numerics.spacing);
    ASSERT_FALSE(data.field->frames.empty());
    EXPECT_FALSE(data.field->frames.back().x.empty());
    // Between side walls the mean over the width has no measured value beside it.
    const auto quantities = summarize(data);
    const SummaryRow* const mean = find_quantity(quantities, "depth_mean_velocity");
    ASSERT_NE(mean, nullptr);
    EXPECT_FALSE(mean->measured.has_value());
    ASSERT_TRUE(mean->column.has_value());
    EXPECT_EQ(mean->column->value, 0.35);
}

}  // namespace
}  // namespace riffle::cost_test
