#pragma once

#include "case/case.hpp"
#include "column/column.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"

namespace riffle::test {

/// A short piece of flow condition 2 at 4 mm: 14 rows, some hundred particles, quick to step.
inline Case small_channel() {
    Case c;
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.channel.length = 0.08;
    c.bed.roughness_height = 0.010;
    c.numerics.spacing = 0.004;
    return c;
}

struct Channel {
    Case parameters;
    ColumnResult column;
    std::unique_ptr<Simulation> simulation;

    explicit Channel(const Case& c) : parameters(c), column(solve_column(c)) {
        simulation = make_simulation(c, &column, initial_particles(c, make_scheme(c, &column), &column));
    }
    void advance(int steps) const {
        for (int i = 0; i < steps; ++i) {
            simulation->step();
        }
    }
};

}  // namespace riffle::test
