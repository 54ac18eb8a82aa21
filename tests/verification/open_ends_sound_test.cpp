#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "solver/simulation.hpp"
#include "solver/start.hpp"

// A packet of sound runs out of still water under a free surface, or through a duct: what comes back.

namespace riffle {
namespace {

constexpr double water_height = 0.02;
constexpr double reach = 0.24;

std::string still_water(double length) {
    return "[channel]\nslope = 0\ndepth = 0.02\nlength = " + std::to_string(length) +
           "\nends = \"open\"\n[inflow]\ndepth = 0.02\nprofile = \"uniform\"\n[outflow]\nkind = \"depth\"\n"
           "depth = 0.02\n[numerics]\nspacing = 0.001\n[start]\nkind = \"rest\"\n[bed]\nkind = \"slip\"\n"
           "[turbulence]\nclosure = \"none\"\n[run]\nuntil = \"1 s\"\n";
}

std::string full_duct(double length) {
    return "[channel]\nslope = 0\ndepth = 0.02\nlength = " + std::to_string(length) +
           "\nends = \"open\"\ntop = \"wall\"\n[inflow]\nunit_discharge = 2e-3\nprofile = \"uniform\"\n"
           "[outflow]\nkind = \"pressure\"\n[numerics]\nspacing = 0.001\n[start]\nkind = \"uniform\"\n[bed]\n"
           "kind = \"slip\"\n[turbulence]\nclosure = \"none\"\n[run]\nuntil = \"1 s\"\n";
}

/// A packet in the middle of a reach: its waves over the height of the water, the way it runs, and whether
/// its pressure vanishes at a surface.
struct Packet {
    double wavelength = 2.0;
    double direction = 1.0;
    bool under_surface = true;

    [[nodiscard]] double along() const { return 2.0 * std::numbers::pi / (wavelength * water_height); }
    [[nodiscard]] double upright() const {
        return under_surface ? 0.5 * std::numbers::pi / water_height : 0.0;
    }
    /// Speed of the packet over that of sound.
    [[nodiscard]] double group_speed() const { return along() / std::hypot(along(), upright()); }

    void add_to(Particles<2>& p, const StateEquation& state, double middle) const {
        const double c = state.sound_speed;
        const double frequency = c * std::hypot(along(), upright());
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = (p.position[0][i] - middle) * direction;
            const double z = p.position[1][i];
            const double envelope = 1e-3 * c * c * std::exp(-0.5 * std::pow(x / (1.5 * water_height), 2));
            const double pressure = envelope * std::cos(along() * x) * std::cos(upright() * z);
            p.density_deviation[i] = state.deviation(state.pressure(p.density_deviation[i]) + pressure);
            p.velocity[0][i] += direction * pressure * along() / frequency;
            p.velocity[1][i] -=
                envelope * upright() / frequency * std::sin(upright() * z) * std::sin(along() * x);
        }
    }
};

/// Water with a packet beside the same water without, between ends that are near or far.
class Pair {
  public:
    Pair(const std::string& text, const Packet& packet, double length) : middle_(0.5 * length) {
        const Case c = parse_case(text, "sound");
        const Scheme scheme = make_scheme(c, nullptr);
        auto start = initial_particles<2>(c, scheme, nullptr);
        quiet_ = make_simulation<2>(c, nullptr, start);
        packet.add_to(start, scheme.state, middle_);
        loud_ = make_simulation<2>(c, nullptr, std::move(start));
        const double time = reach / (packet.group_speed() * scheme.state.sound_speed);
        while (loud_->clock().time < time) loud_->step();
        while (quiet_->clock().time < time) quiet_->step();
    }

    /// Energy of what the packet has made, all of it or within half a distance of the middle.
    [[nodiscard]] double energy(double within) const {
        const auto& p = loud_->particles();
        const auto& q = quiet_->particles();
        const StateEquation& state = loud_->scheme().state;
        std::map<std::int32_t, std::size_t> place;
        for (std::size_t j = 0; j < q.size(); ++j) place[q.id[j]] = j;
        double sum = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto other = place.find(p.id[i]);
            if (other == place.end() || std::abs(p.position[0][i] - middle_) > 0.5 * within) continue;
            const std::size_t j = other->second;
            const double pressure =
                state.pressure(p.density_deviation[i]) - state.pressure(q.density_deviation[j]);
            double squares = std::pow(pressure / state.sound_speed, 2);
            for (std::size_t k = 0; k < 2; ++k) squares += std::pow(p.velocity[k][i] - q.velocity[k][j], 2);
            sum += 0.5 * p.mass[i] * squares;
        }
        return sum;
    }

  private:
    double middle_;
    std::unique_ptr<SimulationIn<2>> loud_, quiet_;
};

/// Amplitude of what comes back: energy in the reach, once the packet has gone on by its length, above that
/// in a longer channel, over that of the packet there.
double echo(std::string (*text)(double), const Packet& packet) {
    const Pair near(text(reach), packet, reach);
    const Pair far(text(3.4 * reach), packet, 3.4 * reach);
    const double back = std::max(0.0, near.energy(reach) - far.energy(reach));
    const double amplitude = std::sqrt(back / far.energy(3.4 * reach));
    std::printf("%s, waves of %.0f heights, %s: %.3f comes back\n",
                packet.under_surface ? "under a surface" : "in a duct", packet.wavelength,
                packet.direction > 0.0 ? "downstream" : "upstream", amplitude);
    return amplitude;
}

// Of sound whose waves are two depths long at most a tenth; pressure and velocity that are given beyond the
// ends, as they were before, throw half of it back (0.49 at both ends).
TEST(OpenEndsSound, LeavesAChannel) {
    for (const double direction : {1.0, -1.0}) {
        EXPECT_LT(echo(still_water, {.wavelength = 2.0, .direction = direction}), 0.1);
        EXPECT_LT(echo(still_water, {.wavelength = 1.0, .direction = direction}), 0.1);
        // These go up and down as much as along, and much of the packet more.
        EXPECT_LT(echo(still_water, {.wavelength = 4.0, .direction = direction}), 0.3);
    }
}

TEST(OpenEndsSound, LeavesADuct) {
    for (const double direction : {1.0, -1.0}) {
        const Packet packet{.wavelength = 2.0, .direction = direction, .under_surface = false};
        EXPECT_LT(echo(full_duct, packet), 0.1);
    }
}

}  // namespace
}  // namespace riffle
