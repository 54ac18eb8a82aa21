#pragma once

#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::test {

/// Expects the same bits of a case after some steps with one, two and three threads.
template <int D>
void expect_same_bits_for_any_threads(const Case& c, int steps) {
    const auto state_after = [&](int threads) {
        set_thread_count(threads);
        const ChannelIn<D> channel(c);
        channel.advance(steps);
        return saved_particles(*channel.simulation);
    };
    const auto one = state_after(1);
    for (const int threads : {2, 3}) {
        expect_same_bits(one, state_after(threads));
    }
    set_thread_count(1);
}

/// Expects a run that was saved after some steps to go on with the bits of one that was not, which two
/// threads share from there on.
template <int D = 2>
void expect_same_bits_after_resume(const Case& c, int before, int after) {
    const ChannelIn<D> straight(c);
    straight.advance(before);
    const ChannelIn<D> resumed(c);
    resumed.simulation->restore(saved_particles(*straight.simulation), straight.simulation->clock(),
                                straight.simulation->wall_density_deviation());
    set_thread_count(2);
    straight.advance(after);
    set_thread_count(1);
    resumed.advance(after);
    set_thread_count(0);
    expect_same_bits(straight.simulation->particles(), resumed.simulation->particles());
}

}  // namespace riffle::test
