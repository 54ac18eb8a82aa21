// Analyses of made-up runs in three dimensions whose answers are known.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "analysis/chapters.hpp"
#include "analysis/figure_keys.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/run_record.hpp"
#include "analysis/secondary_flow.hpp"
#include "analysis_parts.hpp"
#include "roughness/side_wall_partition.hpp"
#include "sample_results.hpp"
#include "sample_space.hpp"

namespace riffle::space_analysis_test {
namespace {

using testing::figure;
using testing::finding;
using ::testing::HasSubstr;
using testing::SampleSpace;
using testing::write_sample_space;

class SpaceAnalyses : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const SampleSpace& sample) {
        write_sample_space(folder_ / "results.h5", sample);
        return folder_ / "results.h5";
    }
    Analysis analysed(const SampleSpace& sample, const std::string& chapter = {}) {
        return analyse(RunRecord(write(sample)), chapter);
    }

    std::filesystem::path folder_;
};

TEST_F(SpaceAnalyses, HaveAllFiguresWithoutAMissingOneAndFiniteFindings) {
    const Analysis analysis = analysed({});
    std::set<std::string> keys;
    for (const Finding& each : analysis.findings) {
        EXPECT_TRUE(keys.insert(each.key).second) << "twice: " << each.key;
        EXPECT_TRUE(std::isfinite(each.value)) << each.key;
    }
    keys.clear();
    for (const Figure& each : analysis.figures) {
        EXPECT_TRUE(keys.insert(each.key).second) << "twice: " << each.key;
        EXPECT_TRUE(is_figure_key(each.key, each.chapter)) << each.key << " in " << each.chapter;
        EXPECT_FALSE(each.missing.empty() && each.curves.empty() && each.maps.empty()) << each.key;
        for (const ColourMap& map : each.maps) {
            EXPECT_EQ(map.values.size(), map.x.size() * map.y.size()) << each.key;
        }
    }
    for (const char* key : {"section_velocity_map",
                            "section_twin_map",
                            "section_secondary_map",
                            "section_stress_map",
                            "section_resolved_stress_map",
                            "centreline_velocity_profile",
                            "centreline_msep_profile",
                            "centreline_stress_profile",
                            "station_velocity_profile",
                            "lateral_velocity",
                            "secondary_strength_averaging",
                            "secondary_streamfunction",
                            "swirling_strength_map",
                            "q_criterion_map",
                            "bed_stress_distribution",
                            "bed_drag_distribution",
                            "wall_stress_distribution",
                            "drag_plan_map",
                            "drag_section_map",
                            "drag_side_map",
                            "surface_mean_map",
                            "surface_deviation_map",
                            "double_averaged_velocity_profile",
                            "double_averaged_stress_profile",
                            "form_induced_moment_profile"}) {
        EXPECT_TRUE(figure(analysis, key).missing.empty()) << key << ": " << figure(analysis, key).missing;
    }
}

TEST_F(SpaceAnalyses, AverageTheWindowsOfTheAveragingWindowOnly) {
    const RunRecord record(write({}));
    const MeanFlow& field = record.mean_field();
    ASSERT_EQ(field.time.size(), 15U);
    EXPECT_EQ(field.time.front(), 16.0);
    const Case& c = *record.flow();
    const FieldSums section = field.section();
    for (const std::size_t iy : {std::size_t{3}, std::size_t{13}}) {
        // The form-induced part has no mean along the bed.
        EXPECT_NEAR(section.mean(FieldQuantity::velocity, field.at(7, iy)),
                    testing::sample_space_velocity(field.y[iy], field.z[7], c.channel.width, c.total_depth()),
                    1e-9);
    }
    RunRecordOptions options;
    options.window = TimeWindow{24.0, 26.0};
    EXPECT_EQ(RunRecord(folder_ / "results.h5", options).mean_field().time.size(), 2U);
    options.window = TimeWindow{24.2, 24.9};
    const RunRecord brief(folder_ / "results.h5", options);
    EXPECT_TRUE(brief.mean_field().empty());
    ASSERT_FALSE(brief.warnings().empty());
    EXPECT_THAT(brief.warnings().back(), HasSubstr("none of the 19 windows"));
}

