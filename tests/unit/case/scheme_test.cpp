// Combinations of the options of the pair sums that make no sense, and what the message says about them.

#include "case/key_table.hpp"
#include "case/presets.hpp"
#include "case/refusals.hpp"
#include "case_test.hpp"

namespace riffle::scheme_test {
namespace {

using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::HasSubstr;

std::string with(const std::string& numerics, const std::string& turbulence = "") {
    return smallest + turbulence + "[numerics]\n" + numerics;
}

const std::string laminar = "[turbulence]\nclosure = \"none\"\n";

TEST(SchemeValidation, TensileCorrectionNeedsTheSymmetricForm) {
    const std::string cubic = "kernel = \"cubic-spline\"\ntensile_correction = 0.2\n";
    EXPECT_THAT(
        error_of(with(cubic)),
        AllOf(HasSubstr("[numerics] tensile_correction = 0.2 with [numerics] pressure_form = \"corrected\""),
              HasSubstr("choose pressure_form = \"symmetric\"")));
    EXPECT_THAT(error_of(with(cubic + "pressure_form = \"riemann\"\n")),
                HasSubstr("pressure_form = \"riemann\""));
    EXPECT_EQ(error_of(with(cubic + "pressure_form = \"symmetric\"\n")), "");
}

TEST(SchemeValidation, TensileCorrectionNeedsTheCubicSpline) {
    EXPECT_THAT(error_of(with("pressure_form = \"symmetric\"\ntensile_correction = 0.2\n")),
                HasSubstr("cubic-spline"));
}

TEST(SchemeValidation, ArtificialViscosityCarriesNoEddyViscosity) {
    const std::string artificial = "viscosity = \"artificial\"\n";
    EXPECT_THAT(error_of(with(artificial)),
                AllOf(HasSubstr("closure = \"ramp\""), HasSubstr("the eddy viscosity cannot act")));
    EXPECT_EQ(error_of(with(artificial + "eddy_stress = \"stress-divergence\"\n")), "");
    EXPECT_EQ(error_of(with(artificial, laminar)), "");
}

TEST(SchemeValidation, KernelCorrectionNeedsAForm) {
    const std::string kernel = "kernel_correction = \"kernel\"\n";
    EXPECT_EQ(error_of(with(kernel)), "");
    EXPECT_EQ(error_of(with(kernel + "pressure_form = \"symmetric\"\n")), "") << "of the velocity gradient";
    EXPECT_THAT(error_of(with(kernel + "pressure_form = \"symmetric\"\n", laminar)),
                AllOf(HasSubstr("pressure_form = \"symmetric\""), HasSubstr("closure = \"none\""),
                      HasSubstr("nothing to correct")));
    EXPECT_THAT(error_of(with(kernel + "pressure_form = \"symmetric\"\nvelocity_gradient = \"plain\"\n")),
                HasSubstr("velocity_gradient = \"plain\""));
}

TEST(SchemeValidation, OneDissipationOfApproachingParticles) {
    EXPECT_THAT(error_of(with("viscosity = \"artificial\"\npressure_form = \"riemann\"\n", laminar)),
                HasSubstr("both damp approaching particles"));
    EXPECT_EQ(error_of(with("viscosity = \"lo-shao\"\npressure_form = \"riemann\"\n")), "");
}

TEST(SchemeValidation, DifferencesOfPressureHaveNoFreeSurface) {
    EXPECT_THAT(error_of(with("pressure_form = \"riemann-non-conservative\"\n")),
                AllOf(HasSubstr("top = \"free-surface\""), HasSubstr("the surface blows up")));
}

TEST(SchemeValidation, HoldsForThePresets) {
    for (const Preset preset : {Preset::riffle, Preset::violent, Preset::thesis, Preset::paper}) {
        Case c;
        c.numerics = preset_numerics(preset);
        for_each_finding(method_refusals(), c,
                         [](const CaseCheck& check, const CaseFinding&) { ADD_FAILURE() << check.what; });
    }
}

/// Every choice of the method says who stated it and where it is advised.
TEST(Options, OfTheMethodHaveASourceAndAdvice) {
    for (const Key& key : find_section("numerics")->keys) {
        if (key.name == "preset") continue;
        for (const Word& option : key.words) {
            EXPECT_FALSE(option.advice.empty()) << key.id() << " = " << option.name;
            EXPECT_TRUE(!option.source.empty() || option.name == "none") << key.id() << " = " << option.name;
        }
    }
}

/// What was measured stands in the documents, with the command that measures it.
TEST(Options, QuoteNoMeasurement) {
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            for (const Word& option : key.words) {
                for (const std::string_view text : {option.meaning, option.source, option.advice}) {
                    EXPECT_THAT(std::string(text), testing::Not(HasSubstr(" %"))) << key.id();
                }
            }
        }
    }
}

}  // namespace
}  // namespace riffle::scheme_test
