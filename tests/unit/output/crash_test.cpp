// A crash of the process at each step that changes the folder: a child process ends there, without any
// cleaning up.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <optional>

#include "base/error.hpp"
#include "contents.hpp"
#include "output/checkpoint_write.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

using test::TemporaryFolder;

/// Run `action` in a child that ends at step `last`; whether it came to its end before.
bool crash_at(int last, const std::function<void(const StepObserver&)>& action) {
    const pid_t child = ::fork();
    if (child == 0) {
        int step = 0;
        try {
            action([&](std::string_view) {
                if (step++ == last) ::_exit(9);
            });
        } catch (const std::exception&) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_TRUE(WEXITSTATUS(status) == 9 || WEXITSTATUS(status) == 0) << WEXITSTATUS(status);
    return WEXITSTATUS(status) == 0;
}

std::optional<Content> whole(const std::filesystem::path& path) {
    try {
        return CheckpointFile::read(path);
    } catch (const FileError&) {
        return {};
    }
}

TEST(Crash, AtAnyStepLeavesTheOldOrTheNewCheckpointWhole) {
    const Content first = test::state(20, 1.0);
    const Content second = test::state(20, 2.0);
    const Content third = test::state(20, 3.0);
    const Content fourth = test::state(20, 4.0);
    int steps = 0;
    int old_left = 0;
    for (bool ended = false; !ended; ++steps) {
        ASSERT_LT(steps, 100);
        const TemporaryFolder folder;
        const auto path = folder / "checkpoint.h5";
        CheckpointFile::write(path, first);
        CheckpointFile::write(path, second);
        ended =
            crash_at(steps, [&](const StepObserver& observer) { write_checkpoint(path, third, observer); });

        const std::optional<Content> left = whole(path);
        ASSERT_TRUE(left) << "step " << steps;
        const bool is_old = test::same(*left, second);
        EXPECT_TRUE(is_old || test::same(*left, third)) << "step " << steps;
        old_left += is_old ? 1 : 0;
        const std::optional<Content> previous = whole(CheckpointFile::previous(path));
        ASSERT_TRUE(previous) << "step " << steps;
        EXPECT_TRUE(test::same(*previous, is_old ? first : second) || test::same(*previous, second));

        // The run goes on from there, and leaves nothing of the crash behind.
        CheckpointFile::write(path, fourth);
        EXPECT_TRUE(test::same(CheckpointFile::read(path), fourth)) << "step " << steps;
        EXPECT_TRUE(test::same(CheckpointFile::read(CheckpointFile::previous(path)), *left))
            << "step " << steps;
        EXPECT_THAT(test::names_in(folder.path()),
                    testing::ElementsAre("checkpoint-previous.h5", "checkpoint.h5"))
            << "step " << steps;
    }
    // Both outcomes have been seen, over all of: open, two parts, flush, link, two renames, flush the folder.
    EXPECT_GE(steps, 9);
    EXPECT_GT(old_left, 5);
    EXPECT_LT(old_left, steps - 1);
}

TEST(Crash, TwiceAtAnyTwoStepsLeavesACheckpoint) {
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            const TemporaryFolder folder;
            const auto path = folder / "checkpoint.h5";
            CheckpointFile::write(path, test::state(3, 1.0));
            for (const int step : {i, j}) {
                crash_at(step, [&](const StepObserver& observer) {
                    write_checkpoint(path, test::state(3, 2.0), observer);
                });
                ASSERT_TRUE(whole(path)) << "steps " << i << ", " << j;
            }
        }
    }
}

TEST(Crash, AtAnyStepLeavesTheOldOrTheNewFile) {
    int steps = 0;
    for (bool ended = false; !ended; ++steps) {
        ASSERT_LT(steps, 100);
        const TemporaryFolder folder;
        test::put_bytes(folder / "a", "the old content");
        const std::string content = "the new";
        const std::array parts = {std::as_bytes(std::span(content))};
        ended = crash_at(steps, [&](const StepObserver& observer) {
            replace_file(folder / "a", parts, {.observer = observer});
        });
        const std::string left = test::bytes_of(folder / "a");
        EXPECT_TRUE(left == content || (!ended && left == "the old content"))
            << "step " << steps << ": " << left;
    }
    EXPECT_GE(steps, 5);
}

}  // namespace
}  // namespace riffle