TEST_F(SpaceAnalyses, FindAKnownCellWithItsStrengthNumberAndWidth) {
    SampleSpace sample;
    sample.noise = 2e-3;
    sample.streamfunction = 1e-4;
    const std::filesystem::path path = write(sample);
    const RunRecord record(path);
    const Analysis analysis = analyse(record, "secondary");
    const Case& c = *record.flow();
    const double depth = c.total_depth();
    const double width = c.channel.width;
    // Mean square of (V, W) above the datum by the formula at the cells, without the noise.
    const MeanFlow& field = record.mean_field();
    double square = 0.0;
    double count = 0.0;
    for (const double z : field.z) {
        for (const double y : field.y) {
            if (z < c.datum()) continue;
            const double n = 3.0 * std::numbers::pi;
            const double v = 1e-4 * std::numbers::pi / depth * std::sin(n * y / width) *
                             std::cos(std::numbers::pi * z / depth);
            const double w =
                -1e-4 * n / width * std::cos(n * y / width) * std::sin(std::numbers::pi * z / depth);
            square += v * v + w * w;
            count += 1.0;
        }
    }
    const double expected = std::sqrt(square / count) / bulk_velocity(record);
    const Finding& lasting = finding(analysis, "secondary_lasting_rms");
    ASSERT_TRUE(lasting.half_width.has_value());
    // Within twice the 95 % interval, which itself is small beside the value.
    EXPECT_NEAR(lasting.value, expected, 2.0 * *lasting.half_width);
    EXPECT_LT(*lasting.half_width, 0.1 * expected);
    EXPECT_THAT(lasting.remark, HasSubstr("survives"));
    EXPECT_EQ(finding(analysis, "secondary_cells").value, 3.0);
    EXPECT_NEAR(finding(analysis, "secondary_cell_width").value, width / 3.0 / depth, 0.02);
    EXPECT_GE(finding(analysis, "vortices").value, 3.0);
}

TEST_F(SpaceAnalyses, TellNoiseFromACell) {
    SampleSpace sample;
    sample.noise = 5e-3;
    sample.streamfunction = 0.0;
    const RunRecord record(write(sample));
    const Analysis analysis = analyse(record, "secondary");
    EXPECT_THAT(finding(analysis, "secondary_lasting_rms").remark, HasSubstr("no motion"));
    // Means over ten cells along the bed and 15 windows, both components together.
    const double left = 5e-3 * std::sqrt(2.0 / (10.0 * 15.0));
    EXPECT_NEAR(finding(analysis, "secondary_fluctuation_left").value * bulk_velocity(record), left,
                0.1 * left);
    // 15 windows of 1 s: the rms falls by sqrt(15); over 0.2 s alone it would be sqrt(5) times that of 1 s.
    const Curve& rms = figure(analysis, "secondary_strength_averaging").curves.front();
    EXPECT_NEAR(rms.y.front() / rms.y.back(), std::sqrt(15.0), 0.4);
    EXPECT_NEAR(finding(analysis, "secondary_strength_brief").value / rms.y.front(), std::sqrt(5.0), 0.2);
}

