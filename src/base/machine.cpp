#include "base/machine.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

namespace riffle::inline base {

namespace {

/// Text behind the colon of the first line of `file` that starts with `key`; empty when there is none.
std::string entry_of(const std::string& file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with(key) && colon != std::string::npos) {
            const std::size_t text = line.find_first_not_of(" \t", colon + 1);
            return text == std::string::npos ? "" : line.substr(text);
        }
    }
    return "";
}

/// Bytes of address space that the process holds.
std::size_t held_address_space() {
    std::ifstream stream("/proc/self/statm");
    std::size_t pages = 0;
    stream >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// The number that a text begins with; nothing where there is none ("max").
std::optional<std::size_t> bytes_of(const std::string& text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end != text.data() ? std::optional(value) : std::nullopt;
}

/// The number behind a word of memory.stat.
std::size_t statistic(const std::string& file, const std::string& name) {
    std::ifstream stream(file);
    std::string word;
    for (std::size_t value = 0; stream >> word >> value;) {
        if (word == name) return value;
    }
    return 0;
}

/// What a control group leaves of its memory.
std::optional<std::size_t> left_in(const ControlGroupFolder& folder) {
    const bool second = folder.version == 2;
    const auto limit =
        bytes_of(first_line(folder.path + (second ? "/memory.max" : "/memory.limit_in_bytes")));
    const auto used =
        bytes_of(first_line(folder.path + (second ? "/memory.current" : "/memory.usage_in_bytes")));
    if (!limit || !used) return std::nullopt;
    const std::size_t droppable =
        statistic(folder.path + "/memory.stat", second ? "inactive_file" : "total_inactive_file");
    const std::size_t held = *used - std::min(*used, droppable);
    return *limit - std::min(*limit, held);
}

}  // namespace

std::string processor_name() {
    const std::string name = entry_of("/proc/cpuinfo", "model name");
    return name.empty() ? "unknown" : name;
}

std::optional<std::size_t> available_memory(const SystemFiles& files) {
    const auto kilobytes = bytes_of(entry_of(files.root + "/proc/meminfo", "MemAvailable"));  // "12345 kB"
    if (!kilobytes) return std::nullopt;
    std::size_t bytes = 1024 * *kilobytes;
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        const std::size_t held = held_address_space();
        bytes = std::min(bytes, limit.rlim_cur > held ? limit.rlim_cur - held : 0);
    }
    for (const ControlGroupFolder& folder : control_group_folders(files, "memory")) {
        bytes = std::min(bytes, left_in(folder).value_or(bytes));
    }
    return bytes;
}

}  // namespace riffle::inline base
