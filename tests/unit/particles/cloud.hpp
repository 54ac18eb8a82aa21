#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "particles/clusters.hpp"

namespace riffle {

/// Random particles in a box, in spatial order, with the clusters made of them.
template <int D>
struct Cloud {
    Domain<D> domain;
    FixedPoint<D> fixed_point;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    Clusters<D> clusters;

    [[nodiscard]] std::size_t size() const { return position[0].size(); }

    [[nodiscard]] PositionView<D> view() const { return position_view<D>(position); }

    /// Squared distance to the nearest image.
    [[nodiscard]] double distance_squared(std::size_t i, std::size_t j) const {
        double squared = 0.0;
        for (std::size_t k = 0; k < D; ++k) {
            double d = position[k][i] - position[k][j];
            if (domain.periodic[k]) {
                const double extent = domain.extent(static_cast<int>(k));
                d -= extent * std::nearbyint(d / extent);
            }
            squared += d * d;
        }
        return squared;
    }
};

template <int D>
[[nodiscard]] Cloud<D> random_cloud(const Domain<D>& domain, std::size_t count, double column_width,
                                    std::uint64_t seed) {
    Cloud<D> cloud;
    cloud.domain = domain;
    cloud.fixed_point = FixedPoint<D>(domain);
    std::mt19937_64 generator(seed);
    for (std::size_t k = 0; k < D; ++k) {
        std::uniform_real_distribution<double> uniform(domain.lower[k], domain.upper[k]);
        for (std::size_t i = 0; i < count; ++i) cloud.position[k].push_back(uniform(generator));
    }
    const auto order = spatial_order<D>(domain, cloud.view(), column_width, 0.2 * column_width);
    for (auto& axis : cloud.position) {
        const std::vector<double> old = axis;
        for (std::size_t i = 0; i < count; ++i) axis[i] = old[static_cast<std::size_t>(order[i])];
    }
    cloud.clusters = build_clusters<D>(domain, cloud.fixed_point, cloud.view(), column_width);
    return cloud;
}

}  // namespace riffle
