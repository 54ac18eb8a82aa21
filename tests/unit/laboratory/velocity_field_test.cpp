// Fields and frames of image velocimetry, in Riffle's own tables and as other programs export them.

#include "laboratory/velocity_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "laboratory_file.hpp"

namespace riffle::velocity_field_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::LaboratoryFile;
using testing::message_of;

TEST(VelocityField, ATableOfMeansWithUncertainties) {
    const LaboratoryFile file(
        "# title: condition 2\n# z_offset: 4 mm\nx [mm],z [mm],u [m/s],w [m/s],u_uncertainty [m/s]\n"
        "5,10,0.30,0.001,0.01\n0,10,0.31,0,0.02\n0,20,0.40,0,0.01\n");
    const VelocityField field = read_velocity_field(file.path());
    EXPECT_EQ(field.title, "condition 2");
    EXPECT_EQ(field.frames, 1U);
    EXPECT_EQ(field.x, (std::vector<double>{0.0, 0.005}));
    ASSERT_EQ(field.z.size(), 2U);
    EXPECT_DOUBLE_EQ(field.z[0], 0.014);
    EXPECT_EQ(field.u[0], 0.31);
    EXPECT_EQ(field.u[1], 0.30);
    EXPECT_EQ(field.u[2], 0.40);
    EXPECT_TRUE(std::isnan(field.u[3]));  // no vector there
    EXPECT_EQ(field.u_uncertainty[0], 0.02);
    EXPECT_THAT(field.w_uncertainty, IsEmpty());
    EXPECT_THAT(field.time, IsEmpty());
}

TEST(VelocityField, FramesBelowEachOther) {
    const LaboratoryFile file(
        "t [s];x [m];z [m];u [m/s];w "
        "[m/s]\n0;0;0.01;0.1;0\n0;0.1;0.01;0.2;0\n0;0;0.02;0.3;0\n0;0.1;0.02;0.4;0\n"
        "0.5;0;0.01;0.5;0\n0.5;0.1;0.01;0.6;0\n0.5;0;0.02;0.7;0\n0.5;0.1;0.02;0.8;0\n");
    const VelocityField field = read_velocity_field(file.path());
    EXPECT_EQ(field.frames, 2U);
    EXPECT_EQ(field.time, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(field.u, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}));
}

// The columns and heading that OpenPIV's tools.save() writes.
TEST(VelocityField, TheTextOfOpenPiv) {
    const LaboratoryFile file(
        "# x\ty\tu\tv\tflags\tmask\n1.2000e+01\t8.0000e+00\t3.1000e+02\t1.0000e+00\t0.0000e+00\t0.0000e+00\n"
        "2.4000e+01\t8.0000e+00\t9.9000e+02\t0.0000e+00\t1.0000e+00\t0.0000e+00\n"
        "1.2000e+01\t4.0000e+00\t2.5000e+02\t0.0000e+00\t2.0000e+00\t0.0000e+00\n"
        "2.4000e+01\t4.0000e+00\t0.0000e+00\t0.0000e+00\t0.0000e+00\t1.0000e+00\n# units: mm, mm/s\n");
    const VelocityField field = read_velocity_field(file.path());
    ASSERT_EQ(field.points(), 4U);
    EXPECT_DOUBLE_EQ(field.z[0], 0.004);
    EXPECT_DOUBLE_EQ(field.u[0], 0.25);   // interpolated there, and kept
    EXPECT_TRUE(std::isnan(field.u[1]));  // masked
    EXPECT_DOUBLE_EQ(field.u[2], 0.31);
    EXPECT_DOUBLE_EQ(field.w[2], 0.001);
    EXPECT_TRUE(std::isnan(field.u[3]));  // invalid
    EXPECT_THAT(field.warnings, ::testing::ElementsAre("2 of 4 vectors are marked as none and left out"));
}

// DaVis: the units stand in the first line; zeros stand for no vector; decimals as the computer writes them.
TEST(VelocityField, TheTextOfDaVis) {
    const LaboratoryFile file(
        "#DaVis 8.4.0 2D-vector 16 2 2 \"x\" \"mm\" \"y\" \"mm\" \"velocity\" \"m/s\"\n"
        "0,0\t20,5\t0,40\t0,01\n2,5\t20,5\t0,42\t0,0\n0,0\t18,0\t0,35\t0,0\n2,5\t18,0\t0\t0\n");
    const VelocityField field = read_velocity_field(file.path());
    EXPECT_EQ(field.x, (std::vector<double>{0.0, 0.0025}));
    EXPECT_DOUBLE_EQ(field.z[1], 0.0205);
    EXPECT_DOUBLE_EQ(field.u[2], 0.40);
    EXPECT_DOUBLE_EQ(field.w[2], 0.01);
    EXPECT_TRUE(std::isnan(field.u[1]));
}

