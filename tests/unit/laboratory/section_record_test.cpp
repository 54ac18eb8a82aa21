// Profiles across a channel and points of a cross-section.

#include "laboratory/section_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "laboratory_file.hpp"

namespace riffle::section_record_test {
namespace {

using ::testing::HasSubstr;
using testing::LaboratoryFile;
using testing::message_of;
using Q = ProfileQuantity;

TEST(SectionRecord, AProfileAcrossTheChannelAtOneHeight) {
    const LaboratoryFile file(
        "# title: condition 2, 12 mm\n# z: 12 mm\ny [mm],-u'w' [cm2/s2],u [cm/s],SNR\n"
        "20,18,30,14\n10,12,25,15\n30,21,,15\n");
    const SectionRecord record = read_section_record(file.path());
    EXPECT_EQ(record.title, "condition 2, 12 mm");
    EXPECT_EQ(record.origin, LateralOrigin::wall);
    EXPECT_EQ(record.y, (std::vector<double>{0.01, 0.02, 0.03}));
    EXPECT_EQ(record.z, (std::vector<double>{0.012, 0.012, 0.012}));
    EXPECT_DOUBLE_EQ(record.find(Q::reynolds_stress)->values[0], 12e-4);
    EXPECT_TRUE(std::isnan(record.find(Q::velocity)->values[2]));
    EXPECT_EQ(record.lines, (std::vector<int>{5, 4, 6}));
    ASSERT_EQ(record.warnings.size(), 2U);
    EXPECT_THAT(record.warnings[0], HasSubstr("column 4 (SNR) is not used"));
    EXPECT_THAT(record.warnings[1], HasSubstr("u: 1 of 3 points"));
}

TEST(SectionRecord, PointsAllOverTheSectionAreSortedByHeight) {
    const LaboratoryFile file(
        "# y_from: centreline\ny [m];z [m];u [m/s];u_uncertainty [m/s]\n-0.1;0.02;0.3;0.01\n"
        "0.1;0.01;0.2;0.02\n-0.1;0.01;0.25;0.01\n");
    const SectionRecord record = read_section_record(file.path());
    EXPECT_EQ(record.origin, LateralOrigin::centreline);
    EXPECT_EQ(record.y, (std::vector<double>{-0.1, 0.1, -0.1}));
    EXPECT_EQ(record.z, (std::vector<double>{0.01, 0.01, 0.02}));
    EXPECT_EQ(record.find(Q::velocity)->values, (std::vector<double>{0.25, 0.2, 0.3}));
    EXPECT_EQ(record.find(Q::velocity)->uncertainty[1], 0.02);
}

TEST(SectionRecord, MeansOverTheDepthHaveNoHeight) {
    const LaboratoryFile file("# z: depth mean\ny,u\n0.2,0.3\n0.1,0.25\n");
    const SectionRecord record = read_section_record(file.path());
    EXPECT_TRUE(std::isnan(record.z[0]));
    EXPECT_EQ(record.y, (std::vector<double>{0.1, 0.2}));
}

TEST(SectionRecord, SaysWhatIsWrongAndWhere) {
    const auto message = [](const char* text) {
        const LaboratoryFile file(text);
        return message_of([&] { return read_section_record(file.path()); });
    };
    EXPECT_THAT(message("y,u\n0.1,0.2\n"), HasSubstr("a column z, or a comment \"# z: 12 mm\""));
    EXPECT_THAT(message("# z: high\ny,u\n0.1,0.2\n"), HasSubstr("got \"high\""));
    EXPECT_THAT(message("# z: 1 cm\n# y_from: left\ny,u\n0.1,0.2\n"),
                HasSubstr("\"wall\" or \"centreline\""));
    EXPECT_THAT(
        message("# z: 1 cm\ny,u\n0.1,0.2\n0.2,0.3\n0.1,0.25\n"),
        HasSubstr(":5: expected one point for each place; y = 0.1 m at this height is also in line 3"));
    EXPECT_THAT(message("y,z,u\n0.1,,0.2\n"), HasSubstr(":2: expected a height z"));
    EXPECT_THAT(message("z,u\n0.1,0.2\n"), HasSubstr("expected a column y"));
}

}  // namespace
}  // namespace riffle::section_record_test
