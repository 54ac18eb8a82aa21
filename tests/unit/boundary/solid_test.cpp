// Wall particles of solids, and their motion.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "boundary/solid_contact.hpp"
#include "boundary/solid_distance.hpp"
#include "boundary/solid_fill.hpp"
#include "boundary/wall.hpp"
#include "boundary/wall_motion.hpp"
#include "particles/lattice.hpp"
#include "periodic_reach.hpp"
#include "sph/kernel.hpp"
#include "temporary_folder.hpp"

namespace riffle::solid_test {
namespace {

Case tank(const std::vector<Solid>& solids) {
    Case c;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.06;
    c.channel.length = 0.1;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.002;
    c.numerics.wall_layers = 3;
    c.solids = solids;
    return c;
}

Solid solid(std::vector<double> x, std::vector<double> z) {
    Solid s;
    s.name = "body";
    s.x = std::move(x);
    s.z = std::move(z);
    return s;
}

WallParticles<2> filled(const Case& c) {
    WallParticles<2> walls;
    add_solid(c, c.solids[0], first_solid, walls);
    return walls;
}

double area(const WallParticles<2>& walls) {
    double sum = 0.0;
    for (const double v : walls.volume) sum += v;
    return sum;
}

// Away from all walls every edge is wetted: three layers of 2 mm, 6 mm of the outline's inside.
TEST(SolidFill, LayersOfAConvexBodyCoverItsRim) {
    const Case c = tank({solid({0.03, 0.07, 0.07, 0.03}, {0.01, 0.01, 0.05, 0.05})});
    const WallParticles<2> walls = filled(c);
    EXPECT_NEAR(area(walls), 0.04 * 0.04 - 0.028 * 0.028, 1e-9);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const double x = walls.position[0][i];
        const double z = walls.position[1][i];
        const double depth = std::min({x - 0.03, 0.07 - x, z - 0.01, 0.05 - z});
        EXPECT_NEAR(walls.depth[i], depth, 1e-9);
        EXPECT_NEAR(std::hypot(walls.normal[0][i], walls.normal[1][i]), 1.0, 1e-12);
        // The normal leads out of the body over the shortest way.
        const double out_x = x + 1.01 * depth * walls.normal[0][i];
        const double out_z = z + 1.01 * depth * walls.normal[1][i];
        EXPECT_FALSE(contains(outline_of(c.solids[0]), out_x, out_z));
        EXPECT_EQ(walls.body[i], first_solid);
    }
}

// In a triangle the layers are trapezia whatever its corners; in either sense of its corners.
TEST(SolidFill, LayersOfATriangleCoverItsRim) {
    const std::vector<double> x{0.02, 0.08, 0.05};
    const std::vector<double> z{0.005, 0.005, 0.055};
    const Case c = tank({solid(x, z)});
    const double side = std::hypot(0.03, 0.05);
    const double whole = 0.5 * 0.06 * 0.05;
    const double inradius = 2.0 * whole / (0.06 + 2.0 * side);
    const double rest = whole * std::pow((inradius - 0.006) / inradius, 2);
    EXPECT_NEAR(area(filled(c)), whole - rest, 0.002 * whole);
    const Case reversed = tank({solid({x[2], x[1], x[0]}, {z[2], z[1], z[0]})});
    EXPECT_NEAR(area(filled(reversed)), area(filled(c)), 1e-9);
}

// Round a corner that the solid surrounds the layers are quarters of rings, without a normal.
TEST(SolidFill, ArcsFillTheInnerCorner) {
    const Case c = tank({solid({0.02, 0.08, 0.08, 0.05, 0.05, 0.02}, {0.01, 0.01, 0.03, 0.03, 0.05, 0.05})});
    const WallParticles<2> walls = filled(c);
    double arcs = 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls.normal[0][i] == 0.0 && walls.normal[1][i] == 0.0) {
            arcs += walls.volume[i];
            EXPECT_NEAR(std::hypot(walls.position[0][i] - 0.05, walls.position[1][i] - 0.03), walls.depth[i],
                        1e-9);
            EXPECT_EQ(walls.projector[0][i], 1.0);
            EXPECT_EQ(walls.projector[1][i], 0.0);
        }
    }
    EXPECT_NEAR(arcs, std::numbers::pi / 4.0 * 0.006 * 0.006, 1e-8);
}