TEST(VelocityField, ColumnsBetweenBlanksAndAxesTurnedRound) {
    const LaboratoryFile file(
        "# flow: -x\n# z_axis: down\n# units: m, m/s\nx y u v\n 0.0  -0.02  -0.3 0.01\n 0.1  -0.02  -0.4 "
        "0.0\n"
        " 0.0  -0.01  -0.2 0.0\n 0.1  -0.01  -0.25 0.0\n");
    const VelocityField field = read_velocity_field(file.path());
    EXPECT_EQ(field.x, (std::vector<double>{-0.1, 0.0}));
    EXPECT_EQ(field.z, (std::vector<double>{0.01, 0.02}));
    EXPECT_EQ(field.u[3], 0.3);
    EXPECT_EQ(field.w[3], -0.01);
}

/// A folder of frames, made for a test.
class Folder {
  public:
    Folder() {
        const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::path(::testing::TempDir()) /
                (std::string(test->test_suite_name()) + "." + test->name());
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    void add(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::string frame(double u, const std::string& more = {}) {
    const std::string value = std::to_string(u);
    return more + "x [m],z [m],u [m/s],w [m/s]\n0,0.01," + value + ",0\n0.1,0.01," + value + ",0\n0,0.02," +
           value + ",0\n0.1,0.02," + value + ",0\n";
}

TEST(VelocityField, AFolderOfFramesInTheOrderOfTheirNumbers) {
    const Folder folder;
    folder.add("b10.csv", frame(3.0));
    folder.add("b9.csv", frame(2.0));
    folder.add("b1.csv", frame(1.0));
    folder.add("notes.md", "no frame");
    const VelocityField field = read_velocity_field(folder.path(), 20.0);
    EXPECT_EQ(field.frames, 3U);
    EXPECT_EQ(field.time, (std::vector<double>{0.0, 0.05, 0.1}));
    EXPECT_EQ(field.u[0], 1.0);
    EXPECT_EQ(field.u[4], 2.0);
    EXPECT_EQ(field.u[8], 3.0);
    EXPECT_THAT(read_velocity_field(folder.path()).time, IsEmpty());
}

TEST(VelocityField, SaysWhatIsWrongAndWhere) {
    const auto message = [](const std::string& text) {
        const LaboratoryFile file(text);
        return message_of([&] { return read_velocity_field(file.path()); });
    };
    EXPECT_THAT(message("x,z,u\n0,0.1,1\n"), HasSubstr("expected columns x, z, u, w"));
    EXPECT_THAT(message("x,z,u,w\n0,0,1,0\n1,1,1,0\n2,2,1,0\n3,3,1,0\n4,4,1,0\n"),
                HasSubstr("points of a grid"));
    EXPECT_THAT(message("x,z,u,w\n0,0,1,0\n1,0,1,0\n0,1,1,0\n1,1,1,0\n1,1,2,0\n"),
                HasSubstr(":6: expected one vector at each point; x = 1 m, z = 1 m is also in line 5"));
    EXPECT_THAT(message("# units: furlong, m/s\nx,z,u,w\n0,0,1,0\n1,0,1,0\n0,1,1,0\n1,1,1,0\n"),
                HasSubstr("got \"furlong\""));
    EXPECT_THAT(message("#DaVis 8.4\n0 0 1 1\n"), HasSubstr("the units in quotes"));
    const Folder folder;
    EXPECT_THAT(message_of([&] { return read_velocity_field(folder.path()); }), HasSubstr("found none"));
    folder.add("a.csv", frame(1.0));
    folder.add("b.csv", "x [m],z [m],u [m/s],w [m/s]\n0.03,0.01,1,0\n");
    EXPECT_THAT(message_of([&] { return read_velocity_field(folder.path()); }),
                HasSubstr("b.csv:2: the point"));
    const Folder timed;
    timed.add("a.csv", frame(1.0, "# time: 0.2 s\n"));
    timed.add("b.csv", frame(1.0, "# time: 0.1 s\n"));
    EXPECT_THAT(message_of([&] { return read_velocity_field(timed.path()); }), HasSubstr("rising times"));
}

}  // namespace
}  // namespace riffle::velocity_field_test
