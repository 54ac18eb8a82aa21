#include "walls/ghost_nodes.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/parallel.hpp"
#include "sph/listed_pairs.hpp"

namespace riffle::inline walls {

namespace {

/// Moments of the water around a node, lengths in h: rows W and h grad W, columns 1 and (x_j - x)/h; right
/// sides s and u.
template <int D>
struct Moments {
    Eigen::Matrix<double, D + 1, D + 1> matrix = Eigen::Matrix<double, D + 1, D + 1>::Zero();
    Eigen::Matrix<double, D + 1, D + 1> sides = Eigen::Matrix<double, D + 1, D + 1>::Zero();
};

/// Smallest determinant of the moments that is inverted. It is 1 inside of the water; with Wendland's C2 in
/// two dimensions 0.046 on its surface and 0.0013 half a smoothing length above it, and 0.04 at the node
/// nearest to a corner of two walls.
constexpr double least_determinant = 1e-3;

}  // namespace

template <int D>
GhostNodes<D>::GhostNodes(const Case& c, const Scheme& scheme, const Domain<D>& domain,
                          const WallParticles<D>& walls, double column_width)
    : constants_(FixedPoint<D>(domain), c.numerics.kernel, scheme.smoothing_length),
      hydrostatic_gradient_(scheme.normal_gravity / (scheme.state.sound_speed * scheme.state.sound_speed)),
      values_(walls.size()) {
    make_nodes(c, domain, walls, column_width);
}

template <int D>
void GhostNodes<D>::make_nodes(const Case& c, const Domain<D>& domain, const WallParticles<D>& walls,
                               double column_width) {
    Vec<D> extent{};
    extent[0] = c.channel.length;
    extent[D - 1] = c.total_depth();
    if constexpr (D == 3) extent[1] = c.channel.simulated_width();
    std::array<std::vector<double>, static_cast<std::size_t>(D)> unsorted;
    for (std::size_t k = 0; k < D; ++k) {
        // Over the water there is a wall only where a lid is.
        const bool far_side = k + 1 < D || c.channel.top == Top::wall;
        for (const double x : walls.position[k]) {
            const bool beyond = far_side && x > extent[k];
            unsorted[k].push_back(domain.periodic[k] ? x : x < 0.0 ? -x : beyond ? 2.0 * extent[k] - x : x);
        }
    }
    wall_particle_ = spatial_order<D>(domain, position_view<D>(unsorted), column_width, 0.5 * column_width);
    std::array<std::vector<double>, static_cast<std::size_t>(D)> sorted;
    for (std::size_t k = 0; k < D; ++k) {
        for (const std::int32_t i : wall_particle_) {
            sorted[k].push_back(unsorted[k][static_cast<std::size_t>(i)]);
        }
    }
    clusters_ = build_clusters<D>(domain, constants_.fixed_point(), position_view<D>(sorted), column_width);
    nodes_.resize(clusters_.slots());
    to_wall_.resize(clusters_.slots());
    slot_.resize(walls.size());
    for (std::size_t slot = 0; slot < clusters_.slots(); ++slot) {
        for (std::size_t k = 0; k < D; ++k) nodes_[slot].x[k] = clusters_.slot_position[k][slot];
        const std::int32_t node = clusters_.particle_of(slot);
        if (node >= 0) {
            const auto wall = static_cast<std::size_t>(wall_particle_[static_cast<std::size_t>(node)]);
            slot_[wall] = slot;
            for (std::size_t k = 0; k < D; ++k) {
                to_wall_[slot][k] = walls.position[k][wall] - unsorted[k][wall];
            }
        }
    }
}

template <int D>
Vec<D> GhostNodes<D>::node(std::size_t wall_particle) const {
    Vec<D> x{};
    for (std::size_t k = 0; k < D; ++k) {
        x[k] = constants_.fixed_point().decode(nodes_[slot_[wall_particle]].x[k], k);
    }
    return x;
}

template <int D>
void GhostNodes<D>::build_list(const Clusters<D>& fluid, double range) {
    list_ = build_neighbour_list<D>(clusters_, fluid, constants_.fixed_point(), range);
}

template <int D>
template <class Real>
void GhostNodes<D>::interpolate(const PairData<D, Real>& data, const Clusters<D>& fluid,
                                const std::vector<double>& density_deviation) {
    const double h = constants_.smoothing_length();
    parallel_blocks(clusters_.size(), block_clusters, [&](std::size_t begin, std::size_t end) {
        std::vector<Moments<D>> moments((end - begin) * cluster_size);
        for_listed_pairs<D>(list_, clusters_, nodes_, data.motion, constants_.fixed_point(), 2.0 * h, begin,
                            end, [&](std::size_t i, std::size_t j, const Vec<D>& r, double squared) {
                                const auto volume = static_cast<double>(data.motion[j].volume);
                                const double slope = h * h * volume * constants_.gradient_factor(squared);
                                Eigen::Matrix<double, D + 1, 1> test;
                                Eigen::Matrix<double, 1, D + 1> basis;
                                Eigen::Matrix<double, 1, D + 1> field;
                                test(0) = volume * constants_.value(squared);
                                basis(0) = 1.0;
                                field(0) = density_deviation[static_cast<std::size_t>(fluid.particle_of(j))];
                                for (int k = 0; k < D; ++k) {
                                    const double distance = r[static_cast<std::size_t>(k)] / h;
                                    test(k + 1) = slope * distance;
                                    basis(k + 1) = -distance;
                                    field(k + 1) =
                                        static_cast<double>(data.motion[j].u[static_cast<std::size_t>(k)]);
                                }
                                Moments<D>& own = moments[i - begin * cluster_size];
                                own.matrix += test * basis;
                                own.sides += test * field;
                            });
        for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
            const std::int32_t node = clusters_.particle_of(slot);
            if (node < 0) continue;
            const Moments<D>& own = moments[slot - begin * cluster_size];
            GhostValue<D>& value =
                values_[static_cast<std::size_t>(wall_particle_[static_cast<std::size_t>(node)])];
            value = {};
            value.found = own.matrix(0, 0) > 0.0;
            if (!value.found) continue;
            if (own.matrix.determinant() >= least_determinant) {
                const Eigen::Matrix<double, D + 1, D + 1> fields = own.matrix.partialPivLu().solve(own.sides);
                value.deviation = fields(0, 0);
                for (int k = 0; k < D; ++k) {
                    const auto axis = static_cast<std::size_t>(k);
                    value.deviation += fields(k + 1, 0) * to_wall_[slot][axis] / h;
                    value.velocity[axis] = fields(0, k + 1);
                }
            } else {
                // Shepard's mean, and from its height on the density of water at rest.
                const double weight = own.matrix(0, 0);
                const double mean_height = h * own.matrix(0, D) / weight;
                value.deviation =
                    own.sides(0, 0) / weight - hydrostatic_gradient_ * (to_wall_[slot][D - 1] - mean_height);
                for (int k = 0; k < D; ++k) {
                    value.velocity[static_cast<std::size_t>(k)] = own.sides(0, k + 1) / weight;
                }
            }
        }
    });
}

template <int D>
std::size_t GhostNodes<D>::bytes() const {
    const auto size = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
    return size(nodes_) + size(wall_particle_) + size(slot_) + size(to_wall_) + size(values_) + list_.bytes();
}

template class GhostNodes<2>;
template class GhostNodes<3>;
template void GhostNodes<2>::interpolate(const PairData<2, float>&, const Clusters<2>&,
                                         const std::vector<double>&);
template void GhostNodes<2>::interpolate(const PairData<2, double>&, const Clusters<2>&,
                                         const std::vector<double>&);
template void GhostNodes<3>::interpolate(const PairData<3, float>&, const Clusters<3>&,
                                         const std::vector<double>&);
template void GhostNodes<3>::interpolate(const PairData<3, double>&, const Clusters<3>&,
                                         const std::vector<double>&);

}  // namespace riffle::inline walls
