#pragma once

#include <algorithm>
#include <string>

#include "particles/particles.hpp"
#include "engine/scheme.hpp"
#include "sph/pair_loops.hpp"
#include "sph/particle_loops.hpp"

namespace riffle::bench {

/// A channel on a jittered lattice, as a simulation holds it in the middle of a step: particles in spatial
/// order, clusters, lists, and all records that the loops read.
template <int D>
struct Channel {
    /// `scheme`: "plain" or "default", as in `riffle bench`.
    explicit Channel(const std::string& scheme);
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;
    Channel(Channel&&) = delete;
    Channel& operator=(Channel&&) = delete;
    ~Channel() = default;

    Scheme scheme;
    Domain<D> domain;
    FixedPoint<D> fixed_point;
    Particles<D> particles;
    WallParticles<D> walls;
    double column_width = 0.0;  ///< m
    double range = 0.0;         ///< of the lists, m
    Clusters<D> clusters;
    Clusters<D> wall_clusters;
    NeighbourList fluid_fluid;
    NeighbourList fluid_wall;
    NeighbourList wall_fluid;
    bool gradients = false;  ///< the loops of the default scheme
    PairData<D, float> data;
    ParticleData<D> particle_data;
    Displacement<D> moved;
    BlockWork<D, float> work;
    ParticleWork<D, float> particle_work;

    [[nodiscard]] PositionView<D> positions() const;
    /// Directed pairs within the support, of fluid particles with fluid and wall.
    [[nodiscard]] double directed_pairs() const;

    /// f(begin, end) for the blocks that a simulation cuts the clusters into.
    template <class F>
    static void for_blocks(const Clusters<D>& clusters, const F& f) {
        for (std::size_t begin = 0; begin < clusters.size(); begin += block_clusters) {
            f(begin, std::min(clusters.size(), begin + block_clusters));
        }
    }

  private:
    void pack_fluid();
};

}  // namespace riffle::bench
