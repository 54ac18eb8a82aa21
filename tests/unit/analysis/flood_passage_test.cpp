#include "analysis/flood_passage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "passing_record.hpp"

namespace riffle::flood_passage_test {
namespace {

using ::testing::HasSubstr;

/// A crest that goes down a channel with 1 m/s and loses 0.005 m2/s a metre, under ripples of a wave.
class Flood : public test::PassingRecord {
  public:
    explicit Flood(const std::vector<double>& places) : PassingRecord({0.0, 20.0}) {
        flow_->channel.slope = 0.002;
        flow_->inflow.discharge_file = "hydrograph.csv";
        for (std::size_t n = 0; n < places.size(); ++n) {
            const double place = places[n];
            const auto crest = [place](double time) {
                return std::exp(-std::pow((time - 8.0 - place) / 2.0, 2));
            };
            add_section(
                n == 0 ? "standard_end_sections" : "gauges", n == 0 ? 1 : n, place,
                [=](double time) {
                    return 0.03 + (0.04 - 0.005 * place) * crest(time) + 0.004 * std::sin(time * 40.0);
                },
                [=](double time) { return 0.06 + 0.02 * crest(time); });
        }
    }
};

TEST(FloodPassage, TellsHowLateAndHowMuchLowerTheCrestIs) {
    Flood record({0.0, 4.0, 2.0});
    record.surface_ =
        make_space_time(std::vector{0.5, 1.5}, std::vector{1.0, 2.0}, std::vector{0.05, 0.08, 0.06, 0.07});
    Analysis analysis;
    add_flood_passage(record, analysis);
    const Finding* const inflow = find_finding(analysis, "flood_discharge_1");
    const Finding* const last = find_finding(analysis, "flood_discharge_3");  // in their order downstream
    ASSERT_NE(inflow, nullptr);
    ASSERT_NE(last, nullptr);
    // The running mean over half a second takes a ripple of 0.16 s away, and 2 % of so short a crest.
    EXPECT_NEAR(inflow->value, 0.07, 0.001);
    EXPECT_NEAR(last->value, 0.05, 0.001);
    EXPECT_THAT(last->label, HasSubstr("at x = 4000 mm"));
    EXPECT_THAT(last->remark, ::testing::ContainsRegex("(3.9|4.0)[0-9] s after that at the inflow"));
    EXPECT_THAT(last->remark, HasSubstr("% of the rise there less"));
    const Finding* const depth = find_finding(analysis, "flood_depth_2");
    ASSERT_NE(depth, nullptr);
    EXPECT_NEAR(depth->value, 0.08, 0.001);
    EXPECT_THAT(depth->label, HasSubstr("x = 2000 mm"));
    const Finding* const highest = find_finding(analysis, "flood_highest_level");
    ASSERT_NE(highest, nullptr);
    EXPECT_DOUBLE_EQ(highest->value, 0.08);
    EXPECT_THAT(highest->remark, HasSubstr("x = 1500 mm, t = 1 s"));
    ASSERT_EQ(analysis.figures.size(), 3U);
    for (const Figure& figure : analysis.figures) EXPECT_EQ(figure.curves.size(), 3U) << figure.key;
}

TEST(FloodPassage, SaysNothingOfSteadyFlow) {
    Flood record({0.0, 2.0});
    record.flow_->inflow.discharge_file.clear();
    record.flow_->inflow.unit_discharge = 0.03;
    Analysis analysis;
    add_flood_passage(record, analysis);
    EXPECT_TRUE(analysis.findings.empty());
    EXPECT_TRUE(analysis.figures.empty());
}

// The standard sections stand where the user's own may stand.
TEST(FloodPassage, NamesEachPlaceOnce) {
    Flood record({0.0, 2.0, 2.0, 4.0});
    Analysis analysis;
    add_flood_passage(record, analysis);
    EXPECT_NE(find_finding(analysis, "flood_discharge_3"), nullptr);
    EXPECT_EQ(find_finding(analysis, "flood_discharge_4"), nullptr);
}

// Sections that the user named and no section at the inflow: crests without a lag.
TEST(FloodPassage, TellsNoLagWithoutTheInflow) {
    Flood record({1.0, 3.0});
    for (ScalarProbe& probe : record.probes_) probe.name = "gauges_" + std::to_string(*probe.x);
    Analysis analysis;
    add_flood_passage(record, analysis);
    const Finding* const crest = find_finding(analysis, "flood_discharge_2");
    ASSERT_NE(crest, nullptr);
    EXPECT_THAT(crest->remark, ::testing::Not(HasSubstr("inflow")));
    EXPECT_EQ(find_finding(analysis, "flood_highest_level"), nullptr);
}

}  // namespace
}  // namespace riffle::flood_passage_test