// A step on the bed, aligned with the lattice, continues the water as a bed does: particles beside it see the
// sum of W that those in the middle see, at its inner corners with the bed too.
TEST(SolidFill, AStepOnTheBedCompletesTheSupport) {
    const Case c = tank({solid({0.04, 0.06, 0.06, 0.04}, {0.0, 0.0, 0.02, 0.02})});
    const Particles<2> fluid = lattice_particles(c);
    const WallParticles<2> walls = wall_particles(c);
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    const double volume = 0.002 * 0.002;
    EXPECT_EQ(fluid.size(), 30U * 50U - 100U);
    int checked = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        if (fluid.position[1][i] > 0.05) continue;
        double sum = 0.0;
        const auto add = [&](const auto& particles, const auto& volume_of) {
            for (std::size_t j = 0; j < particles.position[0].size(); ++j) {
                sum += volume_of(j) *
                       WendlandC2<2>::value(std::hypot(particles.position[0][j] - fluid.position[0][i],
                                                       particles.position[1][j] - fluid.position[1][i]) /
                                            h) /
                       (h * h);
            }
        };
        add(fluid, [&](std::size_t) { return volume; });
        add(walls, [&](std::size_t j) { return walls.volume[j]; });
        EXPECT_NEAR(sum, 1.0, 0.01) << fluid.position[0][i] << " " << fluid.position[1][i];
        ++checked;
    }
    EXPECT_GT(checked, 1000);
}

/// The sum of W over the particles of all solids, at a place.
double sum_at(const WallParticles<2>& walls, double h, double x, double z) {
    double sum = 0.0;
    for (std::size_t j = 0; j < walls.size(); ++j) {
        const double distance = std::hypot(walls.position[0][j] - x, walls.position[1][j] - z);
        sum += is_solid(walls, j) ? walls.volume[j] * WendlandC2<2>::value(distance / h) / (h * h) : 0.0;
    }
    return sum;
}

// A pier that stands in a sill, a bank drawn in two triangles that overlap: water sees the solids' union
// once.
TEST(SolidFill, SolidsThatOverlapAreFilledOnce) {
    const Solid sill = solid({0.02, 0.08, 0.08, 0.02}, {0.002, 0.002, 0.02, 0.02});
    const Solid pier = solid({0.04, 0.06, 0.06, 0.04}, {0.006, 0.006, 0.04, 0.04});
    const Solid united = solid({0.02, 0.08, 0.08, 0.06, 0.06, 0.04, 0.04, 0.02},
                               {0.002, 0.002, 0.02, 0.02, 0.04, 0.04, 0.02, 0.02});
    for (const bool sill_first : {true, false}) {
        Case c = tank(sill_first ? std::vector{sill, pier} : std::vector{pier, sill});
        const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
        const WallParticles<2> walls = wall_particles(c);
        c.solids = {united};
        const WallParticles<2> of_one = wall_particles(c);
        for (double x = 0.021; x < 0.08; x += 0.002) {
            for (double z = std::abs(x - 0.05) > 0.01 ? 0.021 : 0.041; z < 0.046; z += 0.002) {
                EXPECT_NEAR(sum_at(walls, h, x, z), sum_at(of_one, h, x, z), 0.03) << x << " " << z;
            }
        }
    }
    // Of two that are alike the second has nothing left; beside each other both have all of theirs.
    EXPECT_NEAR(area(wall_particles(tank({pier, pier}))), area(wall_particles(tank({pier}))), 1e-9);
    const Solid beside = solid({0.06, 0.08, 0.08, 0.06}, {0.006, 0.006, 0.04, 0.04});
    const Case two = tank({pier, beside});
    WallParticles<2> alone;
    add_solid(two, beside, first_solid, alone);
    const WallParticles<2> walls = wall_particles(two);
    EXPECT_EQ(std::count(walls.body.begin(), walls.body.end(), first_solid + 1),
              static_cast<std::ptrdiff_t>(alone.size()));
}

