#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/control_group.hpp"

namespace riffle::inline base {

/// Name of the processor as /proc/cpuinfo gives it; "unknown" where there is none.
[[nodiscard]] std::string processor_name();

/// Bytes of memory that this process may still take: what the system reports as available, or less where the
/// process's address space is limited (`ulimit -v`) or its control group's memory (containers, batch systems:
/// memory.max, memory.limit_in_bytes in version 1; file content that can be dropped counts as free). Nothing
/// where the system does not say.
[[nodiscard]] std::optional<std::size_t> available_memory(const SystemFiles& files = {});

}  // namespace riffle::inline base
