#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "particles/domain.hpp"

namespace riffle {

inline constexpr int cluster_size = 8;

/// Particles cut into clusters of 8 neighbours in space. The domain is divided into columns along the last
/// axis; the particles of a column, sorted by height, fill its clusters from the bottom, and the last cluster
/// of a column is padded with empty slots. Slot 8 c + l is lane l of cluster c.
template <int D>
struct Clusters {
    std::vector<std::int32_t> particle_of_slot;  ///< -1 in an empty slot
    std::vector<std::int32_t> slot_of_particle;
    std::vector<std::int32_t> column_begin;  ///< first cluster of each column, and the number of clusters
    std::array<int, static_cast<std::size_t>(D) - 1>
        columns{};  ///< number of columns along each of the other axes
    std::array<bool, static_cast<std::size_t>(D)> periodic{};
    Vec<D> lower{};  ///< corner of the first column
    Vec<D> column_width{};

    /// Bounding box of each cluster: centre in integer units, half extent in metres.
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> centre;
    std::array<std::vector<float>, static_cast<std::size_t>(D)> half_extent;

    /// Positions in integer units by slot; empty slots repeat the first particle of their cluster.
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> slot_position;

    [[nodiscard]] std::size_t size() const { return particle_of_slot.size() / cluster_size; }
    [[nodiscard]] std::size_t slots() const { return particle_of_slot.size(); }
};

template <int D>
using PositionView = std::array<std::span<const double>, static_cast<std::size_t>(D)>;

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

}  // namespace riffle
