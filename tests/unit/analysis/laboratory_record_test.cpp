// The examples of cases/laboratory, whose answers stand in their comments.

#include "analysis/laboratory_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "base/error.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path examples = std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/laboratory";

LaboratoryRecordOptions of_condition_2() {
    LaboratoryRecordOptions options;
    options.case_file = std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/rough-bed-2d/condition-2.toml";
    return options;
}

double value_of(const Analysis& analysis, const std::string& key) {
    const Finding* const found = find_finding(analysis, key);
    EXPECT_NE(found, nullptr) << key;
    return found == nullptr ? 0.0 : found->value;
}

void expect_within(const Analysis& analysis, const std::string& key, double truth) {
    const Finding* const found = find_finding(analysis, key);
    ASSERT_NE(found, nullptr) << key;
    ASSERT_TRUE(found->half_width) << key;
    EXPECT_NEAR(found->value, truth, 1.5 * *found->half_width) << key;
}

TEST(LaboratoryRecords, WaveProbesGiveTheDeviationAndTheCelerity) {
    const LaboratoryRecord record(examples / "wave-probes.csv", of_condition_2());
    const Analysis analysis = analyse(record);
    // The standard deviation of this sample at the first probe, known to the noise of the probe, 0.01 mm.
    EXPECT_NEAR(value_of(analysis, "surface_standard_deviation"), 0.3724e-3, 0.01e-3);
    // The lag of 0.078 s is found to about a tenth of a sample of 0.01 s: 2 %.
    EXPECT_NEAR(value_of(analysis, "celerity_between_places_1"), 0.36, 0.02 * 0.36);
    expect_within(analysis, "celerity_stations", 0.36);
    EXPECT_EQ(analysis.name, "synthetic wave probes, like condition 2");
    EXPECT_FALSE(analysis.warnings.empty()) << "gaps, spikes and lost rows are told";
}

TEST(LaboratoryRecords, AProfileGivesTheLogLaw) {
    const LaboratoryRecord record(examples / "adv-profile.csv", of_condition_2());
    const Analysis analysis = analyse(record);
    expect_within(analysis, "log_law_friction_velocity", 0.044);
    expect_within(analysis, "equivalent_roughness", 0.035);
}

TEST(LaboratoryRecords, VelocitiesAtAPointGiveTheirMoments) {
    const LaboratoryRecord record(examples / "adv-point.csv", of_condition_2());
    const Analysis analysis = analyse(record);
    expect_within(analysis, "point_velocity", 0.28);
    expect_within(analysis, "point_velocity_deviation", 0.08);
    expect_within(analysis, "point_vertical_velocity_deviation", 0.045);
    expect_within(analysis, "point_covariance", -0.00144);
}

TEST(LaboratoryRecords, NeedNoCase) {
    for (const char* name : {"wave-probes.csv", "adv-profile.csv", "adv-point.csv"}) {
        const LaboratoryRecord record(examples / name);
        EXPECT_NO_THROW(static_cast<void>(analyse(record))) << name;
    }
}

TEST(LaboratoryRecords, RefuseAWindowOutsideOfTheRecord) {
    LaboratoryRecordOptions options;
    options.window = TimeWindow{100.0, 200.0};
    try {
        const LaboratoryRecord record(examples / "wave-probes.csv", options);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("wave-probes.csv"));
    }
}

}  // namespace
}  // namespace riffle
