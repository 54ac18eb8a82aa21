#include "output/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.hpp"
#include "temporary_folder.hpp"

namespace riffle::atomic_file_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(AtomicFile, WritesAndReplacesAText) {
    const test::TemporaryFolder folder;
    write_text_atomically(folder / "a.txt", "first, longer");
    EXPECT_EQ(test::bytes_of(folder / "a.txt"), "first, longer");
    write_text_atomically(folder / "a.txt", "second");
    EXPECT_EQ(test::bytes_of(folder / "a.txt"), "second");
    write_text_atomically(folder / "a.txt", "");
    EXPECT_EQ(test::bytes_of(folder / "a.txt"), "");
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("a.txt"));
}

TEST(AtomicFile, ReplacesWhatACrashLeftBehind) {
    const test::TemporaryFolder folder;
    test::put_bytes(folder / "a.txt.new", "half of a text that is much longer than the new one");
    write_text_atomically(folder / "a.txt", "whole");
    EXPECT_EQ(test::bytes_of(folder / "a.txt"), "whole");
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("a.txt"));
}

TEST(AtomicFile, SaysWhyItCannotBeWritten) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(
        test::file_error_of([&] { write_text_atomically(folder / "no/a.txt", "text"); }),
        AllOf(HasSubstr("a.txt"), HasSubstr("No such file or directory"), HasSubstr("does not exist")));
    std::filesystem::create_directory(folder / "a");
    EXPECT_THAT(test::file_error_of([&] { write_text_atomically(folder / "a", "text"); }),
                AllOf(HasSubstr("Is a directory"), HasSubstr((folder / "a").string())));
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("a"));
}

}  // namespace
}  // namespace riffle::atomic_file_test
