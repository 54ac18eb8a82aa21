#include "watch/run_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace riffle::run_state_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* log_text =
    "2026-11-21 10:09:31 info    riffle 0.1.0\n"
    "2026-11-21 10:09:40 error   the state is no longer finite: particle 2\n"
    "The last good checkpoint is at t = 0 s\n";

TEST(RunLog, LastLineCarriesTheUndatedLinesBehindIt) {
    const auto line = last_line(log_text);
    ASSERT_TRUE(line);
    EXPECT_EQ(*line,
              (LogLine{"2026-11-21 10:09:40", "error",
                       "the state is no longer finite: particle 2\nThe last good checkpoint is at t = 0 s"}));
}

TEST(RunLog, WithoutADatedLineThereIsNone) {
    for (const char* text :
         {"", "\n", "\n\n", "no date", "2026-11-21", "2026-11-21 10:09:31 ", "20261-11-21 10:09:31 info x"}) {
        EXPECT_FALSE(last_line(text)) << text;
    }
    // A line that is cut after its level has no message, which is no fault.
    EXPECT_EQ(last_line("2026-11-21 10:09:31 info"), (LogLine{"2026-11-21 10:09:31", "info", ""}));
}

TEST(RunLog, OnlyTheEndOfALongFileIsRead) {
    const auto path =
        std::filesystem::path(::testing::TempDir()) / ("riffle-log-" + std::to_string(getpid()));
    std::ofstream(path) << std::string(1'000'000, 'x') << "\n" << log_text;
    const auto line = last_line_of(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->level, "error");
    EXPECT_FALSE(last_line_of(path));
}

/// A lock that a process holds, or with 0 nobody.
FolderLock::Standing lock_of(int process) {
    FolderLock::Standing lock{.known = true, .holder = {}};
    if (process != 0) lock.holder = LockHolder{.process = process, .host = "elsewhere"};
    return lock;
}

RunSigns signs(const std::string& message, FolderLock::Standing lock = {}) {
    RunSigns s;
    s.results = true;
    s.log = LogLine{"2026-11-21 10:09:31", "info", message};
    s.lock = lock;
    s.seconds_since_write = 5.0;
    return s;
}

TEST(RunState, TheLogsLastWordCountsFirst) {
    EXPECT_EQ(judge_state(signs("finished at t = 3 s after 9 steps")).state, RunState::finished);
    EXPECT_EQ(judge_state(signs("stopped at t = 3 s after 9 steps")).state, RunState::stopped);
    // The process closes its log after its last line.
    EXPECT_EQ(judge_state(signs("finished at t = 3 s", lock_of(12))).state, RunState::finished);
    RunSigns failed = signs("the state is no longer finite");
    failed.log->level = "error";
    EXPECT_EQ(judge_state(failed).state, RunState::failed);
    EXPECT_THAT(judge_state(failed).reason, HasSubstr("no longer finite"));
}

TEST(RunState, AResumedRunIsRunningThoughTheFileIsStillMarkedComplete) {
    RunSigns resumed = signs("resumed at t = 3 s, step 9, from checkpoint.h5", lock_of(12));
    resumed.complete = true;
    EXPECT_EQ(judge_state(resumed).state, RunState::running);
    EXPECT_THAT(judge_state(resumed).reason, HasSubstr("Process 12 of the machine elsewhere"));
    resumed.lock = lock_of(0);
    EXPECT_EQ(judge_state(resumed).state, RunState::finished);
}

TEST(RunState, ALockThatNobodyHoldsTellsAtOnceThatTheRunIsLost) {
    RunSigns s = signs("resumed at t = 3 s", lock_of(0));
    s.seconds_since_write = 0.1;
    EXPECT_EQ(judge_state(s).state, RunState::lost);
}

TEST(RunState, WithoutALockTheAgeOfTheResultsDecides) {
    RunSigns s = signs("resumed at t = 3 s");
    s.write_interval = 60;
    s.seconds_since_write = 180;
    EXPECT_EQ(judge_state(s).state, RunState::unseen);
    s.seconds_since_write = 181;
    EXPECT_EQ(judge_state(s).state, RunState::lost);
    // However often a run writes, ten seconds of silence are no sign yet.
    s.write_interval = 0.1;
    s.seconds_since_write = 9.9;
    EXPECT_EQ(judge_state(s).state, RunState::unseen);
    s.log.reset();
    s.complete = true;
    s.seconds_since_write = 1e6;
    EXPECT_EQ(judge_state(s).state, RunState::finished);
}

TEST(RunState, WithoutResultsItWaits) {
    RunSigns s;
    EXPECT_EQ(judge_state(s).state, RunState::waiting);
    s.lock = lock_of(12);
    EXPECT_EQ(judge_state(s).state, RunState::waiting);
    EXPECT_THAT(judge_state(s).reason, HasSubstr("Process 12 "));
}

}  // namespace
}  // namespace riffle::run_state_test
