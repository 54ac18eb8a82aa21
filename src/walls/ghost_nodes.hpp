#pragma once

#include "engine/scheme.hpp"
#include "particles/particles.hpp"
#include "sph/pair_sum.hpp"

namespace riffle::inline walls {

/// What the water says at the ghost node of a wall particle.
template <int D>
struct GhostValue {
    bool found = false;      ///< any water within the kernel of the node
    double deviation = 0.0;  ///< density deviation, carried on to the wall particle
    Vec<D> velocity{};       ///< of the water at the node, m/s
};

/// The ghost nodes of the wall particles of plane walls (English et al. 2022): their mirror images in the
/// water. Density and velocity are found there by an interpolation that is exact for linear fields (Liu & Liu
/// 2006), from the water alone; the density goes on to the wall particle along its gradient.
template <int D>
class GhostNodes {
  public:
    /// Of walls in their final order. `column_width` as of the wall's own clusters.
    GhostNodes(const Case& c, const Scheme& scheme, const Domain<D>& domain, const WallParticles<D>& walls,
               double column_width);

    /// New neighbour lists of the nodes in the water, whose clusters still have their boxes.
    void build_list(const Clusters<D>& fluid, double range);

    /// Values of all nodes from the water as its motion records and the density deviations by particle say.
    template <class Real>
    void interpolate(const PairData<D, Real>& data, const Clusters<D>& fluid,
                     const std::vector<double>& density_deviation);

    [[nodiscard]] const GhostValue<D>& of(std::size_t wall_particle) const { return values_[wall_particle]; }
    [[nodiscard]] Vec<D> node(std::size_t wall_particle) const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    struct Node {
        std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    };
    void make_nodes(const Case& c, const Domain<D>& domain, const WallParticles<D>& walls,
                    double column_width);

    PairSumConstants<D> constants_;
    double hydrostatic_gradient_;              ///< -ds/dz of water at rest, 1/m
    Clusters<D> clusters_;                     ///< of the nodes
    std::vector<Node> nodes_;                  ///< by slot
    std::vector<std::int32_t> wall_particle_;  ///< by node in the order of the clusters
    std::vector<std::size_t> slot_;            ///< of the node, by wall particle
    std::vector<Vec<D>> to_wall_;              ///< from the node to the wall particle, by slot, m
    NeighbourList list_;
    std::vector<GhostValue<D>> values_;  ///< by wall particle
};

}  // namespace riffle::inline walls