TEST_F(SpaceAnalyses, FindTheStressAndItsDistribution) {
    SampleSpace sample;
    sample.form_u = sample.form_w = 0.0;
    const RunRecord record(write(sample));
    const Analysis analysis = analyse(record, "bed");
    const Case& c = *record.flow();
    const Curve& cells = figure(analysis, "bed_stress_distribution").curves.front();
    const MeanFlow& field = record.mean_field();
    const double z = field.z[4];  // 4.5/14 H, next to 12 mm above the datum
    ASSERT_NEAR(z, c.datum() + 0.012, 0.5 * field.cell_height());
    const double uniform = c.fluid.density * c.streamwise_gravity() * (c.total_depth() - z);
    for (const std::size_t iy : {std::size_t{0}, std::size_t{6}, std::size_t{13}}) {
        const double cosine = std::cos(std::numbers::pi * field.y[iy] / c.channel.width);
        EXPECT_NEAR(cells.y[iy], 1.0 - 0.3 * cosine * cosine + 0.1 / uniform, 1e-9);
    }
    const double weight = c.fluid.density * c.streamwise_gravity() * c.total_depth();
    EXPECT_NEAR(finding(analysis, "bed_drag_mean").value, 0.8 * weight, 1e-9 * weight);
    EXPECT_NEAR(*finding(analysis, "bed_drag_mean").reference,
                c.fluid.density * side_wall_partition(c).bed_stress, 1e-9);
    // Both walls together carry a fifth of the weight: W/(2 H) of it on each wall area.
    EXPECT_NEAR(finding(analysis, "wall_stress_mean").value,
                0.2 * weight * c.channel.width / (2.0 * c.total_depth()), 1e-9 * weight);
}

TEST_F(SpaceAnalyses, FindTheFormInducedStressBesideTheNoiseOfTheWindows) {
    SampleSpace sample;
    sample.sides = "periodic";
    sample.streamfunction = 0.0;
    sample.noise = 5e-3;
    const RunRecord record(write(sample));
    const Analysis analysis = analyse(record, "profiles");
    const Figure& stresses = figure(analysis, "double_averaged_stress_profile");
    const Curve& form = stresses.curves.back();
    ASSERT_EQ(form.name, "form-induced stress");
    ASSERT_FALSE(form.x_half_width.empty());
    // -rho <u~ w~> = 1000 x 0.02 x 0.004/2 = 0.04 Pa, with the scatter that its interval states.
    int outside = 0;
    for (std::size_t i = 0; i < form.x.size(); ++i) {
        outside += std::abs(form.x[i] - 0.04) > form.x_half_width[i] ? 1 : 0;
    }
    EXPECT_LE(outside, 3);  // of 14 at 95 %: four and more happen once in 200 times
    // The fluctuation of 5 mm/s that 15 windows leave, (5 mm/s)^2/15, is not in the variance of v~.
    const Curve& v = figure(analysis, "form_induced_moment_profile").curves[1];
    double mean = 0.0;
    for (const double value : v.x) mean += value / static_cast<double>(v.x.size());
    EXPECT_LT(std::abs(mean), 0.1 * 25e-6 / 15.0);
    const Curve& reynolds = stresses.curves[1];
    for (const double stress : reynolds.x) EXPECT_NEAR(stress, 0.1, 0.05);
}

TEST_F(SpaceAnalyses, BalanceTheForcesWithTheSideWalls) {
    const Analysis analysis = analysed({}, "forces");
    EXPECT_NEAR(finding(analysis, "momentum_balance").value, 1.0, 1e-9);
    EXPECT_NEAR(finding(analysis, "side_wall_share").value, 0.2, 0.002);
    EXPECT_EQ(*finding(analysis, "side_wall_share").reference, 0.21);
    EXPECT_EQ(finding(analysis, "side_wall_share").reference_name, "section twin");
    EXPECT_THAT(finding(analysis, "side_wall_share").remark, HasSubstr("Yang & Lim"));
}

