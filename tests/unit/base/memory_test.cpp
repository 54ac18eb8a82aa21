// What a process may take of the memory, as far as the system's files tell.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/machine.hpp"

namespace riffle::memory_test {
namespace {

namespace fs = std::filesystem;

class AvailableMemory : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(root_);
        write("proc/meminfo", "MemTotal: 9000 kB\nMemAvailable:    8000 kB\n");
    }
    void TearDown() override { fs::remove_all(root_); }
    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text << '\n';
    }
    [[nodiscard]] std::optional<std::size_t> available() const {
        return available_memory(SystemFiles{root_.string()});
    }

  private:
    fs::path root_ = fs::path(testing::TempDir()) / ("riffle-memory-" + std::to_string(getpid()));
};

TEST_F(AvailableMemory, IsThatOfTheMachineWithoutALimit) { EXPECT_EQ(available(), 8000U * 1024U); }

TEST_F(AvailableMemory, IsWhatTheControlGroupLeaves) {
    write("proc/self/cgroup", "0::/job/step");
    write("sys/fs/cgroup/job/memory.max", "2000000");
    write("sys/fs/cgroup/job/memory.current", "700000");
    write("sys/fs/cgroup/job/memory.stat", "anon 400000\ninactive_file 300000");
    write("sys/fs/cgroup/job/step/memory.max", "max");
    write("sys/fs/cgroup/job/step/memory.current", "1");
    EXPECT_EQ(available(), 1600000U);  // files that can be dropped count as free
}

TEST_F(AvailableMemory, KnowsTheFirstVersionToo) {
    write("proc/self/cgroup", "4:memory:/box");
    write("sys/fs/cgroup/memory/box/memory.limit_in_bytes", "1000000");
    write("sys/fs/cgroup/memory/box/memory.usage_in_bytes", "1500000");
    EXPECT_EQ(available(), 0U);
    write("sys/fs/cgroup/memory/box/memory.stat", "total_inactive_file 600000");
    EXPECT_EQ(available(), 100000U);
}

}  // namespace
}  // namespace riffle::memory_test