// A layer of gravel drawn into the bed: the water over it is near the layer alone, though the bed's face lies
// only two spacings below that; each has its friction on its own faces.
TEST(SolidDistance, CountsNoFaceThatStandsInAnotherSolid) {
    const Case c = tank({solid({0.02, 0.08, 0.08, 0.02}, {0.0, 0.0, 0.02, 0.02}),
                         solid({0.04, 0.06, 0.06, 0.04}, {0.012, 0.012, 0.024, 0.024})});
    const SolidDistance<2> distance(c, 0.012);
    EXPECT_NEAR(distance.from(0, {}, {0.05, 0.028}), 0.012, 1e-9);
    EXPECT_NEAR(distance.from(1, {}, {0.05, 0.028}), 0.004, 1e-9);
    EXPECT_NEAR(distance.at({}, {0.05, 0.028}), 0.004, 1e-9);
    EXPECT_NEAR(distance.from(0, {}, {0.026, 0.026}), 0.006, 1e-9);
    // Solids that touch are beside each other.
    const Case beside = tank({solid({0.02, 0.05, 0.05, 0.02}, {0.0, 0.0, 0.02, 0.02}),
                              solid({0.05, 0.08, 0.08, 0.05}, {0.0, 0.0, 0.02, 0.02})});
    const SolidDistance<2> of_both(beside, 0.012);
    EXPECT_NEAR(of_both.from(0, {}, {0.048, 0.026}), 0.006, 1e-9);
    EXPECT_NEAR(of_both.from(1, {}, {0.052, 0.026}), 0.006, 1e-9);
}

// What lies against the bed is not wetted while the solid stands still.
TEST(SolidFill, OnlyEdgesThatWaterMayTouchAreLined) {
    Case c = tank({solid({0.03, 0.07, 0.05}, {0.0, 0.0, 0.04})});
    Solid& wedge = c.solids[0];
    const Outline outline = outline_of(wedge);
    EXPECT_FALSE(is_wetted(c, wedge, outline, 0));
    EXPECT_TRUE(is_wetted(c, wedge, outline, 1));
    wedge.motion = SolidMotion::constant;
    EXPECT_TRUE(is_wetted(c, wedge, outline, 0));
}

// A plate of three spacings is filled once, not from both sides.
TEST(SolidFill, FillsAThinPlateOnce) {
    const Case c = tank({solid({0.03, 0.036, 0.036, 0.03}, {0.01, 0.01, 0.05, 0.05})});
    EXPECT_NEAR(area(filled(c)), 0.006 * 0.04, 0.1 * 0.006 * 0.006);
}

// In space water and wall particles share one lattice: each place of it in the channel is one or the other,
// or deeper in the solid than its layers.
TEST(SolidFill, InSpaceWaterAndSolidShareTheLattice) {
    Case c = test::periodic_reach();
    c.numerics.wall_layers = 3;
    // An octahedron with corners 20 mm from its middle; its faces are planes |x| + |y| + |z| = 20 mm.
    Solid s;
    s.name = "octahedron";
    s.file = test::folder_of_this_process() / "octahedron.stl";
    s.scale = 0.02;
    s.place = {0.03, 0.03, 0.02};
    const int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const char* const corners[6] = {"1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1"};
    std::ofstream file(s.file);
    file << "solid octahedron\n";
    for (const auto& face : faces) {
        file << "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face) file << "vertex " << corners[corner] << "\n";
        file << "endloop\nendfacet\n";
    }
    file << "endsolid octahedron\n";
    file.close();
    c.solids = {s};

    std::set<std::array<long, 3>> places;
    const auto place = [](const auto& position, std::size_t i) {
        return std::array<long, 3>{std::lround(position[0][i] / 1e-3), std::lround(position[1][i] / 1e-3),
                                   std::lround(position[2][i] / 1e-3)};
    };
    const Particles<3> water = lattice_particles<3>(c);
    for (std::size_t i = 0; i < water.size(); ++i) {
        EXPECT_TRUE(places.insert(place(water.position, i)).second);
    }
    const WallParticles<3> walls = wall_particles<3>(c);
    std::size_t of_solid = 0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls.body[i] < first_solid) continue;
        ++of_solid;
        EXPECT_TRUE(places.insert(place(walls.position, i)).second);
        const double sum = std::abs(walls.position[0][i] - 0.03) + std::abs(walls.position[1][i] - 0.03) +
                           std::abs(walls.position[2][i] - 0.02);
        EXPECT_NEAR(walls.depth[i], (0.02 - sum) / std::sqrt(3.0), 1e-9);
        EXPECT_LE(walls.depth[i], 0.006);
    }
    EXPECT_GT(of_solid, 500U);
    // What is missing lies deeper than 6 mm: in the octahedron whose corners are 6 sqrt(3) mm nearer.
    const double missing = 30.0 * 30.0 * 20.0 - static_cast<double>(places.size());
    const double edge = 0.02 - 0.006 * std::sqrt(3.0);
    EXPECT_NEAR(missing, 4.0 / 3.0 * edge * edge * edge / 8e-9, 0.25 * missing);
}

