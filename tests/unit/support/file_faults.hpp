#pragma once

namespace riffle::test {

/// What happens at one of the system's calls that change files.
enum class FileFault {
    none,
    fail,  ///< this one call fails
    full,  ///< this one fails, and all writing after it: a full disk
    end,   ///< the process ends before the call, without any cleaning up
    half,  ///< as `end`; half of what a call was to write has been written
};

/// From now on let the fault happen at the call number `at`, counted from 0, of this process. `error`: errno
/// of a call that fails. The program must be linked with file_faults.cpp.
void set_file_fault(FileFault fault, int at = 0, int error = 0);

/// Calls counted since then.
[[nodiscard]] int file_calls();

/// Name of the call at which the fault happened; empty before.
[[nodiscard]] const char* faulted_call();

}  // namespace riffle::test
