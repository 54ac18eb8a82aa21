#include "analysis/tailwater_passage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "passing_record.hpp"

namespace riffle::tailwater_passage_test {
namespace {

using ::testing::HasSubstr;

/// A tide of 20 mm every 10 s that goes up a channel of 4 m with 1 m/s and loses an eighth of its range a
/// metre; `reach`: whether it goes further up than 3 m. The gauge has half as many samples as the ends.
class Tide : public test::PassingRecord {
  public:
    explicit Tide(bool reach = true, double speed = 1.0) : PassingRecord({0.0, 40.0}) {
        flow_->channel.length = 4.0;
        flow_->outflow.kind = OutflowKind::depth;
        flow_->outflow.depth_file = "tide.csv";
        const std::vector<double> places = {0.0, 4.0, 2.0};
        for (std::size_t n = 0; n < places.size(); ++n) {
            const double away = 4.0 - places[n];
            const double share = n == 0 && !reach ? 0.0 : 1.0 - away / 8.0;
            const auto phase = [away, speed](double time) {
                return 2.0 * std::numbers::pi * (time - away / speed) / 10.0;
            };
            add_section(
                n < 2 ? "standard_end_sections" : "gauge", n < 2 ? n + 1 : 1, places[n],
                [=](double time) { return 0.01 - 0.015 * share * std::cos(phase(time)); },
                [=](double time) { return 0.1 + 0.01 * share * std::sin(phase(time)); }, n < 2 ? 0.02 : 0.04);
        }
    }
};

TEST(TailwaterPassage, TellsHowLateAndHowMuchOfTheTideArrives) {
    Analysis analysis;
    add_tailwater_passage(Tide(), analysis);
    const auto value = [&](const char* key) {
        const Finding* const found = find_finding(analysis, key);
        return found != nullptr ? found->value : std::nan("");
    };
    const auto remark = [&](const char* key) { return find_finding(analysis, key)->remark; };
    // The running mean over half a second takes less than 1 % of a tide of ten.
    EXPECT_NEAR(value("tailwater_high_3"), 0.11, 1e-4);
    EXPECT_NEAR(value("tailwater_low_3"), 0.09, 1e-4);
    EXPECT_NEAR(value("tailwater_range_3"), 0.02, 2e-4);
    EXPECT_NEAR(value("tailwater_range_2"), 0.015, 2e-4);
    EXPECT_NEAR(value("tailwater_range_1"), 0.01, 2e-4);
    EXPECT_EQ(remark("tailwater_range_3"), "");
    EXPECT_THAT(remark("tailwater_range_2"), HasSubstr("75 % of that at the outflow"));
    EXPECT_THAT(remark("tailwater_range_2"), ::testing::ContainsRegex("follows by (1.9|2.0)[0-9] s"));
    EXPECT_THAT(remark("tailwater_range_1"), ::testing::ContainsRegex("follows by (3.9|4.0)[0-9] s"));
    EXPECT_NEAR(value("tailwater_largest_discharge_3"), 0.025, 1e-3);
    EXPECT_NEAR(value("tailwater_smallest_discharge_3"), -0.005, 1e-3);
    // cos > 2/3 for 0.268 of the time, at first.
    EXPECT_THAT(remark("tailwater_smallest_discharge_3"),
                ::testing::ContainsRegex("up the channel for 26.[5-9] % of"));
    EXPECT_THAT(remark("tailwater_smallest_discharge_3"), HasSubstr("first at t = 0 s"));
    EXPECT_NEAR(value("tailwater_smallest_discharge_1"), 0.0025, 1e-3);
    EXPECT_THAT(remark("tailwater_smallest_discharge_1"), ::testing::Not(HasSubstr("up the channel")));
    ASSERT_EQ(analysis.figures.size(), 3U);
    for (const Figure& figure : analysis.figures) EXPECT_EQ(figure.curves.size(), 3U) << figure.key;
}

TEST(TailwaterPassage, SaysWhereTheTideDoesNotArrive) {
    Analysis analysis;
    add_tailwater_passage(Tide(false), analysis);
    EXPECT_THAT(find_finding(analysis, "tailwater_range_1")->remark, HasSubstr("which it does not follow"));
}

// What stands at the outflow a little earlier than beside it goes with it; it does not follow a period later.
TEST(TailwaterPassage, WaterThatMovesAsOneGoesWithTheTide) {
    Analysis analysis;
    add_tailwater_passage(Tide(true, -200.0), analysis);
    EXPECT_THAT(find_finding(analysis, "tailwater_range_1")->remark, HasSubstr("with which it goes"));
    EXPECT_THAT(find_finding(analysis, "tailwater_range_2")->remark, HasSubstr("with which it goes"));
}

TEST(TailwaterPassage, SaysNothingOfADepthThatIsHeld) {
    Tide record;
    record.flow_->outflow.depth_file.clear();
    record.flow_->outflow.depth = 0.1;
    Analysis analysis;
    add_tailwater_passage(record, analysis);
    EXPECT_TRUE(analysis.findings.empty());
    EXPECT_TRUE(analysis.figures.empty());
}

// A flood that comes with the tide has the figures; the findings of both stand.
TEST(TailwaterPassage, LeavesTheFiguresToAFlood) {
    Tide record;
    record.flow_->inflow.discharge_file = "hydrograph.csv";
    Analysis analysis;
    add_tailwater_passage(record, analysis);
    EXPECT_NE(find_finding(analysis, "tailwater_range_1"), nullptr);
    EXPECT_TRUE(analysis.figures.empty());
}

}  // namespace
}  // namespace riffle::tailwater_passage_test
