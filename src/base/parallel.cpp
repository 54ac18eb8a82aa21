#include "base/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <atomic>
#include <memory>

namespace riffle {

namespace {
std::unique_ptr<tbb::global_control>& control() {
    static std::unique_ptr<tbb::global_control> limit;
    return limit;
}
std::atomic<bool>& only_one() {
    static std::atomic<bool> one{false};
    return one;
}
}  // namespace

bool single_thread() { return only_one().load(std::memory_order_relaxed); }

void set_thread_count(int count) {
    const int threads = count > 0 ? count : tbb::info::default_concurrency();
    only_one().store(threads == 1);
    control() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
}

int thread_count() {
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return static_cast<int>(allowed);
}

}  // namespace riffle
