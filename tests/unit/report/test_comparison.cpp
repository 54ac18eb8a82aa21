#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "base/error.hpp"
#include "case/case_text.hpp"
#include "case/flow_conditions.hpp"
#include "report/comparison.hpp"
#include "report/quantities.hpp"
#include "report/report.hpp"
#include "report/thesis.hpp"
#include "sample_analysis.hpp"
#include "sample_results.hpp"

namespace riffle::comparison_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::sample_analysis;
using testing::sample_record;
using testing::SampleOptions;
using testing::write_sample_results;

std::vector<std::string> names(const std::vector<Case>& cases, const std::vector<std::string>& otherwise) {
    std::vector<const Case*> pointers;
    for (const Case& c : cases) pointers.push_back(&c);
    return names_of_cases(pointers, otherwise);
}

Case condition_2_at(double spacing) {
    Case c = builtin_case("condition-2");
    c.numerics.spacing = spacing;
    return c;
}

TEST(CaseNames, SayWhatDiffers) {
    EXPECT_THAT(names({condition_2_at(0.002), condition_2_at(0.0015)}, {"a", "b"}),
                ElementsAre("spacing 2 mm", "spacing 1.5 mm"));
}

TEST(CaseNames, NameTheFlowConditionsAndTheClosureWithinOne) {
    Case sps = builtin_case("condition-3");
    sps.turbulence.closure = ClosureKind::sps;
    EXPECT_THAT(names({builtin_case("condition-1"), builtin_case("condition-3"), sps}, {"a", "b", "c"}),
                ElementsAre("condition 1", "condition 3, closure ramp", "condition 3, closure sps"));
}

TEST(CaseNames, TakeTheFirstKeyThatAloneTellsThemApart) {
    std::vector<Case> cases{condition_2_at(0.002), condition_2_at(0.0015), condition_2_at(0.001)};
    cases[0].channel.length = 0.1;  // the length alone leaves two of them alike
    EXPECT_THAT(names(cases, {"a", "b", "c"}), ElementsAre("spacing 2 mm", "spacing 1.5 mm", "spacing 1 mm"));
}

TEST(CaseNames, TellTwoFromThreeDimensions) {
    EXPECT_THAT(names({builtin_case("condition-2"), builtin_case("condition-2-3d")}, {"a", "b"}),
                ElementsAre("2D", "3D"));
}

TEST(CaseNames, FallBackToTheFolderWhereTheCasesAreEqual) {
    const std::vector<Case> cases(2, builtin_case("condition-2"));
    EXPECT_THAT(names(cases, {"monday", "tuesday"}),
                ElementsAre("condition 2 (monday)", "condition 2 (tuesday)"));
}

TEST(CaseNames, NumberWhatIsTheSameEvenSo) {
    const std::vector<Case> cases(3, builtin_case("condition-2"));
    EXPECT_THAT(names(cases, {"x", "x", "y"}),
                ElementsAre("condition 2 (x)", "condition 2 (x) (2)", "condition 2 (y)"));
}

TEST(CaseNames, TheSurfaceThatIsMeasuredIsADifference) {
    const Case first = builtin_case("condition-2");
    Case other = first;
    other.output.surface_detection = first.output.surface_detection == SurfaceDetection::volume_fraction
                                         ? SurfaceDetection::position_divergence
                                         : SurfaceDetection::volume_fraction;
    const auto differences = case_differences({&first, &other});
    ASSERT_EQ(differences.size(), 1U);
    EXPECT_EQ(differences[0].key, "output.surface_detection");
}

TEST(CaseNames, TitlesAndMeasuredValuesAreNoDifference) {
    Case other = builtin_case("condition-2");
    other.title = "another title";
    other.measured.depth_mean_velocity = 0.36;
    const Case first = builtin_case("condition-2");
    EXPECT_THAT(case_differences({&first, &other}), IsEmpty());
}

class Compared : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("riffle-comparison-" + std::to_string(getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::error_code error;
        std::filesystem::remove_all(folder_, error);
    }

    /// A run of a built-in case, in a folder of its own.
    ReportSubject run(const std::string& name, const Case& c) {
        std::filesystem::create_directories(folder_ / name);
        SampleOptions options;
        options.case_text = case_text(c);
        const auto path = folder_ / name / "results.h5";
        write_sample_results(path, options);
        return {path, sample_analysis(name)};
    }

    std::filesystem::path folder_;
};

