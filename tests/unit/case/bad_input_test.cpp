// What a user gets wrong in a case file, and what the message says about it.

#include <fstream>

#include "case_test.hpp"

namespace riffle::bad_input_test {
namespace {

using test::changed;
using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(BadInput, SmallestCaseIsRight) { EXPECT_EQ(error_of(smallest), ""); }

TEST(BadInput, UnknownKeyNamesPlaceAndNearestMatch) {
    EXPECT_THAT(
        error_of(changed("slope = 0.004", "slop = 0.004")),
        AllOf(
            HasSubstr("case.toml:2:1: unknown key `slop` in [channel]: did you mean `slope`?"),
            HasSubstr("the keys in [channel] are slope, depth, length, width, dimensions, ends, sides, top"),
            HasSubstr("[channel] slope is missing")));
}

TEST(BadInput, UnknownKeyLikeNoOther) {
    const std::string message = error_of(smallest + "banana = 1\n");
    EXPECT_THAT(message,
                HasSubstr("case.toml:6:1: unknown key `banana` in [bed]; the keys in [bed] are kind,"));
    EXPECT_THAT(message, Not(HasSubstr("did you mean")));
}

TEST(BadInput, TheKeysOfASectionAreListedOnce) {
    const std::string message = error_of(smallest + "banana = 1\npeach = 2\nspacing = \"2 mm\"\n");
    EXPECT_THAT(message, HasSubstr("unknown key `peach` in [bed]"));
    const std::string list = "the keys in [bed] are";
    ASSERT_THAT(message, HasSubstr(list));
    EXPECT_EQ(message.find(list), message.rfind(list));
}

TEST(BadInput, KeyInTheWrongSectionIsSentHome) {
    EXPECT_THAT(error_of(smallest + "spacing = \"2 mm\"\n"),
                HasSubstr("`spacing` in [bed]: it belongs in [numerics]"));
    EXPECT_THAT(error_of("slope = 0.1\n" + smallest),
                HasSubstr("case.toml:1:1: unknown key `slope` before the first "
                          "section: it belongs in [channel]"));
    EXPECT_THAT(error_of(smallest + "title = \"x\"\n"), HasSubstr("it belongs before the first section"));
}

TEST(BadInput, UnknownSection) {
    EXPECT_THAT(error_of(smallest + "[turbulance]\nkappa = 0.4\n"),
                AllOf(StartsWith("case.toml:6:2: unknown section [turbulance]: did you mean [turbulence]?"),
                      HasSubstr("the sections are channel, bed, side_walls, turbulence")));
}

TEST(BadInput, SectionWrittenAsValue) {
    EXPECT_THAT(error_of("bed = \"spheres\"\n[channel]\nslope = 0\ndepth = 1\n"),
                HasSubstr("case.toml:1:1: `bed` is a section: write [bed] on a line of its own"));
}

TEST(BadInput, TableAndArrayWhereAValueBelongs) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "[1, 2]")),
                HasSubstr("3:9: [channel] depth = an array: expected a length"));
    EXPECT_THAT(error_of(smallest + "[[fluid]]\ndensity = 1\n"), HasSubstr("`fluid` is a section"));
}

TEST(BadInput, WrongUnitListsTheAcceptedOnes) {
    EXPECT_THAT(
        error_of(changed("\"50 mm\"", "\"50 s\"")),
        StartsWith(
            "case.toml:3:9: [channel] depth = \"50 s\": expected a length greater than 0; `s` is the unit "
            "of a time; write a number in m or a text with one of the units m, dm, cm, mm, um, km"));
    EXPECT_THAT(error_of(changed("\"50 mm\"", "\"50 inch\"")), HasSubstr("`inch` is no known unit"));
    EXPECT_THAT(error_of(changed("0.004", "\"0.004 m\"")),
                AllOf(HasSubstr("2:9: [channel] slope"), HasSubstr("expected a number (without unit)"),
                      HasSubstr("write a number without quotes")));
}

TEST(BadInput, MultipleOfDiameterOnlyForTheRoughnessHeight) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "\"2 D\"")), HasSubstr("`D` is no known unit"));
    EXPECT_THAT(error_of(changed("0.4 D", "0.4 E")),
                HasSubstr("or a multiple of the sphere diameter such as \"0.4 D\""));
    EXPECT_THAT(error_of(changed("0.4 D", "-0.4 D")), HasSubstr("5:20: [bed] roughness_height = \"-0.4 D\""));
}

