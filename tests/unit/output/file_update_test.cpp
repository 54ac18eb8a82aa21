#include "output/file_update.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "output/sealed_reader.hpp"
#include "temporary_folder.hpp"

namespace riffle::file_update_test {
namespace {

using test::bytes_of;
using test::put_bytes;
using test::TemporaryFolder;

std::span<const std::byte> bytes_in(const std::string& text) { return std::as_bytes(std::span(text)); }

/// The content of a sealed file without its seal.
std::string content_of(SealedReader& reader) {
    std::string content(reader.size(), '\0');
    reader.read(0, std::as_writable_bytes(std::span(content)));
    return content.substr(seal_bytes);
}
std::string content_of(const std::filesystem::path& path) {
    SealedReader reader(path, results_seal);
    EXPECT_TRUE(reader.content().damaged_pages().empty());
    return content_of(reader);
}

void create(const std::filesystem::path& path, const std::string& content) {
    const auto update = FileUpdate::create(path, results_seal);
    update->write(seal_bytes, bytes_in(content));
    update->commit();
}

ino_t file_number(const std::filesystem::path& path) {
    struct stat status = {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_ino;
}

/// A change of a few bytes of a file, and of its length.
void change(const std::filesystem::path& path, std::uint64_t in_place_from = 0) {
    const auto update = FileUpdate::change(path, results_seal, in_place_from);
    update->write(seal_bytes + 1000, bytes_in("changed"));
    update->write(update->size(), bytes_in("added"));
    update->commit();
}
std::string changed(std::string content) { return content.replace(1000, 7, "changed") + "added"; }

TEST(FileUpdate, GivesBackAnyChangesInBothWays) {
    const TemporaryFolder folder;
    const auto path = folder / "f";
    EXPECT_TRUE(rc::check([&] {
        const auto any_bytes = [] {
            const auto size = *rc::gen::weightedOneOf<std::size_t>(
                {{3, rc::gen::inRange<std::size_t>(0, 100)}, {1, rc::gen::inRange<std::size_t>(0, 300'000)}});
            return std::string(size, *rc::gen::inRange<char>('a', 'z'));
        };
        std::string expected = any_bytes();
        create(path, expected);
        const auto changes = *rc::gen::inRange(1, 5);
        for (int n = 0; n < changes; ++n) {
            const auto update = FileUpdate::change(path, results_seal,
                                                   *rc::gen::element<std::uint64_t>(0, 1U << 17U, 1U << 30U));
            const auto writes = *rc::gen::inRange(0, 4);
            for (int k = 0; k < writes; ++k) {
                const auto at = *rc::gen::inRange<std::size_t>(0, expected.size() + 100'000);
                const std::string bytes = any_bytes();
                if (bytes.empty()) continue;
                expected.resize(std::max(expected.size(), at + bytes.size()), '\0');
                expected.replace(at, bytes.size(), bytes);
                update->write(seal_bytes + at, bytes_in(bytes));
            }
            if (*rc::gen::arbitrary<bool>()) {
                const auto size = *rc::gen::inRange<std::size_t>(0, expected.size() + 1);
                // What is cut off and asked for again is as the library left it: it writes before it reads.
                expected.resize(size);
                update->resize(seal_bytes + size);
            }
            update->commit();
            RC_ASSERT(content_of(path) == expected);
        }
        RC_ASSERT(test::names_in(folder.path()) == std::set<std::string>{"f"});
    }));
}

TEST(FileUpdate, ChangesInPlaceOnlyLargeFilesWithOneName) {
    const TemporaryFolder folder;
    const auto path = folder / "f";
    const std::string content(200'000, 'x');
    create(path, content);
    const ino_t first = file_number(path);
    change(path, 0);
    EXPECT_EQ(file_number(path), first);
    change(path, 1U << 30U);
    const ino_t second = file_number(path);
    EXPECT_NE(second, first);
    // Whoever keeps a second name for the file keeps its content.
    std::filesystem::create_hard_link(path, folder / "kept");
    const std::string kept = bytes_of(folder / "kept");
    change(path, 0);
    EXPECT_NE(file_number(path), second);
    EXPECT_EQ(bytes_of(folder / "kept"), kept);
    EXPECT_EQ(content_of(path), changed(changed(changed(content))));
}

TEST(FileUpdate, LeavesAReaderWhatItOpened) {
    const TemporaryFolder folder;
    const auto path = folder / "f";
    const std::string content(200'000, 'x');
    create(path, content);
    const ino_t number = file_number(path);
    {
        SealedReader reader(path, results_seal);
        change(path, 0);
        EXPECT_NE(file_number(path), number);
        EXPECT_EQ(content_of(reader), content);
    }
    EXPECT_EQ(content_of(path), changed(content));
    EXPECT_EQ(test::names_in(folder.path()), std::set<std::string>{"f"});
}

TEST(FileUpdate, WithoutCommitTheFileStaysAsItWas) {
    const TemporaryFolder folder;
    const auto path = folder / "f";
    create(path, std::string(200'000, 'x'));
    const std::string before = bytes_of(path);
    for (const std::uint64_t from : {std::uint64_t{0}, change_in_place_from}) {
        const auto update = FileUpdate::change(path, results_seal, from);
        update->write(1000, bytes_in("changed"));
        update->write(300'000, bytes_in("added"));
    }
    EXPECT_EQ(bytes_of(path), before);
    EXPECT_EQ(test::names_in(folder.path()), std::set<std::string>{"f"});
}

TEST(FileUpdate, TakesMemoryForWhatChangesOnly) {
    const TemporaryFolder folder;
    const auto path = folder / "f";
    create(path, std::string(50'000'000, 'x'));
    const auto resident = [] {
        std::ifstream status("/proc/self/statm");
        std::size_t size = 0;
        std::size_t pages = 0;
        status >> size >> pages;
        return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    };
    const std::size_t before = resident();
    for (const std::uint64_t from : {std::uint64_t{0}, change_in_place_from}) {
        const auto update = FileUpdate::change(path, results_seal, from);
        const std::string block(1'000'000, 'y');
        for (int n = 0; n < 50; ++n) update->write(update->size(), bytes_in(block));
        update->write(1000, bytes_in("changed"));
        update->commit();
        // A block to copy with, some pages and the table; all of the file would be 100 MB.
        EXPECT_LT(resident(), before + 10'000'000);
    }
}

TEST(FileUpdate, FollowsLinksAndKeepsPermissions) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "elsewhere");
    create(folder / "elsewhere/f", "content");
    std::filesystem::permissions(folder / "elsewhere/f", std::filesystem::perms(0640));
    std::filesystem::create_symlink("elsewhere/f", folder / "link");
    const std::string content(2000, 'x');
    create(folder / "link", content);
    change(folder / "link", change_in_place_from);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(content_of(folder / "elsewhere/f"), changed(content));
    EXPECT_EQ(std::filesystem::status(folder / "elsewhere/f").permissions(), std::filesystem::perms(0640));
    EXPECT_EQ(test::names_in(folder / "elsewhere"), std::set<std::string>{"f"});
}

/// A file in the midst of a change in place: its journal is there, and a part of it has been done.
class Interrupted : public testing::Test {
  protected:
    void SetUp() override {
        create(path, content);
        before = bytes_of(path);
        change(path, 0);
        after = bytes_of(path);
        put_bytes(path, before.substr(0, 300) + after.substr(300, 2000) + before.substr(2300) +
                            after.substr(before.size()));
        const auto seal = [](const std::string& bytes) {
            return read_seal(results_seal, bytes_in(bytes).first(seal_bytes)).identity;
        };
        write_journal(path, {.from = seal(before),
                             .to = seal(after),
                             .file_size = after.size(),
                             .patches = {{0, bytes_in(after)}}});
    }
    TemporaryFolder folder;
    std::filesystem::path path = folder / "f";
    std::string content = std::string(200'000, 'x');
    std::string before;
    std::string after;
};

TEST_F(Interrupted, IsReadAsCompleteWithoutWriting) {
    const std::string torn = bytes_of(path);
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    EXPECT_EQ(content_of(path), changed(content));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    EXPECT_EQ(bytes_of(path), torn);
}

TEST_F(Interrupted, IsCompletedByTheNextChange) {
    change(path, 0);
    EXPECT_EQ(content_of(path), changed(changed(content)));
    EXPECT_EQ(test::names_in(folder.path()), std::set<std::string>{"f"});
}

TEST_F(Interrupted, ATornJournalOrOneOfAnotherFileCountsForNothing) {
    put_bytes(path, before + after.substr(before.size()));  // what is added comes before the journal
    const std::string journal = bytes_of(journal_of(path));
    for (std::size_t size = 0; size < journal.size(); size += 1009) {
        put_bytes(journal_of(path), journal.substr(0, size));
        ASSERT_EQ(content_of(path), content) << size;
    }
    put_bytes(journal_of(path), journal);
    EXPECT_EQ(content_of(path), changed(content));
    create(path, "another file of this name");
    EXPECT_EQ(content_of(path), "another file of this name");
    change(path, 0);
    EXPECT_EQ(test::names_in(folder.path()), std::set<std::string>{"f"});
}

}  // namespace
}  // namespace riffle::file_update_test
