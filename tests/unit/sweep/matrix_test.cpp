#include "sweep/matrix.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "temporary_folder.hpp"

namespace riffle::matrix_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path condition_2 =
    std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/rough-bed-2d/condition-2.toml";

std::vector<std::string> names_of(const std::vector<Combination>& combinations) {
    std::vector<std::string> names;
    for (const Combination& combination : combinations) names.push_back(combination.name);
    return names;
}

std::vector<Combination> combine(const std::vector<std::string>& texts) {
    std::vector<Variation> variations;
    for (const std::string& text : texts) variations.push_back(read_variation(text));
    return combinations_of(variations);
}

SweepInput input_of(const std::vector<std::string>& variations, const std::vector<Override>& settings = {}) {
    SweepInput input{condition_2, settings, {}, "sweep"};
    for (const std::string& text : variations) input.variations.push_back(read_variation(text));
    return input;
}

/// The message of the InputError that f must throw.
template <class F>
std::string refusal_of(const F& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

TEST(Variation, IsSplitAtCommasOutsideQuotesAndBrackets) {
    const Variation plain = read_variation("numerics.spacing=2mm, 1.5mm,1 mm");
    EXPECT_EQ(plain.key, "numerics.spacing");
    EXPECT_THAT(plain.values, ElementsAre("2mm", "1.5mm", "1 mm"));
    EXPECT_EQ(plain.short_name(), "spacing");
    EXPECT_THAT(read_variation("title=\"a, b\",'c,d'").values, ElementsAre("\"a, b\"", "'c,d'"));
    EXPECT_THAT(read_variation("output.snapshot_x=[0,1],[1,2]").values, ElementsAre("[0,1]", "[1,2]"));
}

TEST(Variation, RefusesWhatIsIncompleteOrTwice) {
    for (const char* wrong : {"numerics.spacing", "=1mm", "numerics.spacing=", "numerics.spacing=1mm,,2mm"}) {
        EXPECT_THAT(refusal_of([&] { (void)read_variation(wrong); }), HasSubstr("KEY=V1,V2")) << wrong;
    }
    EXPECT_THAT(refusal_of([&] { (void)read_variation("numerics.spacing=1mm,2mm,1mm"); }),
                AllOf(HasSubstr("1mm"), HasSubstr("twice")));
}

TEST(Combinations, AreAllOfThemTheLastKeyFastest) {
    EXPECT_THAT(names_of(combine({"numerics.spacing=2mm,1mm", "numerics.kernel=wendland-c2,cubic-spline"})),
                ElementsAre("spacing=2mm_kernel=wendland-c2", "spacing=2mm_kernel=cubic-spline",
                            "spacing=1mm_kernel=wendland-c2", "spacing=1mm_kernel=cubic-spline"));
    EXPECT_EQ(combine({"a.a=1,2,3", "b.b=1,2", "c.c=1,2,3,4"}).size(), 24U);
}

TEST(Combinations, HaveNamesFitForFolders) {
    EXPECT_THAT(names_of(combine({"run.until=\"2 s\",'3/2 s'"})), ElementsAre("until=2s", "until=3-2s"));
    // Keys of one name are told apart by their sections.
    EXPECT_THAT(names_of(combine({"bed.kind=flat", "start.kind=rest"})),
                ElementsAre("bed.kind=flat_start.kind=rest"));
}

TEST(Combinations, RefuseAKeyTwiceAndNamesThatAreOne) {
    EXPECT_THAT(refusal_of([] {
                    (void)combine({"numerics.spacing=1mm", "numerics.spacing=2mm"});
                }),
                HasSubstr("varied twice"));
    EXPECT_THAT(refusal_of([] { (void)combine({"numerics.spacing=1mm,1 mm"}); }),
                AllOf(HasSubstr("spacing=1mm"), HasSubstr("share the folder")));
}

TEST(Matrix, ReadsTheCaseOfEachCombination) {
    const auto runs = read_matrix(
        input_of({"numerics.spacing=2mm,1.5mm", "turbulence.lambda=0.09,0.1"}, {{"channel.length", "0.06"}}));
    ASSERT_EQ(runs.size(), 4U);
    EXPECT_DOUBLE_EQ(runs[0].flow.numerics.spacing, 2e-3);
    EXPECT_DOUBLE_EQ(runs[3].flow.numerics.spacing, 1.5e-3);
    EXPECT_DOUBLE_EQ(runs[1].flow.turbulence.lambda, 0.1);
    for (const SweepRun& run : runs) EXPECT_DOUBLE_EQ(run.flow.channel.length, 0.06);
    EXPECT_EQ(runs[1].folder, std::filesystem::path("sweep/spacing=2mm_lambda=0.1"));
}

TEST(Matrix, NamesEveryCombinationThatCannotBeRunWithKeyAndReason) {
    const std::string message = refusal_of([] {
        (void)read_matrix(input_of({"numerics.spacing=2mm,-1mm,2 kg", "numerics.kernel=wendland-c2,cubic"}));
    });
    EXPECT_THAT(message,
                AllOf(HasSubstr("5 of the 6 combinations"), HasSubstr("spacing=-1mm_kernel=wendland-c2"),
                      HasSubstr("--vary numerics.spacing=-1mm"), HasSubstr("greater than 0"),
                      HasSubstr("--vary numerics.kernel=cubic"), HasSubstr("cubic-spline")));
    EXPECT_THAT(refusal_of([] { (void)read_matrix(input_of({"numerics.spacin=1mm,2mm"})); }),
                HasSubstr("did you mean `spacing`"));
}

TEST(Matrix, RefusesAKeyThatIsSetAndVariedAndCasesThatAreOne) {
    EXPECT_THAT(refusal_of([] {
                    (void)read_matrix(input_of({"numerics.spacing=1mm,2mm"}, {{"numerics.spacing", "3mm"}}));
                }),
                AllOf(HasSubstr("numerics.spacing"), HasSubstr("both set")));
    EXPECT_THAT(refusal_of([] { (void)read_matrix(input_of({"numerics.spacing=2mm,0.002"})); }),
                AllOf(HasSubstr("spacing=2mm"), HasSubstr("spacing=0.002"), HasSubstr("same case")));
}

TEST(Matrix, RefusesWhatOnlyShowsWhenARunIsSetUp) {
    // An instrument that samples more often than there are steps.
    const auto file = test::folder_of_this_process() / "sweep-probe.toml";
    std::ofstream(file) << std::ifstream(condition_2).rdbuf()
                        << "\n[[probe]]\nname = \"wave\"\nkind = \"wave\"\nx = 0.01\n"
                           "sampling_frequency = \"2 kHz\"\n";
    SweepInput input = input_of({"numerics.time_step=0.1ms,1ms"});
    input.case_file = file;
    EXPECT_THAT(refusal_of([&] { (void)read_matrix(input); }),
                AllOf(HasSubstr("1 of the 2"), HasSubstr("time_step=1ms"), HasSubstr("sampling_frequency")));
}

}  // namespace
}  // namespace riffle::matrix_test
