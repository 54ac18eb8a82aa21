#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"

namespace riffle::test {

/// A run of a case with open ends, through the library.
template <int D>
struct OpenRun {
    Case c;
    std::unique_ptr<SimulationIn<D>> simulation;

    explicit OpenRun(const std::string& text) : OpenRun(parse_case(text, "open ends")) {}
    explicit OpenRun(const Case& of) : c(of) {
        simulation =
            make_simulation<D>(c, nullptr, initial_particles<D>(c, make_scheme(c, nullptr), nullptr));
    }
    void advance_to(double time) {
        while (simulation->clock().time < time) simulation->step();
    }
    [[nodiscard]] const OpenEndsState& ends() const { return simulation->clock().open_ends; }

    /// Take over the state of another run of the case, as a checkpoint keeps it.
    void restore_from(const OpenRun& other) {
        Particles<D> saved = other.simulation->particles();
        for (std::size_t k = 0; k < D && !other.simulation->lists_out_of_date(); ++k) {
            saved.listed_position[k].resize(saved.size());
            other.simulation->listed_positions(k, 0, saved.listed_position[k]);
        }
        SimulationClock clock = other.simulation->clock();
        const std::vector<double> sound = clock.open_ends.sound_numbers();
        clock.open_ends = OpenEndsState::from(clock.open_ends.numbers());
        clock.open_ends.take_sound(sound);
        simulation->restore(saved, clock, other.simulation->wall_density_deviation());
    }
};

/// The same ends and water to the bit.
template <int D>
void expect_same_bits(const OpenRun<D>& one, const OpenRun<D>& other) {
    EXPECT_EQ(one.ends(), other.ends());
    EXPECT_EQ(one.simulation->particles().position, other.simulation->particles().position);
    EXPECT_EQ(one.simulation->particles().velocity, other.simulation->particles().velocity);
    EXPECT_EQ(one.simulation->particles().density_deviation, other.simulation->particles().density_deviation);
    EXPECT_EQ(one.simulation->particles().id, other.simulation->particles().id);
}

}  // namespace riffle::test
