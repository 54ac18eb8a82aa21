// Bodies in the water: at rest, in a flow, and moving.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "boundary/wall_motion.hpp"
#include "case/outline.hpp"
#include "check_run.hpp"
#include "solver/start.hpp"
#include "temporary_folder.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

/// How deep the water stands in the first solid: the largest distance of a particle behind its outline, m.
double penetration(const CheckRun& run) {
    const Solid& solid = run.parameters().solids[0];
    const Outline outline{solid.x, solid.z};
    const Vec<2> moved = in_flow<2>(WallMotion(run.parameters()).at(run.time())[first_solid].displacement);
    const Particles<2>& p = run.particles();
    double deepest = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = p.position[0][i] - moved[0];
        const double z = p.position[1][i] - moved[1];
        if (contains(outline, x, z)) deepest = std::max(deepest, distance_from_outline(outline, x, z));
    }
    return deepest;
}

// No particle may be in a solid; what remains is the rounding of the place where its face is.
constexpr double allowed_penetration = 1e-4;

}  // namespace

// The bar of the pressure is that of the hydrostatic tank. That of the speed is fifty times as high: the
// faces cut the rows of particles at any place.
TEST(Wedge, WaterStaysAtRest) {
    CheckRun run("tank-with-wedge");
    const Scheme& scheme = run.simulation().scheme();
    const double speed = std::sqrt(scheme.normal_gravity * scheme.depth);
    double deepest = 0.0;
    run.advance_to(10.0, [&] { deepest = std::max(deepest, penetration(run)); });
    double later = 0.0;
    run.advance_to(11.0, [&] { later = std::max(later, largest_speed(run.particles())); });
    expect_below("tank with a wedge", "largest velocity from 10 to 11 s / sqrt(gH)", 5e-3, later / speed);
    expect_below("tank with a wedge", "rms of p - rho g (H - z) / (rho g H)", 0.01, hydrostatic_error(run));
    expect_below("tank with a wedge", "deepest particle in the wedge, 0 to 10 s / dx", allowed_penetration,
                 deepest / run.parameters().numerics.spacing);
}

// The same with the viscosity of water. A particle that finds a better place is faster than all others.
TEST(Wedge, WaterOfItsOwnViscosityStaysAtRest) {
    CheckRun run("tank-with-wedge", {{"fluid.kinematic_viscosity", "1e-6"}});
    const Scheme& scheme = run.simulation().scheme();
    double largest = 0.0;
    run.advance_to(5.0);
    run.advance_to(6.0, [&] { largest = std::max(largest, largest_speed(run.particles())); });
    expect_below("tank with a wedge, water", "largest velocity from 5 to 6 s / sqrt(gH)", 1e-2,
                 largest / std::sqrt(scheme.normal_gravity * scheme.depth));
}

// Water of its own viscosity beside a face that cuts the rows at a small angle.
TEST(Beach, WaterStaysAtRest) {
    CheckRun run("beach-at-rest");
    const Scheme& scheme = run.simulation().scheme();
    const double speed = std::sqrt(scheme.normal_gravity * scheme.depth);
    double deepest = 0.0;
    run.advance_to(5.0, [&] { deepest = std::max(deepest, penetration(run)); });
    double largest = 0.0;
    double rms = 0.0;
    run.advance_to(6.0, [&] {
        const Particles<2>& p = run.particles();
        largest = std::max(largest, largest_speed(p));
        const double square = mass_mean<2>(p, [&](std::size_t i) {
            return p.velocity[0][i] * p.velocity[0][i] + p.velocity[1][i] * p.velocity[1][i];
        });
        rms = std::max(rms, std::sqrt(square));
    });
    expect_below("beach", "largest velocity from 5 to 6 s / sqrt(gH)", 1e-2, largest / speed);
    expect_below("beach", "rms velocity from 5 to 6 s / sqrt(gH)", 2e-3, rms / speed);
    expect_below("beach", "deepest particle in the beach, 0 to 5 s / dx", allowed_penetration,
                 deepest / run.parameters().numerics.spacing);
}