TEST(BadInput, TextWithoutUnit) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "\"50\"")),
                HasSubstr("a text needs a unit (m, dm, cm, mm, um, km)"));
}

TEST(BadInput, WrongType) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "true")),
                HasSubstr("3:9: [channel] depth = true: expected a length"));
    EXPECT_THAT(error_of(smallest + "kind = 3\n"),
                HasSubstr("6:8: [bed] kind = 3: expected one of the words spheres,"));
    EXPECT_THAT(error_of(smallest + "[numerics]\nwall_layers = 2.5\n"), HasSubstr("expected a whole number"));
    EXPECT_THAT(error_of(smallest + "[measured]\nuniform = \"no\"\n"), HasSubstr("expected true or false"));
    EXPECT_THAT(error_of("title = 5\n" + smallest),
                HasSubstr("1:9: title = 5: expected a text; write it in quotes"));
    EXPECT_THAT(error_of(smallest + "[start]\nfile = 5\n"), HasSubstr("expected the name of a file"));
}

TEST(BadInput, NotFinite) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "nan")), HasSubstr("a finite number is needed"));
    EXPECT_THAT(error_of(changed("\"50 mm\"", "inf")), HasSubstr("a finite number is needed"));
    EXPECT_NE(error_of(changed("\"50 mm\"", "\"nan m\"")), "");
    EXPECT_NE(error_of(changed("\"50 mm\"", "\"1e999 m\"")), "");
}

TEST(BadInput, WordMisspelt) {
    EXPECT_THAT(
        error_of(smallest + "[turbulence]\nclosure = \"nezu-rody\"\n"),
        AllOf(StartsWith("case.toml:7:11: [turbulence] closure = \"nezu-rody\""),
              HasSubstr("none, ramp, nezu-rodi, nikuradse, sps"), HasSubstr("did you mean \"nezu-rodi\"?")));
    EXPECT_THAT(error_of(smallest + "[numerics]\nsound_speed = \"atuo\"\n"),
                HasSubstr("did you mean \"auto\"?"));
    EXPECT_THAT(error_of(smallest + "[run]\nuntil = \"convergence\"\n"),
                HasSubstr("did you mean \"converged\"?"));
}

TEST(BadInput, OutOfRange) {
    EXPECT_THAT(error_of(changed("\"50 mm\"", "\"-50 mm\"")),
                StartsWith("case.toml:3:9: [channel] depth = \"-50 mm\": expected a length greater than 0"));
    EXPECT_THAT(error_of(changed("\"50 mm\"", "0")), HasSubstr("expected a length greater than 0"));
    EXPECT_THAT(error_of(changed("0.004", "-0.004")), HasSubstr("at least 0 and at most 1"));
    EXPECT_THAT(error_of(changed("0.004", "4")), HasSubstr("at least 0 and at most 1"));
    EXPECT_THAT(error_of(smallest + "[numerics]\nxsph = 1.5\n"), HasSubstr("at least 0 and at most 1"));
    EXPECT_THAT(error_of(smallest + "[numerics]\nwall_layers = 5000000000\n"),
                HasSubstr("at least 1 and at most 10"));
}

TEST(BadInput, MissingRequiredKeys) {
    EXPECT_THAT(
        error_of("[fluid]\ngravity = 9.81\n"),
        AllOf(HasSubstr("case.toml: [channel] slope is missing"), HasSubstr("[channel] depth is missing"),
              HasSubstr("[bed] roughness_height is missing"), HasSubstr("for example depth = \"50 mm\"")));
    EXPECT_EQ(error_of("[channel]\nslope = 0.001\ndepth = 0.05\n[bed]\nkind = \"no-slip\"\n"), "");
}

