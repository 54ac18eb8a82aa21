// The end of the process, or a failure, at each call of the system that changes files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <optional>
#include <span>

#include "base/error.hpp"
#include "contents.hpp"
#include "file_faults.hpp"
#include "output/atomic_file.hpp"
#include "output/checkpoint_file.hpp"
#include "output/file_update.hpp"
#include "output/journal.hpp"
#include "output/results_update.hpp"
#include "temporary_folder.hpp"

namespace riffle::crash_test {
namespace {

using test::FileFault;
using test::TemporaryFolder;

/// Run `action` in a child that meets a fault; whether it came to its end without one.
bool fault_at(FileFault fault, int at, int error, const std::function<void()>& action) {
    const pid_t child = ::fork();
    if (child == 0) {
        test::set_file_fault(fault, at, error);
        try {
            action();
        } catch (const FileError&) {
            ::_exit(2);
        } catch (const std::exception&) {
            ::_exit(3);
        }
        ::_exit(*test::faulted_call() == '\0' ? 0 : 4);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
    EXPECT_NE(WEXITSTATUS(status), 3) << "an error that is no FileError";
    return WEXITSTATUS(status) == 0;
}

struct Fault {
    FileFault fault;
    int error;
    const char* name;
};
constexpr Fault all_faults[] = {{FileFault::end, 0, "end"},
                                {FileFault::half, 0, "half"},
                                {FileFault::fail, EIO, "fail"},
                                {FileFault::full, ENOSPC, "full"}};

/// `check(faulted)` after each fault at each call of `action`, which begins with what `prepare` leaves.
void at_every_call(const std::function<void()>& prepare, const std::function<void()>& action,
                   const std::function<void()>& check, int fewest_calls) {
    for (const Fault& fault : all_faults) {
        bool ended = false;
        for (int at = 0; !ended; ++at) {
            ASSERT_LT(at, 500);
            SCOPED_TRACE(testing::Message() << fault.name << " at call " << at);
            prepare();
            ended = fault_at(fault.fault, at, fault.error, action);
            check();
            if (testing::Test::HasFatalFailure()) return;
            if (ended) {
                EXPECT_GE(at, fewest_calls);
            }
        }
    }
}

std::optional<Content> whole(const std::filesystem::path& path) {
    try {
        return CheckpointFile::read(path);
    } catch (const FileError&) {
        return {};
    }
}

TEST(Crash, AtAnyCallLeavesTheOldOrTheNewCheckpointWhole) {
    const TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    const Content first = test::state(20, 1.0);
    const Content second = test::state(20, 2.0);
    const Content third = test::state(20, 3.0);
    const Content fourth = test::state(20, 4.0);
    int old_left = 0;
    int new_left = 0;
    at_every_call(
        [&] {
            CheckpointFile::write(path, first);
            CheckpointFile::write(path, second);
        },
        [&] { CheckpointFile::write(path, third); },
        [&] {
            const std::optional<Content> left = whole(path);
            ASSERT_TRUE(left);
            const bool is_old = test::same(*left, second);
            EXPECT_TRUE(is_old || test::same(*left, third));
            ++(is_old ? old_left : new_left);
            const std::optional<Content> previous = whole(CheckpointFile::previous(path));
            ASSERT_TRUE(previous);
            EXPECT_TRUE(test::same(*previous, is_old ? first : second) || test::same(*previous, second));

            // The run goes on from there, and leaves nothing of the crash behind.
            CheckpointFile::write(path, fourth);
            EXPECT_TRUE(test::same(CheckpointFile::read(path), fourth));
            EXPECT_TRUE(test::same(CheckpointFile::read(CheckpointFile::previous(path)), *left));
            EXPECT_THAT(test::names_in(folder.path()),
                        testing::ElementsAre("checkpoint-previous.h5", "checkpoint.h5"));
        },
        9);
    EXPECT_GT(old_left, 5);
    EXPECT_GT(new_left, 3);
}

TEST(Crash, TwiceAtAnyTwoCallsLeavesACheckpoint) {
    for (int i = 0; i < 24; ++i) {
        for (int j = 0; j < 24; ++j) {
            const TemporaryFolder folder;
            const auto path = folder / "checkpoint.h5";
            CheckpointFile::write(path, test::state(3, 1.0));
            for (const int call : {i, j}) {
                fault_at(FileFault::end, call, 0, [&] { CheckpointFile::write(path, test::state(3, 2.0)); });
                ASSERT_TRUE(whole(path)) << "calls " << i << ", " << j;
            }
        }
    }
}

TEST(Crash, AtAnyCallLeavesTheOldOrTheNewText) {
    const TemporaryFolder folder;
    const std::string before = "the old content";
    const std::string after = "the new";
    at_every_call([&] { test::put_bytes(folder / "a", before); },
                  [&] { write_text_atomically(folder / "a", after); },
                  [&] {
                      const std::string left = test::bytes_of(folder / "a");
                      EXPECT_TRUE(left == after || left == before) << left;
                  },
                  5);
}

/// Series that grow and a field that is replaced, of noise that does not compress.
Content rows(std::size_t count, double phase) {
    std::vector<double> noise = test::wave(12000, phase);
    Content content;
    content.datasets = {{"/t", {count}, test::wave(count, phase), "s", "time", true},
                        {"/field", {noise.size()}, noise, "1", "a field"},
                        {"/text", {}, std::string(100, 'a' + static_cast<char>(phase)), "1", "a text"}};
    content.attributes = {{"/", "phase", phase}};
    return content;
}

/// Results of so many rows, with a part replaced: whatever is read must be of one of the two.
class Results : public testing::TestWithParam<std::uint64_t> {
  protected:
    void change(std::size_t count, double phase) const {
        const Content content = rows(count, phase);
        const std::map<std::string, std::size_t> rows_kept;
        const std::vector<std::string> removed;
        update_results(path, {content, rows_kept, {}, removed}, GetParam());
    }
    void check_is_old_or_new() {
        const ResultsReader reader(path);
        reader.verify();
        const std::vector<double> t = reader.read_doubles("/t");
        const bool is_old = t.size() == 1000;
        ASSERT_TRUE(is_old || t.size() == 1600) << t.size();
        const double phase = is_old ? 1.0 : 2.0;
        EXPECT_EQ(reader.read_doubles("/field"), test::wave(12000, phase));
        EXPECT_EQ(reader.read_string("/text"), std::string(100, 'a' + static_cast<char>(phase)));
        EXPECT_EQ(reader.attribute("/", "phase"), AttributeValue(phase));
        ++(is_old ? old_left : new_left);
    }
    TemporaryFolder folder;
    std::filesystem::path path = folder / "results.h5";
    int old_left = 0;
    int new_left = 0;
};

TEST_P(Results, AreOldOrNewAfterAFaultAtAnyCall) {
    at_every_call([&] { ResultsFile::create(path, rows(1000, 1.0), true); }, [&] { change(600, 2.0); },
                  [&] {
                      check_is_old_or_new();
                      // The run goes on from there, and leaves nothing of the crash behind.
                      change(10, 3.0);
                      const ResultsReader reader(path);
                      reader.verify();
                      EXPECT_EQ(reader.read_doubles("/field"), test::wave(12000, 3.0));
                      EXPECT_THAT(test::names_in(folder.path()), testing::ElementsAre("results.h5"));
                  },
                  9);
    EXPECT_GT(old_left, 5);
    EXPECT_GT(new_left, 3);
}

TEST_P(Results, AreOldOrNewAfterTwoFaults) {
    for (int first = 0; first < 42; first += 6) {
        for (int second = 0; second < 42; second += 6) {
            ResultsFile::create(path, rows(1000, 1.0), true);
            for (const int call : {first, second}) {
                SCOPED_TRACE(testing::Message() << "calls " << first << ", " << second);
                fault_at(FileFault::half, call, 0, [&] {
                    if (ResultsReader(path).read_doubles("/t").size() == 1000) change(600, 2.0);
                });
                check_is_old_or_new();
            }
        }
    }
}

TEST_P(Results, CreatedAnewAreNotTakenForThoseThatAJournalIsLeftOf) {
    ResultsFile::create(path, rows(1000, 1.0), true);
    int journals = 0;
    for (int call = 0; call < 60; ++call) {
        SCOPED_TRACE(testing::Message() << "call " << call);
        fault_at(FileFault::end, call, 0, [&] { change(600, 2.0); });
        journals += std::filesystem::exists(journal_of(path)) ? 1 : 0;
        // The same bytes as before the change, so that the journal would fit them.
        ResultsFile::create(path, rows(1000, 1.0), true);
        const ResultsReader reader(path);
        reader.verify();
        EXPECT_EQ(reader.read_doubles("/t").size(), 1000U);
        EXPECT_THAT(test::names_in(folder.path()), testing::ElementsAre("results.h5"));
    }
    EXPECT_EQ(journals > 0, GetParam() == 0);
}

INSTANTIATE_TEST_SUITE_P(Anew, Results, testing::Values(change_in_place_from));
INSTANTIATE_TEST_SUITE_P(InPlace, Results, testing::Values(0));

}  // namespace
}  // namespace riffle::crash_test
