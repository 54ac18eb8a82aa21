#include "analysis/drowned_inflow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/figure_tools.hpp"
#include "passing_record.hpp"

namespace riffle::drowned_inflow_test {
namespace {

/// Water that is to enter at Fr 2.4, 40 mm deep over the datum, and so deep a section at the inflow.
class Inflow : public test::PassingRecord {
  public:
    explicit Inflow(double depth, double entering = 0.04) : PassingRecord({0.0, 5.0}) {
        flow_->inflow.unit_discharge = 0.06;
        flow_->inflow.depth = entering;
        flow_->bed.roughness_height = 0.0;
        flow_->bed.datum_below_crest = 0.0;
        add_section(
            "standard_end_sections", 1, 0.0, [](double /*time*/) { return 0.06; },
            [=](double /*time*/) { return depth; });
    }
};

TEST(DrownedInflow, AJumpAtTheInflowIsTold) {
    Analysis analysis;
    EXPECT_TRUE(add_drowned_inflow(Inflow(0.118), analysis));
    const Finding* const depth = find_finding(analysis, "drowned_inflow_depth");
    ASSERT_NE(depth, nullptr);
    EXPECT_NEAR(depth->value, 0.118, 1e-12);
    EXPECT_THAT(depth->remark, ::testing::HasSubstr("where 40 mm enter faster than their waves"));
}

// Not a jet as deep as it is to be, nor slow water, whose depth comes from downstream.
TEST(DrownedInflow, OtherInflowsAreNot) {
    Analysis analysis;
    EXPECT_FALSE(add_drowned_inflow(Inflow(0.042), analysis));
    EXPECT_FALSE(add_drowned_inflow(Inflow(0.2, 0.1), analysis));
    EXPECT_TRUE(analysis.findings.empty());
}

}  // namespace
}  // namespace riffle::drowned_inflow_test