TEST(WallMotion, FollowsItsLaw) {
    Case c = tank({solid({0.03, 0.04, 0.04, 0.03}, {0.0, 0.0, 0.05, 0.05}), {}, {}});
    c.channel.lid_velocity = 0.5;
    c.solids[1].motion = SolidMotion::constant;
    c.solids[1].start = 1.0;
    c.solids[1].velocity_z = 2.0;
    c.solids[1].velocity_y = -1.0;
    c.solids[2].motion = SolidMotion::oscillating;
    c.solids[2].amplitude_x = 0.01;
    c.solids[2].frequency = 2.0;
    const WallMotion motion(c);
    EXPECT_TRUE(motion.displaces());
    const double t = 1.3;
    const std::vector<BodyState> now = motion.at(t);
    ASSERT_EQ(now.size(), 5U);
    EXPECT_EQ(now[resting_body].velocity[0], 0.0);
    EXPECT_EQ(now[lid_body].velocity[0], 0.5);
    EXPECT_EQ(now[lid_body].displacement[0], 0.0);
    EXPECT_EQ(now[first_solid].displacement, (Vec<3>{}));
    EXPECT_NEAR(now[first_solid + 1].displacement[2], 0.6, 1e-12);
    EXPECT_NEAR(now[first_solid + 1].displacement[1], -0.3, 1e-12);
    EXPECT_EQ(motion.at(0.9)[first_solid + 1].velocity[2], 0.0);
    // Velocity and acceleration are the derivatives of the displacement.
    const double step = 1e-5;
    const BodyState before = motion.at(t - step)[first_solid + 2];
    const BodyState after = motion.at(t + step)[first_solid + 2];
    const BodyState& swing = now[first_solid + 2];
    EXPECT_NEAR((after.displacement[0] - before.displacement[0]) / (2 * step), swing.velocity[0], 1e-8);
    EXPECT_NEAR((after.velocity[0] - before.velocity[0]) / (2 * step), swing.acceleration[0], 1e-6);
    EXPECT_NEAR(largest_wall_speed(c), std::sqrt(5.0), 1e-12);
}

TEST(WallMotion, RestsAfterItsStopWhereItHasCome) {
    Case c = tank({solid({0.03, 0.04, 0.04, 0.03}, {0.0, 0.0, 0.05, 0.05})});
    Solid& s = c.solids[0];
    s.motion = SolidMotion::constant;
    s.start = 0.5;
    s.stop = 1.5;
    s.velocity_x = 0.02;
    const WallMotion motion(c);
    EXPECT_NEAR(motion.at(1.0)[first_solid].displacement[0], 0.01, 1e-12);
    for (const double t : {1.5, 2.0, 100.0}) {
        EXPECT_NEAR(motion.at(t)[first_solid].displacement[0], 0.02, 1e-12) << t;
        EXPECT_EQ(motion.at(t)[first_solid].velocity[0], 0.0) << t;
    }
}

TEST(WallLawOfSolids, EachHasItsOwnSurface) {
    Case c = tank({solid({0.03, 0.04, 0.04, 0.03}, {0.0, 0.0, 0.05, 0.05}), {}});
    c.solids[1].surface = SolidSurface::slip;
    const WallAction action = wall_action(c);
    WallParticles<2> walls;
    walls.body = {resting_body, first_solid, first_solid + 1};
    EXPECT_FALSE(action.rests_at(walls, 0));
    EXPECT_TRUE(action.rests_at(walls, 1));
    EXPECT_FALSE(action.rests_at(walls, 2));
}

// A particle in a solid comes back onto the nearest face that water touches, keeps its motion along the face,
// and no longer moves into it; outside nothing happens to it.
TEST(SolidContact, PutsWaterBackOntoTheFace) {
    Case c = tank({solid({0.04, 0.06, 0.06, 0.04}, {0.0, 0.0, 0.02, 0.02})});
    c.solids[0].motion = SolidMotion::constant;
    c.solids[0].velocity_x = 0.1;
    const SolidContact contact(c);
    const std::vector<BodyState> now = WallMotion(c).at(0.05);  // 5 mm on
    Vec<2> x{0.0655, 0.012};
    Vec<2> u{0.0, 0.3};
    EXPECT_EQ(contact.resolve(now, x, u), 0.0);
    EXPECT_EQ(x[0], 0.0655);
    x = {0.0645, 0.012};
    EXPECT_NEAR(contact.resolve(now, x, u), 0.0005, 1e-12);
    EXPECT_NEAR(x[0], 0.065, 1e-8);
    EXPECT_EQ(x[1], 0.012);
    EXPECT_NEAR(u[0], 0.1, 1e-12);
    EXPECT_EQ(u[1], 0.3);
    // Deeper than a spacing it is left for the error that names it.
    x = {0.055, 0.010};
    EXPECT_NEAR(contact.resolve(now, x, u), 0.01, 1e-12);
    EXPECT_EQ(x[0], 0.055);
}

