// The examples of cases/laboratory, whose answers stand in their comments.

#include "analysis/laboratory_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/surface_parts.hpp"
#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"
#include "laboratory_file.hpp"

namespace riffle::laboratory_record_test {
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

TEST(LaboratoryRecords, AProfileHasItsOwnMeanVelocity) {
    const LaboratoryRecord record(examples / "adv-profile.csv", of_condition_2());
    // Of the law that the profile was made of, not the 0.35 m/s of the case; 1 %: noise of the points.
    const double law = rough_log_law_depth_mean(0.05, 0.044, 0.035);
    EXPECT_NEAR(bulk_velocity(record), law, 0.01 * law);
    EXPECT_GT(value_of(analyse(record, "profiles"), "msep_column"), 0.0);
}

TEST(LaboratoryRecords, SpanwiseFluctuationsAreDrawnOverTheFrictionVelocity) {
    const testing::LaboratoryFile file("z [mm],u [cm/s],v_rms [cm/s]\n10,30,5\n20,35,4\n30,38,3\n");
    const LaboratoryRecord record(file.path(), of_condition_2());
    const Analysis analysis = analyse(record, "profiles");
    const auto found = std::find_if(analysis.figures.begin(), analysis.figures.end(),
                                    [](const Figure& f) { return f.key == "turbulence_intensity_profile"; });
    ASSERT_NE(found, analysis.figures.end());
    const Curve& curve = found->curves.front();
    EXPECT_EQ(curve.name, "v'");
    ASSERT_EQ(curve.x.size(), 3U);
    EXPECT_NEAR(curve.x[1], 0.04 / friction_velocity_of(record), 1e-12);
    EXPECT_NEAR(curve.y[1], 0.02 / record.flow()->channel.depth, 1e-12);
}

TEST(LaboratoryRecords, ACrossSectionStandsBesideTheSectionTwin) {
    LaboratoryRecordOptions options;
    options.case_file = std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/rough-bed-3d/condition-2.toml";
    const LaboratoryRecord record(examples / "cross-section.csv", options);
    const Analysis analysis = analyse(record, "section");
    for (const char* key : {"station_velocity_profile", "station_stress_profile", "lateral_profile"}) {
        const auto found = std::find_if(analysis.figures.begin(), analysis.figures.end(),
                                        [key](const Figure& f) { return f.key == key; });
        ASSERT_NE(found, analysis.figures.end()) << key;
        EXPECT_EQ(found->missing, "") << key;
        const auto of = [&](Origin origin) {
            return std::count_if(found->curves.begin(), found->curves.end(),
                                 [origin](const Curve& c) { return c.origin == origin; });
        };
        EXPECT_GT(of(Origin::measured), 0) << key;
        EXPECT_GT(of(Origin::column), 0) << key;
    }
}

TEST(LaboratoryRecords, AVelocityFieldGivesTheLogLawOfItsMeans) {
    const LaboratoryRecord record(examples / "piv-means.csv", of_condition_2());
    const Analysis analysis = analyse(record);
    expect_within(analysis, "log_law_friction_velocity", 0.044);
    expect_within(analysis, "equivalent_roughness", 0.035);
    const auto map = std::find_if(analysis.figures.begin(), analysis.figures.end(),
                                  [](const Figure& f) { return f.key == "mean_velocity_map"; });
    ASSERT_NE(map, analysis.figures.end());
    ASSERT_EQ(map->maps.size(), 1U);
    EXPECT_EQ(map->maps[0].x.size(), 9U);
    EXPECT_EQ(map->maps[0].y.size(), 11U);
    EXPECT_EQ(std::count_if(map->maps[0].values.begin(), map->maps[0].values.end(),
                            [](double v) { return std::isnan(v); }),
              3);
}

/// Wave probes in any order.
class WaveProbes : public FlowRecord {
  public:
    std::vector<ElevationProbe> probes;
    [[nodiscard]] std::string name() const override { return "probes"; }
    [[nodiscard]] std::string source() const override { return "probes"; }
    [[nodiscard]] Origin origin() const override { return Origin::measured; }
    [[nodiscard]] const Case* flow() const override { return nullptr; }
    [[nodiscard]] TimeWindow window() const override { return {0.0, 20.0}; }
    [[nodiscard]] const std::vector<ElevationProbe>& elevation_probes() const override { return probes; }
};

TEST(LaboratoryRecords, TheOrderOfProbesDoesNotMatter) {
    const auto probe = [](const char* name, double x) {
        ElevationProbe result{name, x, {}, {}};
        for (int i = 0; i < 2000; ++i) {
            result.time.push_back(0.01 * i);
            result.elevation.push_back(std::sin(12.0 * (0.01 * i - x / 0.4)) +
                                       0.5 * std::sin(31.0 * (0.01 * i - x / 0.4)));
        }
        return result;
    };
    WaveProbes sorted;
    WaveProbes mixed;
    sorted.probes = {probe("a", 0.0), probe("b", 0.03), probe("c", 0.1)};
    mixed.probes = {sorted.probes[2], sorted.probes[0], sorted.probes[1]};
    const Analysis first = analyse(sorted, "surface");
    const Analysis second = analyse(mixed, "surface");
    ASSERT_FALSE(first.findings.empty());
    ASSERT_EQ(first.findings.size(), second.findings.size());
    for (std::size_t i = 0; i < first.findings.size(); ++i) {
        EXPECT_EQ(first.findings[i].key, second.findings[i].key);
        EXPECT_EQ(first.findings[i].value, second.findings[i].value) << first.findings[i].key;
    }
    // A second probe at a place, and one of an unknown place.
    mixed.probes.push_back(probe("d", 0.03));
    mixed.probes.push_back(probe("e", 0.2));
    mixed.probes.back().x = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::string> warnings;
    const std::vector<SurfaceStation> stations = stations_of_probes(mixed, warnings);
    ASSERT_EQ(stations.size(), 4U);
    EXPECT_EQ(stations.back().name, "e");
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings.front().find("place of b"), std::string::npos);
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
}  // namespace riffle::laboratory_record_test
