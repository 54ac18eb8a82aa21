#include "solver/sweep_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../particles/cloud.hpp"
#include "base/parallel.hpp"
#include "small_case.hpp"

namespace riffle::sweep_order_test {
namespace {

/// Wave of each block, and that every block has exactly one.
std::vector<std::size_t> waves_of(const SweepStage& stage, std::size_t waves, std::size_t blocks) {
    std::vector<std::size_t> wave_of(blocks, waves);
    std::size_t seen = 0;
    for (std::size_t wave = 0; wave < waves; ++wave) {
        for (const std::uint32_t block : stage.blocks(wave)) {
            EXPECT_EQ(wave_of.at(block), waves) << "block " << block << " runs twice";
            wave_of.at(block) = wave;
            ++seen;
        }
    }
    EXPECT_EQ(seen, blocks);
    return wave_of;
}

/// The pairs (i-block, j-block) of a list, from the slots that it spells out.
std::set<std::pair<std::size_t, std::size_t>> listed(const NeighbourList& list) {
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<std::int32_t> slots(list.buffer_size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t n = list.spell(i, slots.data());
        for (std::size_t k = 0; k < n; ++k) {
            pairs.emplace(i / block_clusters, static_cast<std::size_t>(slots[k]) / block_lanes);
        }
    }
    return pairs;
}

TEST(SweepOrder, NoBlockRunsBeforeWhatItReadsNorOverwritesWhatIsStillRead) {
    for (const bool periodic : {true, false}) {
        const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {30.0, 1.0}, .periodic = {periodic, false}};
        const auto water = random_cloud<2>(domain, 6000, 0.2, 7);
        const auto bed = random_cloud<2>(
            {.lower = {0.0, -0.2}, .upper = {30.0, 0.0}, .periodic = {periodic, false}}, 1200, 0.2, 11);
        // Both lists on the domain of the water, which is large enough for the walls below it.
        const double range = 0.3;
        const auto water_water =
            build_neighbour_list<2>(water.clusters, water.clusters, water.fixed_point, range);
        const auto water_bed =
            build_neighbour_list<2>(water.clusters, bed.clusters, water.fixed_point, range);
        const auto bed_water =
            build_neighbour_list<2>(bed.clusters, water.clusters, water.fixed_point, range);
        const std::size_t blocks = (water.clusters.size() + block_clusters - 1) / block_clusters;
        const std::size_t bed_blocks = (bed.clusters.size() + block_clusters - 1) / block_clusters;
        ASSERT_GT(blocks, 30U);

        for (const SweepPlan& plan :
             {SweepPlan{.wave_blocks = 1}, SweepPlan{.wave_blocks = 4}, SweepPlan{.wave_blocks = blocks},
              SweepPlan{.threads = 2, .wave_blocks = 1}, SweepPlan{.threads = 3, .wave_blocks = 2},
              SweepPlan{.threads = 64, .shared_wave_blocks = 1}}) {
            const SweepOrder order = order_sweeps(
                {.fluid_fluid = &water_water, .fluid_wall = &water_bed, .wall_fluid = &bed_water}, plan);
            const auto gradients = waves_of(order.gradients, order.waves, blocks);
            const auto walls = waves_of(order.walls, order.waves, bed_blocks);
            const auto forces = waves_of(order.forces, order.waves, blocks);
            const auto packing = waves_of(order.packing, order.waves, blocks);
            // Within a wave the sweeps run one after the other in this order. Sections run at any time beside
            // each other, so that nothing may wait for another one but in the last wave.
            const auto section = [&](std::size_t wave) {
                std::size_t s = 0;
                while (s < order.sections() && wave >= order.section_begin[s + 1]) {
                    ++s;
                }
                return s;
            };
            const auto in_order = [&](std::size_t before, std::size_t after) {
                return before <= after &&
                       (section(before) == section(after) || section(after) == order.sections());
            };
            for (const auto& [i, j] : listed(water_water)) {
                EXPECT_TRUE(in_order(gradients[j], forces[i]));
                EXPECT_TRUE(in_order(forces[i], packing[j]));
                EXPECT_TRUE(in_order(gradients[i], packing[j]));
            }
            for (const auto& [i, wall] : listed(water_bed)) {
                EXPECT_TRUE(in_order(gradients[i], walls[wall]));
                EXPECT_TRUE(in_order(walls[wall], forces[i]));
            }
            for (const auto& [wall, j] : listed(bed_water)) {
                EXPECT_TRUE(in_order(gradients[j], walls[wall]));
                EXPECT_TRUE(in_order(walls[wall], packing[j]));
            }
            if (plan.threads == 1) {
                EXPECT_EQ(order.sections(), 1U);
                EXPECT_EQ(order.waves, (blocks + plan.wave_blocks - 1) / plan.wave_blocks);
            } else if (plan.threads == 64) {
                EXPECT_EQ(order.sections(), 1U) << "too short for as many sections";
            } else {
                EXPECT_GE(order.sections(), plan.threads);
                const auto late =
                    static_cast<std::size_t>(std::count(forces.begin(), forces.end(), order.waves - 1));
                EXPECT_GT(late, 0U);
                EXPECT_LT(2 * late, blocks) << "most of the work is within a section";
            }
            // Blocks far from the ends do not wait for the end of the channel.
            if (plan.threads == 1 && plan.wave_blocks == 1) {
                EXPECT_LT(packing[blocks / 2], blocks / 2 + 12);
            }
        }
    }
}

TEST(SweepOrder, LongChannelsGiveTheSameBitsInManyWavesAsInOne) {
    Case c = test::small_channel();
    c.channel.length = 2.0;  // 7000 particles: several waves of one thread, or sections
    c.start.jitter = 0.2;
    const auto state_after = [&](int threads) {
        set_thread_count(threads);
        const test::Channel channel(c);
        EXPECT_GT(channel.simulation->particles().size(), 8 * 2 * block_lanes);
        channel.advance(40);
        EXPECT_GT(channel.simulation->clock().list_builds, 1);
        set_thread_count(0);
        return channel.simulation->particles();
    };
    test::expect_same_bits(state_after(1), state_after(2));
    test::expect_same_bits(state_after(1), state_after(3));
}

}  // namespace
}  // namespace riffle::sweep_order_test