// Time averages over the last of 4 s, five times the relaxation time: what is left of the start is 1 % of
// what it was. What passes a section in a second crosses 60 cells of it, so that single particles do not
// show.
TEST(Step, FlowOverItKeepsDischargeAndMomentum) {
    CheckRun run("flow-over-step");
    const Case& c = run.parameters();
    const double length = c.channel.length;
    constexpr std::size_t sections = 16;
    std::vector<double> discharge(sections, 0.0);
    double deepest = 0.0;
    double wall = 0.0;
    double weight = 0.0;
    double steps = 0.0;
    const auto watch = [&] { deepest = std::max(deepest, penetration(run)); };
    run.advance_to(3.0, watch);
    run.advance_to(4.0, [&] {
        watch();
        const Particles<2>& p = run.particles();
        const ParticleFields& fields = run.simulation().fields();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto section = static_cast<std::size_t>(p.position[0][i] / length * sections);
            discharge[std::min(section, sections - 1)] += p.mass[i] * p.velocity[0][i];
            wall -= p.mass[i] * fields.wall_acceleration_x[i];
            weight += p.mass[i] * c.streamwise_gravity();
        }
        steps += 1.0;
    });
    double mean = 0.0;
    for (double& q : discharge) {
        q /= steps * c.fluid.density * length / sections;
        mean += q / sections;
    }
    double largest = 0.0;
    for (const double q : discharge) largest = std::max(largest, std::abs(q / mean - 1.0));
    expect_below("flow over a step", "discharge of any section / mean - 1", 0.01, largest);
    expect_below("flow over a step", "force on bed and step / weight down the slope - 1", 0.01,
                 std::abs(wall / weight - 1.0));
    expect_below("flow over a step", "deepest particle in the step / dx", allowed_penetration,
                 deepest / c.numerics.spacing);
}

// The level as of the tank: twice the height of the centre of mass, and the same bar. The water is pushed so
// slowly (3 % of sqrt(gH)) that its waves hold 1e-3 H of it.
TEST(Piston, DisplacesItsVolume) {
    CheckRun run("piston");
    const double depth = run.parameters().total_depth();
    const auto level = [&] {
        return 2.0 *
               mass_mean(run.particles(), [&](std::size_t i) { return run.particles().position[1][i]; });
    };
    double deepest = 0.0;
    const auto watch = [&] { deepest = std::max(deepest, penetration(run)); };
    run.advance_to(0.5, watch);
    const double before = level();
    run.advance_to(3.0, watch);
    const double exact = depth * 188.0 / 168.0;
    double behind = 0.0;
    for (const double x : run.particles().position[0]) {
        behind += x < 0.032 - allowed_penetration * run.parameters().numerics.spacing ? 1.0 : 0.0;
    }
    expect_below("piston", "rise of the level against the volume displaced / H", 5e-3,
                 std::abs(level() - before * exact / depth) / depth);
    expect_below("piston", "particles behind it", 0.5, behind);
    expect_below("piston", "deepest particle in it / dx", allowed_penetration,
                 deepest / run.parameters().numerics.spacing);
}

// As the dam break: the speed of the front, not its place, and from three units of time after the gate has
// gone.
TEST(Gate, HoldsTheWaterAndReleasesIt) {
    CheckRun run("gate");
    const Case& c = run.parameters();
    const double depth = c.total_depth();
    const double celerity = std::sqrt(c.fluid.gravity * depth);
    const auto front = [&] {
        std::vector<double> x = run.particles().position[0];
        constexpr std::size_t drops = 2;
        std::nth_element(x.begin(), x.end() - 1 - drops, x.end());
        return x[x.size() - 1 - drops];
    };
    run.advance_to(0.3);
    expect_below(
        "gate", "water beyond its face before it opens / dx", allowed_penetration,
        (*std::max_element(run.particles().position[0].begin(), run.particles().position[0].end()) - 0.5) /
            c.numerics.spacing);
    run.advance_to(0.35 + 3.0 * depth / celerity);
    const double early = run.time();
    const double early_front = front();
    run.advance_to(0.35 + 6.0 * depth / celerity);
    const double speed = (front() - early_front) / (run.time() - early);
    expect_below("gate", "speed of the front, t sqrt(g/h0) from 3 to 6, against 2 sqrt(g h0)", 0.05,
                 std::abs(speed / (2.0 * celerity) - 1.0));
}

