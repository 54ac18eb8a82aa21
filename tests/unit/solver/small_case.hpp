#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "case/case.hpp"
#include "column/column.hpp"
#include "plane_bed.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"

namespace riffle::test {

/// A short piece of flow condition 2 at 4 mm: 14 rows, some hundred particles, quick to step. In three
/// dimensions just wide enough for the periodic sides, some 2000 particles, and no spheres at their places.
inline Case small_channel(int dimensions = 2) {
    Case c;
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.channel.length = 0.08;
    if (dimensions == 3) {
        c.channel.dimensions = 3;
        c.channel.width = 0.028;
        c.bed.drag_form = DragForm::plan_mean;  // that of a plane
    }
    c.bed.roughness_height = 0.010;
    c.numerics.spacing = 0.004;
    return c;
}

/// The same with still water over a smooth bed, without a closure.
inline Case still_water(int dimensions = 2) {
    Case c = small_channel(dimensions);
    c.channel.slope = 0.0;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.start.kind = StartKind::rest;
    return c;
}

/// A closed tank of still water whose particles stand in disorder.
inline Case disordered_tank() {
    Case c = still_water();
    c.channel.length = 0.1;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.0025;
    c.start.jitter = 0.2;
    c.start.packed = true;
    return c;
}

/// The simulation of a case at its start, without a column twin.
template <int D>
auto simulation_of(const Case& c) {
    return make_simulation<D>(c, nullptr, initial_particles<D>(c, make_scheme(c, nullptr), nullptr));
}

/// A solid with upright and level slip faces in a plane.
inline Solid rectangle(const char* name, double from, double to, double bottom, double top) {
    Solid solid;
    solid.name = name;
    solid.x = {from, to, to, from};
    solid.z = {bottom, bottom, top, top};
    solid.surface = SolidSurface::slip;
    return solid;
}

/// Root mean square of the speeds of all particles, m/s.
template <int D>
double rms_speed(const Particles<D>& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t k = 0; k < D; ++k) sum += p.velocity[k][i] * p.velocity[k][i];
    }
    return std::sqrt(sum / static_cast<double>(p.size()));
}

/// A place in D dimensions; a plane has no y.
template <int D>
Vec<D> place(double x, double y, double z) {
    if constexpr (D == 2) {
        return {x, z};
    } else {
        return {x, y, z};
    }
}

/// The water of a case as it starts and single particles more, at rest at these places, with the next ids.
template <int D>
Particles<D> water_and(const Case& c, const std::vector<Vec<D>>& places) {
    Particles<D> p = initial_particles<D>(c, make_scheme(c, nullptr), nullptr);
    const std::size_t water = p.size();
    p.resize(water + places.size());
    for (std::size_t i = water; i < p.size(); ++i) {
        p.id[i] = static_cast<std::int32_t>(i);
        p.mass[i] = p.mass.front();
        for (std::size_t k = 0; k < D; ++k) p.position[k][i] = places[i - water][k];
    }
    return p;
}

/// A case with its column, where it has one, and the simulation that starts from it.
template <int D>
struct ChannelIn {
    Case parameters;
    ColumnResult column;
    std::unique_ptr<SimulationIn<D>> simulation;

    explicit ChannelIn(const Case& c) : parameters(c) {
        const ColumnResult* start = nullptr;
        if (has_column(c)) {
            column = solve_column(c);
            start = &column;
        }
        simulation = make_simulation<D>(c, start, initial_particles<D>(c, make_scheme(c, start), start));
    }
    void advance(int steps) const {
        for (int i = 0; i < steps; ++i) simulation->step();
    }
    void advance_to(double time) const {
        while (simulation->clock().time < time) simulation->step();
    }
};
using Channel = ChannelIn<2>;

/// That the water's mean velocity is still the column's, to `tolerance` of it, and its level that of the
/// case.
inline void expect_carried_flow(const Channel& channel, double tolerance) {
    const auto& p = channel.simulation->particles();
    double u = 0.0;
    double z = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        u += p.velocity[0][i] / static_cast<double>(p.size());
        z += p.position[1][i] / static_cast<double>(p.size());
    }
    const double expected = channel.column.total_mean_velocity;
    const double depth = channel.parameters.total_depth();
    EXPECT_NEAR(u, expected, tolerance * expected);
    EXPECT_NEAR(z, 0.5 * depth, 0.02 * depth);
}

/// Number of each particle's place in the arrays, by its id (ids count from zero).
template <int D>
[[nodiscard]] std::vector<std::size_t> places_by_id(const Particles<D>& particles) {
    std::vector<std::size_t> place(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) place[static_cast<std::size_t>(particles.id[i])] = i;
    return place;
}

template <int D>
void expect_same_bits(const Particles<D>& a, const Particles<D>& b) {
    for (std::size_t k = 0; k < a.position.size(); ++k) {
        EXPECT_EQ(a.position[k], b.position[k]);
        EXPECT_EQ(a.velocity[k], b.velocity[k]);
    }
    EXPECT_EQ(a.density_deviation, b.density_deviation);
    EXPECT_EQ(a.id, b.id);
}

}  // namespace riffle::test
