#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/control_group.hpp"

namespace riffle::inline base {

/// Numbers of a list such as "0-3,8"; empty where the text is none.
[[nodiscard]] std::vector<std::size_t> numbers_of_list(const std::string& text);

/// Processors that the process may run on (affinity: taskset, a batch system), or fewer where its control
/// group grants less computing time (containers: cpu.max, or cpu.cfs_quota_us of version 1); at least 1.
[[nodiscard]] int available_processors(const SystemFiles& files = {});

/// Nodes of a computer whose memory is in several places (NUMA) that have any of these processors.
[[nodiscard]] std::vector<std::size_t> memory_nodes(const std::vector<std::size_t>& processors,
                                                    const SystemFiles& files = {});

/// Let the memory that this thread and those it starts take from now on lie page by page on all nodes that
/// the process may run on, instead of where a page is written first. Tasks go to any thread, so no place is
/// near to all uses of a page; spread out, all memory controllers work, instead of that one beside the thread
/// that made the arrays. Returns over how many nodes: 1 where there is one, where somebody has chosen a
/// policy already (numactl), or where the system refuses. It stays so for the life of the process.
std::size_t spread_memory_over_nodes();

}  // namespace riffle::inline base
