#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "particles/domain.hpp"

namespace riffle::inline particles {

inline constexpr int cluster_size = 8;

/// Particles cut into clusters of 8 neighbours in space. The domain is divided into columns along the last
/// axis; the particles of a column, sorted by height, fill its clusters from the bottom, and the last cluster
/// of a column is padded with empty slots. Slot 8 c + l is lane l of cluster c. Cluster c holds the particles
/// [begin[c], begin[c + 1]), which follow each other in memory.
template <int D>
struct Clusters {
    std::vector<std::int32_t> begin;         ///< clusters + 1: first particle of each cluster
    std::vector<std::int32_t> column_begin;  ///< first cluster of each column, and the number of clusters
    std::array<int, static_cast<std::size_t>(D) - 1>
        columns{};  ///< number of columns along each of the other axes
    std::array<bool, static_cast<std::size_t>(D)> periodic{};
    Vec<D> lower{};  ///< corner of the first column
    Vec<D> column_width{};

    /// Bounding box of each cluster: centre in integer units, half extent in metres. 8 more elements than
    /// clusters, so that lanes may read past the last one.
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> centre;
    std::array<std::vector<float>, static_cast<std::size_t>(D)> half_extent;
    /// Bit l of a cluster: whether its slot l holds a particle. 8 more elements than clusters.
    std::vector<std::uint8_t> present;
    /// Along a last axis that is not periodic, in integer units: no cluster of the column up to this one
    /// reaches higher than `highest`, and none from this one on lower than `lowest`.
    std::vector<std::int32_t> highest;
    std::vector<std::int32_t> lowest;
    std::int32_t top = std::numeric_limits<std::int32_t>::min();  ///< the highest of all

    /// Positions in integer units by slot, 8 more than slots; empty ones repeat their cluster's last
    /// particle.
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> slot_position;

    /// Free what only the search for neighbours needs.
    void release_boxes() {
        for (std::size_t k = 0; k < D; ++k) {
            std::vector<std::int32_t>().swap(centre[k]);
            std::vector<float>().swap(half_extent[k]);
        }
        std::vector<std::uint8_t>().swap(present);
        std::vector<std::int32_t>().swap(highest);
        std::vector<std::int32_t>().swap(lowest);
    }

    [[nodiscard]] std::size_t size() const { return begin.empty() ? 0 : begin.size() - 1; }
    [[nodiscard]] std::size_t slots() const { return size() * cluster_size; }
    /// Number of particles of a cluster, 1 to 8.
    [[nodiscard]] int count(std::size_t cluster) const { return begin[cluster + 1] - begin[cluster]; }
    /// Particle of a slot; -1 in an empty one.
    [[nodiscard]] std::int32_t particle_of(std::size_t slot) const {
        const std::size_t cluster = slot / cluster_size;
        const std::int32_t particle = begin[cluster] + static_cast<std::int32_t>(slot % cluster_size);
        return particle < begin[cluster + 1] ? particle : -1;
    }
};

template <int D>
using PositionView = std::array<std::span<const double>, static_cast<std::size_t>(D)>;

/// Views of arrays of positions, one per axis.
template <int D>
[[nodiscard]] PositionView<D> position_view(
    const std::array<std::vector<double>, static_cast<std::size_t>(D)>& position) {
    PositionView<D> view;
    for (std::size_t k = 0; k < D; ++k) view[k] = position[k];
    return view;
}

/// Order in which particles follow each other in space: by column (width about `column_width`), then by bins
/// of `bin_height` along the last axis; ties keep their old order. order[i] is the old index of particle i.
template <int D>
[[nodiscard]] std::vector<std::int32_t> spatial_order(const Domain<D>& domain,
                                                      const PositionView<D>& position, double column_width,
                                                      double bin_height);

/// Cut particles that already stand in spatial order into clusters. The same widths as for spatial_order.
template <int D>
[[nodiscard]] Clusters<D> build_clusters(const Domain<D>& domain, const FixedPoint<D>& fixed_point,
                                         const PositionView<D>& position, double column_width);

}  // namespace riffle::inline particles
