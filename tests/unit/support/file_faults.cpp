// Stands between a program and the calls of the system that change files: open for writing, write, pwrite,
// fsync, ftruncate, rename, link, unlink, and close of what was opened for writing. Linked into a test it
// takes the calls of the test. As a library that is loaded first (LD_PRELOAD) it takes those of a whole
// program, and the environment says what is to happen: RIFFLE_FAULT (fail, full, end, half), RIFFLE_FAULT_AT,
// RIFFLE_FAULT_ERROR (errno), RIFFLE_FAULT_REPORT (file for the number of calls and the name of the faulted
// one).

#include "file_faults.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace riffle::test {
namespace {

std::atomic<bool> active = false;
FileFault fault_kind = FileFault::none;
int fault_at = 0;
int fault_error = EIO;
std::atomic<int> calls = 0;
const char* faulted = "";
std::array<std::atomic<bool>, 4096> written_to = {};  ///< by descriptor

template <class Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

enum class Happens { wholly, half_then_end, not_at_all };

Happens next_call(const char* name, bool writes) {
    if (!active) return Happens::wholly;
    const int number = calls++;
    if (fault_kind == FileFault::full && number > fault_at && writes) {
        errno = fault_error;
        return Happens::not_at_all;
    }
    if (fault_kind == FileFault::none || number != fault_at) return Happens::wholly;
    faulted = name;
    if (fault_kind == FileFault::half && writes) return Happens::half_then_end;
    if (fault_kind == FileFault::end || fault_kind == FileFault::half) ::_exit(9);
    errno = fault_error;
    return Happens::not_at_all;
}

bool is_written_to(int descriptor) {
    return descriptor > 2 && static_cast<std::size_t>(descriptor) < written_to.size() &&
           written_to[static_cast<std::size_t>(descriptor)];
}

int open_counted(const char* path, int flags, mode_t mode, const char* name) {
    const bool writes = (flags & O_ACCMODE) != O_RDONLY;
    const Happens happens = writes ? next_call("open", (flags & O_CREAT) != 0) : Happens::wholly;
    if (happens == Happens::half_then_end) ::_exit(9);  // there is no half of an opening
    if (happens == Happens::not_at_all) return -1;
    const int descriptor = real<int(const char*, int, ...)>(name)(path, flags, mode);
    if (descriptor >= 0 && static_cast<std::size_t>(descriptor) < written_to.size()) {
        written_to[static_cast<std::size_t>(descriptor)] = writes;
    }
    return descriptor;
}

template <class Write>
ssize_t write_counted(const char* name, int descriptor, std::size_t size, const Write& write) {
    const Happens happens = is_written_to(descriptor) ? next_call(name, true) : Happens::wholly;
    if (happens == Happens::not_at_all) return -1;
    if (happens == Happens::half_then_end) {
        (void)write(size / 2);
        ::_exit(9);
    }
    return write(size);
}

struct FromEnvironment {
    FromEnvironment() {
        const char* const word = std::getenv("RIFFLE_FAULT");
        if (word == nullptr) return;
        const std::string_view kind(word);
        const auto number = [](const char* name, int otherwise) {
            const char* const text = std::getenv(name);
            return text != nullptr ? std::atoi(text) : otherwise;
        };
        set_file_fault(kind == "fail"   ? FileFault::fail
                       : kind == "full" ? FileFault::full
                       : kind == "end"  ? FileFault::end
                       : kind == "half" ? FileFault::half
                                        : FileFault::none,
                       number("RIFFLE_FAULT_AT", 0), number("RIFFLE_FAULT_ERROR", EIO));
    }
    ~FromEnvironment() {
        const char* const report = std::getenv("RIFFLE_FAULT_REPORT");
        if (report == nullptr) return;
        active = false;
        if (std::FILE* const file = std::fopen(report, "w"); file != nullptr) {
            (void)std::fprintf(file, "%d %s\n", file_calls(), faulted_call());
            (void)std::fclose(file);
        }
    }
};
const FromEnvironment from_environment;

}  // namespace

void set_file_fault(FileFault fault, int at, int error) {
    fault_kind = fault;
    fault_at = at;
    fault_error = error;
    calls = 0;
    faulted = "";
    active = true;
}

int file_calls() { return calls; }
const char* faulted_call() { return faulted; }

}  // namespace riffle::test

// NOLINTBEGIN(*-vararg, readability-identifier-naming)
extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return riffle::test::open_counted(path, flags, mode, "open");
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return riffle::test::open_counted(path, flags, mode, "open64");
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
    static const auto real = riffle::test::real<ssize_t(int, const void*, size_t)>("write");
    return riffle::test::write_counted("write", descriptor, size,
                                       [&](size_t part) { return real(descriptor, bytes, part); });
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t at) {
    static const auto real = riffle::test::real<ssize_t(int, const void*, size_t, off_t)>("pwrite");
    return riffle::test::write_counted("pwrite", descriptor, size,
                                       [&](size_t part) { return real(descriptor, bytes, part, at); });
}

int fsync(int descriptor) {
    static const auto real = riffle::test::real<int(int)>("fsync");
    if (riffle::test::next_call("fsync", false) != riffle::test::Happens::wholly) return -1;
    return real(descriptor);
}

int ftruncate(int descriptor, off_t size) {
    static const auto real = riffle::test::real<int(int, off_t)>("ftruncate");
    if (riffle::test::next_call("ftruncate", false) != riffle::test::Happens::wholly) return -1;
    return real(descriptor, size);
}

int rename(const char* from, const char* to) {
    static const auto real = riffle::test::real<int(const char*, const char*)>("rename");
    if (riffle::test::next_call("rename", false) != riffle::test::Happens::wholly) return -1;
    return real(from, to);
}

int link(const char* from, const char* to) {
    static const auto real = riffle::test::real<int(const char*, const char*)>("link");
    if (riffle::test::next_call("link", false) != riffle::test::Happens::wholly) return -1;
    return real(from, to);
}

int unlink(const char* path) {
    static const auto real = riffle::test::real<int(const char*)>("unlink");
    if (riffle::test::next_call("unlink", false) != riffle::test::Happens::wholly) return -1;
    return real(path);
}

int close(int descriptor) {
    static const auto real = riffle::test::real<int(int)>("close");
    if (!riffle::test::is_written_to(descriptor)) return real(descriptor);
    riffle::test::written_to[static_cast<std::size_t>(descriptor)] = false;
    const auto happens = riffle::test::next_call("close", false);
    const int result = real(descriptor);
    return happens == riffle::test::Happens::wholly ? result : -1;
}

}  // extern "C"
// NOLINTEND(*-vararg, readability-identifier-naming)
