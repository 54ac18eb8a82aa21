// Case files that nobody writes on purpose: nested without end, with characters that a terminal obeys, with
// sizes that cannot be meant. Each ends in a message with its place.

#include <fmt/format.h>

#include <cmath>

#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "case_test.hpp"

namespace riffle::hostile_input_test {
namespace {

using test::changed;
using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
}

TEST(HostileInput, NestingIsRefusedBeforeItOverflowsTheStack) {
    for (const std::string& dotted :
         {"a" + repeated(".a", 50000) + " = 1\n", "[a" + repeated(".a", 50000) + "]\n",
          "[[a" + repeated(" . \"a\"", 50000) + "]]\n", "x = { a" + repeated(".a", 50000) + " = 1 }\n"}) {
        EXPECT_THAT(error_of(smallest + dotted), AllOf(StartsWith("case.toml:6:"), HasSubstr("parts")));
    }
    for (const std::string& brackets :
         {repeated("[", 50000), repeated("{a=", 50000), repeated("[\n", 50000)}) {
        EXPECT_THAT(error_of(smallest + "a = " + brackets), HasSubstr("arrays or tables in each other"));
    }
    EXPECT_NE(error_of(smallest, {{"channel.depth", repeated("[", 50000)}}), "");
    EXPECT_NE(error_of(smallest, {{"channel." + repeated("a.", 50000), "1"}}), "");
}

TEST(HostileInput, DotsAndBracketsInTextsAreNoNesting) {
    const std::string dots = repeated("a.", 1000) + repeated("[", 1000);
    EXPECT_EQ(error_of("title = \"" + dots + "\"\n" + smallest), "");
    EXPECT_EQ(error_of("title = '" + dots + "'\n# " + dots + "\n" + smallest), "");
    EXPECT_EQ(error_of("description = \"\"\"\n" + dots + "\n\"\"\"\n" + smallest), "");
}

TEST(HostileInput, ControlCharactersInTextsAreRefused) {
    EXPECT_THAT(error_of("title = \"a\\u0000b\"\n" + smallest),
                AllOf(StartsWith("case.toml:1:9: title holds the control character U+0000 after \"a\""),
                      HasSubstr("remove it")));
    EXPECT_THAT(error_of("title = \"\\u001b[31mred\"\n" + smallest), HasSubstr("U+001B"));
    EXPECT_THAT(error_of("title = \"two\\nlines\"\n" + smallest), HasSubstr("U+000A"));
    EXPECT_THAT(error_of("title = \"\\u202Eback\"\n" + smallest), HasSubstr("U+202E"));
    EXPECT_EQ(error_of("description = \"two\\nlines\\tand a tab\"\n" + smallest), "");
    EXPECT_THAT(error_of("description = \"\\u001b[2J\"\n" + smallest),
                HasSubstr("line breaks and tabs may stay"));
    EXPECT_THAT(error_of(smallest + "[start]\nkind = \"results\"\nfile = \"a\\u0000.h5\"\n"),
                HasSubstr("U+0000"));
    EXPECT_THAT(error_of(smallest, {{"title", "\x1b[2J"}}), HasSubstr("U+001B"));
    EXPECT_THAT(error_of(smallest + "\"\\u001b[2J\" = 1\n"), HasSubstr("unknown key `<U+001B>[2J`"));
    EXPECT_THAT(error_of(smallest + "[\"\\u001b[2J\"]\n"), HasSubstr("unknown section [<U+001B>[2J]"));
}

TEST(HostileInput, SizesThatCannotBeMeantAreRefusedWithTheReason) {
    EXPECT_THAT(error_of(smallest + "[fluid]\ndensity = 1e-300\n"),
                AllOf(StartsWith("case.toml:7:11: [fluid] density = 1e-300: less than 0.001 kg/m3"),
                      HasSubstr("air has 1.2 kg/m3"), HasSubstr("correct the value or its unit")));
    EXPECT_THAT(error_of(smallest + "[fluid]\ngravity = 1e6\n"), HasSubstr("more than 10000 m/s2"));
    EXPECT_THAT(error_of(changed("\"50 mm\"", "1e300")), HasSubstr("more than 100000 m"));
    EXPECT_THAT(error_of(changed("\"50 mm\"", "1e-300")), HasSubstr("less than 1e-09 m"));
    EXPECT_THAT(error_of(smallest + "[numerics]\ncourant_number = 1e-12\n"), HasSubstr("at least 0.001"));
    EXPECT_THAT(error_of(smallest + "[turbulence]\nkappa = 1e-12\n"), HasSubstr("measured: 0.35 to 0.45"));
}

/// Every number has a range, of its own or of its dimension.
TEST(HostileInput, NoKeyTakesAnyNumber) {
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            if (key.type != ValueType::number && key.type != ValueType::integer) continue;
            for (const double absurd : {1e300, -1e300}) {
                const RawValue raw =
                    key.type == ValueType::integer
                        ? RawValue(absurd > 0 ? 9223372036854775807LL : -9223372036854775807LL)
                        : RawValue(absurd);
                EXPECT_TRUE(std::holds_alternative<std::string>(convert(key, raw)))
                    << key.id() << " takes " << absurd;
            }
            if (key.range.minimum >= 0.0 && key.type == ValueType::number) {
                EXPECT_TRUE(std::holds_alternative<std::string>(convert(key, RawValue(1e-300))) ||
                            key.dimension == Dimension::none)
                    << key.id() << " takes 1e-300";
            }
        }
    }
}

