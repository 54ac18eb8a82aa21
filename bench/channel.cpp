#include "channel.hpp"

#include <cmath>

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "solver/benchmark.hpp"
#include "solver/simulation_of.hpp"
#include "solver/start.hpp"

namespace riffle::bench {

namespace {

template <int D, class Arrays>
PositionView<D> view(const Arrays& position) {
    PositionView<D> result;
    for (std::size_t k = 0; k < D; ++k) {
        result[k] = position[k];
    }
    return result;
}

/// About 50 000 particles in either dimension: the records do not fit into the second cache.
template <int D>
Workload workload_of(const std::string& scheme) {
    if constexpr (D == 2) {
        return {.name = "bench", .scheme = scheme, .spacing = 0.0015, .length = 2.0, .jitter = 0.1};
    } else {
        return {.name = "bench",
                .scheme = scheme,
                .dimensions = 3,
                .spacing = 0.002,
                .length = 0.08,
                .width = 0.09,
                .jitter = 0.1};
    }
}

}  // namespace

LoopTable loops_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512:
            return avx512::loop_table();
        case InstructionSet::avx2:
            return avx2::loop_table();
        case InstructionSet::baseline:
            break;
    }
    return baseline::loop_table();
}

template <int D>
NeighbourSearchFunction<D> search_of(InstructionSet set) {
    if constexpr (D == 2) {
        return loops_of(set).plane_search;
    } else {
        return loops_of(set).space_search;
    }
}

template <int D>
PairLoops<D, float> pair_loops_of(InstructionSet set, bool gradients) {
    return pair_loops<D, float>({.gradients = gradients}, set);
}

template <int D>
ParticleLoops<D, float> particle_loops_of(InstructionSet set) {
    if constexpr (D == 2) {
        return loops_of(set).plane_particles_single;
    } else {
        return loops_of(set).space_particles_single;
    }
}

template <int D>
Channel<D>::Channel(const std::string& scheme_name) : gradients(scheme_name == "default") {
    const Workload workload = workload_of<D>(scheme_name);
    const Case c = workload_case(workload);
    const ColumnResult column = workload_column(workload);
    scheme = make_scheme(c, &column);
    domain = domain_of<D>(c);
    fixed_point = FixedPoint<D>(domain);
    column_width = cluster_column_spacings(D) * c.numerics.spacing;
    range = (2.0 + c.numerics.skin_in(D)) * scheme.smoothing_length;

    particles = initial_particles<D>(c, scheme, &column);
    particles.permute(spatial_order<D>(domain, positions(), column_width, 0.5 * c.numerics.spacing));
    clusters = build_clusters<D>(domain, fixed_point, positions(), column_width);
    walls = wall_particles<D>(c);
    walls.permute(spatial_order<D>(domain, view<D>(walls.position), column_width, 0.5 * c.numerics.spacing));
    wall_clusters = build_clusters<D>(domain, fixed_point, view<D>(walls.position), column_width);
    fluid_fluid = build_neighbour_list<D>(clusters, clusters, fixed_point, range);
    fluid_wall = build_neighbour_list<D>(clusters, wall_clusters, fixed_point, range);
    wall_fluid = build_neighbour_list<D>(wall_clusters, clusters, fixed_point, range);
    work.slots.resize(
        std::max({fluid_fluid.buffer_size(), fluid_wall.buffer_size(), wall_fluid.buffer_size()}));

    const double h = scheme.smoothing_length;
    const double c0 = scheme.state.sound_speed;
    data.fluid_fluid = &fluid_fluid;
    data.fluid_wall = &fluid_wall;
    data.wall_fluid = &wall_fluid;
    for (std::size_t k = 0; k < D; ++k) {
        data.constants.unit[k] = static_cast<float>(fixed_point.unit(k) / h);
    }
    data.constants.h = static_cast<float>(h);
    data.constants.gradient_scale = static_cast<float>(std::pow(h, -(D + 2)));
    data.constants.diffusion = static_cast<float>(c.numerics.density_diffusion_coefficient * h * c0);
    data.constants.hydrostatic_gradient = static_cast<float>(scheme.normal_gravity / (c0 * c0));
    data.constants.correct_pressure = gradients;
    data.constants.correct_gradient = gradients;

    for (std::size_t k = 0; k < D; ++k) {
        particle_data.position[k] = particles.position[k].data();
        particle_data.velocity[k] = particles.velocity[k].data();
    }
    particle_data.density_deviation = particles.density_deviation.data();
    particle_data.mass = particles.mass.data();
    particle_data.domain = domain;
    particle_data.fixed_point = fixed_point;
    particle_data.state = scheme.state;
    particle_data.density = scheme.density;
    particle_data.viscosity = scheme.viscosity;
    particle_data.gravity[0] = scheme.streamwise_gravity;
    particle_data.gravity[D - 1] = -scheme.normal_gravity;
    particle_data.corrected = gradients;
    particle_data.closure = gradients;
    particle_data.clusters = &clusters;

    pack_walls();
    pack_fluid();
}

