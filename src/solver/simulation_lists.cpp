// Sorting, neighbour lists and packing of the records.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

namespace {

PositionView<2> view(const std::array<std::vector<double>, 2>& position) {
    return {position[0], position[1]};
}

}  // namespace

template <class Real>
void SimulationOf<Real>::build_lists(bool sort) {
    const double spacing = case_.numerics.spacing;
    if (sort) {
        particles_.permute(
            spatial_order<2>(domain_, view(particles_.position), column_width_, 0.5 * spacing));
        particles_.listed_position = particles_.position;
        ++clock_.list_builds;
    }
    const PositionView<2> listed = view(particles_.listed_position);
    clusters_ = build_clusters<2>(domain_, fixed_point_, listed, column_width_);
    const double range = 2.0 * scheme_.smoothing_length + scheme_.skin;
    fluid_fluid_ = build_neighbour_list<2>(clusters_, clusters_, fixed_point_, range);
    if (walls_.size() > 0) {
        fluid_wall_ = build_neighbour_list<2>(clusters_, wall_clusters_, fixed_point_, range);
        wall_fluid_ = build_neighbour_list<2>(wall_clusters_, clusters_, fixed_point_, range);
        data_.fluid_wall = &fluid_wall_;
        data_.wall_fluid = &wall_fluid_;
    }
    data_.fluid_fluid = &fluid_fluid_;
    allocate();
    repack();
}

template <class Real>
void SimulationOf<Real>::repack() {
    parallel_blocks(clusters_.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            const auto [first, last] = particles_of(cluster);
            for (std::size_t i = first; i < last; ++i) {
                pack_gradient(i, cluster * cluster_size + (i - first));
            }
            pad_records(cluster);
            measure_displacement(cluster);
        }
    });
}

template <class Real>
void SimulationOf<Real>::allocate() {
    const std::size_t slots = clusters_.slots();
    const std::size_t n = particles_.size();
    data_.fluid_gradient.resize(slots);
    data_.fluid_force.resize(slots);
    data_.fluid_pressure.resize(slots);
    data_.gradient.density_rate.resize(slots);
    data_.gradient.diffusion.resize(slots);
    data_.gradient.viscosity_factor.resize(slots);
    data_.gradient.regularity.resize(slots);
    for (std::size_t k = 0; k < 4; ++k) {
        data_.gradient.velocity_gradient[k].resize(slots);
        data_.gradient.correction[k].resize(slots);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        data_.force.tensor[k].resize(slots);
        data_.force.viscous[k].resize(slots);
        data_.force.wall[k].resize(slots);
        displacement_low_[k].resize(clusters_.size());
        displacement_high_[k].resize(clusters_.size());
        acceleration_[k].resize(n);
    }
    mixing_length_.resize(n, 0.0);
    drag_coefficient_.resize(n, 0.0);
    density_rate_.resize(n, 0.0);
    cluster_largest_.resize(clusters_.size());
    cluster_fault_.assign(clusters_.size(), 0);
    fields_.resize(n);
}

template <class Real>
void SimulationOf<Real>::pack_gradient(std::size_t i, std::size_t slot) {
    auto& record = data_.fluid_gradient[slot];
    const double s = particles_.density_deviation[i];
    for (std::size_t k = 0; k < 2; ++k) {
        record.x[k] = fixed_point_.encode(particles_.position[k][i], k);
        record.u[k] = static_cast<Real>(particles_.velocity[k][i]);
    }
    record.s = static_cast<Real>(s);
    record.volume = static_cast<Real>(particles_.mass[i] / (scheme_.density * (1.0 + s)));
}

template <class Real>
void SimulationOf<Real>::pad_records(std::size_t cluster) {
    const auto [first, last] = particles_of(cluster);
    const std::size_t slot = cluster * cluster_size;
    for (std::size_t empty = slot + (last - first); empty < slot + cluster_size; ++empty) {
        // An empty lane repeats the first particle without volume: finite results that nobody reads.
        data_.fluid_gradient[empty] = data_.fluid_gradient[slot];
        data_.fluid_gradient[empty].volume = Real(0);
        data_.fluid_force[empty] = ForceRecord<2, Real>{};
        data_.fluid_force[empty].x = data_.fluid_gradient[slot].x;
        data_.fluid_pressure[empty] = Real(0);
    }
}

