// Sorting, neighbour lists and packing of the records.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "case/velocity_gradient.hpp"
#include "engine/pair_setup.hpp"
#include "solver/simulation_of.hpp"
#include "sph/directed_pairs.hpp"

namespace riffle::inline solver {

template <int D, class Real>
void SimulationOf<D, Real>::build_lists(bool sort) {
    const double spacing = flow_.c.numerics.spacing;
    Particles<D>& particles = flow_.particles;
    // What is made anew below is freed first: else both would be there for a while.
    flow_.fluid_fluid = {};
    flow_.fluid_wall = {};
    flow_.wall_fluid = {};
    flow_.data.stress = {};
    flow_.data.pressure = {};
    flow_.data.pair_pressure = {};
    if (sort) {
        for (const auto& component : components_) component->before_lists(flow_);
        particles.permute(spatial_order<D>(flow_.domain, position_view<D>(particles.position),
                                           flow_.column_width, 0.5 * spacing));
        ++flow_.clock.list_builds;
        for (const auto& component : components_) component->particles_sorted(flow_);
        flow_.clock.displacement_bound = 0.0;
        walls_.place_for_lists(flow_);
        flow_.refer_to_particles();
    }
    flow_.clusters = build_clusters<D>(
        flow_.domain, flow_.fixed_point,
        position_view<D>(sort ? particles.position : particles.listed_position), flow_.column_width);
    const double reach = list_reach<D>(flow_.c, flow_.scheme);
    const auto list = [&](const Clusters<D>& from, const Clusters<D>& to) {
        return build_neighbour_list<D>(from, to, flow_.fixed_point, reach);
    };
    flow_.fluid_fluid = list(flow_.clusters, flow_.clusters);
    flow_.data.fluid_fluid = &flow_.fluid_fluid;
    if (flow_.walls.size() > 0) {
        flow_.fluid_wall = list(flow_.clusters, flow_.wall_clusters);
        flow_.wall_fluid = list(flow_.wall_clusters, flow_.clusters);
        flow_.data.fluid_wall = &flow_.fluid_wall;
        flow_.data.wall_fluid = &flow_.wall_fluid;
    }
    walls_.lists_built(flow_, reach);
    order_passes_anew();
    loose_ = has_loose_particles();
    flow_.clusters.release_boxes();
    unlisted_ = false;
    for (const auto& component : components_) component->lists_built(flow_);
    allocate();
    flow_.repack();
}

template <int D, class Real>
void SimulationOf<D, Real>::order_passes_anew() {
    std::vector<PassDeclaration> declarations;
    for (const Pass& pass : passes_) declarations.push_back(pass.declaration);
    std::vector<ListBetween> lists{{.from = fluid_set, .to = fluid_set, .list = &flow_.fluid_fluid}};
    if (flow_.walls.size() > 0) {
        lists.push_back({.from = fluid_set, .to = wall_set, .list = &flow_.fluid_wall});
        lists.push_back({.from = wall_set, .to = fluid_set, .list = &flow_.wall_fluid});
    }
    const std::array sizes{flow_.clusters.size(), flow_.wall_clusters.size()};
    order_ = order_passes(declarations, lists, sizes, {.threads = static_cast<std::size_t>(thread_count())});
}

template <int D, class Real>
void SimulationOf<D, Real>::allocate() {
    // One record more than slots: it fills up turns of the loops.
    const std::size_t records = flow_.clusters.slots() + 1;
    // A vector that grows by itself doubles: a few clusters more would take as much memory again.
    const auto resize = [&](auto& values) {
        if (records > values.capacity()) values.reserve(records + records / 64);
        values.resize(records);
    };
    resize(flow_.data.motion);
    const bool gradients = needs_gradients(flow_.c);
    if (gradients) {
        resize(flow_.data.stress);
    } else {
        resize(flow_.data.pressure);
    }
    if (flow_.particle_data.reference_pressure.acts()) resize(flow_.data.pair_pressure);
    // The force pass needs B only where walls continue the fluid.
    const bool continued =
        std::any_of(flow_.data.wall_gradient.begin(), flow_.data.wall_gradient.end(),
                    [](const auto& record) { return record.continuation.back() > Real(0); });
    if (continued && gradients) {
        std::int32_t lanes = 0;
        flow_.data.correction_lane.assign(flow_.clusters.size(), -1);
        for (std::size_t cluster = 0; cluster < flow_.clusters.size(); ++cluster) {
            if (flow_.fluid_wall.run_begin[cluster] < flow_.fluid_wall.run_begin[cluster + 1]) {
                flow_.data.correction_lane[cluster] = lanes;
                lanes += cluster_size;
            }
        }
        for (auto& component : flow_.data.correction) component.resize(static_cast<std::size_t>(lanes));
    }
    // State and records of a particle; most processors have a mebibyte of second-level cache or more.
    constexpr std::size_t cache = std::size_t{1} << 20U;
    asks_ahead_ = flow_.particles.size() *
                      ((2 * axes + 1) * sizeof(double) + sizeof(flow_.data.motion[0]) +
                       (gradients ? sizeof(flow_.data.stress[0]) : sizeof(flow_.data.pressure[0]))) >
                  cache;
    flow_.moved.resize(flow_.clusters.size());
    const std::size_t blocks = blocks_of(flow_.clusters.size());
    flow_.block_advance.assign(blocks, {});
    if (block_seconds_.size() < blocks) block_seconds_.resize(blocks);
    const std::size_t wall_blocks = blocks_of(flow_.wall_clusters.size());
    if (wall_seconds_.size() < wall_blocks) wall_seconds_.resize(wall_blocks);
}

template <int D, class Real>
double SimulationOf<D, Real>::displacement_limit() const {
    return flow_.c.numerics.skin_in(D) * flow_.scheme.smoothing_length;
}

// Finding the displacements with the packing costs less than finding them later, but most steps need none.
template <int D, class Real>
bool SimulationOf<D, Real>::displacements_due() const {
    constexpr double margin = 1.1;  // the next step may be a little faster
    return flow_.clock.displacement_bound + margin * last_motion_ > displacement_limit();
}

// A list stays complete as long as no two particles of neighbouring clusters have moved against each other by
// more than the skin. Only relative motion counts, so a fast but smooth flow needs few rebuilds. While the
// bound from the range of all velocities says so already, the test is spared; the answer is the same. A drop
// that flies towards water beyond its reach is in no list that the test could look at: then the bound alone
// decides; so with walls that move, which the test takes to stand still, and where ghost nodes stand in the
// water, which it does not know either.
template <int D, class Real>
bool SimulationOf<D, Real>::lists_valid(double fraction) {
    if (unlisted_ || std::any_of(components_.begin(), components_.end(),
                                 [&](const auto& component) { return component->lists_expired(flow_); })) {
        return false;
    }
    const double limit = fraction * displacement_limit();
    if (flow_.clock.displacement_bound <= limit || loose_ || walls_.outside_of_lists(flow_)) {
        return flow_.clock.displacement_bound <= limit;
    }
    if (!flow_.moved_known) flow_.repack();
    const double worst = reduce_blocks(
        flow_.clusters.size(), light_block, 0.0,
        [&](std::size_t begin, std::size_t end) {
            return flow_.particle_loops.displaced(flow_.data, flow_.fixed_point, flow_.moved, begin, end);
        },
        [](double a, double b) { return std::max(a, b); });
    flow_.clock.displacement_bound = std::sqrt(worst);
    return flow_.clock.displacement_bound <= limit;
}

// Whether any column of particles has a gap wider than the kernel's support, or does not reach down to the
// bed.
template <int D, class Real>
bool SimulationOf<D, Real>::has_loose_particles() const {
    if (flow_.domain.periodic[vertical]) return false;
    const double support = 2.0 * flow_.scheme.smoothing_length;
    const std::size_t columns = flow_.clusters.column_begin.size() - 1;
    const auto height = [&](std::int32_t code) { return flow_.fixed_point.decode(code, vertical); };
    return reduce_blocks(
               columns, light_block, 0,
               [&](std::size_t begin, std::size_t end) {
                   for (std::size_t column = begin; column < end; ++column) {
                       double reached = 0.0;  // the bed
                       for (auto c = static_cast<std::size_t>(flow_.clusters.column_begin[column]);
                            c < static_cast<std::size_t>(flow_.clusters.column_begin[column + 1]); ++c) {
                           if (height(flow_.clusters.lowest[c]) > reached + support) return 1;
                           reached = height(flow_.clusters.highest[c]);
                       }
                   }
                   return 0;
               },
               [](int a, int b) { return a + b; }) > 0;
}

template <int D, class Real>
void SimulationOf<D, Real>::listed_positions(std::size_t axis, std::size_t first,
                                             std::span<double> values) const {
    const auto& begin = flow_.clusters.begin;
    const auto after = std::upper_bound(begin.begin(), begin.end(), static_cast<std::int32_t>(first));
    auto cluster = static_cast<std::size_t>(after - begin.begin()) - 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto particle = static_cast<std::int32_t>(first + i);
        while (particle >= begin[cluster + 1]) ++cluster;
        const std::size_t slot = cluster * cluster_size + static_cast<std::size_t>(particle - begin[cluster]);
        values[i] = flow_.fixed_point.decode(flow_.clusters.slot_position[axis][slot], axis);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::restore(Particles<D> particles, const SimulationClock& clock,
                                    std::vector<double> wall_deviation) {
    flow_.particles = std::move(particles);
    flow_.clock = clock;
    walls_.restore(flow_, std::move(wall_deviation));
    check_state();
    flow_.refer_to_particles();
    if (flow_.particles.listed_position[0].empty()) {
        build_lists(true);
        return;
    }
    build_lists(false);
    flow_.particles.listed_position = {};
}

template <int D, class Real>
double SimulationOf<D, Real>::mean_listed_neighbours() const {
    return static_cast<double>(flow_.fluid_fluid.neighbours) / static_cast<double>(flow_.clusters.size());
}

template <int D, class Real>
double SimulationOf<D, Real>::count_neighbours() const {
    return count_directed_pairs(flow_.data, flow_.clusters, flow_.fixed_point,
                                2.0 * flow_.scheme.smoothing_length) /
           static_cast<double>(flow_.particles.size());
}

template <int D, class Real>
std::size_t SimulationOf<D, Real>::bytes() const {
    std::size_t total = 0;
    const auto add = [&](const auto& values) { total += values.capacity() * sizeof(values[0]); };
    for (std::size_t k = 0; k < axes; ++k) {
        add(flow_.clusters.slot_position[k]);
        add(flow_.clusters.centre[k]);
        add(flow_.clusters.half_extent[k]);
        add(flow_.moved.low[k]);
        add(flow_.moved.high[k]);
    }
    add(flow_.clusters.begin);
    add(flow_.clusters.column_begin);
    add(flow_.clusters.highest);
    add(flow_.clusters.lowest);
    add(flow_.data.motion);
    add(flow_.data.stress);
    add(flow_.data.pressure);
    add(flow_.data.pair_pressure);
    add(flow_.data.wall_gradient);
    add(flow_.data.wall_force);
    for (const auto& component : flow_.data.correction) add(component);
    add(flow_.data.correction_lane);
    total += flow_.particles.bytes() + flow_.fields.bytes();
    for (const auto& component : components_) total += component->bytes();
    return total + walls_.bytes() + method_->bytes() + flow_.fluid_fluid.bytes() + flow_.fluid_wall.bytes() +
           flow_.wall_fluid.bytes();
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle::inline solver