template <int D>
void Channel<D>::pack_walls() {
    data.wall_gradient.assign(wall_clusters.slots() + 1, {});
    data.wall_force.assign(wall_clusters.slots() + 1, {});
    for (std::size_t slot = 0; slot < wall_clusters.slots(); ++slot) {
        auto& gradient = data.wall_gradient[slot];
        auto& force = data.wall_force[slot];
        for (std::size_t k = 0; k < D; ++k) {
            gradient.x[k] = wall_clusters.slot_position[k][slot];
            force.x[k] = gradient.x[k];
        }
        if (wall_clusters.particle_of(slot) < 0) {
            continue;
        }
        const auto i = static_cast<std::size_t>(wall_clusters.particle_of(slot));
        for (std::size_t k = 0; k < D * D; ++k) {
            gradient.projector[k] = static_cast<float>(walls.projector[k][i]);
        }
        gradient.volume = static_cast<float>(walls.volume[i]);
        force.weight = gradient.volume;
        force.viscous_weight = gradient.volume;
        force.viscosity_root = static_cast<float>(std::sqrt(0.5 * scheme.viscosity));
    }
}

template <int D>
void Channel<D>::pack_fluid() {
    data.motion.resize(clusters.slots() + 1);
    if (gradients) {
        data.stress.resize(clusters.slots() + 1);
    } else {
        data.pressure.resize(clusters.slots() + 1);
    }
    moved.resize(clusters.size());
    particle_work.mixing_length.fill(0.1 * scheme.depth);
    const PairLoops<D, float> sums = pair_loops_of<D>(active_instruction_set(), gradients);
    const ParticleLoops<D, float> loops = particle_loops_of<D>(active_instruction_set());
    for_blocks(clusters, [&](std::size_t begin, std::size_t end) {
        loops.pack(particle_data, data, moved, begin, end);
    });
    for_blocks(clusters, [&](std::size_t begin, std::size_t end) {
        sums.gradient(data, begin, end, work);
        loops.stress(particle_data, data, work, particle_work, 0.0, begin, end);
    });
}

template <int D>
PositionView<D> Channel<D>::positions() const {
    return view<D>(particles.position);
}

template <int D>
double Channel<D>::directed_pairs() const {
    const double support = 2.0 * scheme.smoothing_length;
    double pairs = -static_cast<double>(particles.size());  // not with itself
    std::vector<std::int32_t> slots(work.slots.size());
    for (std::size_t cluster = 0; cluster < clusters.size(); ++cluster) {
        const auto add = [&](const NeighbourList& list, const auto& records) {
            const std::size_t count = list.spell(cluster, slots.data());
            for (int lane = 0; lane < clusters.count(cluster); ++lane) {
                const auto& own = data.motion[cluster * cluster_size + static_cast<std::size_t>(lane)];
                for (std::size_t n = 0; n < count; ++n) {
                    const auto& other = records[static_cast<std::size_t>(slots[n])];
                    double squared = 0.0;
                    for (std::size_t k = 0; k < D; ++k) {
                        const double d = wrapped_difference(own.x[k], other.x[k]) * fixed_point.unit(k);
                        squared += d * d;
                    }
                    pairs += squared < support * support ? 1.0 : 0.0;
                }
            }
        };
        add(fluid_fluid, data.motion);
        add(fluid_wall, data.wall_gradient);
    }
    return pairs;
}

template struct Channel<2>;
template struct Channel<3>;
template NeighbourSearchFunction<2> search_of<2>(InstructionSet);
template NeighbourSearchFunction<3> search_of<3>(InstructionSet);
template PairLoops<2, float> pair_loops_of<2>(InstructionSet, bool);
template PairLoops<3, float> pair_loops_of<3>(InstructionSet, bool);
template ParticleLoops<2, float> particle_loops_of<2>(InstructionSet);
template ParticleLoops<3, float> particle_loops_of<3>(InstructionSet);

}  // namespace riffle::bench
