#include "channel.hpp"

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "solver/benchmark.hpp"
#include "engine/pair_setup.hpp"
#include "engine/flow.hpp"
#include "solver/start.hpp"
#include "sph/directed_pairs.hpp"
#include "walls/wall_records.hpp"

namespace riffle::bench {

namespace {

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

template <int D>
Channel<D>::Channel(const std::string& scheme_name) : gradients(scheme_name == "default") {
    const Workload workload = workload_of<D>(scheme_name);
    const Case c = workload_case(workload);
    const ColumnResult column = workload_column(workload);
    scheme = make_scheme(c, &column);
    domain = domain_of<D>(c);
    fixed_point = FixedPoint<D>(domain);
    column_width = cluster_column_spacings(D) * c.numerics.spacing;
    range = list_reach<D>(c, scheme);

    particles = initial_particles<D>(c, scheme, &column);
    particles.permute(spatial_order<D>(domain, positions(), column_width, 0.5 * c.numerics.spacing));
    clusters = build_clusters<D>(domain, fixed_point, positions(), column_width);
    walls = wall_particles<D>(c);
    walls.permute(
        spatial_order<D>(domain, position_view<D>(walls.position), column_width, 0.5 * c.numerics.spacing));
    wall_clusters = build_clusters<D>(domain, fixed_point, position_view<D>(walls.position), column_width);
    fluid_fluid = build_neighbour_list<D>(clusters, clusters, fixed_point, range);
    fluid_wall = build_neighbour_list<D>(clusters, wall_clusters, fixed_point, range);
    wall_fluid = build_neighbour_list<D>(wall_clusters, clusters, fixed_point, range);
    work.slots.resize(
        std::max({fluid_fluid.buffer_size(), fluid_wall.buffer_size(), wall_fluid.buffer_size()}));

    data.fluid_fluid = &fluid_fluid;
    data.fluid_wall = &fluid_wall;
    data.wall_fluid = &wall_fluid;
    data.constants = pair_constants<D, float>(c, scheme, fixed_point);
    particle_data = particle_constants<D>(c, scheme, domain);
    for (std::size_t k = 0; k < D; ++k) {
        particle_data.position[k] = particles.position[k].data();
        particle_data.velocity[k] = particles.velocity[k].data();
    }
    particle_data.density_deviation = particles.density_deviation.data();
    particle_data.mass = particles.mass.data();
    particle_data.clusters = &clusters;

    pack_wall_records<D, float>(c, scheme, walls, wall_clusters, data);
    pack_fluid();
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
    const PairLoops<D, float> sums = pair_loops<D, float>({.gradients = gradients});
    const ParticleLoops<D, float> loops = particle_loops<D, float>();
    for_blocks(clusters, [&](std::size_t begin, std::size_t end) {
        loops.pack(particle_data, data, &moved, begin, end);
    });
    for_blocks(clusters, [&](std::size_t begin, std::size_t end) {
        sums.gradient(data, begin, end, work);
        loops.stress(particle_data, data, work, particle_work, 0.0, begin, end);
    });
}

template <int D>
PositionView<D> Channel<D>::positions() const {
    return position_view<D>(particles.position);
}

template <int D>
double Channel<D>::directed_pairs() const {
    return count_directed_pairs(data, clusters, fixed_point, 2.0 * scheme.smoothing_length);
}

template struct Channel<2>;
template struct Channel<3>;

}  // namespace riffle::bench
