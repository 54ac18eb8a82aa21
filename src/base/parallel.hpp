#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace riffle::inline base {

/// Number of threads that the parallel loops use from now on; 0: all processors that this process may run on
/// and has computing time for (available_processors()). With several threads, memory taken later is spread
/// over the nodes of a computer that has more than one (spread_memory_over_nodes()).
void set_thread_count(int count);

/// Whether set_thread_count() asked for one thread: the loops then need no scheduler.
[[nodiscard]] bool single_thread();

/// Number of threads in use.
[[nodiscard]] int thread_count();

/// "8 threads", or "8 threads, memory spread over 2 nodes".
[[nodiscard]] std::string thread_description();

/// Call f(begin, end) for consecutive blocks that cover [0, n). The blocks do not depend on the number of
/// threads, so work that is independent between blocks gives the same bits for any thread count.
template <class F>
void parallel_blocks(std::size_t n, std::size_t block, const F& f) {
    const std::size_t blocks = (n + block - 1) / block;
    if (blocks <= 1 || single_thread()) {
        for (std::size_t b = 0; b < blocks; ++b) f(b * block, std::min(n, (b + 1) * block));
        return;
    }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, blocks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t b = range.begin(); b != range.end(); ++b) {
                f(b * block, std::min(n, (b + 1) * block));
            }
        },
        tbb::auto_partitioner());
}

/// Deterministic reduction: map(begin, end) -> T on fixed blocks, the results combined in order.
template <class T, class Map, class Combine>
[[nodiscard]] T reduce_blocks(std::size_t n, std::size_t block, T identity, const Map& map,
                              const Combine& combine) {
    std::vector<T> partial((n + block - 1) / block, identity);
    parallel_blocks(n, block,
                    [&](std::size_t begin, std::size_t end) { partial[begin / block] = map(begin, end); });
    T result = identity;
    for (const T& p : partial) result = combine(result, p);
    return result;
}

}  // namespace riffle::inline base
