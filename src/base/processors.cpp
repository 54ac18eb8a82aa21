#include "base/processors.hpp"

#include <linux/mempolicy.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace riffle::inline base {

namespace {

/// A number at the start of a text; nothing where there is none ("max").
std::optional<double> number_of(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end != text.data() ? std::optional(value) : std::nullopt;
}

/// Processors worth of time that `quota` microseconds of each `period` are; infinite without a limit.
double granted(const std::string& quota, const std::string& period) {
    const auto q = number_of(quota);
    const auto p = number_of(period);
    return q && p && *q > 0.0 && *p > 0.0 ? *q / *p : std::numeric_limits<double>::infinity();
}

/// Processors worth of time that the control group of the process has.
double granted_by_control_group(const SystemFiles& files) {
    double least = std::numeric_limits<double>::infinity();
    for (const ControlGroupFolder& folder : control_group_folders(files, "cpu")) {
        std::string quota = first_line(folder.path + "/cpu.cfs_quota_us");
        std::string period = first_line(folder.path + "/cpu.cfs_period_us");
        if (folder.version == 2) {
            std::istringstream words(first_line(folder.path + "/cpu.max"));
            words >> quota >> period;
        }
        least = std::min(least, granted(quota, period));
    }
    return least;
}

/// Masks of the kernel: bit n of consecutive words.
constexpr std::size_t word_bits = 8 * sizeof(unsigned long);
template <class Words>
bool has_bit(const Words& words, std::size_t n) {
    return (words[n / word_bits] >> n % word_bits & 1UL) != 0;
}

/// Processors that the process may run on.
std::vector<std::size_t> processors_of_process() {
    // Larger than any machine's; the call fails where the kernel's own set is larger.
    constexpr std::size_t most = 16384;
    std::vector<unsigned long> bits(most / word_bits);
    const long bytes = syscall(SYS_sched_getaffinity, 0, bits.size() * sizeof(bits[0]), bits.data());
    std::vector<std::size_t> processors;
    for (std::size_t p = 0; bytes > 0 && p < 8 * static_cast<std::size_t>(bytes); ++p) {
        if (has_bit(bits, p)) processors.push_back(p);
    }
    return processors;
}

}  // namespace

std::vector<std::size_t> numbers_of_list(const std::string& text) {
    std::vector<std::size_t> numbers;
    std::istringstream ranges(text);
    for (std::string range; std::getline(ranges, range, ',');) {
        std::size_t first = 0;
        const char* const end = range.data() + range.size();
        std::from_chars_result read = std::from_chars(range.data(), end, first);
        std::size_t last = first;
        if (read.ec == std::errc() && read.ptr != end && *read.ptr == '-') {
            read = std::from_chars(read.ptr + 1, end, last);
        }
        if (read.ec != std::errc() || read.ptr != end) {
            return {};
        }
        for (std::size_t n = first; n <= last; ++n) numbers.push_back(n);
    }
    return numbers;
}

int available_processors(const SystemFiles& files) {
    const auto allowed = static_cast<double>(std::max<std::size_t>(processors_of_process().size(), 1));
    return static_cast<int>(std::min(allowed, std::max(1.0, std::ceil(granted_by_control_group(files)))));
}

std::vector<std::size_t> memory_nodes(const std::vector<std::size_t>& processors, const SystemFiles& files) {
    const std::string folder = files.root + "/sys/devices/system/node";
    std::vector<std::size_t> nodes;
    for (const std::size_t node : numbers_of_list(first_line(folder + "/has_memory"))) {
        const std::vector<std::size_t> of_node =
            numbers_of_list(first_line(folder + "/node" + std::to_string(node) + "/cpulist"));
        if (std::find_first_of(of_node.begin(), of_node.end(), processors.begin(), processors.end()) !=
            of_node.end()) {
            nodes.push_back(node);
        }
    }
    return nodes;
}

std::size_t spread_memory_over_nodes() {
    constexpr std::size_t most = 1024;
    using NodeMask = std::array<unsigned long, most / word_bits>;
    NodeMask allowed{};
    // The kernel takes one bit less than it is told of.
    if (syscall(SYS_get_mempolicy, nullptr, allowed.data(), most + 1, nullptr, MPOL_F_MEMS_ALLOWED) != 0) {
        return 1;
    }
    NodeMask mask{};
    std::size_t count = 0;
    for (const std::size_t node : memory_nodes(processors_of_process())) {
        if (node < most && has_bit(allowed, node)) {
            mask[node / word_bits] |= 1UL << node % word_bits;
            ++count;
        }
    }
    // The answer of the first call: the next would meet the policy that it has set.
    static const bool unchosen = [] {
        int policy = MPOL_DEFAULT;
        return syscall(SYS_get_mempolicy, &policy, nullptr, 0UL, nullptr, 0UL) == 0 && policy == MPOL_DEFAULT;
    }();
    const bool spread =
        count > 1 && unchosen && syscall(SYS_set_mempolicy, MPOL_INTERLEAVE, mask.data(), most + 1) == 0;
    return spread ? count : 1;
}

}  // namespace riffle::inline base