TEST_F(Compared, RunsAndRecordsStandOnOnePage) {
    const Comparison comparison = compare({run("coarse", condition_2_at(0.002)),
                                           run("fine", condition_2_at(0.001)),
                                           {{}, sample_record("adv")}});
    const json page = json::parse(comparison_page_json(comparison));
    EXPECT_EQ(page.at("runs").at(0).at("name"), "spacing 2 mm");
    EXPECT_EQ(page.at("runs").at(2).at("kind"), "record");
    EXPECT_EQ(page.at("runs").at(2).at("name"), "adv");
    EXPECT_EQ(page.at("differences").at(0).at("values"), json({"2 mm", "1 mm", "–"}));
    EXPECT_EQ(page.at("sets").at(0).at("members"), json({0, 1, 2}));

    const auto html = folder_ / "comparison.html";
    write_comparison(comparison, html, summary_beside(html));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "comparison-summary.json"));
}

TEST_F(Compared, SummaryHoldsEachRunsFindingsAndVerdict) {
    const Comparison comparison =
        compare({run("one", builtin_case("condition-2")), {{}, sample_record("adv")}});
    const json summary = json::parse(comparison_summary_json(comparison));
    EXPECT_EQ(summary.at("format"), "riffle-report-comparison");
    const json& first = summary.at("runs").at(0);
    EXPECT_EQ(first.at("format"), "riffle-report-summary");
    EXPECT_TRUE(first.at("verdict").contains("headline"));
    EXPECT_EQ(first.at("findings").at(1).at("key"), "surface_standard_deviation");
    EXPECT_EQ(summary.at("runs").at(1).at("findings").at(0).at("value"), 0.35);
    // What is not known is null, not a number that no reader can parse.
    EXPECT_TRUE(first.at("findings").at(3).at("value").is_null());
}

TEST_F(Compared, EqualCasesInFoldersOfOneNameAreToldApartByTheFoldersAbove) {
    const Case c = builtin_case("condition-2");
    const auto runs = collect_runs({run("monday/x", c), run("tuesday/x", c)});
    EXPECT_EQ(runs[0].name, "condition 2 (monday/x)");
    EXPECT_EQ(runs[1].name, "condition 2 (tuesday/x)");
}

TEST_F(Compared, RecordsOfOneNameAreAllToldApart) {
    Analysis first = sample_record("adv");
    Analysis second = sample_record("adv");
    first.source = "a.csv";
    second.source = "b.csv";
    const auto runs = collect_runs({{{}, first}, {{}, second}});
    EXPECT_EQ(runs[0].name, "adv (a.csv)");
    EXPECT_EQ(runs[1].name, "adv (b.csv)");
}

TEST_F(Compared, ARecordAloneGivesThePageItsName) {
    EXPECT_EQ(compare({{{}, sample_record("adv")}}).title, "adv");
}

TEST_F(Compared, TheSurfaceFluctuationOfTheSummaryIsThatOfTheAnalysis) {
    const auto runs = collect_runs({run("one", builtin_case("condition-2"))});
    const Finding* const found = find_finding(runs[0].analysis, "surface_standard_deviation");
    ASSERT_NE(found, nullptr);
    const auto quantities = summarize(*runs[0].run, runs[0].analysis);
    const SummaryRow* const row = find_quantity(quantities, "surface_standard_deviation");
    ASSERT_TRUE(row != nullptr && row->simulated);
    EXPECT_EQ(row->simulated->value, found->value);
    EXPECT_EQ(row->simulated->half_width, found->half_width);
}

TEST_F(Compared, NothingToCompareIsAnError) { EXPECT_THROW(static_cast<void>(compare({})), InputError); }

