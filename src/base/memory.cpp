#include "base/memory.hpp"

#include <malloc.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <new>
#include <string>

#include "base/error.hpp"

namespace riffle::inline base {

namespace {

constexpr const char* message =
    "out of memory: this takes more than the system gives. `riffle check CASE` says what a run needs; take "
    "a larger spacing, a shorter channel or fewer records, or a computer with more memory. A run goes on "
    "from its last checkpoint: `riffle resume DIR`\n";

std::atomic<int> log_descriptor = -1;

void put(int descriptor, const char* text) { (void)!::write(descriptor, text, std::strlen(text)); }

[[noreturn]] void end_without_memory() {
    put(STDERR_FILENO, "riffle: error: ");
    put(STDERR_FILENO, message);
    if (const int log = log_descriptor; log >= 0) {
        // As the lines of the log are (solver/run_log.cpp).
        std::array<char, 64> start{};
        const std::time_t now = std::time(nullptr);
        std::tm local{};
        if (localtime_r(&now, &local) != nullptr &&
            std::strftime(start.data(), start.size(), "%Y-%m-%d %H:%M:%S error   ", &local) > 0) {
            put(log, start.data());
        }
        put(log, message);
    }
    ::_exit(static_cast<int>(ExitCode::run_failed));
}

/// A value of /proc/self/status in bytes: "VmHWM:     12345 kB".
std::optional<std::size_t> status_value(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == name + ":") {
            std::size_t kilobytes = 0;
            return status >> kilobytes ? std::optional(1024 * kilobytes) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace

OutOfMemoryEnd::OutOfMemoryEnd() { std::set_new_handler(end_without_memory); }

OutOfMemoryEnd::~OutOfMemoryEnd() { std::set_new_handler(nullptr); }

void OutOfMemoryEnd::tell_in(int log) { log_descriptor = log; }

std::optional<std::size_t> peak_memory() { return status_value("VmHWM"); }

std::optional<std::size_t> resident_memory() { return status_value("VmRSS"); }

std::size_t kept_free_memory() {
#ifdef __GLIBC__
    return mallinfo2().fordblks;
#else
    return 0;
#endif
}

bool reset_peak_memory() {
    std::ofstream control("/proc/self/clear_refs");
    control << "5" << std::flush;
    return control.good();
}

}  // namespace riffle::inline base
