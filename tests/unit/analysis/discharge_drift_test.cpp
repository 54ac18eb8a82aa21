// What is said of a discharge that goes on changing over the window.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "passing_record.hpp"

namespace riffle::discharge_drift_test {
namespace {

/// A pool before a weir, whose discharge changes by a share of it in 20 s, under noise of 1 %.
class Pool : public test::PassingRecord {
  public:
    explicit Pool(double change) : PassingRecord({0.0, 20.0}) {
        flow_->channel.ends = Ends::periodic;
        Solid weir;
        weir.name = "weir";
        weir.x = {0.3, 0.33, 0.33, 0.3};
        weir.z = {0.0, 0.0, 0.05, 0.05};
        flow_->solids = {weir};
        surface_ =
            make_space_time(std::vector{5.0, 15.0}, std::vector{0.1, 0.2}, std::vector{0.1, 0.1, 0.1, 0.1});
        add_section(
            "standard_flow_rate", 1, 0.0,
            [this, change](double time) { return 0.05 * (1.0 + change * time / 20.0 + noise_(engine_)); },
            [](double /*time*/) { return 0.1; });
    }

  private:
    std::mt19937 engine_{7};
    std::normal_distribution<double> noise_{0.0, 0.01};
};

Finding discharge_with(double change) {
    Analysis analysis;
    analyse_along(Pool(change), analysis);
    const Finding* const discharge = find_finding(analysis, "unit_discharge");
    EXPECT_NE(discharge, nullptr);
    return discharge != nullptr ? *discharge : Finding{};
}

TEST(DischargeDrift, AMeanThatDriftsHasNoInterval) {
    const Finding discharge = discharge_with(0.02);
    EXPECT_FALSE(discharge.half_width.has_value());
    EXPECT_THAT(discharge.remark, ::testing::ContainsRegex("it changes by .(1.9|2|2.1) % over the window"));
}

// Of less than run.tolerance, half a per cent.
TEST(DischargeDrift, AMeanThatIsAsSteadyAsAskedForIsKnownToItsChange) {
    const Finding steady = discharge_with(0.004);
    ASSERT_TRUE(steady.half_width.has_value());
    // The noise of 1 % leaves the change open by a third of it.
    EXPECT_NEAR(*steady.half_width, 0.004 * 0.05, 0.0014 * 0.05);
    EXPECT_GT(*steady.half_width, 2.0 * *discharge_with(0.0).half_width);
    EXPECT_EQ(steady.remark, "");
}

TEST(DischargeDrift, AMeanThatStaysHasOne) {
    const Finding discharge = discharge_with(0.0);
    EXPECT_TRUE(discharge.half_width.has_value());
    EXPECT_EQ(discharge.remark, "");
}

}  // namespace
}  // namespace riffle::discharge_drift_test