TEST_F(Compared, ThesisChapterKnowsItsRunsByTheirCasesAndNamesThoseMissing) {
    std::vector<ReportSubject> subjects;
    for (const int number : {8, 6, 5, 3}) {
        const auto condition = "condition-" + std::to_string(number);
        subjects.push_back(run("run" + std::to_string(number), builtin_case(condition)));
    }
    subjects.push_back(run("run2", condition_2_at(0.0015)));
    subjects.push_back(run("coarse", condition_2_at(0.002)));
    Case sps = builtin_case("condition-3");
    sps.turbulence.closure = ClosureKind::sps;
    subjects.push_back(run("sps", sps));
    const Comparison chapter = thesis_figures(subjects);

    ASSERT_EQ(chapter.sets.size(), 3U);
    EXPECT_THAT(chapter.sets[0].names,
                ElementsAre("condition 2", "condition 3", "condition 5", "condition 6", "condition 8"));
    EXPECT_THAT(chapter.sets[0].members, ElementsAre(4, 3, 2, 1, 0));
    EXPECT_TRUE(chapter.sets[0].side_by_side);
    EXPECT_THAT(chapter.sets[1].names, ElementsAre("closure ramp", "closure sps"));
    EXPECT_THAT(chapter.sets[2].names, ElementsAre("spacing 1.5 mm", "spacing 2 mm"));
    std::vector<std::string> missing;
    for (const MissingRun& run : chapter.missing) missing.push_back(run.what);
    EXPECT_THAT(
        missing,
        ElementsAre("flow condition 1", "flow condition 7", "flow condition 6 with the original SPS closure",
                    "flow condition 3 at a second spacing", "flow condition 6 at a second spacing",
                    "the paper's case", "the paper's case with the SPS closure"));
    EXPECT_THAT(chapter.missing[0].command, HasSubstr("condition-1.toml"));
}

TEST_F(Compared, ThesisFiguresInThreeDimensionsAndBesideTwo) {
    Case coarse = builtin_case("condition-2-3d");
    coarse.numerics.spacing = 0.003;
    Case low = builtin_case("condition-1-3d");
    low.bed.roughness_height *= 0.8;
    Case sps = builtin_case("condition-5-3d");
    sps.turbulence.closure = ClosureKind::sps;
    const std::vector<ReportSubject> subjects = {run("plane", builtin_case("condition-2")),
                                                 run("space", builtin_case("condition-2-3d")),
                                                 run("coarse", coarse),
                                                 run("first", builtin_case("condition-1-3d")),
                                                 run("low", low),
                                                 run("sps", sps),
                                                 run("wide", builtin_case("condition-2-3d-wide"))};
    const Comparison all = thesis_figures(subjects);
    std::vector<std::string> titles;
    for (const ComparedSet& set : all.sets) titles.push_back(set.title);
    ASSERT_THAT(
        titles,
        ElementsAre("Chapter 4: the flow conditions in two dimensions",
                    "Chapter 5: the flow conditions in three dimensions",
                    "Condition 2 in three dimensions: its runs compared",
                    "Condition 1 in three dimensions: heights of the roughness",
                    "Chapter 6: condition 2 in two and in three dimensions",
                    "Chapter 6: condition 5 with the original SPS closure, in two and in three dimensions",
                    "Other runs and records"));
    EXPECT_THAT(all.sets[1].members, ElementsAre(3, 1));
    EXPECT_THAT(all.sets[3].members, ElementsAre(3, 4));
    EXPECT_THAT(all.sets[4].names, ElementsAre("2D", "3D"));
    EXPECT_THAT(all.sets[6].members, ElementsAre(6));

    // A part alone shows its runs alone.
    const Comparison sixth = thesis_figures(subjects, {ThesisPart::both});
    EXPECT_EQ(sixth.runs.size(), 3U);
    EXPECT_EQ(sixth.sets.size(), 2U);
    for (const ComparedSet& set : sixth.sets) {
        for (const std::size_t member : set.members) EXPECT_LT(member, sixth.runs.size());
    }
    EXPECT_EQ(sixth.runs[sixth.sets[0].members[1]].name, all.runs[1].name);
    EXPECT_THROW(static_cast<void>(thesis_figures(subjects, {ThesisPart::paper})), InputError);
    EXPECT_EQ(thesis_part("6"), ThesisPart::both);
    EXPECT_EQ(thesis_part("7"), std::nullopt);
}

TEST_F(Compared, FlowConditionsAreKnownByDepthSlopeAndSpheres) {
    EXPECT_EQ(flow_condition_of(builtin_case("condition-7")), 7);
    EXPECT_EQ(flow_condition_of(builtin_case("paper-2016")), std::nullopt);
    Case other = builtin_case("condition-7");
    other.channel.slope = 0.0031;
    EXPECT_EQ(flow_condition_of(other), std::nullopt);
}

TEST(SummaryBeside, TakesItsNameFromThePage) {
    EXPECT_EQ(summary_beside("results/a/report.html"), std::filesystem::path("results/a/summary.json"));
    EXPECT_EQ(summary_beside("my.html"), std::filesystem::path("my-summary.json"));
}

}  // namespace
}  // namespace riffle::comparison_test
