// Combinations of the options of the pair sums that make no sense, and what the message says about them.

#include "case_test.hpp"

namespace riffle {
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
    EXPECT_THAT(error_of(with(cubic)),
                AllOf(HasSubstr("tensile_correction = 0.2 goes with pressure_form = \"symmetric\""),
                      HasSubstr("not with \"corrected\"")));
    EXPECT_THAT(error_of(with(cubic + "pressure_form = \"riemann\"\n")), HasSubstr("not with \"riemann\""));
    EXPECT_EQ(error_of(with(cubic + "pressure_form = \"symmetric\"\n")), "");
}

TEST(SchemeValidation, TensileCorrectionNeedsTheCubicSpline) {
    EXPECT_THAT(error_of(with("pressure_form = \"symmetric\"\ntensile_correction = 0.2\n")),
                HasSubstr("cubic-spline"));
}

TEST(SchemeValidation, ArtificialViscosityCarriesNoEddyViscosity) {
    const std::string artificial = "viscosity = \"artificial\"\n";
    EXPECT_THAT(error_of(with(artificial)), HasSubstr("the eddy viscosity of closure = \"ramp\" cannot act"));
    EXPECT_EQ(error_of(with(artificial + "eddy_stress = \"stress-divergence\"\n")), "");
    EXPECT_EQ(error_of(with(artificial, laminar)), "");
}

TEST(SchemeValidation, OneDissipationOfApproachingParticles) {
    EXPECT_THAT(error_of(with("viscosity = \"artificial\"\npressure_form = \"riemann\"\n", laminar)),
                HasSubstr("both damp approaching particles"));
    EXPECT_EQ(error_of(with("viscosity = \"lo-shao\"\npressure_form = \"riemann\"\n")), "");
}

}  // namespace
}  // namespace riffle
