#include "analysis/gauges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "simulated_record.hpp"

namespace riffle::gauges_test {
namespace {

using ::testing::HasSubstr;

/// A record with gauges.
class Gauges : public test::SimulatedRecord {
  public:
    Gauges() : SimulatedRecord({0.0, 1.0}) {}
    void add(const std::string& label, std::vector<double> pressure, double interval = 1e-3) {
        ScalarProbe probe;
        probe.name = "gauge";
        probe.kind = "pressure";
        probe.quantity = "pressure_" + std::to_string(probes_.size() + 1);
        probe.label = label;
        probe.unit = "Pa";
        for (std::size_t i = 0; i < pressure.size(); ++i) {
            probe.time.push_back(interval * static_cast<double>(i));
        }
        probe.value = std::move(pressure);
        probes_.push_back(std::move(probe));
    }
    [[nodiscard]] const std::vector<ScalarProbe>& scalar_probes() const override { return probes_; }

    void flow_in(const Case& c) { flow_ = c; }

  private:
    std::vector<ScalarProbe> probes_;
};

TEST(Gauges, GiveTheLargestMeanOverThreeMilliseconds) {
    Gauges record;
    std::vector<double> blow(100, 1000.0);
    blow[40] = 4000.0;  // one sample of three
    record.add("in the water", blow);
    record.add("dry", std::vector<double>(100, 0.0));
    Analysis analysis;
    add_gauges(record, analysis);
    ASSERT_EQ(analysis.findings.size(), 2U);
    EXPECT_DOUBLE_EQ(analysis.findings[0].value, 2000.0);
    EXPECT_THAT(analysis.findings[0].remark,
                HasSubstr("t = 0.039 s; the largest sample is 2 times as large"));
    EXPECT_EQ(analysis.findings[1].value, 0.0);
    EXPECT_THAT(analysis.findings[1].remark, HasSubstr("no water"));
    ASSERT_EQ(analysis.figures.size(), 1U);
    EXPECT_EQ(analysis.figures[0].curves.size(), 2U);
}

// What is asked of a deck or a sill in a stream; a dam break has no mean that says anything.
TEST(Gauges, GiveTheMeanOfADrivenFlow) {
    Gauges record;
    record.add("under the deck", {-30.0, -10.0, -30.0, -10.0, -30.0, -10.0});
    Case c;
    c.channel.slope = 0.002;
    record.flow_in(c);
    Analysis analysis;
    add_gauges(record, analysis);
    ASSERT_EQ(analysis.findings.size(), 2U);
    EXPECT_EQ(analysis.findings[0].key, "gauge_pressure_1_mean");
    EXPECT_DOUBLE_EQ(analysis.findings[0].value, -20.0);
    EXPECT_THAT(analysis.findings[1].remark, HasSubstr("never above that of the air"));
    c.channel.slope = 0.0;
    c.channel.ends = Ends::walls;
    record.flow_in(c);
    Analysis closed;
    add_gauges(record, closed);
    EXPECT_EQ(closed.findings.size(), 1U);
}

TEST(Gauges, OfASlowInstrumentAreItsSamples) {
    Gauges record;
    record.add("slow", {0.0, 5.0, 1.0}, 0.1);
    Analysis analysis;
    add_gauges(record, analysis);
    EXPECT_DOUBLE_EQ(analysis.findings[0].value, 5.0);
}

TEST(Gauges, AreNotMissedWhereThereAreNone) {
    Analysis analysis;
    add_gauges(Gauges(), analysis);
    EXPECT_TRUE(analysis.figures.empty());
    EXPECT_TRUE(analysis.findings.empty());
}

}  // namespace
}  // namespace riffle::gauges_test
