#include "sph/neighbour_list.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "../particles/cloud.hpp"
#include "base/parallel.hpp"

namespace riffle::neighbour_list_test {
namespace {

/// Every pair within range stands in the list, no slot twice, none out of reach of its cluster.
template <int D>
void check_list(const Cloud<D>& cloud, double range) {
    const NeighbourList list =
        build_neighbour_list<D>(cloud.clusters, cloud.clusters, cloud.fixed_point, range);
    const Clusters<D>& c = cloud.clusters;
    std::size_t total = 0;
    std::vector<std::int32_t> slot_of(cloud.size());
    for (std::size_t slot = 0; slot < c.slots(); ++slot) {
        if (c.particle_of(slot) >= 0) {
            slot_of[static_cast<std::size_t>(c.particle_of(slot))] = static_cast<std::int32_t>(slot);
        }
    }
    for (std::size_t cluster = 0; cluster < c.size(); ++cluster) {
        std::vector<std::int32_t> slots(list.buffer_size());
        const std::size_t count = list.spell(cluster, slots.data());
        RC_ASSERT(count <= list.largest);
        total += count;
        for (std::size_t l = 0; l < NeighbourList::lookahead; ++l) {
            RC_ASSERT(slots[count + l] == static_cast<std::int32_t>(c.slots()));
        }
        const std::set<std::int32_t> listed(slots.begin(),
                                            slots.begin() + static_cast<std::ptrdiff_t>(count));
        RC_ASSERT(listed.size() == count);
        std::set<std::int32_t> listed_clusters;
        for (std::size_t r = list.run_begin[cluster]; r < list.run_begin[cluster + 1]; ++r) {
            for (std::int32_t n = 0; n < list.runs[r].count; ++n) {
                RC_ASSERT(listed_clusters.insert(list.runs[r].first + n).second);
            }
        }
        for (std::size_t j = 0; j < cloud.size(); ++j) {
            bool within = false;
            bool within_margin = false;
            for (std::size_t slot = cluster * cluster_size; slot < (cluster + 1) * cluster_size; ++slot) {
                if (c.particle_of(slot) >= 0) {
                    const double squared =
                        cloud.distance_squared(static_cast<std::size_t>(c.particle_of(slot)), j);
                    within = within || squared <= range * range;
                    within_margin = within_margin || squared <= 1.0001 * range * range;
                }
            }
            const std::int32_t slot_j = slot_of[j];
            const bool present = listed.count(slot_j) > 0;
            RC_ASSERT(!within || present);
            RC_ASSERT(!present || within_margin);
            RC_ASSERT(!present || listed_clusters.count(slot_j / cluster_size) > 0);
        }
    }
    RC_ASSERT(total == list.neighbours);
}

TEST(NeighbourList, IsComplete2D) {
    EXPECT_TRUE(rc::check("all pairs of a random cloud in 2D, periodic or not", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 300);
        const bool periodic_x = *rc::gen::arbitrary<bool>();
        const bool periodic_z = *rc::gen::arbitrary<bool>();
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const double range = 0.01 * *rc::gen::inRange(2, 30);
        const Domain<2> domain{
            .lower = {-0.1, 0.0}, .upper = {1.0, 0.7}, .periodic = {periodic_x, periodic_z}};
        check_list(random_cloud<2>(domain, n, 0.08, seed), range);
    }));
}

TEST(NeighbourList, IsComplete3D) {
    EXPECT_TRUE(rc::check("all pairs of a random cloud in 3D, periodic or not", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 300);
        const bool periodic_y = *rc::gen::arbitrary<bool>();
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const Domain<3> domain{
            .lower = {0.0, -0.2, 0.0}, .upper = {1.0, 0.5, 0.5}, .periodic = {true, periodic_y, false}};
        check_list(random_cloud<3>(domain, n, 0.15, seed), 0.2);
    }));
}

// The shortest periodic reach that a case may have: two supports, 2 (2h + skin). A particle then sees each
// other one through one image only.
TEST(NeighbourList, IsCompleteInTheShortestPeriod) {
    EXPECT_TRUE(rc::check("all pairs in a period of twice the range", [] {
        const auto n = *rc::gen::inRange<std::size_t>(1, 200);
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const double range = 0.0066;
        const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {2.0 * range, 0.05}, .periodic = {true, false}};
        check_list(random_cloud<2>(domain, n, 0.00534, seed), range);
    }));
}

// Eight drops high in the air make one tall cluster, in which single precision resolves distances badly.
TEST(NeighbourList, IsCompleteInSpray) {
    EXPECT_TRUE(rc::check("the nearest two of few drops, just within range", [] {
        const auto n = *rc::gen::inRange<std::size_t>(20, 80);
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {1.0, 400.0}, .periodic = {true, false}};
        const Cloud<2> cloud = random_cloud<2>(domain, n, 0.5, seed);
        double nearest = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, cloud.distance_squared(i, j));
        }
        check_list(cloud, std::sqrt(nearest) * (1.0 + 1e-6));
    }));
}

TEST(NeighbourList, DoesNotDependOnTheNumberOfThreads) {
    const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {1.0, 0.7}, .periodic = {true, false}};
    const Cloud<2> cloud = random_cloud<2>(domain, 4000, 0.05, 7);
    set_thread_count(1);
    const NeighbourList one =
        build_neighbour_list<2>(cloud.clusters, cloud.clusters, cloud.fixed_point, 0.06);
    set_thread_count(2);
    const NeighbourList two =
        build_neighbour_list<2>(cloud.clusters, cloud.clusters, cloud.fixed_point, 0.06);
    set_thread_count(1);
    EXPECT_EQ(one.run_begin, two.run_begin);
    EXPECT_EQ(one.mask_begin, two.mask_begin);
    EXPECT_EQ(one.masks, two.masks);
    ASSERT_EQ(one.runs.size(), two.runs.size());
    for (std::size_t r = 0; r < one.runs.size(); ++r) {
        EXPECT_EQ(+one.runs[r].first, +two.runs[r].first);
        EXPECT_EQ(+one.runs[r].count, +two.runs[r].count);
    }
}

}  // namespace
}  // namespace riffle::neighbour_list_test
