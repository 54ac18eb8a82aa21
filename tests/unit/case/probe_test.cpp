// [[probe]]: what a case file says of its instruments, and what is refused.

#include "case/case_documents.hpp"
#include "case_test.hpp"

namespace riffle::probe_test {
namespace {

using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A probe that is right, with lines added; its first line is line 6 of the file.
std::string with_probe(const std::string& kind, const std::string& lines, const std::string& name = "adv") {
    return smallest + "[[probe]]\nname = \"" + name + "\"\nkind = \"" + kind +
           "\"\nsampling_frequency = \"100 Hz\"\n" + lines;
}

TEST(Probes, AreReadInTheirOrderWithTheirUnits) {
    const Case c =
        parse_case(with_probe("velocity", "x = \"10 cm\"\nz = [\"20 mm\", 0.03]\nstart = \"2 s\"\n") +
                       "[[probe]]\nname = \"piv\"\nkind = \"grid\"\nsampling_frequency = 15\n"
                       "averaging_time = \"5 s\"\nspacing = \"4 mm\"\n",
                   "case.toml");
    ASSERT_EQ(c.probes.size(), 2U);
    EXPECT_EQ(c.probes[0].name, "adv");
    EXPECT_EQ(c.probes[0].kind, ProbeKind::velocity);
    EXPECT_DOUBLE_EQ(c.probes[0].sampling_frequency, 100.0);
    EXPECT_DOUBLE_EQ(c.probes[0].start, 2.0);
    EXPECT_THAT(c.probes[0].x, ElementsAre(0.1));
    EXPECT_THAT(c.probes[0].z, ElementsAre(0.02, 0.03));
    EXPECT_EQ(c.probes[1].kind, ProbeKind::grid);
    EXPECT_EQ(c.probes[1].spacing, 0.004);
    EXPECT_EQ(c.probes[1].x_from, std::nullopt);
    EXPECT_THAT(c.probe_places, ElementsAre("case.toml:6:1", "case.toml:13:1"));
    EXPECT_TRUE(parse_case(c.text, "text").same_parameters(c));
    EXPECT_TRUE(parse_case(case_template(c), "template").same_parameters(c));
}

TEST(Probes, NeedNameKindAndFrequency) {
    EXPECT_THAT(error_of(smallest + "[[probe]]\nstart = 1\n"),
                AllOf(StartsWith("case.toml:6:1: [[probe]] name is missing"),
                      HasSubstr("6:1: [[probe]] kind is missing"),
                      HasSubstr("6:1: [[probe]] sampling_frequency is missing"),
                      HasSubstr("for example sampling_frequency = \"100 Hz\"")));
}

TEST(Probes, OfAnUnknownKindAreRefusedWithoutFurtherComplaints) {
    EXPECT_THAT(
        error_of(with_probe("wav", "x = 0.1\n")),
        AllOf(StartsWith("case.toml:8:8: [[probe]] kind = \"wav\": expected one of the words velocity, wave"),
              HasSubstr("did you mean \"wave\"?"), Not(HasSubstr("goes only"))));
}

TEST(Probes, UnknownKeysAndKeysOfOtherKinds) {
    EXPECT_THAT(
        error_of(with_probe("wave", "X = 0.1\n")),
        AllOf(HasSubstr("case.toml:10:1: unknown key `X` in [[probe]]"), HasSubstr("did you mean `x`?")));
    EXPECT_THAT(error_of(with_probe("wave", "x = 0.1\nz = 0.02\n")),
                HasSubstr("11:5: [[probe]] z goes only with probe.kind = \"velocity\""));
    EXPECT_THAT(error_of(with_probe("force", "x = 0.1\n")),
                HasSubstr("x goes only with probe.kind = \"velocity\", \"wave\", \"flow_rate\""));
}

TEST(Probes, NamesAreUniqueAndNotThoseOfTheStandardSet) {
    EXPECT_THAT(error_of(with_probe("force", "") + "[[probe]]\nname = \"adv\"\nkind = \"force\"\n"
                                                   "sampling_frequency = 10\n"),
                StartsWith("case.toml:11:8: [[probe]] name = \"adv\" is that of another probe already"));
    EXPECT_THAT(error_of(with_probe("force", "", "standard_force")),
                AllOf(StartsWith("case.toml:7:8: [[probe]] name = \"standard_force\""),
                      HasSubstr("output.standard_probes = false")));
    EXPECT_THAT(error_of(with_probe("force", "", "a/b")),
                StartsWith("case.toml:7:8: [[probe]] name: expected letters"));
    EXPECT_THAT(error_of(with_probe("force", "", "")), HasSubstr("name: expected letters"));
}

TEST(Probes, StandInTheWater) {
    EXPECT_THAT(
        error_of(with_probe("wave", "x = [0, \"300.3 mm\"]\n")),
        StartsWith("case.toml:10:5: [[probe]] x = 300.3 mm is outside of the channel: expected 0 to its "
                   "length 200 mm"));
    EXPECT_THAT(error_of(with_probe("velocity", "x = 0.1\nz = \"2 m\"\n")),
                StartsWith("case.toml:11:5: [[probe]] z = 2 m is outside of the water"));
    EXPECT_THAT(error_of(with_probe("velocity", "x = 0.1\nz = 0\n")),
                HasSubstr("more than 0 (the bed level)"));
    EXPECT_THAT(error_of(with_probe("velocity", "x = 0.1\n")), HasSubstr("6:1: [[probe]] z is missing"));
    EXPECT_THAT(error_of(with_probe("wave", "")), HasSubstr("6:1: [[probe]] x is missing"));
    EXPECT_THAT(error_of(with_probe("wave", "x = []\n")), HasSubstr("10:5: [[probe]] x = []"));
    EXPECT_THAT(error_of(with_probe("velocity", "x = [0.1, 0.2]\nz = [0.01, 0.02, 0.03]\n")),
                HasSubstr("2 values of x and 3 of z"));
    EXPECT_THAT(error_of(with_probe("wave", "x = [0.1, \"5 s\"]\n")),
                HasSubstr("10:5: [[probe]] x = \"5 s\": expected a length, or a list of them"));
}

TEST(Probes, GridsAndLinesAreNotTooFine) {
    EXPECT_THAT(error_of(with_probe("grid", "spacing = \"0.2 mm\"\n")),
                StartsWith("case.toml:10:11: [[probe]] spacing is 0.2 mm, too fine"));
    EXPECT_THAT(error_of(with_probe("surface_line", "spacing = \"0.2 mm\"\n")), HasSubstr("too fine"));
    EXPECT_THAT(error_of(with_probe("grid", "x_from = \"0.15\"\n")), HasSubstr("a text needs a unit"));
    EXPECT_THAT(error_of(with_probe("grid", "x_from = 0.15\nx_to = 0.1\n")),
                HasSubstr("11:8: [[probe]] x_to lies before"));
    EXPECT_THAT(error_of(with_probe("grid", "averaging_time = \"10 ms\"\n")),
                HasSubstr("less than two samples"));
    EXPECT_THAT(error_of(with_probe("grid", "averaging_time = \"1 h\"\n")), HasSubstr("no window would end"));
}

TEST(Probes, MeasureNothingThatIsNotThere) {
    const std::string plates =
        "[channel]\nslope = 0.004\ndepth = 0.05\ntop = \"wall\"\n[bed]\nkind = \"no-slip\"\n"
        "[start]\nkind = \"rest\"\n[run]\nuntil = \"1 s\"\n[[probe]]\nname = \"w\"\n";
    EXPECT_THAT(error_of(plates + "kind = \"wave\"\nsampling_frequency = 50\nx = 0.1\n"),
                HasSubstr("kind = \"wave\": the water of this case has no free surface"));
    EXPECT_THAT(error_of(plates + "kind = \"force\"\nsampling_frequency = 50\nstart = \"2 s\"\n"),
                HasSubstr("start is 2 s, not before the end of the run at 1 s"));
    EXPECT_EQ(error_of(plates + "kind = \"force\"\nsampling_frequency = 50\n"), "");
}

TEST(Probes, StandUnderDoubleBrackets) {
    EXPECT_THAT(error_of(smallest + "[probe]\nname = \"a\"\n"),
                HasSubstr("`probe` is a section that may stand several times: write [[probe]]"));
    EXPECT_THAT(error_of(smallest, {{"probe.x", "0.1"}}),
                HasSubstr("--set probe.x=0.1: the case has no [[probe]]"));
    EXPECT_THAT(error_of(smallest + "[measured]\nsampling_frequency = 5\n"),
                HasSubstr("it belongs in [[probe]]"));
}

}  // namespace
}  // namespace riffle::probe_test