// The depth of the water at a station by the volume in a sixth of a depth along the channel, 4 % of the
// wave's length; its part of the piston's frequency over two periods.
TEST(Wavemaker, MakesHavelocksWaves) {
    CheckRun run("wavemaker");
    const Case& c = run.parameters();
    const Solid& piston = c.solids[0];
    const double omega = 2.0 * std::numbers::pi * piston.frequency;
    const double depth = c.total_depth();
    const double width = depth / 6.0;
    const std::vector<double> stations{0.4, 0.45, 0.5, 0.55, 0.6};
    std::vector<double> cosine(stations.size(), 0.0);
    std::vector<double> sine(stations.size(), 0.0);
    double deepest = 0.0;
    const double begin = 3.0;
    const double end = begin + 2.0 / piston.frequency;
    run.advance_to(begin, [&] { deepest = std::max(deepest, penetration(run)); });
    run.advance_to(end, [&] {
        deepest = std::max(deepest, penetration(run));
        const Particles<2>& p = run.particles();
        std::vector<double> volume(stations.size(), 0.0);
        for (std::size_t i = 0; i < p.size(); ++i) {
            for (std::size_t s = 0; s < stations.size(); ++s) {
                if (std::abs(p.position[0][i] - stations[s]) < 0.5 * width) {
                    volume[s] += p.mass[i] / (c.fluid.density * (1.0 + p.density_deviation[i]));
                }
            }
        }
        const double weight = 2.0 / (end - begin) * run.simulation().clock().time_step;
        for (std::size_t s = 0; s < stations.size(); ++s) {
            cosine[s] += weight * (volume[s] / width - depth) * std::cos(omega * run.time());
            sine[s] += weight * (volume[s] / width - depth) * std::sin(omega * run.time());
        }
    });
    double height = 0.0;
    for (std::size_t s = 0; s < stations.size(); ++s) {
        height += 2.0 * std::hypot(cosine[s], sine[s]) / static_cast<double>(stations.size());
    }
    double kh = 1.0;  // of the dispersion relation omega^2 h/g = kh tanh kh
    for (int i = 0; i < 100; ++i) kh = 0.5 * (kh + omega * omega * depth / c.fluid.gravity / std::tanh(kh));
    const double havelock = 2.0 * (std::cosh(2.0 * kh) - 1.0) / (std::sinh(2.0 * kh) + 2.0 * kh);
    expect_below("wavemaker", "height of the waves over the stroke against Havelock", 0.05,
                 std::abs(height / (2.0 * piston.amplitude_x) / havelock - 1.0));
    expect_below("wavemaker", "deepest particle in the piston / dx", allowed_penetration,
                 deepest / c.numerics.spacing);
}

namespace {

/// The step of flow-over-step, eight particles deep, in the plane or in space, where it goes through the
/// periodic sides and into the bed.
Case step_case(int dimensions) {
    Case c;
    c.channel.dimensions = dimensions;
    c.channel.slope = 0.02;
    c.channel.depth = 0.02;
    c.channel.length = 0.08;
    c.channel.width = 0.02;
    c.channel.sides = Sides::periodic;
    c.bed.kind = BedKind::no_slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.kinematic_viscosity = 2e-4;
    c.numerics.spacing = 0.0025;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.08;
    Solid step;
    step.name = "step";
    if (dimensions == 2) {
        step.x = {0.03, 0.05, 0.05, 0.03};
        step.z = {-0.005, -0.005, 0.005, 0.005};
    } else {
        step.file = test::folder_of_this_process() / "step.stl";
        step.scale = 1e-3;
        std::ofstream file(step.file);
        file << "solid step\n";
        const auto corner = [&](int bits) {
            file << "vertex " << ((bits & 1) != 0 ? 50 : 30) << " " << ((bits & 2) != 0 ? 40 : -20) << " "
                 << ((bits & 4) != 0 ? 5 : -5) << "\n";
        };
        const int faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
        for (const auto& face : faces) {
            file << "facet normal 0 0 0\nouter loop\n";
            for (const int bits : face) corner(bits);
            file << "endloop\nendfacet\n";
        }
        file << "endsolid step\n";
    }
    c.solids = {step};
    return c;
}

struct StepFlow {
    double velocity = 0.0;  ///< mean over the water and the last second, m/s
    double budget = 0.0;    ///< force on bed and step over the weight down the slope
    std::size_t particles = 0;
};

template <int D>
StepFlow flow_over_step() {
    set_thread_count(1);
    const Case c = step_case(D);
    const Scheme scheme = make_scheme(c, nullptr);
    const auto run = make_simulation<D>(c, nullptr, initial_particles<D>(c, scheme, nullptr));
    StepFlow flow{.particles = run->particles().size()};
    double mass = 0.0;
    double wall = 0.0;
    while (run->clock().time < 3.0) {
        run->step();
        const Particles<D>& p = run->particles();
        for (std::size_t i = 0; i < p.size() && run->clock().time > 2.0; ++i) {
            mass += p.mass[i];
            flow.velocity += p.mass[i] * p.velocity[0][i];
            wall -= p.mass[i] * run->fields().wall_acceleration_x[i];
        }
    }
    flow.velocity /= mass;
    flow.budget = wall / (mass * c.streamwise_gravity());
    return flow;
}

}  // namespace

// The kernels of two and three dimensions meet a depth of eight particles with errors of a percent each: 3 %.
TEST(StepInSpace, IsTheStepInThePlane) {
    const StepFlow plane = flow_over_step<2>();
    const StepFlow space = flow_over_step<3>();
    EXPECT_EQ(space.particles, 8 * plane.particles);
    expect_below("flow over a step from an STL file", "mean velocity against that of the outline - 1", 0.03,
                 std::abs(space.velocity / plane.velocity - 1.0));
    expect_below("flow over a step from an STL file", "force on bed and step / weight down the slope - 1",
                 0.01, std::abs(space.budget - 1.0));
}
