#include "particles/lost_particle.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace riffle::inline particles {

namespace {

constexpr std::array<std::string_view, 8> texts = {"over the end wall at x = 0",
                                                   "over the far end wall",
                                                   "over a side wall",
                                                   "through the top of the domain",
                                                   "through the end wall at x = 0",
                                                   "through the far end wall",
                                                   "through a side wall",
                                                   "through the bed"};

/// Height at which a particle in free flight passed the wall at `wall`, standing now at x; less than any wall
/// where it does not come from there.
double height_at_wall(double x, double u, double wall, double z, double w, double gravity) {
    const double since = u != 0.0 ? (x - wall) / u : -1.0;
    return since > 0.0 ? z - (w + 0.5 * gravity * since) * since : -1.0;
}

}  // namespace

std::string_view exit_text(Exit exit) { return texts[static_cast<std::size_t>(exit)]; }

Exit exit_of(const Case& c, const std::array<double, 3>& position, const std::array<double, 3>& velocity) {
    const double top = c.channel.wall_height.value_or(1.5 * c.total_depth()) - c.numerics.spacing;
    const auto over = [&](std::size_t axis, double wall) {
        return height_at_wall(position[axis], velocity[axis], wall, position[2], velocity[2],
                              c.normal_gravity()) >= top;
    };
    if (c.channel.ends == Ends::walls && position[0] < 0.0) {
        return over(0, 0.0) ? Exit::over_start : Exit::through_start;
    }
    if (c.channel.ends == Ends::walls && position[0] > c.channel.length) {
        return over(0, c.channel.length) ? Exit::over_end : Exit::through_end;
    }
    const double width = c.channel.simulated_width();
    if (c.channel.dimensions == 3 && (position[1] < 0.0 || position[1] > width)) {
        return over(1, position[1] < 0.0 ? 0.0 : width) ? Exit::over_side : Exit::through_side;
    }
    return position[2] < 0.0 ? Exit::through_bed : Exit::above;
}

LostWater lost_water(const std::vector<LostParticle>& lost, double remaining) {
    LostWater water;
    for (const LostParticle& particle : lost) {
        ++water.particles;
        water.mass += particle.mass;
    }
    const double all = water.mass + remaining;
    water.share = all > 0.0 ? water.mass / all : 0.0;
    return water;
}

std::string lost_text(const LostWater& water) {
    return fmt::format("{} particle{} ({:.2g} % of the water)", water.particles,
                       water.particles == 1 ? "" : "s", 100.0 * water.share);
}

std::string exits_text(const std::vector<LostParticle>& lost) {
    std::string text;
    for (std::size_t exit = 0; exit < texts.size(); ++exit) {
        const auto n = std::count_if(lost.begin(), lost.end(),
                                     [&](const auto& p) { return p.exit == static_cast<Exit>(exit); });
        if (n > 0) {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, texts[exit]);
        }
    }
    return text;
}

}  // namespace riffle::inline particles
