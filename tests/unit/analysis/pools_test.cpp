// The pools of a fish pass: their falls, volumes and power.

#include "analysis/pools.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "passing_record.hpp"

namespace riffle::pools_test {
namespace {

constexpr double step = 0.005;
constexpr double weir_height = 0.13;
constexpr double weir_length = 0.03;

Solid weir_at(double x, const std::string& name = "weir") {
    Solid weir;
    weir.name = name;
    weir.x = {x, x + weir_length, x + weir_length, x};
    weir.z = {0.0, 0.0, weir_height, weir_height};
    return weir;
}

/// Levels by columns of 5 mm, in their middles.
template <class Level>
LongProfile levels(double length, const Level& level) {
    LongProfile profile;
    const auto columns = static_cast<std::size_t>(std::lround(length / step));
    for (std::size_t i = 0; i < columns; ++i) {
        profile.x.push_back((static_cast<double>(i) + 0.5) * step);
        profile.level.push_back(level(profile.x.back()));
    }
    return profile;
}

/// A channel of weirs 0.5 m from each other.
class Pass : public test::PassingRecord {
  public:
    explicit Pass(double slope, double length, Ends ends) : PassingRecord({0.0, 10.0}) {
        flow_->channel.slope = slope;
        flow_->channel.length = length;
        flow_->channel.ends = ends;
        flow_->channel.depth = 0.18;
        flow_->numerics.spacing = step;
        for (int i = 0; 0.3 + 0.5 * i < length; ++i) {
            flow_->solids.push_back(weir_at(0.3 + 0.5 * i, "weir " + std::to_string(i)));
        }
    }
};

double value_of(const Analysis& analysis, const char* key) {
    const Finding* const finding = find_finding(analysis, key);
    return finding != nullptr ? finding->value : std::nan("");
}

// One pool of many falls by slope times length, whatever its level; its water is what the weir leaves.
TEST(Pools, OnePoolOfManyFallsByTheSlope) {
    const Pass pass(0.08, 0.5, Ends::periodic);
    const LongProfile profile = levels(0.5, [](double /*x*/) { return 0.18; });
    const std::vector<Pool> pools = pools_of(*pass.flow(), profile);
    ASSERT_EQ(pools.size(), 1U);
    const double cosine = 1.0 / std::sqrt(1.0 + 0.08 * 0.08);
    EXPECT_NEAR(pools[0].fall, 0.08 * cosine * 0.5, 1e-12);
    EXPECT_NEAR(pools[0].volume, 0.47 * 0.18, 1e-12);
    EXPECT_NEAR(pools[0].from, 0.33, 1e-12);
    EXPECT_NEAR(pools[0].to, 0.8, 1e-12);

    Analysis analysis;
    constexpr double discharge = 0.02;
    add_pools(pass, profile, discharge, analysis);
    EXPECT_NEAR(value_of(analysis, "pool_fall"), pools[0].fall, 1e-12);
    EXPECT_NEAR(value_of(analysis, "pool_jet_velocity"), std::sqrt(2.0 * 9.81 * pools[0].fall), 1e-3);
    EXPECT_NEAR(value_of(analysis, "pool_power"),
                1000.0 * pass.flow()->fluid.gravity * discharge * pools[0].fall / pools[0].volume, 1e-9);
    EXPECT_TRUE(analysis.figures.empty());
}

// In a level channel with open ends the water comes down by steps; before the first weir and behind the last
// there is no pool, but the first pool's fall counts from the water before the first weir.
TEST(Pools, FallsBetweenOpenEndsAreThoseOfTheLevels) {
    const Pass pass(0.0, 1.6, Ends::open);  // weirs at 0.3, 0.8 and 1.3 m
    const LongProfile profile = levels(1.6, [](double x) {
        return x < 0.315 ? 0.30 : x < 0.815 ? 0.26 : x < 1.315 ? 0.21 : 0.18;
    });
    const std::vector<Pool> pools = pools_of(*pass.flow(), profile);
    ASSERT_EQ(pools.size(), 2U);
    EXPECT_NEAR(pools[0].fall, 0.04, 1e-12);
    EXPECT_NEAR(pools[1].fall, 0.05, 1e-12);
    EXPECT_NEAR(pools[1].volume, 0.47 * 0.21, 1e-12);

    Analysis analysis;
    add_pools(pass, profile, 0.03, analysis);
    EXPECT_NEAR(value_of(analysis, "pool_fall"), 0.045, 1e-12);
    ASSERT_EQ(analysis.figures.size(), 2U);
    EXPECT_EQ(analysis.figures[0].curves.front().y.size(), 2U);
}

// Ribs that the water passes over make no pools, nor does one weir between open ends.
TEST(Pools, RibsAndASingleWeirMakeNone) {
    Pass ribs(0.002, 1.0, Ends::periodic);
    for (Solid& rib : ribs.flow_->solids) rib.z = {0.0, 0.0, 0.04, 0.04};
    EXPECT_TRUE(pools_of(*ribs.flow(), levels(1.0, [](double /*x*/) { return 0.18; })).empty());
    const Pass weir(0.0, 0.6, Ends::open);
    EXPECT_TRUE(pools_of(*weir.flow(), levels(0.6, [](double /*x*/) { return 0.2; })).empty());
}

// Walls with slots, across a channel in space: a pool from wall to wall, though its centreline is open.
TEST(Pools, SlotsInSpaceMakePools) {
    Pass slots(0.05, 1.0, Ends::periodic);
    Case& c = *slots.flow_;
    c.channel.dimensions = 3;
    c.channel.width = 0.2;
    c.channel.sides = Sides::walls;
    for (Solid& wall : c.solids) {
        const double x = wall.x.front();
        wall.shape = SolidShape::box;
        wall.size = {weir_length, 0.15, 0.3};
        wall.centre = {x + 0.5 * weir_length, 0.075, 0.15};
        wall.x.clear();
        wall.z.clear();
    }
    const std::vector<Pool> pools = pools_of(c, levels(1.0, [](double /*x*/) { return 0.18; }));
    ASSERT_EQ(pools.size(), 2U);
    EXPECT_NEAR(pools[0].fall, pools[1].fall, 1e-9);
    EXPECT_NEAR(pools[0].volume, 0.47 * 0.18, 1e-9);
}

}  // namespace
}  // namespace riffle::pools_test
