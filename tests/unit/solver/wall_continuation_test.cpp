// Which walls continue the water along the channel, and which across it alone.

#include "walls/wall_continuation.hpp"

#include <gtest/gtest.h>

#include <set>

#include "small_case.hpp"

namespace riffle::wall_continuation_test {
namespace {

/// An upright canal between side walls, with a pier on its floor.
Case canal_with_pier() {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::walls;
    c.channel.depth = 0.05;
    c.channel.length = 0.3;
    c.channel.width = 0.2;
    c.channel.slope = 0.001;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.numerics.spacing = 0.005;
    c.side_walls.drag_form = SideDragForm::none;
    c.start.kind = StartKind::rest;
    Solid canal;
    canal.name = "canal";
    canal.shape = SolidShape::section;
    canal.y = {0.0, 0.03, 0.03, 0.2};
    canal.levels = {0.06, 0.06, 0.0, 0.0};
    canal.surface = SolidSurface::slip;
    Solid pier;
    pier.name = "pier";
    pier.shape = SolidShape::box;
    pier.centre = {0.15, 0.1, 0.03};
    pier.size = {0.02, 0.02, 0.08};
    pier.surface = SolidSurface::slip;
    c.solids = {canal, pier};
    return c;
}

struct Seen {
    int banks = 0;
    int pier = 0;
    int sides = 0;
    int far_bed = 0;
    int bed_at_pier = 0;
    int bed_at_bank = 0;
};

Seen look_at(const Case& c, double banks_along) {
    const auto simulation = test::simulation_of<3>(c);
    const WallParticles<3>& walls = simulation->walls();
    const Continuations<3> continuations(c, make_scheme(c, nullptr), walls);
    Seen seen;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const auto [along, across] = continuations.of<double>(i);
        const double x = walls.position[0][i];
        const double y = walls.position[1][i];
        if (is_solid(walls, i)) {
            const bool is_canal = walls.body[i] == first_solid;
            ++(is_canal ? seen.banks : seen.pier);
            EXPECT_EQ(along, is_canal ? banks_along : 1.0);
            EXPECT_EQ(across, 1.0);
        } else if (walls.normal[2][i] == 0.0) {
            ++seen.sides;
            EXPECT_EQ(along, banks_along);
            EXPECT_EQ(across, 1.0);
        } else if (x < 0.06 && y > 0.09 && y < 0.14) {
            ++seen.far_bed;
            EXPECT_EQ(along, 0.0);
            EXPECT_EQ(across, 0.0);
        } else if (std::abs(x - 0.15) < 0.012 && std::abs(y - 0.1) < 0.012) {
            ++seen.bed_at_pier;
            EXPECT_EQ(along, 1.0);
            EXPECT_EQ(across, 1.0);
        } else if (x > 0.24 && x < 0.29 && y < 0.03) {
            ++seen.bed_at_bank;
            EXPECT_EQ(along, 0.0);
            EXPECT_EQ(across, 1.0);
        }
    }
    return seen;
}

TEST(WallContinuation, IsThatOfEachWallForItself) {
    const Seen seen = look_at(canal_with_pier(), 0.0);
    for (const int count :
         {seen.banks, seen.pier, seen.sides, seen.far_bed, seen.bed_at_pier, seen.bed_at_bank}) {
        EXPECT_GT(count, 0);
    }
}

/// How far the side walls continue the water along the channel: all of them alike.
double along_side_walls(const Case& c) {
    const auto simulation = test::simulation_of<3>(c);
    const WallParticles<3>& walls = simulation->walls();
    const Continuations<3> continuations(c, make_scheme(c, nullptr), walls);
    std::set<double> along;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (is_solid(walls, i) || walls.normal[1][i] == 0.0) continue;
        along.insert(continuations.of<double>(i)[0]);
        EXPECT_EQ(continuations.of<double>(i)[1], 1.0);
    }
    EXPECT_EQ(along.size(), 1U);
    return *along.begin();
}

// Side walls run along a channel whose ends are open as along a periodic one; those of a basin end.
TEST(WallContinuation, SideWallsRunAlongAnOpenChannel) {
    Case c = canal_with_pier();
    c.solids.clear();
    EXPECT_EQ(along_side_walls(c), 0.0);
    c.channel.ends = Ends::open;
    c.inflow.unit_discharge = 0.01;
    c.inflow.profile = InflowProfile::uniform;
    c.outflow.kind = OutflowKind::critical_depth;
    EXPECT_EQ(along_side_walls(c), 0.0);
    c.channel.ends = Ends::walls;
    c.channel.slope = 0.0;
    EXPECT_EQ(along_side_walls(c), 1.0);
}

TEST(WallContinuation, OfAPlaneIsOneForAllRows) {
    Case c;
    c.channel.ends = Ends::walls;
    c.channel.slope = 0.0;
    c.channel.depth = 0.05;
    c.channel.length = 0.3;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.numerics.spacing = 0.005;
    c.start.kind = StartKind::rest;
    const auto simulation = test::simulation_of<2>(c);
    const WallParticles<2>& walls = simulation->walls();
    const Continuations<2> continuations(c, make_scheme(c, nullptr), walls);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const double continued = continuations.of<double>(i)[0];
        if (walls.normal[1][i] == 0.0) {
            EXPECT_EQ(continued, 1.0);
        } else if (std::abs(walls.position[0][i] - 0.15) < 0.05) {
            EXPECT_EQ(continued, 0.0);
        }
    }
}

}  // namespace
}  // namespace riffle::wall_continuation_test
