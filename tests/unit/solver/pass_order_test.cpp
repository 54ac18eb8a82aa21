#include "engine/pass_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../particles/cloud.hpp"
#include "base/parallel.hpp"
#include "small_case.hpp"

namespace riffle::pass_order_test {
namespace {

/// Wave of each block, and that every block has exactly one.
std::vector<std::size_t> waves_of(const BlocksOfPass& stage, std::size_t waves, std::size_t blocks) {
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

/// Passes like those of an evaluation: water is set 0, walls are set 1.
std::vector<PassDeclaration> evaluation_passes() {
    return {
        {.name = "gradients",
         .set = 0,
         .reads = {"motion"},
         .neighbours = {{0, {"motion"}}, {1, {"volume"}}},
         .writes = {"stress"}},
        {.name = "walls", .set = 1, .neighbours = {{0, {"motion", "stress"}}}, .writes = {"volume", "force"}},
        {.name = "forces",
         .set = 0,
         .reads = {"stress"},
         .neighbours = {{0, {"motion", "stress"}}, {1, {"force"}}},
         .writes = {"state"}},
        {.name = "packing", .set = 0, .reads = {"state"}, .writes = {"motion"}}};
}

TEST(PassOrder, NoBlockRunsBeforeWhatItReadsNorOverwritesWhatIsStillRead) {
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
        const std::array lists{ListBetween{0, 0, &water_water}, ListBetween{0, 1, &water_bed},
                               ListBetween{1, 0, &bed_water}};
        const std::array sizes{water.clusters.size(), bed.clusters.size()};
        const std::size_t blocks = (water.clusters.size() + block_clusters - 1) / block_clusters;
        const std::size_t bed_blocks = (bed.clusters.size() + block_clusters - 1) / block_clusters;
        ASSERT_GT(blocks, 30U);

        for (const PassPlan& plan :
             {PassPlan{.wave_blocks = 1}, PassPlan{.wave_blocks = 4}, PassPlan{.wave_blocks = blocks},
              PassPlan{.threads = 2, .wave_blocks = 1}, PassPlan{.threads = 3, .wave_blocks = 2},
              PassPlan{.threads = 64, .shared_wave_blocks = 1}}) {
            const PassOrder order = order_passes(evaluation_passes(), lists, sizes, plan);
            const auto gradients = waves_of(order.passes[0], order.waves, blocks);
            const auto walls = waves_of(order.passes[1], order.waves, bed_blocks);
            const auto forces = waves_of(order.passes[2], order.waves, blocks);
            const auto packing = waves_of(order.passes[3], order.waves, blocks);
            // Within a wave the passes run one after the other in this order. Strips run at any time beside
            // each other, so that nothing may wait for another one but in the last wave.
            const auto strip = [&](std::size_t wave) {
                std::size_t s = 0;
                while (s < order.strips() && wave >= order.strip_begin[s + 1]) ++s;
                return s;
            };
            const auto in_order = [&](std::size_t before, std::size_t after) {
                return before <= after && (strip(before) == strip(after) || strip(after) == order.strips());
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
                EXPECT_EQ(order.strips(), 1U);
                EXPECT_EQ(order.waves, (blocks + plan.wave_blocks - 1) / plan.wave_blocks);
            } else if (plan.threads == 64) {
                EXPECT_EQ(order.strips(), 1U) << "too short for as many sections";
            } else {
                EXPECT_GE(order.strips(), plan.threads);
                const auto late =
                    static_cast<std::size_t>(std::count(forces.begin(), forces.end(), order.waves - 1));
                EXPECT_GT(late, 0U);
                EXPECT_LT(2 * late, blocks) << "most of the work is within a strip";
            }
            // Blocks far from the ends do not wait for the end of the channel.
            if (plan.threads == 1 && plan.wave_blocks == 1) {
                EXPECT_LT(packing[blocks / 2], blocks / 2 + 12);
            }
        }
    }
}

// The rule is general: a filter between two passes, whose values the next one reads of the neighbours, shifts
// that one behind it and nothing else.
TEST(PassOrder, PassInBetweenShiftsOnlyWhatReadsIt) {
    const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {30.0, 1.0}, .periodic = {false, false}};
    const auto water = random_cloud<2>(domain, 6000, 0.2, 7);
    const auto list = build_neighbour_list<2>(water.clusters, water.clusters, water.fixed_point, 0.3);
    const std::array lists{ListBetween{0, 0, &list}};
    const std::array sizes{water.clusters.size()};
    const std::size_t blocks = blocks_of(sizes[0]);
    const PassDeclaration rates{
        .name = "rates", .set = 0, .neighbours = {{0, {"motion"}}}, .writes = {"rate"}};
    const PassDeclaration smoothing{
        .name = "smoothing", .set = 0, .neighbours = {{0, {"rate"}}}, .writes = {"smooth rate"}};
    const PassDeclaration local{.name = "local", .set = 0, .reads = {"rate"}, .writes = {"heat"}};
    const PassDeclaration packing{.name = "packing", .set = 0, .reads = {"rate"}, .writes = {"motion"}};
    PassDeclaration of_smooth = packing;
    of_smooth.neighbours = {{0, {"smooth rate"}}};
    const PassPlan plan{.wave_blocks = 1};
    const auto waves = [&](const std::vector<PassDeclaration>& passes) {
        const PassOrder order = order_passes(passes, lists, sizes, plan);
        std::vector<std::vector<std::size_t>> result;
        for (const BlocksOfPass& pass : order.passes) result.push_back(waves_of(pass, order.waves, blocks));
        return result;
    };
    const auto plain = waves({rates, packing});
    const auto with_local = waves({rates, local, packing});
    const auto with_smoothing = waves({rates, smoothing, of_smooth});
    EXPECT_EQ(with_local[1], plain[0]) << "what reads its own block alone follows at once";
    EXPECT_EQ(with_local[2], plain[1]);
    for (const auto& [i, j] : listed(list)) {
        EXPECT_LE(plain[0][i], plain[1][j]) << "positions are overwritten while they are still read";
        EXPECT_LE(with_smoothing[0][j], with_smoothing[1][i]);
        EXPECT_LE(with_smoothing[1][j], with_smoothing[2][i]);
    }
    EXPECT_LT(plain[1][blocks / 2], with_smoothing[2][blocks / 2]);
    EXPECT_LT(with_smoothing[2][blocks / 2], blocks / 2 + 12) << "far ends need not wait for each other";
}

// What looks at the whole of the water is done once, between the passes before and behind it.
TEST(PassOrder, PassOverTheWholePutsAllIntoOneWave) {
    const Domain<2> domain{.lower = {0.0, 0.0}, .upper = {30.0, 1.0}, .periodic = {true, false}};
    const auto water = random_cloud<2>(domain, 6000, 0.2, 7);
    const auto list = build_neighbour_list<2>(water.clusters, water.clusters, water.fixed_point, 0.3);
    const std::array lists{ListBetween{0, 0, &list}};
    const std::array sizes{water.clusters.size(), std::size_t{0}};
    std::vector<PassDeclaration> passes = evaluation_passes();
    passes.insert(passes.begin() + 1, {.name = "whole", .set = 1, .whole = true});
    const PassOrder order = order_passes(passes, lists, sizes, {.threads = 2, .wave_blocks = 1});
    EXPECT_EQ(order.waves, 1U);
    EXPECT_EQ(order.passes.size(), passes.size());
    EXPECT_EQ(order.passes[0].blocks(0).size(), blocks_of(sizes[0]));
}

TEST(PassOrder, LongChannelsGiveTheSameBitsInManyWavesAsInOne) {
    Case c = test::small_channel();
    c.channel.length = 2.0;  // 7000 particles: several waves of one thread, or strips
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
}  // namespace riffle::pass_order_test
