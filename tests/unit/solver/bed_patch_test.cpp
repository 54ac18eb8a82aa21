// Patches of the bed in a run: a patch like the rest of the bed changes nothing, another one holds the water
// back as its own bed does.

#include <gtest/gtest.h>

#include <cmath>

#include "same_bits.hpp"
#include "small_case.hpp"

namespace riffle::bed_patch_test {
namespace {

using test::ChannelIn;

Case gravel_channel(int dimensions) {
    Case c = test::small_channel(dimensions);
    c.channel.dimensions = dimensions;
    test::lay_plane_bed(c, 0.001);
    c.turbulence.closure = ClosureKind::nezu_rodi;
    c.turbulence.depth = ClosureDepth::initial;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.4;
    c.start.perturbation = 0.0;
    return c;
}

/// Half of the bed as a patch of an equivalent roughness, m.
Case with_patch(Case c, double roughness) {
    BedPatch patch;
    patch.name = "half";
    patch.equivalent_roughness = roughness;
    if (c.channel.dimensions == 3) {
        patch.y_to = 0.5 * c.channel.width;
    } else {
        patch.x_to = 0.5 * c.channel.length;
    }
    c.bed_patches = {patch};
    return c;
}

template <int D>
void expect_no_difference() {
    const Case c = gravel_channel(D);
    // Without the column twin, which the patched case has not.
    const auto plain = test::simulation_of<D>(c);
    const auto patched = test::simulation_of<D>(with_patch(c, 0.001));
    for (int i = 0; i < 30; ++i) {
        plain->step();
        patched->step();
    }
    const auto& a = plain->particles();
    const auto& b = patched->particles();
    const auto place_a = test::places_by_id(a);
    const auto place_b = test::places_by_id(b);
    for (std::size_t id = 0; id < a.size(); ++id) {
        for (std::size_t k = 0; k < D; ++k) {
            // The shares of both sides are rounded once more.
            EXPECT_NEAR(a.velocity[k][place_a[id]], b.velocity[k][place_b[id]], 1e-9);
        }
    }
}

TEST(BedPatches, LikeTheRestOfTheBedChangeNothing) {
    expect_no_difference<2>();
    expect_no_difference<3>();
}

TEST(BedPatches, HoldTheWaterBackMoreWhereTheyAreRougher) {
    const ChannelIn<3> channel(with_patch(gravel_channel(3), 0.02));
    channel.advance(40);
    const auto& p = channel.simulation->particles();
    double over_patch = 0.0;
    double beside = 0.0;
    int count_over = 0;
    int count_beside = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.position[2][i] > 0.006) continue;
        const bool over = p.position[1][i] < 0.5 * channel.parameters.channel.width;
        (over ? over_patch : beside) += p.velocity[0][i];
        ++(over ? count_over : count_beside);
    }
    EXPECT_LT(over_patch / count_over, beside / count_beside - 0.01);
}

TEST(BedPatches, HaveTheSameBitsForAnyNumberOfThreadsAndAfterResume) {
    test::expect_same_bits_for_any_threads<2>(with_patch(gravel_channel(2), 0.02), 12);
    test::expect_same_bits_for_any_threads<3>(with_patch(gravel_channel(3), 0.02), 12);
    test::expect_same_bits_after_resume(with_patch(gravel_channel(2), 0.02), 21, 20);
}

}  // namespace
}  // namespace riffle::bed_patch_test
