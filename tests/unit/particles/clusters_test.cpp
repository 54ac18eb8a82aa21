#include "particles/clusters.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>

#include "cloud.hpp"
#include "particles/particles.hpp"

namespace riffle::clusters_test {
namespace {

template <int D>
void check_clusters(const Cloud<D>& cloud) {
    const Clusters<D>& c = cloud.clusters;
    const std::size_t n = cloud.size();
    RC_ASSERT(c.slots() % cluster_size == 0U);
    // Every particle stands in one slot.
    std::vector<int> seen(n, 0);
    for (std::size_t slot = 0; slot < c.slots(); ++slot) {
        const std::int32_t particle = c.particle_of(slot);
        if (particle < 0) {
            // Padding only at the end of a cluster, which is never empty.
            RC_ASSERT(slot % cluster_size != 0U);
            RC_ASSERT(slot % cluster_size == cluster_size - 1U || c.particle_of(slot + 1) < 0);
            continue;
        }
        ++seen[static_cast<std::size_t>(particle)];
    }
    RC_ASSERT(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
    // The columns divide the clusters.
    RC_ASSERT(c.column_begin.front() == 0);
    RC_ASSERT(static_cast<std::size_t>(c.column_begin.back()) == c.size());
    RC_ASSERT(std::is_sorted(c.column_begin.begin(), c.column_begin.end()));
    // The search along a column relies on these bounds.
    for (std::size_t column = 0; !c.periodic[D - 1] && column + 1 < c.column_begin.size(); ++column) {
        const auto first = static_cast<std::size_t>(c.column_begin[column]);
        const auto last = static_cast<std::size_t>(c.column_begin[column + 1]);
        for (std::size_t a = first; a < last; ++a) {
            for (std::size_t slot = first * cluster_size; slot < last * cluster_size; ++slot) {
                const std::int32_t z = c.slot_position[D - 1][slot];
                RC_ASSERT(slot >= (a + 1) * cluster_size || z <= c.highest[a]);
                RC_ASSERT(slot < a * cluster_size || z >= c.lowest[a]);
            }
        }
    }
    for (std::size_t cluster = 0; cluster < c.size(); ++cluster) {
        for (std::size_t lane = 0; lane < cluster_size; ++lane) {
            const bool holds = c.particle_of(cluster * cluster_size + lane) >= 0;
            RC_ASSERT((c.present[cluster] >> lane & 1U) == (holds ? 1U : 0U));
        }
        RC_ASSERT(c.periodic[D - 1] || c.highest[cluster] <= c.top);
    }
    // Every particle lies in the box of its cluster.
    for (std::size_t slot = 0; slot < c.slots(); ++slot) {
        for (std::size_t k = 0; k < D; ++k) {
            const double offset =
                wrapped_difference(c.slot_position[k][slot], c.centre[k][slot / cluster_size]) *
                cloud.fixed_point.unit(k);
            RC_ASSERT(std::abs(offset) <= static_cast<double>(c.half_extent[k][slot / cluster_size]));
        }
    }
}

TEST(Clusters, LoseNoParticle2D) {
    EXPECT_TRUE(rc::check("clusters of a random cloud in 2D", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 600);
        const bool periodic = *rc::gen::arbitrary<bool>();
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {1.0, 0.6}, .periodic = {true, periodic}};
        check_clusters(random_cloud<2>(domain, n, 0.1, seed));
    }));
}

TEST(Clusters, LoseNoParticle3D) {
    EXPECT_TRUE(rc::check("clusters of a random cloud in 3D", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 600);
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const Domain<3> domain{
            .lower = {0.0, -0.3, 0.0}, .upper = {1.0, 0.3, 0.6}, .periodic = {true, false, false}};
        check_clusters(random_cloud<3>(domain, n, 0.2, seed));
    }));
}

TEST(SpatialOrder, IsAPermutationThatKeepsTies) {
    EXPECT_TRUE(rc::check("each particle once; particles of one bin keep their order", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 500);
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {1.0, 1.0}, .periodic = {true, false}};
        const Cloud<2> cloud = random_cloud<2>(domain, n, 0.1, seed);
        const auto order = spatial_order<2>(domain, cloud.view(), 0.1, 0.02);
        std::vector<std::int32_t> sorted = order;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 0; i < n; ++i) {
            RC_ASSERT(sorted[i] == static_cast<std::int32_t>(i));
            // The cloud already stands in this order: sorting again must not move anything.
            RC_ASSERT(order[i] == static_cast<std::int32_t>(i));
        }
    }));
}

// A run that goes on knows the positions that its lists were built from as whole numbers alone: a lattice
// whose columns of particles stand on the borders of those of the lists is cut as at its start.
TEST(Clusters, AreThoseOfTheWholeNumbersOnTheBordersOfColumns) {
    for (const double shift : {-0.02, 0.0, 1.0 / 3.0}) {
        const Domain<2> domain{
            .lower = {-0.1 + shift, 0.0}, .upper = {1.1 + shift, 0.6}, .periodic = {false, false}};
        const FixedPoint<2> fixed_point(domain);
        std::array<std::vector<double>, 2> position;
        for (int column = 0; column < 120; ++column) {
            for (int row = 0; row < 30; ++row) {
                position[0].push_back(domain.lower[0] + 0.01 * column);
                position[1].push_back(0.01 * (row + 0.5));
            }
        }
        const auto order = spatial_order<2>(domain, position_view<2>(position), 0.1, 0.01);
        std::array<std::vector<double>, 2> sorted;
        std::array<std::vector<double>, 2> kept;
        for (std::size_t k = 0; k < 2; ++k) {
            for (const std::int32_t i : order) {
                const double x = position[k][static_cast<std::size_t>(i)];
                sorted[k].push_back(x);
                kept[k].push_back(fixed_point.decode(fixed_point.encode(x, k), k));
            }
        }
        const auto now = build_clusters<2>(domain, fixed_point, position_view<2>(sorted), 0.1);
        const auto after = build_clusters<2>(domain, fixed_point, position_view<2>(kept), 0.1);
        EXPECT_EQ(now.begin, after.begin) << shift;
        EXPECT_EQ(now.column_begin, after.column_begin) << shift;
    }
}

TEST(Particles, PermuteMovesAllQuantitiesTogether) {
    Particles<2> p;
    p.resize(5);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto value = static_cast<double>(i);
        p.position[0][i] = value;
        p.position[1][i] = 10.0 + value;
        p.velocity[0][i] = 20.0 + value;
        p.velocity[1][i] = 30.0 + value;
        p.density_deviation[i] = 60.0 + value;
        p.mass[i] = 70.0 + value;
        p.id[i] = static_cast<std::int32_t>(i);
    }
    const std::vector<std::int32_t> order = {3, 0, 4, 1, 2};
    p.permute(order);
    for (std::size_t i = 0; i < 5; ++i) {
        const double value = order[i];
        EXPECT_EQ(p.position[0][i], value);
        EXPECT_EQ(p.position[1][i], 10.0 + value);
        EXPECT_EQ(p.velocity[0][i], 20.0 + value);
        EXPECT_EQ(p.velocity[1][i], 30.0 + value);
        EXPECT_EQ(p.density_deviation[i], 60.0 + value);
        EXPECT_EQ(p.mass[i], 70.0 + value);
        EXPECT_EQ(p.id[i], order[i]);
    }
}

}  // namespace
}  // namespace riffle::clusters_test
