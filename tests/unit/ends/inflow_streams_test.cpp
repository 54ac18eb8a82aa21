#include "ends/inflow_streams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

}  // namespace
}  // namespace riffle