template <class Real>
void SimulationOf<Real>::pack_wall_records() {
    if (walls_.size() == 0) {
        return;
    }
    const std::size_t slots = wall_clusters_.slots();
    data_.wall_gradient.assign(slots, {});
    data_.wall_force.assign(slots, {});
    data_.wall.weight.resize(slots);
    data_.wall.pressure.resize(slots);
    data_.wall.density_rate.resize(slots);
    for (std::size_t k = 0; k < 2; ++k) {
        data_.wall.offset[k].resize(slots);
        data_.wall.velocity[k].resize(slots);
    }
    for (std::size_t slot = 0; slot < slots; ++slot) {
        auto& gradient = data_.wall_gradient[slot];
        auto& force = data_.wall_force[slot];
        for (std::size_t k = 0; k < 2; ++k) {
            gradient.x[k] = wall_clusters_.slot_position[k][slot];
            force.x[k] = gradient.x[k];
        }
        const std::int32_t particle = wall_clusters_.particle_of_slot[slot];
        if (particle < 0) {
            continue;
        }
        const auto i = static_cast<std::size_t>(particle);
        for (std::size_t k = 0; k < 4; ++k) {
            // Dynamic particles are fluid that does not move: the whole velocity counts.
            const double identity = k == 0 || k == 3 ? 1.0 : 0.0;
            gradient.projector[k] = static_cast<Real>(wall_law_.dynamic ? identity : walls_.projector[k][i]);
        }
        // Water and end wall meet the surface at the same height: the wall continues the water, corrected
        // like it, so that nothing varies along the surface at rest. Under a bed this would be friction (3 to
        // 4 %).
        gradient.continuation =
            static_cast<Real>(!wall_law_.dynamic && walls_.normal[1][i] == 0.0 ? 1.0 : 0.0);
        force.continuation = gradient.continuation;
        gradient.volume = static_cast<Real>(walls_.volume[i]);
        force.weight = static_cast<Real>(walls_.volume[i]);
        force.volume = static_cast<Real>(wall_law_.no_slip ? walls_.volume[i] : 0.0);
        force.viscosity_root = static_cast<Real>(std::sqrt(scheme_.viscosity));
    }
}

template <class Real>
std::pair<std::size_t, std::size_t> SimulationOf<Real>::particles_of(std::size_t cluster) const {
    const std::size_t slot = cluster * cluster_size;
    const auto first = static_cast<std::size_t>(clusters_.particle_of_slot[slot]);
    std::size_t count = 1;
    while (count < cluster_size && clusters_.particle_of_slot[slot + count] >= 0) {
        ++count;
    }
    return {first, first + count};
}

template <class Real>
void SimulationOf<Real>::measure_displacement(std::size_t cluster) {
    const auto [first, last] = particles_of(cluster);
    for (std::size_t k = 0; k < 2; ++k) {
        const double period = domain_.extent(static_cast<int>(k));
        double low = 0.0;
        double high = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            double d = particles_.position[k][i] - particles_.listed_position[k][i];
            if (domain_.periodic[k]) {
                d -= period * std::nearbyint(d / period);
            }
            low = i == first ? d : std::min(low, d);
            high = i == first ? d : std::max(high, d);
        }
        displacement_low_[k][cluster] = low;
        displacement_high_[k][cluster] = high;
    }
}

// A list stays complete as long as no two particles of neighbouring clusters have moved against each other by
// more than the skin. Only relative motion counts, so a fast but smooth flow needs few rebuilds.
template <class Real>
bool SimulationOf<Real>::lists_valid(double fraction) const {
    const double limit = fraction * scheme_.skin;
    const double limit_squared = limit * limit;
    const auto largest = [&](const NeighbourList& list, bool fixed, std::size_t begin, std::size_t end) {
        double worst = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            for (const std::int32_t other : list.clusters_of(i)) {
                const auto j = static_cast<std::size_t>(other);
                double squared = 0.0;
                for (std::size_t k = 0; k < 2; ++k) {
                    const double low_j = fixed ? 0.0 : displacement_low_[k][j];
                    const double high_j = fixed ? 0.0 : displacement_high_[k][j];
                    const double d =
                        std::max(displacement_high_[k][i] - low_j, high_j - displacement_low_[k][i]);
                    squared += d * d;
                }
                worst = std::max(worst, squared);
            }
        }
        return worst;
    };
    const double worst = reduce_blocks(
        clusters_.size(), std::size_t{256}, 0.0,
        [&](std::size_t begin, std::size_t end) {
            double result = largest(fluid_fluid_, false, begin, end);
            if (data_.fluid_wall != nullptr) {
                result = std::max(result, largest(fluid_wall_, true, begin, end));
            }
            return result;
        },
        [](double a, double b) { return std::max(a, b); });
    return worst <= limit_squared;
}

template <class Real>
double SimulationOf<Real>::mean_listed_neighbours() const {
    return static_cast<double>(fluid_fluid_.slots.size()) / static_cast<double>(clusters_.size());
}

template class SimulationOf<float>;
template class SimulationOf<double>;

}  // namespace riffle
