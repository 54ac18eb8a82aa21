#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "case/case.hpp"

namespace riffle::stepping_validation_test {
namespace {

using testing::HasSubstr;

/// Message of the error that a case with these lines in [numerics] causes; empty: none.
std::string error_with(const std::string& numerics) {
    try {
        static_cast<void>(parse_case(
            "[channel]\nslope = 0.004\ndepth = \"50 mm\"\nlength = \"0.2 m\"\n[bed]\nroughness_height = "
            "\"0.4 D\"\n[numerics]\n" +
                numerics,
            "case.toml"));
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST(SteppingValidation, VerletIsRefusedWhereItFails) {
    EXPECT_THAT(error_with("stepping = \"verlet\"\n"), HasSubstr("amplifies any diffusion of the density"));
    EXPECT_EQ(error_with("stepping = \"verlet\"\ncourant_number = 0.2\n"), "");
    EXPECT_EQ(error_with("stepping = \"verlet\"\ndensity_diffusion = \"none\"\n"), "");
    EXPECT_EQ(error_with("stepping = \"verlet\"\ntime_step = \"0.05 ms\"\n"), "");
}

TEST(SteppingValidation, TheOtherMethodsAreTaken) {
    for (const std::string method : {"semi-implicit-euler", "predictor-corrector", "symplectic", "beeman"}) {
        EXPECT_EQ(error_with("stepping = \"" + method + "\"\n"), "") << method;
    }
}

}  // namespace
}  // namespace riffle::stepping_validation_test
