#include "particles/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"

namespace riffle::inline particles {

namespace {

/// Particles per task of a pass over all particles.
constexpr std::size_t particle_block = 4096;

/// Division of the horizontal axes into columns.
template <int D>
struct ColumnGrid {
    std::array<int, static_cast<std::size_t>(D) - 1> count{};
    Vec<D> width{};
    Vec<D> lower{};
    FixedPoint<D> fixed_point;

    ColumnGrid(const Domain<D>& domain, double target_width) : lower(domain.lower), fixed_point(domain) {
        for (std::size_t k = 0; k + 1 < D; ++k) {
            const double extent = domain.upper[k] - domain.lower[k];
            count[k] = std::max(1, static_cast<int>(std::lround(extent / target_width)));
            width[k] = extent / count[k];
        }
    }

    [[nodiscard]] std::size_t total() const {
        std::size_t columns = 1;
        for (const int n : count) columns *= static_cast<std::size_t>(n);
        return columns;
    }

    /// By the positions that the lists keep: a particle of a lattice that stands on the border of two columns
    /// is in the same one after a restart, which knows no others.
    [[nodiscard]] std::int32_t column_of(const PositionView<D>& position, std::size_t i) const {
        int column = 0;
        for (std::size_t k = 0; k + 1 < D; ++k) {
            double x = position[k][i];
            if (fixed_point.in_range(x, k)) x = fixed_point.decode(fixed_point.encode(x, k), k);
            const int c = static_cast<int>((x - lower[k]) / width[k]);
            column = column * count[k] + std::clamp(c, 0, count[k] - 1);
        }
        return column;
    }

    [[nodiscard]] std::vector<std::int32_t> columns_of(const PositionView<D>& position) const {
        std::vector<std::int32_t> column(position[0].size());
        parallel_blocks(column.size(), particle_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) column[i] = column_of(position, i);
        });
        return column;
    }
};

/// Stable counting sort of all particles by column: the order, and the first place of each column.
struct ColumnOrder {
    std::vector<std::int32_t> order;
    std::vector<std::int32_t> begin;
};
ColumnOrder sort_by_column(const std::vector<std::int32_t>& column, std::size_t columns) {
    const std::size_t n = column.size();
    // Few chunks, each with its own counts; as many for any number of threads.
    const std::size_t chunk = std::max<std::size_t>(particle_block, (n + 31) / 32);
    const std::size_t chunks = std::max<std::size_t>(1, (n + chunk - 1) / chunk);
    std::vector<std::int32_t> place(chunks * columns, 0);
    parallel_blocks(n, chunk, [&](std::size_t begin, std::size_t end) {
        std::int32_t* count = &place[begin / chunk * columns];
        for (std::size_t i = begin; i < end; ++i) ++count[column[i]];
    });
    ColumnOrder result;
    result.begin.resize(columns + 1);
    std::int32_t total = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        result.begin[c] = total;
        for (std::size_t part = 0; part < chunks; ++part) {
            const std::int32_t count = place[part * columns + c];
            place[part * columns + c] = total;
            total += count;
        }
    }
    result.begin[columns] = total;
    result.order.resize(n);
    parallel_blocks(n, chunk, [&](std::size_t begin, std::size_t end) {
        std::int32_t* next = &place[begin / chunk * columns];
        for (std::size_t i = begin; i < end; ++i) {
            result.order[static_cast<std::size_t>(next[column[i]]++)] = static_cast<std::int32_t>(i);
        }
    });
    return result;
}

/// Columns per task: about particle_block particles.
std::size_t column_block(std::size_t particles, std::size_t columns) {
    return std::max<std::size_t>(1, particle_block * columns / std::max<std::size_t>(1, particles));
}

/// Positions in integer units and bounding box of one cluster.
template <int D>
void fill_cluster(Clusters<D>& clusters, std::size_t c, const FixedPoint<D>& fixed_point,
                  const PositionView<D>& position) {
    const auto first = static_cast<std::size_t>(clusters.begin[c]);
    const auto count = static_cast<std::size_t>(clusters.count(c));
    clusters.present[c] = static_cast<std::uint8_t>((1U << count) - 1U);
    for (std::size_t k = 0; k < D; ++k) {
        std::int32_t* code = &clusters.slot_position[k][c * cluster_size];
        const std::int32_t reference = fixed_point.encode(position[k][first], k);
        std::int32_t low = 0;
        std::int32_t high = 0;
        for (std::size_t l = 0; l < cluster_size; ++l) {
            code[l] = fixed_point.encode(position[k][first + std::min(l, count - 1)], k);
            const std::int32_t offset = wrapped_difference(code[l], reference);
            low = std::min(low, offset);
            high = std::max(high, offset);
        }
        // In 64 bits: a sparse cluster may reach over more than half of a period.
        const std::int64_t middle = low + (std::int64_t{high} - low) / 2;
        clusters.centre[k][c] = static_cast<std::int32_t>(static_cast<std::uint32_t>(reference) +
                                                          static_cast<std::uint32_t>(middle));
        // Half a unit of rounding on each side is covered by the margin.
        const double half = (0.5 * (static_cast<double>(high) - low) + 2.0) * fixed_point.unit(k);
        // A hair more, so that rounding to single precision cuts nothing off.
        clusters.half_extent[k][c] = static_cast<float>(half * (1.0 + 0x1p-23));
        if (k == D - 1 && !clusters.periodic[k]) {
            clusters.highest[c] = reference + high;
            clusters.lowest[c] = reference + low;
        }
    }
}

}  // namespace

