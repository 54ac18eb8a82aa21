#pragma once

#include <cstddef>
#include <optional>

namespace riffle::inline base {

/// Let the program end with a message, at once, when it gets no more memory: what would have to be undone
/// after std::bad_alloc needs memory itself, and parts of the libraries do not survive it. Files stay as
/// after a kill. The message goes to standard error and, as an error, to a log.
class OutOfMemoryEnd {
  public:
    OutOfMemoryEnd();
    /// Throw std::bad_alloc again.
    ~OutOfMemoryEnd();
    OutOfMemoryEnd(const OutOfMemoryEnd&) = delete;
    OutOfMemoryEnd& operator=(const OutOfMemoryEnd&) = delete;

    /// The log's file, opened for appending; -1: none.
    static void tell_in(int log);
};

/// Most memory that this process has had at a time since reset_peak_memory(), or its start, bytes (VmHWM).
/// Nothing where the system does not say.
[[nodiscard]] std::optional<std::size_t> peak_memory();

/// Memory that it has now, bytes (VmRSS).
[[nodiscard]] std::optional<std::size_t> resident_memory();

/// What of it the program has given back and the library keeps for the next request, bytes; 0 where the
/// library does not say.
[[nodiscard]] std::size_t kept_free_memory();

/// Count the peak anew; whether the system lets it.
bool reset_peak_memory();

}  // namespace riffle::inline base
