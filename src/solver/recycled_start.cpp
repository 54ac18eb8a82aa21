#include "solver/recycled_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "instruments/fluid_view.hpp"
#include "solver/start.hpp"

namespace riffle {

namespace {

constexpr std::size_t block = 1024;

bool differs(double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(b); }

/// Whether a is b or several times it.
bool is_multiple(double a, double b) {
    const double times = std::round(a / b);
    return times >= 1.0 && !differs(times * b, a);
}

std::string wrong_extent(const char* what, double here, double there, bool periodic) {
    return fmt::format("{} is {:.10g} m there and {:.10g} m here, expected {}", what, there, here,
                       periodic ? "the same or several times that" : "the same");
}

/// The velocity of the water at a place: near and above its surface, where a point is not wet, that of the
/// wet point below it, at most two smoothing lengths down; nothing where there is none.
FluidView::Velocity velocity_below(const FluidView& view, Vec<3> place, double h) {
    constexpr int points = 5;
    for (int point = 0; point < points; ++point) {
        const FluidView::Velocity velocity = view.velocity_at(place);
        if (std::isfinite(velocity.u)) {
            return velocity;
        }
        place[2] -= 0.5 * h;
    }
    return {0.0, 0.0, 0.0};
}

}  // namespace

bool is_recycled(const Case& c, const Case& other) {
    return differs(c.numerics.spacing, other.numerics.spacing) ||
           differs(c.channel.length, other.channel.length) ||
           (c.channel.dimensions == 3 && differs(c.channel.width, other.channel.width));
}

std::string why_not_recycled(const Case& c, const Case& other) {
    const bool repeats = c.channel.ends == Ends::periodic && other.channel.ends == Ends::periodic;
    const bool across = c.channel.sides == Sides::periodic;
    if (differs(c.total_depth(), other.total_depth())) {
        return wrong_extent("the total depth", c.total_depth(), other.total_depth(), false);
    }
    if (differs(c.channel.length, other.channel.length) &&
        !(repeats && is_multiple(c.channel.length, other.channel.length))) {
        return wrong_extent("channel.length", c.channel.length, other.channel.length, repeats);
    }
    if (c.channel.dimensions == 3 && differs(c.channel.width, other.channel.width) &&
        !(across && is_multiple(c.channel.width, other.channel.width))) {
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
            const FluidView::Velocity velocity = velocity_below(view, place, h);
            particles.velocity[0][i] = velocity.u;
            particles.velocity[D - 1][i] = velocity.w;
            if constexpr (D == 3) {
                particles.velocity[1][i] = velocity.v;
            }
        }
    });
    return particles;
}

template Particles<2> recycled_particles(const Case&, const Scheme&, const Case&, const Particles<2>&);
template Particles<3> recycled_particles(const Case&, const Scheme&, const Case&, const Particles<3>&);

}  // namespace riffle
