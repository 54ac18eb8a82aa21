#include "sph/peak_rate.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "sph/loop_table.hpp"

namespace riffle::inline sph {

double measure_peak_rate(InstructionSet set, double seconds, int repetitions) {
    using Clock = std::chrono::steady_clock;
    const PeakLoop loop = loop_table(set).peak;
    // About 0.1 ms between two looks at the clock.
    constexpr std::int64_t turns = 50'000;
    volatile float kept = 0.0F;
    std::vector<double> rates;
    for (int i = 0; i < repetitions; ++i) {
        const auto start = Clock::now();
        double elapsed = 0.0;
        double done = 0.0;
        while (elapsed < seconds) {
            kept = loop.run(turns);
            done += static_cast<double>(turns);
            elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        }
        rates.push_back(1e-9 * done * loop.operations_per_turn / elapsed);
    }
    (void)kept;
    const auto middle = rates.begin() + repetitions / 2;
    std::nth_element(rates.begin(), middle, rates.end());
    return *middle;
}

}  // namespace riffle::inline sph