// The edge on the bed gives no way out: water at the foot leaves by the face beside it.
TEST(SolidContact, LeavesByAWettedFaceAndAcrossPeriodicEnds) {
    Case c = tank({solid({-0.01, 0.01, 0.01, -0.01}, {0.0, 0.0, 0.02, 0.02})});
    c.channel.ends = Ends::periodic;
    const SolidContact contact(c);
    const std::vector<BodyState> now = WallMotion(c).at(0.0);
    Vec<2> x{0.0095, 0.0001};
    Vec<2> u{-0.2, -0.1};
    EXPECT_NEAR(contact.resolve(now, x, u), 0.0005, 1e-12);
    EXPECT_NEAR(x[0], 0.01, 1e-8);
    EXPECT_EQ(u[0], 0.0);
    // Nor can it slip in under the solid where an impact has squeezed it into the bed.
    for (const double below : {-0.0004, -0.005}) {
        x = {0.0095, below};
        u = {-0.2, -0.1};
        EXPECT_NEAR(contact.resolve(now, x, u), 0.0005, 1e-12);
        EXPECT_NEAR(x[0], 0.01, 1e-8);
        EXPECT_EQ(x[1], below);
        EXPECT_EQ(u[0], 0.0);
    }
    x = {0.0915, 0.012};
    EXPECT_NEAR(contact.resolve(now, x, u), 0.0015, 1e-12);
    EXPECT_NEAR(x[0], 0.09, 1e-8);
}

TEST(WallMotion, TurnsAndFollowsItsTableWithTheVelocitiesOfItsPlaces) {
    Case c;
    Solid solid;
    solid.name = "rotor";
    solid.x = {0.1, 0.2, 0.2, 0.1};
    solid.z = {0.0, 0.0, 0.04, 0.04};
    solid.motion = SolidMotion::table;
    solid.start = 0.5;
    solid.times = {0.0, 0.4, 1.0, 1.5};
    solid.shifts_x = {0.0, 0.02, 0.05, 0.03};
    solid.angles = {0.0, 30.0, -20.0, 45.0};
    c.solids = {solid};
    solid.name = "swing";
    solid.motion = SolidMotion::oscillating;
    solid.amplitude_angle = 25.0;
    solid.frequency = 0.7;
    solid.rotation_about = {0.1, 0.0};
    c.solids.push_back(solid);
    const WallMotion motion(c);
    const Vec<3> corner{0.2, 0.0, 0.04};
    const double step = 1e-5;
    for (const double t : {0.55, 0.8, 1.2, 1.7}) {
        for (std::size_t body = first_solid; body < first_solid + 2U; ++body) {
            const BodyState now = motion.at(t)[body];
            const Vec<3> here = now.placed(corner);
            const Vec<3> before = motion.at(t - step)[body].placed(corner);
            const Vec<3> after = motion.at(t + step)[body].placed(corner);
            const Vec<3> start = now.place_at_start(here);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(start[k], corner[k], 1e-14);
                EXPECT_NEAR((after[k] - before[k]) / (2 * step), now.velocity_at(here)[k], 1e-6);
                EXPECT_NEAR((after[k] - 2 * here[k] + before[k]) / (step * step),
                            now.acceleration_at(here)[k], 1e-3);
            }
        }
    }
    // Ninety degrees about y take z to x.
    const Rotation quarter = rotation_about({0.0, 1.0, 0.0}, std::numbers::pi / 2);
    EXPECT_NEAR(quarter[2], 1.0, 1e-15);
    // At its rows the table is met, and behind them it rests.
    EXPECT_NEAR(motion.at(0.9)[first_solid].displacement[0], 0.02, 1e-12);
    EXPECT_NEAR(motion.at(9.0)[first_solid].displacement[0], 0.03, 1e-12);
    EXPECT_EQ(motion.at(9.0)[first_solid].angular_velocity, (Vec<3>{}));
}

TEST(WallMotion, NothingMovesInAPlainCase) {
    const Case c = tank({});
    EXPECT_FALSE(WallMotion(c).any());
    EXPECT_TRUE(wall_particles(c).body.empty());
}

}  // namespace
}  // namespace riffle::solid_test