TEST_F(SpaceAnalyses, CompareTheCentrelineWithWhatWasMeasuredThere) {
    const RunRecord record(write({}));
    const Analysis analysis = analyse(record);
    const Case& c = *record.flow();
    EXPECT_EQ(*finding(analysis, "centreline_depth_mean_velocity").reference, 0.35);
    EXPECT_EQ(finding(analysis, "depth_mean_velocity").reference_name, "section twin");
    EXPECT_NE(find_finding(analysis, "centreline_msep_upper"), nullptr);
    EXPECT_EQ(find_finding(analysis, "msep_velocity_upper"), nullptr);
    // The twin is 1 % faster everywhere.
    EXPECT_NEAR(finding(analysis, "lateral_velocity_error_rms").value, 0.01 / 1.01, 2e-3);
    const Curve& profile = figure(analysis, "centreline_velocity_profile").curves.front();
    const double expected = testing::sample_space_velocity(c.channel.centreline(), profile.y[9],
                                                           c.channel.width, c.total_depth());
    EXPECT_NEAR(profile.x[9], expected, 0.03 * expected);  // the strip is a third of the width
}

TEST_F(SpaceAnalyses, MapTheSurfaceInPlan) {
    const Analysis analysis = analysed({}, "surface");
    EXPECT_NEAR(finding(analysis, "plan_mean_water_depth").value, 0.05, 1e-6);
    // A slope of 1 mm over the width, at eight places: sqrt((1 - 1/64)/12) of it.
    EXPECT_NEAR(finding(analysis, "plan_mean_level_deviation").value, 1e-3 * std::sqrt((1.0 - 1.0 / 64) / 12),
                2e-6);
    EXPECT_NEAR(finding(analysis, "plan_standard_deviation").value, 4e-5, 2e-6);
}

TEST_F(SpaceAnalyses, SayWhyAFileWithoutAMeanFieldHasNoCrossSection) {
    testing::SampleOptions options;
    options.case_text = testing::sample_space_case("walls");
    testing::write_sample_results(folder_ / "results.h5", options);
    const Analysis analysis = analyse(RunRecord(folder_ / "results.h5"));
    for (const char* key :
         {"section_velocity_map", "secondary_strength_averaging", "bed_stress_distribution"}) {
        EXPECT_THAT(figure(analysis, key).missing, HasSubstr("mean field"));
    }
    EXPECT_THAT(figure(analysis, "surface_mean_map").missing, HasSubstr("surface_map_interval"));
}

TEST_F(SpaceAnalyses, LeaveRunsInTwoDimensionsAsTheyAre) {
    testing::write_sample_results(folder_ / "results.h5");
    const Analysis analysis = analyse(RunRecord(folder_ / "results.h5"));
    for (const Figure& each : analysis.figures) {
        EXPECT_TRUE(each.chapter != "section" && each.chapter != "secondary" && each.chapter != "bed")
            << each.key;
    }
}

TEST(FieldSumsOf, TwoWindowsAreOneOfTheirParticles) {
    // Two windows of one cell: means 1 and 3 with variances 0.5 and 0.1, three times as many particles in the
    // second; the variance of all is that within and that between.
    FieldSums sums(1);
    FieldValues first{};
    FieldValues second{};
    first[0] = 1.0;
    first[1] = 1.0;
    first[4] = 0.5;
    first[14] = -2.0;
    second[0] = 3.0;
    second[1] = 3.0;
    second[4] = 0.1;
    second[14] = -6.0;
    sums.add_window(0, first, 10.0);
    sums.add_window(0, second, 10.0);
    EXPECT_DOUBLE_EQ(sums.mean(FieldQuantity::count, 0), 2.0);
    EXPECT_DOUBLE_EQ(sums.mean(FieldQuantity::velocity, 0), 2.5);
    EXPECT_DOUBLE_EQ(sums.mean(FieldQuantity::velocity_variance, 0),
                     (0.5 + 3 * 0.1) / 4 + (1.0 + 3 * 9.0) / 4 - 2.5 * 2.5);
    EXPECT_DOUBLE_EQ(sums.mean(FieldQuantity::drag, 0), -4.0);
    FieldSums rest = sums;
    FieldSums only(1);
    only.add_window(0, first, 10.0);
    rest.add(only, -1.0);
    EXPECT_NEAR(rest.mean(FieldQuantity::velocity, 0), 3.0, 1e-12);
}

}  // namespace
}  // namespace riffle::space_analysis_test
