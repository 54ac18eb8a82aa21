#include "base/parallel.hpp"

#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <memory>

#include "base/processors.hpp"

namespace riffle::inline base {

namespace {
std::unique_ptr<tbb::global_control>& control() {
    static std::unique_ptr<tbb::global_control> limit;
    return limit;
}
std::atomic<bool>& only_one() {
    static std::atomic<bool> one{false};
    return one;
}
std::size_t& nodes() {
    static std::size_t count = 1;
    return count;
}
}  // namespace

bool single_thread() { return only_one().load(std::memory_order_relaxed); }

void set_thread_count(int count) {
    const int threads = count > 0 ? count : available_processors();
    only_one().store(threads == 1);
    control() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
    nodes() = threads > 1 ? spread_memory_over_nodes() : 1;
}

int thread_count() {
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return static_cast<int>(allowed);
}

std::string thread_description() {
    const std::string threads =
        std::to_string(thread_count()) + (thread_count() == 1 ? " thread" : " threads");
    return nodes() == 1 ? threads : threads + ", memory spread over " + std::to_string(nodes()) + " nodes";
}

}  // namespace riffle::inline base
