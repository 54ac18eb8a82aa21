#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "sweep/study_files.hpp"

namespace riffle::study_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A sweep of three spacings whose outcomes are made up: U converges with order 2 to 0.4 m/s, the departure
/// vanishes with order 1.
SweepStudy made_up(const std::string& second_run = "complete") {
    SweepStudy sweep;
    sweep.title = "made up";
    sweep.case_file = "made-up.toml";
    sweep.outcomes = chosen_outcomes({"depth_mean_velocity", "velocity_error_above_rms"});
    sweep.keys = {{read_variation("numerics.spacing=4mm,2mm,1mm"), "spacing", "m", {4e-3, 2e-3, 1e-3}, true}};
    const std::vector<Combination> combinations = combinations_of({sweep.keys[0].variation});
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = sweep.keys[0].numbers[i];
        StudiedRun run{{combinations[i], {}, combinations[i].name}, {RunFate::done, "", 0}, {}};
        run.outcomes["depth_mean_velocity"] = {0.4 + 1e4 * size * size, 1e-3, 0.41};
        run.outcomes["velocity_error_above_rms"] = {5.0 * size, std::nan(""), std::nan("")};
        sweep.runs.push_back(run);
    }
    if (second_run == "failed") {
        sweep.runs[1].report = {RunFate::failed, "the particles have\nleft, \"all\" of them", 1};
        sweep.runs[1].outcomes.clear();
    }
    return sweep;
}

TEST(Outcomes, AreChosenByNameWithoutRepetition) {
    const auto chosen = chosen_outcomes({"mean_level", "depth_mean_velocity", "mean_level"});
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[0].key, "mean_level");
    for (const Outcome& outcome : chosen_outcomes({})) EXPECT_TRUE(outcome.usual) << outcome.key;
    try {
        (void)chosen_outcomes({"mean_levl"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("did you mean mean_level"), HasSubstr("drag_over_gravity")));
    }
}

TEST(ValueText, ShowsTheValueToThePlaceOfItsHalfWidth) {
    const Outcome velocity = chosen_outcomes({"depth_mean_velocity"}).front();
    EXPECT_EQ(value_text(velocity, 0.45123456, 0.00071), "0.45123 +- 0.00071");
    EXPECT_EQ(value_text(velocity, 0.45123456, std::nan("")), "0.4512");
    EXPECT_EQ(value_text(velocity, std::nan(""), 0.1), "-");
    const Outcome error = chosen_outcomes({"depth_mean_velocity_error"}).front();
    EXPECT_EQ(value_text(error, 0.0123, 0.004), "1.23 +- 0.40");
}

TEST(SweepFiles, CsvHasALineForEachRunWithItsNumbers) {
    const std::string csv = sweep_csv(made_up("failed"));
    EXPECT_THAT(csv, HasSubstr("run,state,numerics.spacing,spacing [m],depth_mean_velocity [m/s],"
                               "depth_mean_velocity_half_width [m/s],depth_mean_velocity_twin [m/s],"));
    EXPECT_THAT(csv, HasSubstr("\nspacing=4mm,complete,4mm,0.004,0.56,0.001,0.41,0.02,,\n"));
    EXPECT_THAT(csv, HasSubstr("\nspacing=2mm,failed,2mm,0.002,,,,,,\n"));
}

TEST(SweepFiles, JsonHasTheDocumentedKeys) {
    const auto json = nlohmann::json::parse(sweep_json(made_up("failed")));
    EXPECT_EQ(json["format"], "riffle-sweep");
    EXPECT_EQ(json["format_version"], 1);
    EXPECT_EQ(json["keys"][0]["key"], "numerics.spacing");
    EXPECT_EQ(json["keys"][0]["refines"], true);
    const auto& run = json["runs"][1];
    EXPECT_EQ(run["state"], "failed");
    EXPECT_THAT(run["message"].get<std::string>(), HasSubstr("\"all\" of them"));
    EXPECT_TRUE(run["outcomes"]["depth_mean_velocity"]["value"].is_null());
    EXPECT_DOUBLE_EQ(json["runs"][2]["outcomes"]["depth_mean_velocity"]["value"], 0.41);
    EXPECT_DOUBLE_EQ(json["runs"][2]["numbers"]["numerics.spacing"], 1e-3);
}

