#include "analysis/run_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "sample_probes.hpp"
#include "sample_results.hpp"

namespace riffle::run_record_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::SampleOptions;
using testing::write_sample_results;

class RunRecords : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
        path_ = folder_ / "results.h5";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_, path_;
};

template <class Error, class Action>
std::string message_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return "";
}

TEST_F(RunRecords, TakeTheWindowOfTheRunOrTheOneAskedFor) {
    write_sample_results(path_);
    EXPECT_EQ(RunRecord(path_).window().from, 15.0);
    EXPECT_EQ(RunRecord(path_).window().to, 30.0);
    RunRecordOptions options;
    options.window = TimeWindow{20.0, 25.0};
    const RunRecord record(path_, options);
    EXPECT_EQ(record.window().from, 20.0);
    // Rows of the surface every 0.02 s: 20.00 to 25.00.
    EXPECT_EQ(record.surface().rows(), 251U);
    EXPECT_NEAR(record.surface().times.front(), 20.0, 1e-9);
    // The sample has no profile blocks to average anew.
    EXPECT_TRUE(record.profiles().empty());
}

TEST_F(RunRecords, RefuseAWindowOutsideOfTheRun) {
    write_sample_results(path_);
    for (const TimeWindow& window :
         {TimeWindow{10, 10}, TimeWindow{20, 10}, TimeWindow{-1, 10}, TimeWindow{20, 31}}) {
        RunRecordOptions options;
        options.window = window;
        EXPECT_THAT(message_of<InputError>([&] { const RunRecord record(path_, options); }),
                    HasSubstr("from 0 s to 30 s"));
    }
}

TEST_F(RunRecords, ReadNoMoreOfTheSurfaceThanAllowedAndSaySo) {
    write_sample_results(path_);
    RunRecordOptions options;
    options.most_elevations = 5000;  // 100 rows of 50 points
    const RunRecord record(path_, options);
    EXPECT_EQ(record.surface().rows(), 100U);
    EXPECT_NEAR(record.surface().times.back(), 30.0, 1e-9);
    ASSERT_EQ(record.warnings().size(), 1U);
    EXPECT_THAT(record.warnings().front(), HasSubstr("the last 100 rows"));
}

TEST_F(RunRecords, WeighTheWindowsOfAGridWithTheirSamples) {
    write_sample_results(path_);
    testing::SampleProbes probes;
    probes.last_window_samples = 600;
    probes.last_window_velocity = 0.5;
    testing::add_sample_probes(path_, probes);
    const RunRecord record(path_);
    ASSERT_EQ(record.velocity_grids().size(), 1U);
    const VelocityGrid& grid = record.velocity_grids().front();
    // Of 15 s to 30 s: 14 windows of 100 samples at 0.3 m/s and the last.
    EXPECT_NEAR(grid.u.front(), (1400 * 0.3 + 600 * 0.5) / 2000, 1e-12);
    EXPECT_NEAR(grid.uu.front(), 4e-4 + (1400 * 0.06 * 0.06 + 600 * 0.14 * 0.14) / 2000, 1e-12);
}

TEST_F(RunRecords, CompareWithTheMeasuredFileOrTheLawOfTheMeasuredValues) {
    write_sample_results(path_);
    EXPECT_TRUE(RunRecord(path_).measured().from_law);
    std::ofstream(folder_ / "adv.csv") << "z [mm],u [cm/s]\n10,22\n20,30\n";
    RunRecordOptions options;
    options.measured = {folder_ / "adv.csv"};
    const RunRecord record(path_, options);
    EXPECT_FALSE(record.measured().from_law);
    ASSERT_EQ(record.measured().profile.height.size(), 2U);
    // Heights over the datum, 6 mm above the bed level.
    EXPECT_NEAR(record.measured().profile.height.front(), 0.016, 1e-12);
    EXPECT_NEAR(record.measured().profile.velocity.front(), 0.22, 1e-12);
    options.measured = {folder_ / "nothing.csv"};
    EXPECT_THAT(message_of<FileError>([&] { RunRecord(path_, options); }), HasSubstr("nothing.csv"));
}

TEST_F(RunRecords, CompareWithSeveralFilesOfOtherKinds) {
    write_sample_results(path_);
    std::ofstream(folder_ / "adv.csv") << "z [mm],u [cm/s]\n10,21\n20,30\n";
    std::ofstream(folder_ / "across.csv") << "# z: 10 mm\ny [mm],u [cm/s]\n0,18\n50,22\n";
    std::ofstream(folder_ / "piv.csv") << "x [mm],z [mm],u [m/s],w [m/s]\n"
                                          "0,10,0.20,0\n10,10,0.24,0\n0,20,0.30,0\n10,20,0.30,0\n";
    RunRecordOptions options;
    options.measured = {folder_ / "adv.csv", folder_ / "across.csv", folder_ / "piv.csv"};
    const RunRecord record(path_, options);
    EXPECT_NEAR(record.measured().profile.velocity.front(), 0.21, 1e-12) << "the profile is that of the ADV";
    EXPECT_EQ(record.measured().section.y.size(), 2U);
    ASSERT_EQ(record.measured().field.x.size(), 2U);
    EXPECT_NEAR(record.measured().field.z.front(), 0.016, 1e-12);
    // Of two profiles one is compared with, and the other is not left out without a word.
    std::ofstream(folder_ / "second.csv") << "z [mm],u [cm/s]\n10,25\n20,30\n";
    options.measured = {folder_ / "adv.csv", folder_ / "second.csv"};
    const RunRecord two(path_, options);
    EXPECT_NEAR(two.measured().profile.velocity.front(), 0.25, 1e-12);
    EXPECT_THAT(two.warnings(), ::testing::Contains(AllOf(HasSubstr("second.csv"), HasSubstr("adv.csv"))));
    // Without a profile of its own a field gives the means along the channel.
    options.measured = {folder_ / "piv.csv"};
    EXPECT_NEAR(RunRecord(path_, options).measured().profile.velocity.front(), 0.22, 1e-12);
    std::ofstream(folder_ / "point.csv") << "# z: 10 mm\n# sampling_frequency: 10 Hz\nu [m/s]\n0.1\n0.2\n";
    options.measured = {folder_ / "point.csv"};
    EXPECT_THAT(message_of<FileError>([&] { RunRecord(path_, options); }), HasSubstr("point.csv"));
}

TEST_F(RunRecords, SayThatAFileHasNoUsableCase) {
    SampleOptions options;
    options.stored_case_text = "title = 3";
    write_sample_results(path_, options);
    EXPECT_THAT(message_of<FileError>([&] { const RunRecord record(path_); }),
                HasSubstr("cannot be read by this version"));
    EXPECT_THAT(message_of<FileError>([&] { const RunRecord record(folder_ / "none.h5"); }),
                HasSubstr("none.h5"));
}

}  // namespace
}  // namespace riffle::run_record_test
