#include "base/processors.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/parallel.hpp"

namespace riffle::processors_test {
namespace {

namespace fs = std::filesystem;

/// A folder with what a system would say, gone at the end.
class SystemFolder {
  public:
    SystemFolder() : root_(fs::path(testing::TempDir()) / ("riffle-system-" + std::to_string(getpid()))) {
        fs::remove_all(root_);
    }
    ~SystemFolder() { fs::remove_all(root_); }
    SystemFolder(const SystemFolder&) = delete;
    SystemFolder& operator=(const SystemFolder&) = delete;
    SystemFolder(SystemFolder&&) = delete;
    SystemFolder& operator=(SystemFolder&&) = delete;

    void write(const std::string& file, const std::string& text) const {
        const fs::path path = root_ / file;
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text << '\n';
    }
    [[nodiscard]] SystemFiles files() const { return {root_.string()}; }

  private:
    fs::path root_;
};

/// Processors of the machine that the test runs on.
int allowed() {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof(set), &set);
    return CPU_COUNT(&set);
}

TEST(NumbersOfList, ReadsRangesAndRefusesWhatIsNone) {
    EXPECT_EQ(numbers_of_list("0"), (std::vector<std::size_t>{0}));
    EXPECT_EQ(numbers_of_list("0-3,8,10-11"), (std::vector<std::size_t>{0, 1, 2, 3, 8, 10, 11}));
    EXPECT_TRUE(numbers_of_list("").empty());
    EXPECT_TRUE(numbers_of_list("none").empty());
    EXPECT_TRUE(numbers_of_list("0-x").empty());
    EXPECT_TRUE(numbers_of_list("1x").empty());
}

TEST(AvailableProcessors, AreThoseOfTheAffinityWithoutALimit) {
    const SystemFolder system;
    EXPECT_EQ(available_processors(system.files()), allowed());
    system.write("proc/self/cgroup", "0::/");
    system.write("sys/fs/cgroup/cpu.max", "max 100000");
    EXPECT_EQ(available_processors(system.files()), allowed());
}

// A container with two processors' time on a machine of 64 would run 64 threads that wait for each other.
TEST(AvailableProcessors, AreLimitedByTheTimeOfAControlGroup) {
    const SystemFolder system;
    system.write("proc/self/cgroup", "0::/outer/inner");
    system.write("sys/fs/cgroup/outer/inner/cpu.max", "max 100000");
    system.write("sys/fs/cgroup/outer/cpu.max", "50000 100000");
    EXPECT_EQ(available_processors(system.files()), 1) << "half a processor, of a group further up";
    system.write("sys/fs/cgroup/outer/cpu.max", "150000 100000");
    EXPECT_EQ(available_processors(system.files()), std::min(allowed(), 2)) << "a part counts as one";
}

TEST(AvailableProcessors, AreLimitedByAControlGroupOfTheFirstVersion) {
    const SystemFolder system;
    system.write("proc/self/cgroup", "5:memory:/job\n4:cpu,cpuacct:/job\n0::/");
    system.write("sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "100000");
    system.write("sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "100000");
    EXPECT_EQ(available_processors(system.files()), 1);
    system.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "100000");
    system.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000");
    system.write("sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "-1");
    EXPECT_EQ(available_processors(system.files()), 1) << "the folder's other name";
    system.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "-1");
    EXPECT_EQ(available_processors(system.files()), allowed());
}

TEST(MemoryNodes, AreThoseWithAProcessorThatMayBeUsed) {
    const SystemFolder system;
    system.write("sys/devices/system/node/has_memory", "0-2");
    system.write("sys/devices/system/node/node0/cpulist", "0-3,8-11");
    system.write("sys/devices/system/node/node1/cpulist", "4-7,12-15");
    system.write("sys/devices/system/node/node2/cpulist", "");  // memory without processors
    EXPECT_EQ(memory_nodes({0, 4}, system.files()), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(memory_nodes({9, 10}, system.files()), (std::vector<std::size_t>{0}));
    EXPECT_TRUE(memory_nodes({0}, SystemFiles{"/no such folder"}).empty());
}

TEST(ThreadDescription, CountsThreads) {
    set_thread_count(1);
    EXPECT_EQ(thread_description(), "1 thread");
    set_thread_count(2);
    EXPECT_EQ(thread_description().substr(0, 9), "2 threads");
    set_thread_count(0);
    EXPECT_EQ(thread_count(), available_processors());
}

}  // namespace
}  // namespace riffle::processors_test
