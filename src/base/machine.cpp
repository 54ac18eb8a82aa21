#include "base/machine.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace riffle {

namespace {

/// Text behind the colon of the first line of `file` that starts with `key`; empty when there is none.
std::string entry_of(const char* file, const std::string& key) {
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

}  // namespace

std::string processor_name() {
    const std::string name = entry_of("/proc/cpuinfo", "model name");
    return name.empty() ? "unknown" : name;
}

std::optional<std::size_t> available_memory() {
    const std::string available = entry_of("/proc/meminfo", "MemAvailable");  // "12345 kB"
    if (available.empty()) {
        return std::nullopt;
    }
    std::size_t bytes = 1024 * std::stoull(available);
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        const std::size_t held = held_address_space();
        bytes = std::min(bytes, limit.rlim_cur > held ? limit.rlim_cur - held : 0);
    }
    return bytes;
}

}  // namespace riffle
