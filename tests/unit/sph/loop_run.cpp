#include "loop_run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sph/kernel_registry.hpp"
#include "sph/pair_terms.hpp"

namespace riffle {

namespace {

/// Clusters of the particles, and the slot of each.
template <int D>
Clusters<D> clusters_of(const PairSample<D>& sample,
                        const std::vector<typename PairSample<D>::Particle>& particles,
                        std::vector<std::size_t>& slot_of) {
    constexpr double width = PairSample<D>::column_width;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> sorted;
    for (std::size_t k = 0; k < D; ++k) {
        for (const auto& p : particles) position[k].push_back(p.x[k]);
    }
    const std::vector<std::int32_t> order =
        spatial_order<D>(sample.domain, position_view<D>(position), width, 0.5 * PairSample<D>::spacing);
    for (std::size_t k = 0; k < D; ++k) {
        for (const std::int32_t i : order) sorted[k].push_back(position[k][static_cast<std::size_t>(i)]);
    }
    Clusters<D> clusters =
        build_clusters<D>(sample.domain, sample.fixed_point, position_view<D>(sorted), width);
    slot_of.resize(particles.size());
    for (std::size_t slot = 0; slot < clusters.slots(); ++slot) {
        const std::int32_t i = clusters.particle_of(slot);
        if (i >= 0) slot_of[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] = slot;
    }
    return clusters;
}

template <class Real, std::size_t N>
std::array<Real, N> rounded(const std::array<double, N>& values) {
    std::array<Real, N> result{};
    std::transform(values.begin(), values.end(), result.begin(),
                   [](double v) { return static_cast<Real>(v); });
    return result;
}

/// Position codes of all slots, empty ones included.
template <class Record, std::size_t N>
void set_positions(std::vector<Record>& records, const std::array<std::vector<std::int32_t>, N>& position) {
    for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t slot = 0; slot + 1 < records.size(); ++slot) records[slot].x[k] = position[k][slot];
    }
}

}  // namespace

template <int D, class Real>
LoopRun<D, Real>::LoopRun(const PairSample<D>& sample, const RunOptions& options)
    : gradients_(options.gradients) {
    const double h = sample.h;
    for (std::size_t k = 0; k < D; ++k) {
        data.constants.unit[k] = static_cast<Real>(sample.fixed_point.unit(k) / h);
    }
    data.constants.h = static_cast<Real>(h);
    data.constants.gradient_scale = static_cast<Real>(std::pow(h, -(D + 2)));
    data.constants.diffusion = static_cast<Real>(options.diffusion);
    data.constants.hydrostatic_gradient = static_cast<Real>(options.hydrostatic_gradient);
    data.constants.half_way = static_cast<Real>(options.ago / h);
    data.constants.correct_pressure = options.correct;
    data.constants.correct_gradient = options.correct;
    data.constants.directional = {.slope = static_cast<Real>(options.directional.slope),
                                  .level = static_cast<Real>(options.directional.level),
                                  .level_across = static_cast<Real>(options.directional.level_across),
                                  .molecular = static_cast<Real>(options.directional.molecular)};
    PairForm<Real>& form = data.constants.form;
    form = viscosity_form<D, Real>(options.viscosity);
    form.by_direction = options.by_direction;
    form.direction = data.constants.directional;
    form.impact = static_cast<Real>(options.impact);
    form.impact_bound = static_cast<Real>(options.impact_bound);
    form.non_conservative = static_cast<Real>(options.non_conservative);
    form.tensile = static_cast<Real>(options.tensile);
    form.tensile_scale = static_cast<Real>(visit_kernel<D>(options.kernel, [&](auto kernel) {
        return 1.0 / decltype(kernel)::value(PairSample<D>::spacing / h);
    }));
    data.constants.table = &kernel_table<D, Real>(options.kernel);
    pack_fluid(sample);
    if (!sample.wall.empty()) pack_walls(sample);
}

template <int D, class Real>
void LoopRun<D, Real>::pack_fluid(const PairSample<D>& sample) {
    clusters = clusters_of<D>(sample, sample.fluid, fluid_slot);
    fluid_fluid = build_neighbour_list<D>(clusters, clusters, sample.fixed_point, 2.2 * sample.h);
    data.fluid_fluid = &fluid_fluid;
    const std::size_t slots = clusters.slots();
    data.motion.resize(slots + 1);
    set_positions(data.motion, clusters.slot_position);
    if (gradients_) {
        data.stress.resize(slots + 1);
        for (auto& component : data.correction) component.resize(slots + 1);
        for (std::size_t cluster = 0; cluster < clusters.size(); ++cluster) {
            data.correction_lane.push_back(static_cast<std::int32_t>(cluster * cluster_size));
        }
    } else {
        data.pressure.resize(slots + 1);
    }
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const auto& p = sample.fluid[i];
        auto& motion = data.motion[fluid_slot[i]];
        motion.u = rounded<Real>(p.u);
        motion.s = static_cast<Real>(p.s);
        motion.volume = static_cast<Real>(p.volume);
        const auto root = static_cast<Real>(viscosity_root(p.viscosity_root * p.viscosity_root));
        const auto pressure = static_cast<Real>(p.pressure);
        if (gradients_) {
            data.stress[fluid_slot[i]] = {.stress = rounded<Real>(p.stress),
                                          .viscosity_root = root,
                                          .weight = motion.volume,
                                          .pressure = pressure};
        } else {
            data.pressure[fluid_slot[i]] = {
                .stress = {pressure}, .viscosity_root = root, .weight = motion.volume, .pressure = pressure};
        }
    }
}

