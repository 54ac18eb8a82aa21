#include "analysis/analysis_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace riffle::analysis_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Analysis sample(const std::string& name, double value) {
    Analysis analysis;
    analysis.name = name;
    analysis.source = name + ".h5";
    analysis.findings = {{"depth_mean_velocity", "statistics", "mean velocity", "m/s", value, 0.00123, 0.25,
                          "measured", "why it differs"},
                         {"drift", "statistics", "drift", "1", 0.5, {}, 0.0, "steady flow", ""}};
    return analysis;
}

TEST(AnalysisText, SaysValueIntervalReferenceAndDifference) {
    Analysis analysis = sample("run", 0.3);
    analysis.warnings = {"too short"};
    Figure figure;
    figure.key = "surface_map";
    figure.missing = "no surface";
    analysis.figures = {figure};
    const std::string text = analysis_to_text(analysis);
    EXPECT_THAT(text, HasSubstr("Statistics of the record\n"));
    EXPECT_THAT(text, HasSubstr("0.3 ± 0.0012"));
    EXPECT_THAT(text, HasSubstr("      0.25: measured, +20.0 %\n      why it differs\n"));
    EXPECT_THAT(text, HasSubstr("surface_map: no surface"));
    EXPECT_THAT(text, HasSubstr("too short"));
    // A reference of zero has no relative difference.
    EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(AnalysisText, ComparesWhatAtLeastTwoHave) {
    Analysis other = sample("other", 0.4);
    other.findings.pop_back();
    const std::string text = comparison_to_text({sample("run", 0.3), other});
    EXPECT_THAT(text, HasSubstr("(1) run, run.h5"));
    EXPECT_THAT(text, HasSubstr("(2) other, other.h5"));
    EXPECT_THAT(text, HasSubstr("0.3 ± 0.0012"));
    EXPECT_THAT(text, HasSubstr("0.4 ± 0.0012"));
    EXPECT_THAT(text, Not(HasSubstr("drift")));
}

TEST(AnalysisText, NamesASourceOnceWhereTheNameHoldsIt) {
    Analysis named = sample("run", 0.3);
    named.name = "run (run.h5)";
    const std::string text = comparison_to_text({named, sample("other", 0.4)});
    EXPECT_THAT(text, HasSubstr("(1) run (run.h5)\n"));
    EXPECT_THAT(text, HasSubstr("(2) other, other.h5\n"));
}

}  // namespace
}  // namespace riffle::analysis_text_test
