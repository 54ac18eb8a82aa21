#include "laboratory/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "laboratory/unit.hpp"
#include "laboratory_file.hpp"

namespace riffle::csv_table_test {
namespace {

using ::testing::HasSubstr;
using testing::message_of;

TEST(LaboratoryUnit, ReadsProductsAndPowers) {
    struct Example {
        const char* text;
        double si;
        const char* dimension;
    };
    for (const Example& e :
         {Example{"mm", 1e-3, "m"}, Example{"cm/s", 1e-2, "m/s"}, Example{"m s-1", 1, "m/s"},
          Example{"m^2/s^2", 1, "m2/s2"}, Example{"cm2/s2", 1e-4, "m2/s2"}, Example{"mm/V", 1e-3, "m/V"},
          Example{"1/s", 1, "Hz"}, Example{"kHz", 1e3, "Hz"}, Example{"min", 60, "s"},
          Example{"%", 0.01, "1"}, Example{"-", 1, "1"}, Example{"\u00b5m", 1e-6, "m"},
          Example{"mm\u00b2/s\u00b2", 1e-6, "m2/s2"}, Example{"N/m2", 1, "Pa"}, Example{"mV", 1e-3, "V"}}) {
        const auto unit = parse_unit(e.text);
        ASSERT_TRUE(unit) << e.text;
        EXPECT_DOUBLE_EQ(unit->to_si(1.0), e.si) << e.text;
        EXPECT_TRUE(unit->same_dimension(*parse_unit(e.dimension))) << e.text;
    }
    EXPECT_EQ(parse_unit("mm")->to_si(35), 0.035);  // to the last bit
    for (const char* wrong : {"inch", "mm/", "m//s", "m^", "mmm", "/s", "m2x"}) {
        EXPECT_FALSE(parse_unit(wrong)) << wrong;
    }
}

TEST(LaboratoryUnit, ReadsQuantities) {
    EXPECT_EQ(parse_quantity(" 28 mm ", "m"), std::optional<double>(0.028));
    EXPECT_EQ(parse_quantity("-1.5e2cm/s", "m/s"), std::optional<double>(-1.5));
    EXPECT_EQ(parse_quantity("3", "m"), std::optional<double>(3.0));
    EXPECT_FALSE(parse_quantity("3 s", "m"));
    EXPECT_FALSE(parse_quantity("about 3", "m"));
}

TEST(CsvTable, TakesEachSeparatorAndKeepsNamesAndUnits) {
    for (const char* text : {"z [mm],u (m/s)\n1,0.5\n2,0.75\n", "z [mm];u (m/s)\n1;0.5\n2;0.75\n",
                             "z [mm]\tu (m/s)\n1\t0.5\n2\t0.75\n",
                             "\xEF\xBB\xBF# note\r\n\r\n\"z [mm]\" , u (m/s)\r\n 1 ,+0.5\r\n2,7.5e-1"}) {
        const CsvTable table = parse_csv_table(text, "f.csv");
        ASSERT_EQ(table.columns.size(), 2U) << text;
        EXPECT_EQ(table.columns[0].name, "z");
        EXPECT_EQ(table.columns[0].unit, "mm");
        EXPECT_EQ(table.columns[1].name, "u");
        EXPECT_EQ(table.columns[1].unit, "m/s");
        EXPECT_EQ(table.columns[1].values, (std::vector<double>{0.5, 0.75}));
        EXPECT_EQ(column_in_si(table, 0, "m"), (std::vector<double>{0.001, 0.002}));
    }
}

TEST(CsvTable, KeepsCommentsAndLines) {
    const CsvTable table = parse_csv_table("# Depth: 50 mm\n#free text\n1,2\n# probe = 3\n\n3,4\n", "f.csv");
    EXPECT_EQ(table.header_line, 0);
    EXPECT_EQ(table.comment_value("depth"), std::optional<std::string>("50 mm"));
    EXPECT_EQ(table.comment_value("Probe"), std::optional<std::string>("3"));
    EXPECT_FALSE(table.comment_value("text"));
    EXPECT_EQ(table.lines, (std::vector<int>{3, 6}));
    EXPECT_EQ(table.place(1), "f.csv:6");
}

TEST(CsvTable, CountsMissingValuesWhereTheyAreAllowed) {
    const char* text = "a,b\n1,\nNaN,2\n3,4\n";
    const CsvTable table = parse_csv_table(text, "f.csv", MissingValues::allowed);
    EXPECT_EQ(table.missing, 2U);
    EXPECT_TRUE(std::isnan(table.columns[1].values[0]));
    EXPECT_THAT(message_of([&] { return parse_csv_table(text, "f.csv"); }),
                HasSubstr("f.csv:2: expected a number in column 2 (b), it is missing"));
    // The last field of a line that ends with a tab.
    EXPECT_EQ(parse_csv_table("a\tb\n1\t\n", "f.csv", MissingValues::allowed).missing, 1U);
}

TEST(CsvTable, SaysWhereAndWhatIsWrong) {
    const auto message = [](const char* text) {
        return message_of([text] { return parse_csv_table(text, "f.csv", MissingValues::allowed); });
    };
    EXPECT_THAT(message("z,u\n1,2\n3,x\n"),
                HasSubstr("f.csv:3: expected a number in column 2 (u), got \"x\""));
    EXPECT_THAT(message("z,u\n1,2\n3\n"),
                HasSubstr("f.csv:3: expected 2 columns as in the lines before, got 1"));
    EXPECT_THAT(message("z;u\n1;2\n3;0,5\n"), HasSubstr("write decimals with a point"));
    EXPECT_THAT(message("z,u\n1 2,3\n"), HasSubstr("separate columns by"));
    EXPECT_THAT(message("z,z\n1,2\n"), HasSubstr("f.csv:1: two columns are named \"z\""));
    EXPECT_THAT(message("z,\n1,2\n"), HasSubstr("f.csv:1: expected a name for column 2"));
    EXPECT_THAT(message("z,\"u\n1,2\n"), HasSubstr("f.csv:1: expected a closing double quote"));
    EXPECT_THAT(message("z,u\n1,inf\n"), HasSubstr("f.csv:2: expected a number"));
    EXPECT_THAT(message("# nothing\nz,u\n"), HasSubstr("f.csv: expected lines of numbers, found none"));
    EXPECT_THAT(message(""), HasSubstr("found none"));
    EXPECT_THAT(message_of([] { return read_csv_table("/nowhere/f.csv"); }), HasSubstr("cannot be read"));
    EXPECT_THAT(message_of([] { return read_csv_table("/tmp"); }), HasSubstr("cannot be read"));
}

TEST(CsvTable, RefusesUnitsThatDoNotFit) {
    const CsvTable table = parse_csv_table("z [mm],u,w [inch/s]\n1,2,3\n", "f.csv");
    const auto message = [&](std::size_t column, const char* unit) {
        return message_of([&] { return column_in_si(table, column, unit); });
    };
    EXPECT_THAT(message(0, "s"), HasSubstr("f.csv:1: expected a unit like [s] for column 1 (z), got [mm]"));
    EXPECT_THAT(message(2, "m/s"), HasSubstr("got [inch/s]"));
    // Millimetres beside a column without unit: which unit that is in cannot be known.
    EXPECT_THAT(message(1, "m/s"), HasSubstr("expected a unit for column 2 (u)"));
    const CsvTable si = parse_csv_table("z [m],u\n1,2\n", "f.csv");
    EXPECT_EQ(column_in_si(si, 1, "m/s"), (std::vector<double>{2}));
}

}  // namespace
}  // namespace riffle::csv_table_test
