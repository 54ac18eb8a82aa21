#include "hydraulics/section_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "hydraulics/lateral_profile.hpp"
#include "hydraulics/varied_flow.hpp"

namespace riffle {
namespace {

constexpr double g = 9.81;

/// A trapezoid of a bottom and a bank slope in a channel of a width, m.
SectionShape trapezoid(double bottom, double bank_slope, double width) {
    const double top = 0.5 * (width - bottom) / bank_slope;
    return {{0.0, top},
            {bottom / width, 1.0},
            {bottom / width, (bottom + 2.0 * top * std::hypot(1.0, bank_slope)) / width}};
}

TEST(SectionShape, ATrapezoidHasItsAreaAndForce) {
    const double width = 4.0;
    const SectionShape shape = trapezoid(1.0, 1.5, width);
    for (const double h : {0.1, 0.4, 0.9}) {
        EXPECT_NEAR(shape.area(h) * width, (1.0 + 1.5 * h) * h, 1e-12);
        EXPECT_NEAR(shape.top_width(h) * width, 1.0 + 3.0 * h, 1e-12);
        EXPECT_NEAR(shape.pressure_integral(h) * width, 0.5 * h * h + 0.5 * h * h * h, 1e-12);
        EXPECT_NEAR(shape.depth_of_area(shape.area(h)), h, 1e-12);
        EXPECT_NEAR(shape.hydraulic_radius(h), (1.0 + 1.5 * h) * h / (1.0 + 2.0 * h * std::hypot(1.0, 1.5)),
                    1e-12);
        EXPECT_NEAR(shape.depth_of_wave_integral(shape.wave_integral(h)), h, 1e-10);
    }
    // Above the banks the sides are upright.
    EXPECT_NEAR((shape.area(1.5) - shape.area(1.2)) * width, 0.3 * width, 1e-12);
}

TEST(SectionShape, WavesInARectangleAndATriangle) {
    const SectionShape rectangle({0.0, 1.0}, {1.0, 1.0}, {1.0, 3.0});
    EXPECT_NEAR(rectangle.wave_integral(0.3), 2.0 * std::sqrt(0.3), 1e-12);
    // c = sqrt(g h/2), and the integral of sqrt(2/h) is 2 sqrt(2 h).
    const SectionShape triangle({0.0, 1.0}, {0.0, 1.0}, {0.0, 2.0});
    EXPECT_NEAR(triangle.wave_integral(0.3), 2.0 * std::sqrt(0.6), 1e-9);
}

TEST(SectionShape, CriticalAndSequentDepths) {
    // Of a triangle of banks m: (2 Q^2/(g m^2))^(1/5); Q = q width, m = width/2.
    const SectionShape triangle({0.0, 1.0}, {0.0, 1.0}, {0.0, 2.0});
    EXPECT_NEAR(critical_depth(triangle, g, 0.05), std::pow(8.0 * 0.0025 / g, 0.2), 1e-9);
    const SectionShape rectangle({0.0, 1.0}, {1.0, 1.0}, {1.0, 3.0});
    EXPECT_NEAR(critical_depth(rectangle, g, 0.1), std::cbrt(0.01 / g), 1e-9);
    const double froude = 3.0;
    EXPECT_NEAR(sequent_depth(rectangle, g, 0.05, froude * std::sqrt(g * 0.05)),
                0.025 * (std::sqrt(1.0 + 8.0 * froude * froude) - 1.0), 1e-9);
    EXPECT_EQ(critical_depth(rectangle, g, 0.0), 0.0);
}

TEST(SectionShape, OverFloodplainsTheLargestCriticalDepthCounts) {
    // A channel 1 m wide and 1 m deep with floodplains to 11 m: 4 m3/s are critical in it, and again above.
    const SectionShape compound({0.0, 1.0, 1.000001, 2.0}, {1.0 / 11.0, 1.0 / 11.0, 1.0, 1.0},
                                {0.1, 0.3, 1.3, 1.5});
    const double q = 4.0 / 11.0;
    const double depth = critical_depth(compound, g, q);
    EXPECT_GT(depth, 1.0);
    EXPECT_NEAR(q * q * compound.top_width(depth), g * std::pow(compound.area(depth), 3.0), 1e-9);
}

/// Chow (1959), example 10-1: 400 ft3/s in a trapezoid of 20 ft with banks 2:1, n = 0.025, slope 0.0016,
/// alpha = 1.10, 5 ft deep at a dam. Normal depth 3.36 ft, critical 2.22 ft; by his direct steps 3.40 ft
/// stand 2377 ft up the channel.
TEST(VariedFlow, BackwaterOfATrapezoidIsChows) {
    constexpr double foot = 0.3048;
    const double width = 60.0 * foot;
    auto section = std::make_shared<const SectionShape>(trapezoid(20.0 * foot, 2.0, width));
    SteadyChannel channel = manning_channel(0.0016, g, 400.0 * std::pow(foot, 3.0) / width, 0.025, section);
    channel.state = [of = channel.state](double depth) {
        SectionState state = of(depth);
        state.momentum_coefficient = state.energy_coefficient = 1.10;
        return state;
    };
    EXPECT_NEAR(normal_depth(channel).value() / foot, 3.36, 0.01);
    EXPECT_NEAR(critical_depth(channel) / foot, 2.22, 0.08);  // by the momentum function, beta = 1.10
    const VariedFlow flow = solve_varied_flow(
        channel, {.length = 3000.0 * foot, .upstream_depth = {}, .downstream_depth = 5.0 * foot});
    EXPECT_EQ(flow.profiles.front().name, "M1");
    EXPECT_NEAR(flow.depth_at((3000.0 - 2377.0) * foot) / foot, 3.40, 0.01);
}

TEST(LateralProfile, AFloodplainIsDraggedAlongByItsChannel) {
    const std::vector<LateralStrip> even(40, {0.1, 1.0, 1e-3});
    const std::vector<double> u = lateral_profile(even, 0.05, 0.01, 1e-6);
    for (const double value : u) EXPECT_NEAR(value / u.front(), 1.0, 1e-12);
    // Beside a floodplain the main channel is slower than alone and the plain faster.
    std::vector<LateralStrip> compound(40, {0.1, 1.0, 1e-3});
    for (std::size_t i = 20; i < 40; ++i) compound[i].depth = 0.05;
    const std::vector<double> both = lateral_profile(compound, 0.02, 0.01, 1e-6);
    const std::vector<double> plain =
        lateral_profile(std::vector<LateralStrip>(4, {0.05, 1.0, 1e-3}), 0.02, 0.01, 1e-6);
    EXPECT_LT(both[19], u.front());
    EXPECT_GT(both[20], plain.front());
    EXPECT_NEAR(both[0] / u.front(), 1.0, 0.05);
    EXPECT_NEAR(both[39] / plain.front(), 1.0, 0.05);
    for (std::size_t i = 1; i < 40; ++i) EXPECT_LE(both[i], both[i - 1] * (1.0 + 1e-12));
    // Dry strips stand still and take nothing.
    std::vector<LateralStrip> dry(10, {0.1, 1.0, 1e-3});
    dry[0] = dry[1] = {};
    const std::vector<double> bank = lateral_profile(dry, 0.02, 0.01, 1e-6);
    EXPECT_EQ(bank[0], 0.0);
    EXPECT_NEAR(bank[5], u.front(), 1e-9);
}

// A floodplain as deep as the rest and rougher is slower, far from the edge as its own depth and roughness
// say.
TEST(LateralProfile, HasTheRoughnessOfEachStrip) {
    std::vector<LateralStrip> strips(60, {0.1, 1.0, 1e-3});
    for (std::size_t i = 30; i < strips.size(); ++i) strips[i].equivalent_roughness = 0.02;
    const std::vector<double> u = lateral_profile(strips, 0.1, 0.01, 1e-6);
    const auto alone = [](double roughness) {
        return lateral_profile(std::vector<LateralStrip>(4, {0.1, 1.0, roughness}), 0.1, 0.01, 1e-6)[0];
    };
    EXPECT_NEAR(u.front(), alone(1e-3), 1e-3 * u.front());
    EXPECT_NEAR(u.back(), alone(0.02), 1e-3 * u.back());
    EXPECT_LT(u.back(), 0.8 * u.front());
    for (std::size_t i = 1; i < u.size(); ++i) EXPECT_LE(u[i], u[i - 1]) << i;
}

}  // namespace
}  // namespace riffle