TEST(BadInput, SyntaxErrorsHaveTheirLine) {
    EXPECT_THAT(error_of("[channel]\nslope = 0.004\nslope = 0.005\n"),
                AllOf(StartsWith("case.toml:3:"), HasSubstr("not TOML"), HasSubstr("may stand only once")));
    EXPECT_THAT(error_of("[channel]\nslope = 0.004\n[bed]\n[channel]\ndepth = 1\n"),
                AllOf(StartsWith("case.toml:4:"), HasSubstr("may stand only once")));
    EXPECT_THAT(error_of("[channel]\nslope = \n"), StartsWith("case.toml:2:"));
    EXPECT_THAT(
        error_of("[channel]\ndepth = 50 mm\n"),
        AllOf(StartsWith("case.toml:2:"), HasSubstr("a value with a unit stands in quotes: \"50 mm\"")));
    EXPECT_THAT(error_of("[bed]\nkind = spheres\n"),
                AllOf(StartsWith("case.toml:2:"), HasSubstr("a word stands in quotes")));
    EXPECT_THAT(error_of("[channel\nslope = 1\n"), StartsWith("case.toml:1:"));
}

TEST(BadInput, AllErrorsInOneMessageInTheOrderOfTheFile) {
    const std::string message = error_of(
        "[channel]\nslope = \"steep\"\ndepth = -1\n[bed]\nroughness_height = \"9 kg\"\nkind = \"sphere\"\n");
    const auto first = message.find("2:9: [channel] slope");
    const auto second = message.find("3:9: [channel] depth");
    const auto third = message.find("5:20: [bed] roughness_height");
    const auto fourth = message.find("6:8: [bed] kind");
    ASSERT_NE(fourth, std::string::npos) << message;
    EXPECT_LT(first, second);
    EXPECT_LT(second, third);
    EXPECT_LT(third, fourth);
}

TEST(BadInput, SpacingLargerThanTheRoughness) {
    EXPECT_THAT(
        error_of(smallest + "[numerics]\nspacing = \"12 mm\"\n"),
        HasSubstr("case.toml:7:11: [numerics] spacing is 12 mm, larger than the roughness height 10 mm"));
    EXPECT_THAT(error_of(changed("0.4 D", "5 mm"), {{"numerics.spacing", "6 mm"}}),
                HasSubstr("[numerics] spacing is 6 mm, larger than the roughness height 5 mm"));
}

TEST(BadInput, ChannelTooLongForThePositions) {
    EXPECT_THAT(error_of(smallest, {{"channel.length", "100 m"}, {"numerics.spacing", "2 mm"}}),
                HasSubstr("[channel] length is 100 m: at a spacing of 2 mm the positions, 32-bit integers, "
                          "resolve channels of up to 85.8993 m"));
    EXPECT_EQ(error_of(smallest, {{"channel.length", "85 m"}, {"numerics.spacing", "2 mm"}}), "");
}

TEST(BadInput, RoughnessZoneThatNoSphereFills) {
    EXPECT_THAT(error_of(changed("0.4 D", "1.2 D")), HasSubstr("more than the sphere diameter 25 mm"));
    EXPECT_THAT(error_of(changed("\"0.4 D\"", "0")), HasSubstr("a bed of spheres needs a roughness zone"));
    EXPECT_THAT(error_of(smallest + "datum_below_crest = \"11 mm\"\n"), HasSubstr("below the bed level"));
}

TEST(BadInput, SmoothBedWithRoughness) {
    EXPECT_THAT(
        error_of(smallest + "datum_below_crest = \"4 mm\"\nkind = \"no-slip\"\n[start]\nkind = \"rest\"\n"),
        AllOf(HasSubstr("5:20: [bed] roughness_height is 10 mm, but a plane bed (kind = \"no-slip\")"),
              HasSubstr("6:21: [bed] datum_below_crest is 4 mm")));
}

TEST(BadInput, ReachTooShortForPeriodicEnds) {
    // 2 (2 h + 0.3 h) with h = 3 mm: 13.8 mm.
    EXPECT_THAT(
        error_of(changed("slope = 0.004", "slope = 0.004\nlength = \"13.7 mm\"")),
        HasSubstr("case.toml:3:10: [channel] length is 13.7 mm: periodic ends need at least 13.8 mm"));
    EXPECT_EQ(error_of(changed("slope = 0.004", "slope = 0.004\nlength = \"13.9 mm\"")), "");
}

TEST(BadInput, StartsThatCannotBe) {
    EXPECT_THAT(error_of(smallest + "[start]\nkind = \"results\"\n"), HasSubstr("[start] file is missing"));
    EXPECT_THAT(error_of(smallest + "[start]\nkind = \"standing-wave\"\n"), HasSubstr("needs an amplitude"));
    EXPECT_THAT(error_of(smallest + "[start]\nkind = \"taylor-green\"\nvelocity = 1\n"),
                HasSubstr("needs [channel] top = \"periodic\""));
    EXPECT_THAT(error_of("[channel]\nslope = 0.004\ndepth = 0.05\n[bed]\nkind = \"slip\"\n"),
                HasSubstr("nothing resists the flow down the slope"));
}

