// Sorting, neighbour lists and packing of the records.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"
#include "sph/directed_pairs.hpp"

namespace riffle {

namespace {

/// Clusters per task of a sweep without sums.
constexpr std::size_t light_block = 128;

}  // namespace

template <int D, class Real>
void SimulationOf<D, Real>::build_lists(bool sort) {
    const double spacing = case_.numerics.spacing;
    // What is made anew below is freed first: else both would be there for a while.
    fluid_fluid_ = {};
    fluid_wall_ = {};
    wall_fluid_ = {};
    data_.stress = {};
    data_.pressure = {};
    if (sort) {
        particles_.permute(
            spatial_order<D>(domain_, position_view<D>(particles_.position), column_width_, 0.5 * spacing));
        ++clock_.list_builds;
        check_solids();
        clock_.displacement_bound = 0.0;
        if (motion_.displaces()) {
            clock_.listed_time = clock_.time;
            place_walls(clock_.listed_time);
        }
        refer_to_particles();
    }
    clusters_ = build_clusters<D>(domain_, fixed_point_,
                                  position_view<D>(sort ? particles_.position : particles_.listed_position),
                                  column_width_);
    const double range = list_reach<D>(case_, scheme_);
    fluid_fluid_ = build_neighbour_list<D>(clusters_, clusters_, fixed_point_, range);
    if (walls_.size() > 0) {
        fluid_wall_ = build_neighbour_list<D>(clusters_, wall_clusters_, fixed_point_, range);
        wall_fluid_ = build_neighbour_list<D>(wall_clusters_, clusters_, fixed_point_, range);
        data_.fluid_wall = &fluid_wall_;
        data_.wall_fluid = &wall_fluid_;
    }
    if (ghosts_) {
        ghosts_->build_list(clusters_, range);
    }
    const bool walled = walls_.size() > 0;
    SweepPlan plan{.threads = static_cast<std::size_t>(thread_count())};
    if (ghosts_) {  // they look at all of the water
        plan = {.threads = 1, .wave_blocks = clusters_.size()};
    }
    order_ = order_sweeps({.fluid_fluid = &fluid_fluid_,
                           .fluid_wall = walled ? &fluid_wall_ : nullptr,
                           .wall_fluid = walled ? &wall_fluid_ : nullptr},
                          plan);
    loose_ = has_loose_particles();
    clusters_.release_boxes();
    data_.fluid_fluid = &fluid_fluid_;
    unlisted_ = false;
    allocate();
    repack();
}

template <int D, class Real>
void SimulationOf<D, Real>::refer_to_particles() {
    for (std::size_t k = 0; k < axes; ++k) {
        particle_data_.position[k] = particles_.position[k].data();
        particle_data_.velocity[k] = particles_.velocity[k].data();
    }
    particle_data_.density_deviation = particles_.density_deviation.data();
    particle_data_.mass = particles_.mass.data();
    const auto& mass = particles_.mass;
    const bool uniform = std::all_of(mass.begin(), mass.end(), [&](double m) { return m == mass.front(); });
    particle_data_.uniform_mass = uniform && !mass.empty() ? mass.front() : 0.0;
    particle_data_.clusters = &clusters_;
}

template <int D, class Real>
void SimulationOf<D, Real>::allocate() {
    // One record more than slots: it fills up turns of the loops.
    const std::size_t records = clusters_.slots() + 1;
    // A vector that grows by itself doubles: a few clusters more would take as much memory again.
    const auto resize = [&](auto& values) {
        if (records > values.capacity()) {
            values.reserve(records + records / 64);
        }
        values.resize(records);
    };
    resize(data_.motion);
    const bool gradients = needs_gradients(case_);
    if (gradients) {
        resize(data_.stress);
    } else {
        resize(data_.pressure);
    }
    // The force pass needs B only where walls continue the fluid.
    const bool continued = std::any_of(data_.wall_gradient.begin(), data_.wall_gradient.end(),
                                       [](const auto& record) { return record.continuation > Real(0); });
    if (continued && gradients) {
        std::int32_t lanes = 0;
        data_.correction_lane.assign(clusters_.size(), -1);
        for (std::size_t cluster = 0; cluster < clusters_.size(); ++cluster) {
            if (fluid_wall_.run_begin[cluster] < fluid_wall_.run_begin[cluster + 1]) {
                data_.correction_lane[cluster] = lanes;
                lanes += cluster_size;
            }
        }
        for (auto& component : data_.correction) {
            component.resize(static_cast<std::size_t>(lanes));
        }
    }
    // State and records of a particle; most processors have a mebibyte of second-level cache or more.
    constexpr std::size_t cache = std::size_t{1} << 20U;
    asks_ahead_ = particles_.size() * ((2 * axes + 1) * sizeof(double) + sizeof(data_.motion[0]) +
                                       (gradients ? sizeof(data_.stress[0]) : sizeof(data_.pressure[0]))) >
                  cache;
    moved_.resize(clusters_.size());
    const std::size_t blocks = blocks_of(clusters_.size());
    block_advance_.assign(blocks, {});
    if (block_seconds_.size() < blocks) {
        block_seconds_.resize(blocks);
    }
    const std::size_t wall_blocks = blocks_of(wall_clusters_.size());
    if (wall_seconds_.size() < wall_blocks) {
        wall_seconds_.resize(wall_blocks);
    }
    if (stepper_) {
        density_rate_.resize(particles_.size());
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::repack() {
    parallel_blocks(clusters_.size(), light_block, [&](std::size_t begin, std::size_t end) {
        particle_loops_.pack(particle_data_, data_, &moved_, begin, end);
    });
    moved_known_ = true;
    fill_last_records();
}

template <int D, class Real>
void SimulationOf<D, Real>::fill_last_records() {
    data_.motion.back() = MotionRecord<D, Real>{};
    data_.motion.back().x = data_.motion.front().x;
    if (!data_.stress.empty()) {
        data_.stress.back() = StressRecord<D, Real>{};
    } else {
        data_.pressure.back() = PressureRecord<Real>{};
    }
}

template <int D, class Real>
double SimulationOf<D, Real>::displacement_limit() const {
    return case_.numerics.skin_in(D) * scheme_.smoothing_length;
}

// Finding the displacements with the packing costs less than finding them later, but most steps need none.
template <int D, class Real>
bool SimulationOf<D, Real>::displacements_due() const {
    constexpr double margin = 1.1;  // the next step may be a little faster
    return clock_.displacement_bound + margin * last_motion_ > displacement_limit();
}

// A list stays complete as long as no two particles of neighbouring clusters have moved against each other by
// more than the skin. Only relative motion counts, so a fast but smooth flow needs few rebuilds. While the
// bound from the range of all velocities says so already, the test is spared; the answer is the same. A drop
// that flies towards water beyond its reach is in no list that the test could look at: then the bound alone
// decides; so with walls that move, which the test takes to stand still, and where ghost nodes stand in the
// water, which it does not know either.
template <int D, class Real>
bool SimulationOf<D, Real>::lists_valid(double fraction) {
    if (unlisted_) {
        return false;
    }
    const double limit = fraction * displacement_limit();
    if (clock_.displacement_bound <= limit || loose_ || ghosts_ || motion_.displaces()) {
        return clock_.displacement_bound <= limit;
    }
    if (!moved_known_) {
        repack();
    }
    const double worst = reduce_blocks(
        clusters_.size(), light_block, 0.0,
        [&](std::size_t begin, std::size_t end) {
            return particle_loops_.displaced(data_, fixed_point_, moved_, begin, end);
        },
        [](double a, double b) { return std::max(a, b); });
    clock_.displacement_bound = std::sqrt(worst);
    return clock_.displacement_bound <= limit;
}

// Whether any column of particles has a gap wider than the kernel's support, or does not reach down to the
// bed.
template <int D, class Real>
bool SimulationOf<D, Real>::has_loose_particles() const {
    if (domain_.periodic[vertical]) {
        return false;
    }
    const double support = 2.0 * scheme_.smoothing_length;
    const std::size_t columns = clusters_.column_begin.size() - 1;
    const auto height = [&](std::int32_t code) { return fixed_point_.decode(code, vertical); };
    return reduce_blocks(
               columns, light_block, 0,
               [&](std::size_t begin, std::size_t end) {
                   for (std::size_t column = begin; column < end; ++column) {
                       double reached = 0.0;  // the bed
                       for (auto c = static_cast<std::size_t>(clusters_.column_begin[column]);
                            c < static_cast<std::size_t>(clusters_.column_begin[column + 1]); ++c) {
                           if (height(clusters_.lowest[c]) > reached + support) {
                               return 1;
                           }
                           reached = height(clusters_.highest[c]);
                       }
                   }
                   return 0;
               },
               [](int a, int b) { return a + b; }) > 0;
}

template <int D, class Real>
void SimulationOf<D, Real>::listed_positions(std::size_t axis, std::size_t first,
                                             std::span<double> values) const {
    const auto& begin = clusters_.begin;
    const auto after = std::upper_bound(begin.begin(), begin.end(), static_cast<std::int32_t>(first));
    auto cluster = static_cast<std::size_t>(after - begin.begin()) - 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto particle = static_cast<std::int32_t>(first + i);
        while (particle >= begin[cluster + 1]) {
            ++cluster;
        }
        const std::size_t slot = cluster * cluster_size + static_cast<std::size_t>(particle - begin[cluster]);
        values[i] = fixed_point_.decode(clusters_.slot_position[axis][slot], axis);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::restore(Particles<D> particles, const SimulationClock& clock,
                                    std::vector<double> wall_deviation) {
    particles_ = std::move(particles);
    clock_ = clock;
    if (motion_.displaces()) {
        place_walls(clock_.listed_time);
    }
    wall_deviation_ = std::move(wall_deviation);
    if (clock_.steps > 0 || starts_beside_dry_walls(case_)) {
        wet_walls();
    }
    check_state();
    refer_to_particles();
    if (particles_.listed_position[0].empty()) {
        build_lists(true);
        return;
    }
    build_lists(false);
    particles_.listed_position = {};
}

template <int D, class Real>
double SimulationOf<D, Real>::mean_listed_neighbours() const {
    return static_cast<double>(fluid_fluid_.neighbours) / static_cast<double>(clusters_.size());
}

template <int D, class Real>
double SimulationOf<D, Real>::count_neighbours() const {
    return count_directed_pairs(data_, clusters_, fixed_point_, 2.0 * scheme_.smoothing_length) /
           static_cast<double>(particles_.size());
}

template <int D, class Real>
std::size_t SimulationOf<D, Real>::bytes() const {
    std::size_t total = 0;
    const auto add = [&](const auto& values) { total += values.capacity() * sizeof(values[0]); };
    for (std::size_t k = 0; k < axes; ++k) {
        add(particles_.position[k]);
        add(particles_.velocity[k]);
        add(clusters_.slot_position[k]);
        add(clusters_.centre[k]);
        add(clusters_.half_extent[k]);
        add(moved_.low[k]);
        add(moved_.high[k]);
        add(smoothed_velocity_[k]);
    }
    add(particles_.density_deviation);
    add(particles_.mass);
    add(particles_.id);
    add(clusters_.begin);
    add(clusters_.column_begin);
    add(clusters_.highest);
    add(clusters_.lowest);
    add(data_.motion);
    add(data_.stress);
    add(data_.pressure);
    add(data_.wall_gradient);
    add(data_.wall_force);
    for (const auto& component : data_.correction) {
        add(component);
    }
    add(data_.correction_lane);
    add(density_rate_);
    for (const auto& component : particles_.previous.motion) {
        add(component);
    }
    add(particles_.previous.density);
    total += fields_.bytes();
    total += ghosts_ ? ghosts_->bytes() : 0;
    for (const auto& sweep : sweeps_) {
        total += sweep->bytes();
    }
    return total + fluid_fluid_.bytes() + fluid_wall_.bytes() + wall_fluid_.bytes();
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
