// A real full disk: a small one in memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contents.hpp"
#include "messages.hpp"
#include "output/atomic_file.hpp"
#include "output/checkpoint_file.hpp"
#include "output/results_file.hpp"
#include "temporary_folder.hpp"

namespace riffle::full_disk_test {
namespace {

using test::bytes_of;
using test::file_error_of;
using testing::AllOf;
using testing::HasSubstr;

class FullDisk : public testing::Test {
  protected:
    void SetUp() override {
        if (!disk.mounted()) {
            GTEST_SKIP() << "this user may not mount a small disk; run as root to test a full one";
        }
    }
    test::SmallDisk disk{"1m"};
};

const auto says_that_the_disk_is_full = AllOf(HasSubstr("No space left on device"), HasSubstr("disk"),
                                              HasSubstr("free at least"), HasSubstr("MiB"));

/// Values that do not compress.
std::vector<double> noise(std::size_t count) {
    std::vector<double> values(count);
    std::uint64_t state = 1;
    for (double& value : values) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        value = static_cast<double>(state);
    }
    return values;
}

TEST_F(FullDisk, LeavesTheEarlierResultsByteIdentical) {
    const auto path = disk / "results.h5";
    ResultsFile::create(path, {{{"/t", {20000}, noise(20000), "s", "time", true}}, {}}, false);
    const std::string before = bytes_of(path);
    // From no room at all to just too little, the file fails to be written at every place of it.
    for (const std::size_t left : {0U, 1U << 12U, 1U << 15U, 1U << 17U}) {
        disk.fill_up_to(left);
        const std::string message = file_error_of([&] {
            ResultsFile::update(path, {{{"/t", {10000}, noise(10000), "s", "time", true}}, {}});
        });
        EXPECT_THAT(message, AllOf(HasSubstr(path.string()), says_that_the_disk_is_full,
                                   HasSubstr("earlier results in this file are untouched"),
                                   HasSubstr("riffle resume")));
        EXPECT_TRUE(bytes_of(path) == before);
        EXPECT_FALSE(std::filesystem::exists(disk / "results.h5.new"));
        std::filesystem::remove(disk / "filler");
    }
    // The run can go on when there is room again.
    ResultsFile::update(path, {{{"/t", {10}, noise(10), "s", "time", true}}, {}});
    EXPECT_EQ(ResultsReader(path).read_doubles("/t").size(), 20010U);
}

TEST_F(FullDisk, SaysThatANewResultsFileFindsNoRoom) {
    const std::string message = file_error_of([&] {
        ResultsFile::create(disk / "results.h5", {{{"/t", {200000}, noise(200000), "s", "time"}}, {}}, false);
    });
    EXPECT_THAT(message, says_that_the_disk_is_full);
    EXPECT_TRUE(test::names_in(disk.path()).empty());
}

TEST_F(FullDisk, LeavesTheEarlierCheckpointsByteIdentical) {
    const auto path = disk / "checkpoint.h5";
    CheckpointFile::write(path, test::state(5000, 1.0));
    CheckpointFile::write(path, test::state(5000, 2.0));
    const std::string newest = bytes_of(path);
    const std::string previous = bytes_of(CheckpointFile::previous(path));
    for (const std::size_t left : {0U, 1U << 12U, 1U << 15U, 1U << 16U}) {
        disk.fill_up_to(left);
        const std::string message =
            file_error_of([&] { CheckpointFile::write(path, test::state(5000, 3.0)); });
        EXPECT_THAT(message, AllOf(HasSubstr(path.string()), says_that_the_disk_is_full,
                                   HasSubstr("riffle resume " + disk.path().string())));
        EXPECT_TRUE(bytes_of(path) == newest);
        EXPECT_TRUE(bytes_of(CheckpointFile::previous(path)) == previous);
        EXPECT_FALSE(std::filesystem::exists(disk / "checkpoint.h5.new"));
        std::filesystem::remove(disk / "filler");
    }
    CheckpointFile::write(path, test::state(5000, 3.0));
    EXPECT_TRUE(test::same(CheckpointFile::read(path), test::state(5000, 3.0)));
}

TEST_F(FullDisk, LeavesTheEarlierTextAsItWas) {
    write_text_atomically(disk / "report.html", "earlier");
    disk.fill_up_to(0);
    EXPECT_THAT(file_error_of([&] { write_text_atomically(disk / "report.html", std::string(10000, 'x')); }),
                AllOf(says_that_the_disk_is_full, HasSubstr("untouched")));
    EXPECT_EQ(bytes_of(disk / "report.html"), "earlier");
}

}  // namespace
}  // namespace riffle::full_disk_test
