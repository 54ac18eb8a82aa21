#include "particles/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace riffle {

namespace {

/// Division of the horizontal axes into columns.
template <int D>
struct ColumnGrid {
    std::array<int, static_cast<std::size_t>(D) - 1> count{};
    Vec<D> width{};
    Vec<D> lower{};

    ColumnGrid(const Domain<D>& domain, double target_width) : lower(domain.lower) {
        for (std::size_t k = 0; k + 1 < D; ++k) {
            const double extent = domain.upper[k] - domain.lower[k];
            count[k] = std::max(1, static_cast<int>(std::lround(extent / target_width)));
            width[k] = extent / count[k];
        }
    }

    [[nodiscard]] int total() const {
        return std::accumulate(count.begin(), count.end(), 1, [](int a, int b) { return a * b; });
    }

    [[nodiscard]] int column_of(const PositionView<D>& position, std::size_t i) const {
        int column = 0;
        for (std::size_t k = 0; k + 1 < D; ++k) {
            const int c = static_cast<int>((position[k][i] - lower[k]) / width[k]);
            column = column * count[k] + std::clamp(c, 0, count[k] - 1);
        }
        return column;
    }
};

}  // namespace

template <int D>
std::vector<std::int32_t> spatial_order(const Domain<D>& domain, const PositionView<D>& position,
                                        double column_width, double bin_height) {
    const ColumnGrid<D> grid(domain, column_width);
    const auto& height = position[D - 1];
    const double bottom = domain.lower[D - 1];
    const int bins = std::max(1, static_cast<int>(std::ceil(domain.extent(D - 1) / bin_height)));
    const std::size_t n = height.size();

    std::vector<std::int32_t> key(n);
    std::vector<std::int32_t> begin(
        static_cast<std::size_t>(grid.total()) * static_cast<std::size_t>(bins) + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const int bin = std::clamp(static_cast<int>((height[i] - bottom) / bin_height), 0, bins - 1);
        key[i] = grid.column_of(position, i) * bins + bin;
        ++begin[static_cast<std::size_t>(key[i]) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::int32_t> order(n);
    for (std::size_t i = 0; i < n; ++i) {
        order[static_cast<std::size_t>(begin[static_cast<std::size_t>(key[i])]++)] =
            static_cast<std::int32_t>(i);
    }
    return order;
}

template <int D>
Clusters<D> build_clusters(const Domain<D>& domain, const FixedPoint<D>& fixed_point,
                           const PositionView<D>& position, double column_width) {
    const ColumnGrid<D> grid(domain, column_width);
    const std::size_t n = position[0].size();
    Clusters<D> clusters;
    clusters.columns = grid.count;
    clusters.column_width = grid.width;
    clusters.lower = grid.lower;
    clusters.periodic = domain.periodic;
    clusters.slot_of_particle.resize(n);
    clusters.column_begin.reserve(static_cast<std::size_t>(grid.total()) + 1);

    std::size_t i = 0;
    for (int column = 0; column < grid.total(); ++column) {
        clusters.column_begin.push_back(
            static_cast<std::int32_t>(clusters.particle_of_slot.size() / cluster_size));
        while (i < n && grid.column_of(position, i) == column) {
            clusters.slot_of_particle[i] = static_cast<std::int32_t>(clusters.particle_of_slot.size());
            clusters.particle_of_slot.push_back(static_cast<std::int32_t>(i));
            ++i;
        }
        while (clusters.particle_of_slot.size() % cluster_size != 0) {
            clusters.particle_of_slot.push_back(-1);
        }
    }
    clusters.column_begin.push_back(static_cast<std::int32_t>(clusters.size()));

    for (std::size_t k = 0; k < D; ++k) {
        auto& slot_position = clusters.slot_position[k];
        slot_position.resize(clusters.slots());
        clusters.centre[k].resize(clusters.size());
        clusters.half_extent[k].resize(clusters.size());
        for (std::size_t c = 0; c < clusters.size(); ++c) {
            const std::size_t first = c * cluster_size;
            const auto code = [&](std::size_t slot) {
                return fixed_point.encode(
                    position[k][static_cast<std::size_t>(clusters.particle_of_slot[slot])], k);
            };
            const std::int32_t reference = code(first);
            std::int32_t low = 0;
            std::int32_t high = 0;
            for (std::size_t slot = first; slot < first + cluster_size; ++slot) {
                slot_position[slot] = clusters.particle_of_slot[slot] >= 0 ? code(slot) : reference;
                const std::int32_t offset = wrapped_difference(slot_position[slot], reference);
                low = std::min(low, offset);
                high = std::max(high, offset);
            }
            // In 64 bits: a sparse cluster may reach over more than half of a period.
            const std::int64_t middle = low + (std::int64_t{high} - low) / 2;
            clusters.centre[k][c] = static_cast<std::int32_t>(static_cast<std::uint32_t>(reference) +
                                                              static_cast<std::uint32_t>(middle));
            // Half a unit of rounding on each side is covered by the margin.
            const double half = (0.5 * (static_cast<double>(high) - low) + 2.0) * fixed_point.unit(k);
            clusters.half_extent[k][c] =
                std::nextafter(static_cast<float>(half), std::numeric_limits<float>::max());
        }
    }
    return clusters;
}

template std::vector<std::int32_t> spatial_order<2>(const Domain<2>&, const PositionView<2>&, double, double);
template std::vector<std::int32_t> spatial_order<3>(const Domain<3>&, const PositionView<3>&, double, double);
template Clusters<2> build_clusters<2>(const Domain<2>&, const FixedPoint<2>&, const PositionView<2>&,
                                       double);
template Clusters<3> build_clusters<3>(const Domain<3>&, const FixedPoint<3>&, const PositionView<3>&,
                                       double);

}  // namespace riffle