TEST(BadInput, ClosedAndPeriodicTops) {
    EXPECT_THAT(error_of(changed("slope = 0.004", "slope = 0.004\ntop = \"wall\"")),
                HasSubstr("goes with a smooth bed"));
    EXPECT_THAT(
        error_of("[channel]\nslope = 0\ndepth = 0.05\ntop = \"periodic\"\nends = \"walls\"\n[bed]\nkind = "
                 "\"slip\"\n[start]\nkind = \"rest\"\n[run]\nuntil = 1\n"),
        AllOf(HasSubstr("needs ends = \"periodic\""), HasSubstr("gravity must be 0")));
}

TEST(BadInput, RunThatAveragesNothing) {
    EXPECT_THAT(error_of(smallest + "[run]\nuntil = \"10 s\"\naverage_from = \"10 s\"\n"),
                HasSubstr("nothing would be"));
    EXPECT_THAT(error_of(changed("0.004", "0")), HasSubstr("needs a flow that becomes steady"));
}

TEST(BadInput, MaximumTimeGoesOnlyWithConverged) {
    const std::string text = smallest + "[run]\nuntil = \"10 s\"\nmaximum_time = \"20 s\"\n";
    EXPECT_THAT(error_of(text),
                HasSubstr("8:16: [run] maximum_time goes only with run.until = \"converged\""));
    // But an option that gives a time supersedes what the file says for the converged run.
    EXPECT_EQ(error_of(smallest + "[run]\nmaximum_time = \"20 s\"\n", {{"run.until", "1s"}}), "");
}

// The reason is the outer one: without open ends there is no outflow whose kind would be another.
TEST(BadInput, AKeyOfWhatIsNotThereNamesTheOutermostCondition) {
    EXPECT_THAT(error_of(smallest + "[outflow]\nkind = \"depth\"\ndepth = \"50 mm\"\n"),
                HasSubstr("[outflow] depth goes only with channel.ends = \"open\""));
}

class BadFiles : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    std::filesystem::path folder_;
};

TEST_F(BadFiles, MissingCaseFile) {
    try {
        const Case c = read_case(folder_ / "nowhere.toml");
        FAIL() << "read a missing file";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("nowhere.toml: there is no such case file"), HasSubstr("riffle new")));
        EXPECT_EQ(error.code(), ExitCode::file_error);
    }
}

TEST_F(BadFiles, FolderInsteadOfAFile) { EXPECT_THROW((void)read_case(folder_), FileError); }

TEST_F(BadFiles, EmptyFileMissesItsRequiredKeys) {
    EXPECT_THROW((void)read_case(write("a.toml", "")), InputError);
}

TEST_F(BadFiles, MissingStartAndProfileFiles) {
    const auto path = write("a.toml", smallest +
                                          "[start]\nkind = \"results\"\nfile = \"old.h5\"\n[measured]\n"
                                          "velocity_profile = \"u.csv\"\n");
    try {
        const Case c = read_case(path);
        FAIL() << "accepted missing files";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("a.toml:8:8: [start] file ="), HasSubstr("old.h5\": there is no such"),
                          HasSubstr("a.toml:10:20: [measured] velocity_profile")));
    }
}

TEST_F(BadFiles, FilesAreFoundFromTheFolderOfTheCase) {
    const auto profile = write("u.csv", "z,u\n");
    const auto path = write("a.toml", smallest + "[measured]\nvelocity_profile = \"u.csv\"\n");
    const Case c = read_case(path);
    EXPECT_TRUE(c.measured.velocity_profile.is_absolute());
    EXPECT_TRUE(std::filesystem::equivalent(c.measured.velocity_profile, profile));
    EXPECT_EQ(c.path, path);
    // The text of a results file is read where those files may be gone.
    std::filesystem::remove(profile);
    EXPECT_EQ(parse_case(c.text, "results.h5").measured.velocity_profile, c.measured.velocity_profile);
}

}  // namespace
}  // namespace riffle::bad_input_test
