#include "ends/inflow_streams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "ends/end_lattice.hpp"
#include "particles/lattice.hpp"

namespace riffle {
namespace {

constexpr double spacing = 0.002;
constexpr double edge = -0.02;

/// The streams of an inflow over some time, whose depth changes as it may, and what they brought in.
struct Inflow {
    InflowStreams streams;
    OpenEndsState state;
    double depth;
    double made = 0.0;  ///< area of the particles, m2

    explicit Inflow(double depth_now, int files = 1)
        : streams(files, spacing * spacing, spacing, edge), depth(depth_now) {
        streams.begin(state, streams.rows_for(depth), 0.5 * spacing);
        fill();
        made = 0.0;
    }
    void fill() {
        streams.rearrange(state, depth);
        streams.fill(state, depth, [&](int, int, double) { made += spacing * spacing; });
    }
    /// Area between the edge and the last particles, m2.
    [[nodiscard]] double waiting() const {
        double area = 0.0;
        const auto files = static_cast<double>(state.front.size()) / state.rows;
        for (const double front : state.front) {
            area += (front - 0.5 * streams.length(state.rows, depth) - edge) * depth / state.rows / files;
        }
        return area;
    }
};

// The area that has come in is the integral of the discharge, and never off by more than what waits.
TEST(InflowStreams, TheDischargeIsExact) {
    Inflow inflow(0.05);
    const double dt = 1e-3;
    const double before = inflow.waiting();
    double discharge = 0.0;
    for (int step = 0; step < 20000; ++step) {
        const auto velocity = [&](int row, int /*file*/ = 0) {
            return 0.02 * (row + 1) * (1.0 + 0.5 * std::sin(1e-3 * step));
        };
        for (int row = 0; row < inflow.state.rows; ++row) {
            discharge += dt * velocity(row) * inflow.depth / inflow.state.rows;
        }
        inflow.streams.advance(inflow.state, dt, 0.0, velocity);
        if (step % 7 == 0) inflow.fill();
    }
    EXPECT_NEAR((inflow.made + inflow.waiting() - before) / discharge, 1.0, 1e-9);
}

TEST(InflowStreams, AChangeOfTheRowsKeepsTheArea) {
    for (const int files : {1, 3}) {
        Inflow inflow(0.05, files);
        inflow.streams.advance(inflow.state, 0.01, 0.0, [](int row, int) { return 0.01 * row; });
        const int rows = inflow.state.rows;
        const double before = inflow.waiting();
        const double shallow = inflow.depth;
        inflow.depth = 0.0517;
        inflow.streams.rearrange(inflow.state, inflow.depth);
        EXPECT_EQ(inflow.state.rows, rows + 1);
        // The water stands higher; its mean edge stays where it was.
        EXPECT_NEAR(
            inflow.waiting() / inflow.depth, before / shallow,
            0.5 * std::abs(inflow.streams.length(rows, shallow) - inflow.streams.length(rows, inflow.depth)) +
                1e-12);
        EXPECT_EQ(inflow.state.front.size(), static_cast<std::size_t>(files * (rows + 1)));
    }
}

TEST(InflowStreams, ADepthThatWaversChangesNoRows) {
    Inflow inflow(0.05);
    const int rows = inflow.state.rows;
    for (const double depth : {0.0505, 0.0495, 0.0511, 0.0489, 0.0505}) {
        inflow.streams.rearrange(inflow.state, depth);
        EXPECT_EQ(inflow.state.rows, rows) << depth;
    }
}

TEST(InflowStreams, WaterThatGoesBackIsGivenUp) {
    Inflow inflow(0.05);
    inflow.streams.advance(inflow.state, 1.0, 0.0, [](int, int) { return -0.1; });
    inflow.fill();
    for (const double front : inflow.state.front) EXPECT_GE(front, edge - spacing * 1.0001);
    EXPECT_EQ(inflow.made, 0.0);
}

// Water that rises everywhere alike moves by the less the farther it is down its stream: dx/dt = u - s x.
TEST(InflowStreams, WaterThatRisesSpreadsAlongItsStream) {
    Inflow inflow(0.004);
    inflow.streams.begin(inflow.state, 2, 0.0);
    constexpr double velocity = 0.1;
    constexpr double spreading = 0.5;
    constexpr double dt = 1e-5;
    for (int step = 0; step < 100000; ++step) {
        inflow.streams.advance(inflow.state, dt, spreading, [](int, int) { return velocity; });
    }
    for (const double place : inflow.state.front) {
        EXPECT_NEAR(place, velocity / spreading * (1.0 - std::exp(-spreading)), 1e-6);
    }
}

TEST(InflowStreams, AStateIsTheSameAfterItsNumbers) {
    Inflow inflow(0.03, 2);
    inflow.state.begun = true;
    inflow.state.leaving = {0.1, 0.2, 0.3};
    inflow.state.ledger = {.entered = 17, .left = 4, .mass_entered = 0.3, .momentum_left = -2.0};
    inflow.state.downstream.coming = -1.5;
    inflow.state.travel = 1e-3;
    EXPECT_EQ(OpenEndsState::from(inflow.state.numbers()), inflow.state);
    EXPECT_TRUE(OpenEndsState().numbers().empty());
    // A level that falls takes out water of the start, which never entered.
    OpenEndsState drawn_back = inflow.state;
    drawn_back.ledger.entered = -3;
    EXPECT_EQ(OpenEndsState::from(drawn_back.numbers()), drawn_back);
    OpenEndsState loud = inflow.state;
    loud.sound_upstream = {.slow = {0.1}, .now = {0.2, 0.3}, .change = {0.4, 0.5}};
    loud.sound_downstream.now = {0.6};
    std::vector<double> sound = loud.sound_numbers();
    OpenEndsState back = inflow.state;
    back.take_sound(sound);
    EXPECT_EQ(back, loud);
    sound.pop_back();
    EXPECT_THROW(back.take_sound(sound), std::invalid_argument);
    EXPECT_THROW(back.take_sound({1.5, 0.0}), std::invalid_argument);
    std::vector<double> cut = inflow.state.numbers();
    cut.resize(12);
    EXPECT_THROW((void)OpenEndsState::from(cut), std::invalid_argument);
    cut = inflow.state.numbers();
    cut.pop_back();
    EXPECT_THROW((void)OpenEndsState::from(cut), std::invalid_argument);
}

/// A canal: bottom 20 mm, banks 1:1, in a channel of 80 mm.
const char* const canal =
    "[channel]\ndimensions = 3\nsides = \"walls\"\nends = \"open\"\nslope = 0.001\ndepth = 0.02\nwidth = 0.08\n"
    "length = 0.2\n[inflow]\ndischarge = 2e-4\n[bed]\nkind = \"slip\"\n[side_walls]\ndrag_form = \"none\"\n"
    "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = 0.002\n[run]\nuntil = 1\n[[solid]]\nname = \"canal\"\n"
    "shape = \"trapezoid\"\nbottom_width = 0.02\nbank_slope = 1\nsurface = \"log-law\"\nequivalent_roughness = 0.0005\n";

TEST(EndLattice, HoldsTheWaterOfItsSection) {
    const Case c = parse_case(canal, "canal");
    const Lattice lattice = lattice_of(c);
    const EndLattice places(c, lattice, 0.0);
    ASSERT_FALSE(places.is_rectangle());
    const SectionShape& shape = *places.shape();
    for (const double depth : {0.01, 0.02, 0.028}) {
        EXPECT_NEAR(shape.area(depth) * 0.08, (0.02 + depth) * depth, 0.02 * (0.02 + depth) * depth) << depth;
    }
    EXPECT_FALSE(places.holds(0, 0));
    EXPECT_TRUE(places.holds(0, lattice.files / 2));
    EXPECT_TRUE(places.holds(1000, 0));
    EXPECT_EQ(places.floor_of(lattice.files / 2), 0.0);
    EXPECT_NEAR(places.floor_of(0), 0.03, 0.003);
}

// What enters a canal is the integral of its streams too, when the water rises over its banks as well.
TEST(InflowStreams, TheDischargeOfACanalIsExact) {
    const Case c = parse_case(canal, "canal");
    const Lattice lattice = lattice_of(c);
    const InflowStreams streams(lattice.files, lattice.dx * lattice.dz, lattice.dz, edge,
                                EndLattice(c, lattice, 0.0));
    OpenEndsState state;
    streams.begin(state, streams.rows_for(0.02), 0.5 * lattice.dx);
    double made = 0.0;
    const auto fill = [&](double depth) {
        streams.rearrange(state, depth);
        streams.fill(state, depth, [&](int row, int file, double) {
            EXPECT_TRUE(streams.lattice().holds(row, file));
            made += lattice.dx * lattice.dz;
        });
    };
    const auto waiting = [&](double depth) {
        double area = 0.0;
        for (int row = 0; row < state.rows; ++row) {
            for (int file = 0; file < lattice.files; ++file) {
                if (!streams.lattice().holds(row, file)) continue;
                const double front =
                    state.front[static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice.files) +
                                static_cast<std::size_t>(file)];
                area += (front - 0.5 * streams.length(state.rows, depth) - edge) * depth / state.rows;
            }
        }
        return area;
    };
    const double depth = 0.02;
    fill(depth);
    made = 0.0;
    const double before = waiting(depth);
    double entered = 0.0;
    const double dt = 1e-3;
    for (int step = 0; step < 5000; ++step) {
        const auto velocity = [](int row, int file) { return 0.02 * (row + 1) + 0.001 * file; };
        for (int row = 0; row < state.rows; ++row) {
            for (int file = 0; file < lattice.files; ++file) {
                const double wet = streams.lattice().holds(row, file) ? 1.0 : 0.0;
                entered += wet * dt * velocity(row, file) * depth / state.rows;
            }
        }
        streams.advance(state, dt, 0.0, velocity);
        if (step % 7 == 0) fill(depth);
    }
    EXPECT_NEAR((made + waiting(depth) - before) / entered, 1.0, 1e-9);
    // The water rises: streams begin where there was bank.
    const int rows = state.rows;
    fill(0.026);
    EXPECT_GT(state.rows, rows);
    for (const double front : state.front) EXPECT_TRUE(std::isfinite(front));
}

}  // namespace
}  // namespace riffle