template <int D>
std::vector<std::int32_t> spatial_order(const Domain<D>& domain, const PositionView<D>& position,
                                        double column_width, double bin_height) {
    const ColumnGrid<D> grid(domain, column_width);
    const auto& height = position[D - 1];
    const double bottom = domain.lower[D - 1];
    const auto last_bin =
        std::max(static_cast<std::int32_t>(std::ceil(domain.extent(D - 1) / bin_height)) - 1, 0);
    ColumnOrder sorted = sort_by_column(grid.columns_of(position), grid.total());

    parallel_blocks(
        grid.total(), column_block(height.size(), grid.total()), [&](std::size_t begin, std::size_t end) {
            std::vector<std::int32_t> place;
            std::vector<std::int32_t> key;
            std::vector<std::int32_t> old;
            for (std::size_t column = begin; column < end; ++column) {
                const auto first = sorted.order.begin() + sorted.begin[column];
                const auto last = sorted.order.begin() + sorted.begin[column + 1];
                old.assign(first, last);
                key.resize(old.size());
                std::int32_t lowest = last_bin;
                std::int32_t highest = 0;
                for (std::size_t i = 0; i < old.size(); ++i) {
                    const double z = height[static_cast<std::size_t>(old[i])];
                    key[i] = static_cast<std::int32_t>(
                        std::min(std::max(0.0, (z - bottom) / bin_height), static_cast<double>(last_bin)));
                    lowest = std::min(lowest, key[i]);
                    highest = std::max(highest, key[i]);
                }
                place.assign(static_cast<std::size_t>(std::max(highest - lowest, 0)) + 2, 0);
                for (const std::int32_t k : key) ++place[static_cast<std::size_t>(k - lowest) + 1];
                std::partial_sum(place.begin(), place.end(), place.begin());
                for (std::size_t i = 0; i < old.size(); ++i) {
                    first[place[static_cast<std::size_t>(key[i] - lowest)]++] = old[i];
                }
            }
        });
    return sorted.order;
}

template <int D>
Clusters<D> build_clusters(const Domain<D>& domain, const FixedPoint<D>& fixed_point,
                           const PositionView<D>& position, double column_width) {
    const ColumnGrid<D> grid(domain, column_width);
    const std::size_t n = position[0].size();
    const std::size_t columns = grid.total();
    Clusters<D> clusters;
    clusters.columns = grid.count;
    clusters.column_width = grid.width;
    clusters.lower = grid.lower;
    clusters.periodic = domain.periodic;

    const std::vector<std::int32_t> column = grid.columns_of(position);
    std::vector<std::int32_t> particle_begin(columns + 1, static_cast<std::int32_t>(n));
    std::size_t next = 0;
    for (std::size_t i = 0; i < n; ++i) {
        while (next <= static_cast<std::size_t>(column[i])) {
            particle_begin[next++] = static_cast<std::int32_t>(i);
        }
    }
    clusters.column_begin.resize(columns + 1);
    std::int32_t total = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        clusters.column_begin[c] = total;
        total += (particle_begin[c + 1] - particle_begin[c] + cluster_size - 1) / cluster_size;
    }
    clusters.column_begin[columns] = total;

    const auto size = static_cast<std::size_t>(total);
    clusters.begin.resize(size + 1);
    clusters.begin[size] = static_cast<std::int32_t>(n);
    clusters.present.resize(size + cluster_size);
    clusters.highest.resize(size);
    clusters.lowest.resize(size);
    for (std::size_t k = 0; k < D; ++k) {
        clusters.slot_position[k].resize(clusters.slots() + cluster_size);
        clusters.centre[k].resize(size + cluster_size);
        clusters.half_extent[k].resize(size + cluster_size);
    }
    parallel_blocks(columns, column_block(n, columns), [&](std::size_t begin, std::size_t end) {
        for (auto c = static_cast<std::size_t>(clusters.column_begin[begin]), col = begin; col < end; ++col) {
            for (std::int32_t i = particle_begin[col]; i < particle_begin[col + 1]; i += cluster_size) {
                clusters.begin[c++] = i;
            }
        }
    });
    parallel_blocks(columns, column_block(n, columns), [&](std::size_t begin, std::size_t end) {
        for (std::size_t col = begin; col < end; ++col) {
            const auto first = static_cast<std::size_t>(clusters.column_begin[col]);
            const auto last = static_cast<std::size_t>(clusters.column_begin[col + 1]);
            for (std::size_t c = first; c < last; ++c) fill_cluster(clusters, c, fixed_point, position);
            for (std::size_t c = first + 1; c < last; ++c) {
                clusters.highest[c] = std::max(clusters.highest[c], clusters.highest[c - 1]);
            }
            for (std::size_t c = last; c > first + 1; --c) {
                clusters.lowest[c - 2] = std::min(clusters.lowest[c - 2], clusters.lowest[c - 1]);
            }
        }
    });
    for (std::size_t col = 0; col < columns; ++col) {
        if (clusters.column_begin[col] < clusters.column_begin[col + 1]) {
            const auto last = static_cast<std::size_t>(clusters.column_begin[col + 1]) - 1;
            clusters.top = std::max(clusters.top, clusters.highest[last]);
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

}  // namespace riffle::inline particles
