// A start whose particles fill the water evenly beside faces that cut the rows of the lattice.

#include "solver/start_packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "case/outline.hpp"
#include "engine/scheme.hpp"
#include "particles/lattice.hpp"
#include "small_case.hpp"
#include "solver/start.hpp"

namespace riffle::start_packing_test {
namespace {

constexpr double depth = 0.05;
constexpr double length = 0.2;
constexpr double wedge_area = 0.5 * 0.1 * 0.02;

/// A closed tank with a wedge on its floor.
Case tank_with_wedge() {
    Case c = test::still_water();
    c.channel.length = length;
    c.channel.ends = Ends::walls;
    c.channel.depth = depth;
    c.numerics.spacing = 0.0025;
    c.start.packed = true;
    Solid wedge;
    wedge.name = "wedge";
    wedge.x = {0.05, 0.15, 0.1};
    wedge.z = {0.0, 0.0, 0.02};
    c.solids.push_back(wedge);
    return c;
}

/// The water of a case on its lattice, packed.
template <int D>
struct Packed {
    Particles<D> particles;
    PackedStart packing;

    explicit Packed(const Case& c)
        : particles(lattice_particles<D>(c)), packing(pack_start(c, make_scheme(c, nullptr), particles)) {}
};

/// The water of a case with gaps beside a face, which packing closes.
template <int D>
Packed<D> without_gaps(const Case& c) {
    Packed<D> water(c);
    // A missing row of particles has 0.4; 1 % of the density over a smoothing length 0.01.
    EXPECT_GT(water.packing.unevenness_before, 0.1);
    EXPECT_LT(water.packing.unevenness_after, 3e-3);
    return water;
}

template <int D>
void expect_same_start_for_any_threads(const Case& c) {
    const Scheme scheme = make_scheme(c, nullptr);
    set_thread_count(1);
    const Particles<D> alone = initial_particles<D>(c, scheme, nullptr);
    set_thread_count(3);
    const Particles<D> together = initial_particles<D>(c, scheme, nullptr);
    set_thread_count(0);
    EXPECT_EQ(alone.position, together.position);
    EXPECT_EQ(alone.mass, together.mass);
}

TEST(StartPacking, LeavesNoGapBesideAFace) {
    const Case c = tank_with_wedge();
    const Particles<2> particles = without_gaps<2>(c).particles;
    const Outline outline{c.solids[0].x, c.solids[0].z};
    for (std::size_t i = 0; i < particles.size(); ++i) {
        EXPECT_FALSE(contains(outline, particles.position[0][i], particles.position[1][i]));
    }
}

TEST(StartPacking, MakesTheParticlesAsLargeAsTheWater) {
    const Case c = tank_with_wedge();
    const Scheme scheme = make_scheme(c, nullptr);
    const auto volume_error = [&](const Case& start) {
        const Particles<2> particles = initial_particles<2>(start, scheme, nullptr);
        double volume = 0.0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            volume += particles.mass[i] / (scheme.density * (1.0 + particles.density_deviation[i]));
        }
        return volume / (length * depth - wedge_area) - 1.0;
    };
    Case lattice = c;
    lattice.start.packed = false;
    // Whole particles stand or do not stand beside the faces; packed, the error is that of the kernel's sum.
    EXPECT_LT(std::abs(volume_error(c)), 0.003);
    EXPECT_LT(std::abs(volume_error(c)), std::abs(volume_error(lattice)));
}

TEST(StartPacking, DoesNotDependOnTheNumberOfThreads) {
    expect_same_start_for_any_threads<2>(tank_with_wedge());
}

// Water that the case outlines up to a wall, whose face cuts its lattice: it fills the outline and no more.
TEST(StartPacking, KeepsTheWaterInItsOutlineBesideAWall) {
    for (const double face : {0.052, 0.0525, 0.05325, 0.0537}) {
        Case c = tank_with_wedge();
        c.solids[0].x = {0.02, face, face, 0.02};
        c.solids[0].z = {0.0, 0.0, 0.08, 0.08};
        c.start.water_x = {face, length, length, face};
        c.start.water_z = {0.0, 0.0, depth, depth};
        const auto [particles, packing] = Packed<2>(c);
        EXPECT_LT(packing.unevenness_after, 3e-3) << face;
        double volume = 0.0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            EXPECT_LT(particles.position[1][i], depth) << face;
            EXPECT_GT(particles.position[0][i], face) << face;
            volume += packing.share[i] * lattice_of(c).volume();
        }
        EXPECT_NEAR(volume, depth * (length - face), 5e-3 * depth * (length - face)) << face;
    }
}