template <int D, class Real>
void LoopRun<D, Real>::pack_walls(const PairSample<D>& sample) {
    wall_clusters = clusters_of<D>(sample, sample.wall, wall_slot);
    const double range = 2.2 * sample.h;
    fluid_wall = build_neighbour_list<D>(clusters, wall_clusters, sample.fixed_point, range);
    wall_fluid = build_neighbour_list<D>(wall_clusters, clusters, sample.fixed_point, range);
    data.fluid_wall = &fluid_wall;
    data.wall_fluid = &wall_fluid;
    const std::size_t slots = wall_clusters.slots();
    data.wall_gradient.resize(slots + 1);
    data.wall_force.resize(slots + 1);
    set_positions(data.wall_gradient, wall_clusters.slot_position);
    set_positions(data.wall_force, wall_clusters.slot_position);
    for (std::size_t i = 0; i < sample.wall.size(); ++i) {
        const auto& p = sample.wall[i];
        auto& of_gradient = data.wall_gradient[wall_slot[i]];
        auto& of_force = data.wall_force[wall_slot[i]];
        of_gradient.projector = rounded<Real>(p.projector);
        of_gradient.volume = static_cast<Real>(p.volume);
        of_gradient.continuation.front() = static_cast<Real>(p.continuation_along);
        of_gradient.continuation.back() = static_cast<Real>(p.continuation);
        of_force.u = rounded<Real>(p.u);
        of_force.pressure = static_cast<Real>(p.pressure);
        of_force.continuation = of_gradient.continuation;
        of_force.viscous_weight = of_gradient.volume;
        of_force.weight = of_gradient.volume;
        of_force.viscosity_root = static_cast<Real>(viscosity_root(p.viscosity_root * p.viscosity_root));
    }
}

namespace {

/// Copy the lanes of a block to the slots of the whole.
template <class Real>
void collect(const LaneArray<Real>& lanes, std::size_t begin, std::size_t end, std::vector<Real>& all) {
    all.resize(std::max(all.size(), end * cluster_size));
    std::copy_n(lanes.begin(), (end - begin) * cluster_size,
                all.begin() + static_cast<std::ptrdiff_t>(begin * cluster_size));
}
template <std::size_t N, class Real>
void collect(const std::array<LaneArray<Real>, N>& lanes, std::size_t begin, std::size_t end,
             std::array<std::vector<Real>, N>& all) {
    for (std::size_t k = 0; k < N; ++k) collect(lanes[k], begin, end, all[k]);
}

}  // namespace

template <int D, class Real>
void LoopRun<D, Real>::run(const PairLoops<D, Real>& loops) {
    const auto work = std::make_unique<BlockWork<D, Real>>();
    work->slots.resize(
        std::max({fluid_fluid.buffer_size(), fluid_wall.buffer_size(), wall_fluid.buffer_size()}));
    const auto blocks = [&](std::size_t n, const auto& f) {
        for (std::size_t begin = 0; begin < n; begin += block_clusters) {
            f(begin, std::min(n, begin + block_clusters));
        }
    };
    blocks(clusters.size(), [&](std::size_t begin, std::size_t end) {
        loops.gradient_midway(data, begin, end, *work);
        const auto& result = work->gradient;
        collect(result.density_rate, begin, end, gradient.midway_density_rate);
        loops.gradient(data, begin, end, *work);
        collect(result.density_rate, begin, end, gradient.density_rate);
        collect(result.diffusion, begin, end, gradient.diffusion);
        if (gradients_) {
            collect(result.viscosity_factor, begin, end, gradient.viscosity_factor);
            collect(result.regularity, begin, end, gradient.regularity);
            collect(result.velocity_gradient, begin, end, gradient.velocity_gradient);
            collect(result.correction, begin, end, gradient.correction);
            collect(result.correction, begin, end, data.correction);
        }
    });
    if (data.wall_fluid != nullptr) {
        blocks(wall_clusters.size(), [&](std::size_t begin, std::size_t end) {
            loops.wall(data, begin, end, *work);
            const auto& result = work->wall;
            collect(result.weight, begin, end, wall.weight);
            collect(result.pressure, begin, end, wall.pressure);
            collect(result.density_rate, begin, end, wall.density_rate);
            collect(result.offset, begin, end, wall.offset);
            collect(result.velocity, begin, end, wall.velocity);
        });
    }
    blocks(clusters.size(), [&](std::size_t begin, std::size_t end) {
        loops.force(data, begin, end, *work);
        collect(work->force.tensor, begin, end, force.tensor);
        collect(work->force.viscous, begin, end, force.viscous);
        collect(work->force.wall, begin, end, force.wall);
        loops.filter(data, begin, end, *work);
        const auto& result = work->filter;
        collect(result.zeroth, begin, end, filter.zeroth);
        collect(result.mass, begin, end, filter.mass);
        collect(result.first, begin, end, filter.first);
        collect(result.mass_first, begin, end, filter.mass_first);
        collect(result.velocity, begin, end, filter.velocity);
        collect(result.second, begin, end, filter.second);
    });
}

template struct LoopRun<2, float>;
template struct LoopRun<2, double>;
template struct LoopRun<3, float>;
template struct LoopRun<3, double>;

}  // namespace riffle
