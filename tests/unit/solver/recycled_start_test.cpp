// A start from the flow of a run of another spacing or of a shorter channel.

#include "solver/recycled_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "small_case.hpp"

namespace riffle::recycled_start_test {
namespace {

constexpr double slope = 5.0;      ///< of the mean velocity, 1/s
constexpr double amplitude = 0.1;  ///< of a wave along the channel, m/s

Case channel(int dimensions, double spacing) {
    Case c = test::still_water(dimensions);
    c.channel.dimensions = dimensions;
    c.channel.length = 0.08;
    c.channel.width = 0.04;
    c.numerics.spacing = spacing;
    return c;
}

/// A shear with a wave whose length is that of the given channel, in its water.
template <int D>
Particles<D> flowing(const Case& c) {
    Particles<D> p = initial_particles<D>(c, make_scheme(c, nullptr), nullptr);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.velocity[0][i] = slope * p.position[D - 1][i];
        p.velocity[D - 1][i] =
            amplitude * std::sin(2.0 * std::numbers::pi * p.position[0][i] / c.channel.length);
    }
    return p;
}

/// Largest departure of the velocities from the shear, and rms of those from the wave, m/s.
template <int D>
std::pair<double, double> departures(const Particles<D>& p, double wave_length) {
    double largest = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double wave = amplitude * std::sin(2.0 * std::numbers::pi * p.position[0][i] / wave_length);
        largest = std::max(largest, std::abs(p.velocity[0][i] - slope * p.position[D - 1][i]));
        square += (p.velocity[D - 1][i] - wave) * (p.velocity[D - 1][i] - wave);
    }
    return {largest, std::sqrt(square / static_cast<double>(p.size()))};
}

template <int D>
void expect_the_flow_of_a_coarser_run() {
    const Case coarse = channel(D, 0.004);
    Case fine = channel(D, 0.0025);
    fine.channel.length = 0.16;
    ASSERT_TRUE(is_recycled(fine, coarse));
    ASSERT_EQ(why_not_recycled(fine, coarse), "");
    const Particles<D> p =
        recycled_particles<D>(fine, make_scheme(fine, nullptr), coarse, flowing<D>(coarse));
    EXPECT_EQ(p.size(), (initial_particles<D>(fine, make_scheme(fine, nullptr), nullptr).size()));
    const auto [shear, wave] = departures<D>(p, 0.08);
    // A linear field is met but beside the surface, where it is carried on from half a coarse spacing below.
    EXPECT_LT(shear, slope * 0.004);
    EXPECT_LT(wave, 0.05 * amplitude);
}

TEST(RecycledStart, HasTheFlowOfACoarserRunRepeated) {
    expect_the_flow_of_a_coarser_run<2>();
    expect_the_flow_of_a_coarser_run<3>();
}

TEST(RecycledStart, LosesLessTheFinerItsRun) {
    const auto error = [](double spacing) {
        const Case run = channel(2, spacing);
        const Case fine = channel(2, 0.00125);
        const Particles<2> p = recycled_particles<2>(fine, make_scheme(fine, nullptr), run, flowing<2>(run));
        return departures<2>(p, 0.08).second;
    };
    // Second order: a quarter at half of the spacing.
    EXPECT_LT(error(0.0025), 0.35 * error(0.005));
}

TEST(RecycledStart, IsOneForAnotherSpacingOrExtentAlone) {
    const Case run = channel(3, 0.004);
    EXPECT_FALSE(is_recycled(run, run));
    Case other = run;
    other.channel.length = 0.1;
    EXPECT_TRUE(is_recycled(other, run));
    EXPECT_NE(why_not_recycled(other, run).find("channel.length is 0.08 m there and 0.1 m here"),
              std::string::npos);
    other = run;
    other.channel.width = 0.12;
    EXPECT_EQ(why_not_recycled(other, run), "");
    other.channel.sides = Sides::walls;
    EXPECT_NE(why_not_recycled(other, run), "");
    other = run;
    other.channel.depth = 0.06;
    EXPECT_NE(why_not_recycled(other, run).find("total depth"), std::string::npos);
}

}  // namespace
}  // namespace riffle::recycled_start_test