// A dam of water beside a wall, on a dry bed: its steep front stands.
TEST(StartPacking, KeepsTheFrontOfADamWhereItIsDrawn) {
    Case c = tank_with_wedge();
    c.solids[0].x = {0.02, 0.0537, 0.0537, 0.02};
    c.solids[0].z = {0.0, 0.0, 0.08, 0.08};
    c.start.water_x = {0.0537, 0.095, 0.095, 0.0537};
    c.start.water_z = {0.0, 0.0, depth, depth};
    const auto [particles, packing] = Packed<2>(c);
    double volume = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        EXPECT_LT(particles.position[1][i], depth);
        EXPECT_LT(particles.position[0][i], 0.095);
        volume += packing.share[i] * lattice_of(c).volume();
    }
    EXPECT_NEAR(volume, depth * (0.095 - 0.0537), 0.01 * depth * 0.0413);
}

TEST(StartPacking, MovesEverythingWhereAllIsJittered) {
    Case c = tank_with_wedge();
    c.solids.clear();
    c.start.jitter = 0.2;
    const PackedStart packing = Packed<2>(c).packing;
    EXPECT_LT(packing.unevenness_after, 0.1 * packing.unevenness_before);
}

/// A closed tank with a sphere in it, in three dimensions.
Case tank_with_sphere() {
    Case c = test::still_water(3);
    c.channel.dimensions = 3;
    c.channel.length = 0.05;
    c.channel.width = 0.05;
    c.channel.depth = 0.04;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.side_walls.drag_form = SideDragForm::none;
    c.numerics.spacing = 0.0025;
    c.start.packed = true;
    Solid sphere;
    sphere.name = "sphere";
    sphere.shape = SolidShape::sphere;
    sphere.centre = {0.0253, 0.0247, 0.0192};
    sphere.diameter = 0.02;
    c.solids.push_back(sphere);
    return c;
}

TEST(StartPackingInSpace, FillsTheWaterUpToTheTrueSurface) {
    const Case c = tank_with_sphere();
    const auto [particles, packing] = without_gaps<3>(c);
    double volume = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        double squared = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            squared += std::pow(particles.position[k][i] - c.solids[0].centre[k], 2);
        }
        EXPECT_GT(std::sqrt(squared), 0.0099);
        volume += packing.share[i] * lattice_of(c).volume();
    }
    const double exact = 0.05 * 0.05 * 0.04 - std::numbers::pi / 6.0 * std::pow(0.02, 3);
    EXPECT_NEAR(volume, exact, 5e-3 * exact);
}

// A body that stands through the surface: the places over the water are packed with it, else water climbs
// into the gaps that its face leaves among them, up and out.
TEST(StartPackingInSpace, KeepsTheWaterUnderItsSurfaceBesideAPier) {
    Case c = tank_with_sphere();
    c.solids[0].shape = SolidShape::cylinder;
    c.solids[0].centre = {0.0253, 0.0247, 0.025};
    c.solids[0].diameter = 0.018;
    c.solids[0].length = 0.06;
    const Particles<3> particles = without_gaps<3>(c).particles;
    for (const double z : particles.position[2]) EXPECT_LT(z, 0.04);
}

TEST(StartPackingInSpace, DoesNotDependOnTheNumberOfThreads) {
    expect_same_start_for_any_threads<3>(tank_with_sphere());
}

}  // namespace
}  // namespace riffle::start_packing_test