TEST(HostileInput, NegativeZeroIsZero) {
    const Key& key = *find_key("start.amplitude");
    for (const RawValue& raw : {RawValue(-0.0), RawValue(std::string("-0 m"))}) {
        const auto converted = convert(key, raw);
        ASSERT_TRUE(std::holds_alternative<Value>(converted));
        EXPECT_FALSE(std::signbit(std::get<double>(std::get<Value>(converted))));
    }
}

TEST(HostileInput, MessagesShowTheBeginOfALongText) {
    const Key& key = *find_key("start.amplitude");
    const auto message = convert(key, RawValue("3 " + std::string(100000, 'm')));
    ASSERT_TRUE(std::holds_alternative<std::string>(message));
    EXPECT_LT(std::get<std::string>(message).size(), 1000U);
    EXPECT_LT(error_of(std::string(100000, 'k') + " = 1\n").size(), 2000U);
}

TEST(HostileInput, TooMuchOfAnythingIsRefused) {
    std::string list = "0";
    for (int i = 1; i <= 10000; ++i) {
        list += fmt::format(", {}", i);
    }
    EXPECT_THAT(error_of(smallest + "[[solid]]\nname = \"a\"\nx = [" + list + "]\nz = [0]\n"),
                HasSubstr("holds 10001 values: expected at most 10000"));
    EXPECT_THAT(error_of(smallest + repeated("[[probe]]\n", 1001)),
                HasSubstr("more than 1000 sections [[probe]]"));
    // Many faults: the first ones are told.
    std::string many = smallest;
    for (int i = 0; i < 1000; ++i) {
        many += fmt::format("nonsense_{} = 1\n", i);
    }
    EXPECT_THAT(error_of(many), HasSubstr("and 960 more of the kind"));
}

TEST(HostileInput, WhatPeopleLookForIsExplained) {
    EXPECT_THAT(error_of(changed("slope = 0.004", "slope = 0.004\ndischarge = 0.01")),
                AllOf(HasSubstr("unknown key `discharge` in [channel]: a periodic channel has no inflow"),
                      HasSubstr("follows from slope, depth and roughness")));
    EXPECT_THAT(error_of(smallest + "[numerics]\ndx = 0.001\n"),
                HasSubstr("the particle spacing is `spacing`"));
    // A name that several sections have.
    EXPECT_THAT(error_of(smallest + "spacing = 1\n"), HasSubstr("it belongs in [numerics] or in [[probe]]"));
}

TEST(HostileInput, LengthsAreShownInFewDigits) {
    const std::string message = error_of(changed("\"0.4 D\"", "0.05600000000000001"));
    EXPECT_THAT(message, HasSubstr("roughness_height is 56 mm"));
    EXPECT_EQ(shown_length(0.05600000000000001), "56 mm");
    EXPECT_EQ(shown_length(2e-6), "2 um");
    EXPECT_EQ(shown_length(0.99999999), "1 m");
    EXPECT_EQ(shown_length(-0.0123456789), "-12.3457 mm");
    EXPECT_EQ(shown_length(0.0), "0 m");
}

}  // namespace
}  // namespace riffle::hostile_input_test
