// Options that change single keys, those of one of several sections too.

#include "case/overrides.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case_test.hpp"

namespace riffle::overrides_test {
namespace {

using test::error_of;
using test::smallest;
using ::testing::HasSubstr;

const std::string reed_beds = smallest + R"(
[start]
kind = "rest"

[[vegetation]]
name = "reeds"
stems_per_area = 400
stem_diameter = "5 mm"
height = "20 mm"
x_from = "0 mm"
x_to = "20 mm"

[[vegetation]]
name = "no. 2.5"
stems_per_area = 300
stem_diameter = "5 mm"
height = "20 mm"
x_from = "30 mm"
x_to = "50 mm"
)";

TEST(Overrides, ReachOneOfSeveralSectionsByItsName) {
    const Case c = parse_case(reed_beds, "test", {}, {{"vegetation.reeds.stems_per_area", "500"}});
    EXPECT_EQ(c.vegetation[0].stems_per_area, 500.0);
    EXPECT_EQ(c.vegetation[1].stems_per_area, 300.0);
    // A name may have dots, and what is not given is added.
    const Case other = parse_case(
        reed_beds, "test", {},
        {{"vegetation.no. 2.5.stems_per_area", "200"}, {"vegetation.no. 2.5.drag_coefficient", "1.2"}});
    EXPECT_EQ(other.vegetation[0].stems_per_area, 400.0);
    EXPECT_EQ(other.vegetation[1].stems_per_area, 200.0);
    EXPECT_EQ(other.vegetation[1].drag_coefficient, 1.2);
}

TEST(Overrides, ApplyInTheirOrder) {
    const Case c =
        parse_case(reed_beds, "test", {},
                   {{"vegetation.reeds.name", "rushes"}, {"vegetation.rushes.stems_per_area", "500"}});
    EXPECT_EQ(c.vegetation[0].name, "rushes");
    EXPECT_EQ(c.vegetation[0].stems_per_area, 500.0);
}

TEST(Overrides, SayWhichSectionsThereAre) {
    EXPECT_THAT(
        error_of(reed_beds, {{"vegetation.stems_per_area", "5"}}),
        HasSubstr("--set vegetation.stems_per_area=5: which [[vegetation]] is meant: those of the case are "
                  "\"reeds\", \"no. 2.5\"; write vegetation.NAME.stems_per_area"));
    EXPECT_THAT(error_of(reed_beds, {{"vegetation.reed.stems_per_area", "5"}}),
                HasSubstr("no [[vegetation]] of the case is named \"reed\": those of the case are"));
    EXPECT_THAT(error_of(smallest, {{"vegetation.reeds.stems_per_area", "5"}}),
                HasSubstr("the case has no [[vegetation]]: options change those that it has, they add none"));
    EXPECT_THAT(error_of(reed_beds, {{"vegetation.reeds.stems", "5"}}), HasSubstr("unknown key `stems`"));
    // What is wrong with a value that an option gave is said of the option.
    EXPECT_THAT(error_of(reed_beds, {{"vegetation.reeds.stems_per_area", "-5"}}),
                HasSubstr("--set vegetation.reeds.stems_per_area=-5: "));
}

TEST(Overrides, FindTheKeyThatTheyName) {
    const Case c = parse_case(reed_beds, "test");
    const KeyItem found = find_option_key(c, "vegetation.no. 2.5.stems_per_area");
    ASSERT_NE(found.key, nullptr);
    EXPECT_EQ(found.key->name, "stems_per_area");
    EXPECT_EQ(found.item, 1U);
    EXPECT_EQ(find_option_key(c, "vegetation.rushes.stems_per_area").key, nullptr);
    EXPECT_EQ(find_option_key(c, "numerics.spacing").key->name, "spacing");
}

}  // namespace
}  // namespace riffle::overrides_test