TEST(SweepFigures, ShowOutcomesAgainstTheRefinedKeyAndDeparturesOnLogarithmicAxes) {
    const Analysis analysis = sweep_figures(made_up());
    std::vector<std::string> keys;
    for (const Figure& figure : analysis.figures) keys.push_back(figure.key);
    EXPECT_THAT(keys, ElementsAre("sweep_depth_mean_velocity", "sweep_velocity_error_above_rms",
                                  "sweep_velocity_error_above_rms_order"));
    const Figure& velocity = analysis.figures.front();
    ASSERT_EQ(velocity.curves.size(), 2U);
    EXPECT_EQ(velocity.curves[0].origin, Origin::column);
    EXPECT_THAT(velocity.curves[1].x, ElementsAre(1e-3, 2e-3, 4e-3));
    EXPECT_EQ(velocity.curves[1].y_half_width.size(), 3U);
    EXPECT_TRUE(analysis.figures[2].x.logarithmic && analysis.figures[2].y.logarithmic);
    EXPECT_TRUE(figure_categories(made_up()).empty());
}

TEST(SweepFigures, ShowATwinForEachFamilyWhoseTwinDiffers) {
    SweepStudy sweep = made_up();
    sweep.keys.push_back({read_variation("turbulence.closure=a,b"), "closure", "", {}, false});
    for (std::size_t i = 0; i < 3; ++i) {
        sweep.runs[i].run.combination.values.emplace_back("a");
        StudiedRun other = sweep.runs[i];
        other.run.combination.values.back() = "b";
        sweep.runs.push_back(other);
        sweep.keys[0].numbers.push_back(sweep.keys[0].numbers[i]);
    }
    const auto twins = [&] {
        const Analysis analysis = sweep_figures(sweep);
        std::vector<std::string> names;
        for (const Curve& curve : analysis.figures.front().curves) {
            if (curve.origin == Origin::column) names.push_back(curve.name);
        }
        return names;
    };
    EXPECT_THAT(twins(), ElementsAre("twin"));
    for (std::size_t i = 3; i < 6; ++i) sweep.runs[i].outcomes["depth_mean_velocity"].twin = 0.3;
    EXPECT_THAT(twins(), ElementsAre("twin, closure=a", "twin, closure=b"));
}

TEST(SweepFigures, PutWordsSideBySideUnderTheirNames) {
    SweepStudy sweep = made_up();
    sweep.keys = {{read_variation("numerics.kernel=a,b,c"), "kernel", "", {}, false}};
    EXPECT_THAT(figure_categories(sweep), ElementsAre("a", "b", "c"));
    for (std::size_t i = 0; i < 3; ++i) {
        sweep.runs[i].run.combination.values = {sweep.keys[0].variation.values[i]};
    }
    const Analysis analysis = sweep_figures(sweep);
    EXPECT_THAT(analysis.figures[0].curves[1].x, ElementsAre(0.0, 1.0, 2.0));
    EXPECT_EQ(analysis.figures[0].curves[1].mark, Mark::points);
}

TEST(SweepText, NamesRunsStatesAndOutcomes) {
    const std::string text = sweep_text(made_up("failed"));
    EXPECT_THAT(text, AllOf(HasSubstr("(1) depth-mean velocity U, m/s"), HasSubstr("spacing=2mm    failed"),
                            HasSubstr("0.4100 +- 0.0010"), Not(HasSubstr("nan"))));
}

TEST(Shares, DivideTheThreadsAmongTheRuns) {
    ScheduleOptions options;
    options.threads = 16;
    EXPECT_EQ(shares_of(options, 8).jobs, 4);  // four threads for each
    EXPECT_EQ(shares_of(options, 8).threads, 4);
    EXPECT_EQ(shares_of(options, 2).jobs, 2);  // no more than there are runs
    EXPECT_EQ(shares_of(options, 2).threads, 8);
    options.jobs = 3;
    EXPECT_EQ(shares_of(options, 8).threads, 5);
    options.jobs = 100;
    EXPECT_EQ(shares_of(options, 50).jobs, 50);
    EXPECT_EQ(shares_of(options, 50).threads, 1);
    EXPECT_EQ(shares_of(options, 0).jobs, 1);
}

}  // namespace
}  // namespace riffle::study_test
