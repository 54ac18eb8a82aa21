// The size of a case, from its keys alone.

#include "particles/case_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "particles/lattice.hpp"

namespace riffle::case_size_test {
namespace {

using testing::HasSubstr;

Case case_of(const std::string& channel, const std::string& rest = "") {
    return parse_case("[channel]\nslope = 0.004\n" + channel + "[bed]\nroughness_height = \"10 mm\"\n" + rest,
                      "case.toml");
}

std::string refusal(const Case& c, std::optional<std::size_t> available, bool confirmed = false) {
    try {
        check_size(c, confirmed, available);
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST(CaseSize, IsThatOfTheLattice) {
    for (const char* channel : {"depth = 0.05\nlength = 0.2\n", "depth = 0.1\nlength = 1\n",
                                "depth = 0.05\nlength = 0.1\nwidth = 0.0866\ndimensions = 3\n"}) {
        const Case c = case_of(channel);
        const auto places = static_cast<double>(lattice_of(c).places());
        EXPECT_NEAR(estimate_size(c).places, places, 0.03 * places);
        EXPECT_EQ(refusal(c, 1000000000), "");
    }
}

TEST(CaseSize, ALengthInMetresForMillimetresIsGuessed) {
    const Case c = case_of("depth = 50\n");
    EXPECT_THAT(refusal(c, std::nullopt), HasSubstr("[channel] depth is 50 m"));
    EXPECT_THAT(refusal(c, std::nullopt), HasSubstr("is 50 mm meant?"));
    EXPECT_THAT(refusal(c, std::nullopt), HasSubstr("--large"));
    EXPECT_EQ(refusal(c, std::nullopt, true), "");
    // A thousandth of the depth would hold no flow: the spacing is too small.
    const Case fine = case_of("depth = 0.05\nlength = 0.2\n", "[numerics]\nspacing = \"20 um\"\n");
    EXPECT_THAT(refusal(fine, std::nullopt), HasSubstr("[numerics] spacing is 20 um"));
    EXPECT_THAT(refusal(fine, std::nullopt), HasSubstr("is 20 mm meant?"));
    // Large, but nothing odd about it.
    EXPECT_EQ(refusal(case_of("depth = 1\nlength = 10\n", "[numerics]\nspacing = \"2 mm\"\n"), std::nullopt),
              "");
}

TEST(CaseSize, WhatIsLargerThanTheMemoryAsksForConfirmation) {
    const Case c = case_of("depth = 1\nlength = 10\n", "[numerics]\nspacing = \"2 mm\"\n");
    EXPECT_THAT(refusal(c, 100000000), HasSubstr("of which 0.1 GB are free"));
    EXPECT_EQ(refusal(c, 100000000, true), "");
    EXPECT_EQ(refusal(c, 2000000000), "");
}

TEST(CaseSize, WhatCannotBeCountedIsRefusedAllTheSame) {
    const Case c = case_of("depth = 1000\nlength = 400\n", "[numerics]\nspacing = \"1 cm\"\n");
    EXPECT_THAT(refusal(c, std::nullopt, true), HasSubstr("can be counted"));
}

}  // namespace
}  // namespace riffle::case_size_test
