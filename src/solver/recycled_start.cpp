#include "solver/recycled_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/multiple.hpp"
#include "base/parallel.hpp"
#include "case/end_buffers.hpp"
#include "case/words.hpp"
#include "instruments/fluid_view.hpp"
#include "solver/start.hpp"

namespace riffle::inline solver {

namespace {

constexpr std::size_t block = 1024;

constexpr double rounding = 1e-9;

bool differs(double a, double b) { return std::abs(a - b) > rounding * std::abs(b); }

std::string wrong_extent(const char* what, double here, double there, bool periodic) {
    return fmt::format("{} is {:.10g} m there and {:.10g} m here, expected {}", what, there, here,
                       periodic ? "the same or several times that" : "the same");
}

}  // namespace

bool is_recycled(const Case& c, const Case& other) {
    return differs(c.numerics.spacing, other.numerics.spacing) ||
           differs(c.channel.length, other.channel.length) ||
           (c.channel.dimensions == 3 && differs(c.channel.width, other.channel.width));
}

std::string why_not_recycled(const Case& c, const Case& other) {
    const bool repeats = c.channel.ends != Ends::walls && other.channel.ends == Ends::periodic;
    const bool open = c.channel.ends == Ends::open;
    if (open ? other.channel.ends == Ends::walls : other.channel.ends == Ends::open) {
        return fmt::format(R"(channel.ends is "{}" there and "{}" here, expected {})",
                           word(other.channel.ends), word(c.channel.ends),
                           open ? R"("periodic" or "open")" : R"("periodic" or "walls")");
    }
    const bool across = c.channel.sides == Sides::periodic;
    if (differs(c.total_depth(), other.total_depth())) {
        return wrong_extent("the total depth", c.total_depth(), other.total_depth(), false);
    }
    if (differs(c.channel.length, other.channel.length) &&
        !(repeats && is_multiple(c.channel.length, other.channel.length, rounding))) {
        return wrong_extent("channel.length", c.channel.length, other.channel.length, repeats);
    }
    if (c.channel.dimensions == 3 && differs(c.channel.width, other.channel.width) &&
        !(across && is_multiple(c.channel.width, other.channel.width, rounding))) {
        return wrong_extent("channel.width", c.channel.width, other.channel.width, across);
    }
    return {};
}

template <int D>
Particles<D> recycled_particles(const Case& c, const Scheme& scheme, const Case& other,
                                const Particles<D>& water) {
    Case still = c;
    still.start.kind = StartKind::rest;
    still.start.perturbation = 0.0;
    Particles<D> particles = initial_particles<D>(still, scheme, nullptr);
    const double h = other.numerics.smoothing_ratio * other.numerics.spacing;
    const FluidViewIn<D> view(other, water, h);
    const auto inside = [](double x, double extent, bool repeats) {
        return repeats ? x - extent * std::floor(x / extent) : x;
    };
    parallel_blocks(particles.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec<3> place = in_space<D>(particles.position, i);
            place[0] = inside(place[0], other.channel.length, other.channel.ends == Ends::periodic);
            place[1] =
                inside(place[1], other.channel.width, D == 3 && other.channel.sides == Sides::periodic);
            const auto velocity = velocity_below(view, place, h).value_or(FluidView::Velocity{0.0, 0.0, 0.0});
            particles.velocity[0][i] = velocity.u;
            particles.velocity[D - 1][i] = velocity.w;
            if constexpr (D == 3) particles.velocity[1][i] = velocity.v;
        }
    });
    return particles;
}

template <int D>
void stand_between_open_ends(const Case& c, const Case& other, Particles<D>& water) {
    std::vector<std::int32_t> kept;
    for (std::size_t i = 0; i < water.size(); ++i) {
        if (water.position[0][i] >= 0.0) kept.push_back(static_cast<std::int32_t>(i));
    }
    water.permute(kept);
    if (other.channel.ends == Ends::open) return;
    const std::size_t n = water.size();
    std::vector<std::size_t> beyond;
    for (std::size_t i = 0; i < n; ++i) {
        if (water.position[0][i] < end_support(c)) beyond.push_back(i);
    }
    water.created = n > 0 ? *std::max_element(water.id.begin(), water.id.end()) + 1 : 0;
    const std::size_t first = water.append(beyond.size());
    for (std::size_t k = 0; k < beyond.size(); ++k) {
        const std::size_t i = beyond[k];
        const std::size_t image = first + k;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis) {
            water.position[axis][image] = water.position[axis][i] + (axis == 0 ? c.channel.length : 0.0);
            water.velocity[axis][image] = water.velocity[axis][i];
        }
        water.mass[image] = water.mass[i];
        water.density_deviation[image] = water.density_deviation[i];
    }
}

template void stand_between_open_ends(const Case&, const Case&, Particles<2>&);
template void stand_between_open_ends(const Case&, const Case&, Particles<3>&);
template Particles<2> recycled_particles(const Case&, const Scheme&, const Case&, const Particles<2>&);
template Particles<3> recycled_particles(const Case&, const Scheme&, const Case&, const Particles<3>&);

}  // namespace riffle::inline solver
