#include "column/canal_channel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/interpolation.hpp"
#include "case/cross_section.hpp"
#include "case/surface_roughness.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline column {

namespace {

double lowest_of(const CrossSection& section) {
    return *std::min_element(section.levels.begin(), section.levels.end());
}

/// The part of a section between two places across the channel.
CrossSection part_of(const CrossSection& section, double from, double to) {
    const auto level_at = [&](double y) {
        std::size_t i = 1;
        while (i + 1 < section.y.size() && section.y[i] < y) ++i;
        const double step = section.y[i] - section.y[i - 1];
        const double share = step > 0.0 ? (y - section.y[i - 1]) / step : 1.0;
        return section.levels[i - 1] + share * (section.levels[i] - section.levels[i - 1]);
    };
    CrossSection part{{from}, {level_at(from)}};
    for (std::size_t i = 0; i < section.y.size(); ++i) {
        if (section.y[i] <= from || section.y[i] >= to) continue;
        part.y.push_back(section.y[i]);
        part.levels.push_back(section.levels[i]);
    }
    part.y.push_back(to);
    part.levels.push_back(level_at(to));
    return part;
}

/// Strips by which the velocities across a canal are found.
constexpr int strips_across = 80;

/// Discharge of velocities over strips, over the width of one, m2/s.
double discharge_of(const std::vector<LateralStrip>& strips, const std::vector<double>& velocities) {
    double sum = 0.0;
    for (std::size_t i = 0; i < strips.size(); ++i) sum += std::max(0.0, strips[i].depth) * velocities[i];
    return sum;
}

/// Depths over which what follows from the strips of a section is interpolated, m.
std::vector<double> depths_of_strips(const Case& c, double least_depth) {
    constexpr int depths = 120;
    constexpr double lowest_share = 0.02;  // of the case's depth
    constexpr double highest_share = 6.0;
    std::vector<double> depth;
    for (int i = 0; i < depths; ++i) {
        const double share = static_cast<double>(i) / (depths - 1);
        const double h = c.total_depth() * lowest_share * std::pow(highest_share / lowest_share, share);
        if (h >= least_depth) depth.push_back(h);
    }
    return depth;
}

/// Coefficients of momentum and energy of velocities over strips.
std::pair<double, double> coefficients_of(const SectionStrips& strips,
                                          const std::vector<double>& velocities) {
    double area = 0.0;
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        const double a = std::max(0.0, strips.strips[i].depth);
        const double u = velocities[i];
        area += a;
        first += a * u;
        second += a * u * u;
        third += a * u * u * u;
    }
    if (!(first > 0.0)) return {1.0, 1.0};
    return {second * area / (first * first), third * area * area / (first * first * first)};
}

}  // namespace

std::shared_ptr<const SectionShape> shape_of_section(const Case& c, const Solid& solid) {
    const CrossSection section = cross_section(c, solid);
    const double lowest = lowest_of(section);
    const double width = c.channel.simulated_width();
    const double highest = *std::max_element(section.levels.begin(), section.levels.end()) - lowest;
    // Even depths, and both sides of each corner, for at a level floodplain the surface widens at once.
    constexpr int even = 400;
    constexpr double depths = 4.0;  // as far as an open end may rise
    const double top = std::max(highest, depths * c.total_depth());
    const double hair = 1e-6 * top;
    std::vector<double> depth;
    for (int i = 1; i <= even; ++i) depth.push_back(top * i / even);
    for (const double level : section.levels) {
        depth.push_back(level - lowest + hair);
        if (level - lowest > hair) depth.push_back(level - lowest - hair);
    }
    std::sort(depth.begin(), depth.end());
    std::vector<double> kept{0.0};
    std::vector<double> widths;
    std::vector<double> perimeters;
    for (const double h : depth) {
        if (h - kept.back() >= 0.5 * hair) kept.push_back(h);
    }
    for (const double h : kept) {
        const double level = lowest + std::max(h, hair);
        const WettedSection wet = wetted_section(section, level);
        widths.push_back(wet.top_width / width);
        const WettedSides sides = wetted_sides(c, section, level);
        perimeters.push_back((wet.perimeter + sides.left + sides.right) / width);
    }
    return std::make_shared<const SectionShape>(std::move(kept), std::move(widths), std::move(perimeters));
}

SectionStrips section_strips(const Case& c, const Solid& solid, double depth, int count) {
    const CrossSection section = cross_section(c, solid);
    const double lowest = lowest_of(section);
    const double level = lowest + depth;
    const double width = c.channel.simulated_width() / count;
    const WettedSides sides = wetted_sides(c, section, level);
    SectionStrips strips{width, {}, {}};
    for (int i = 0; i < count; ++i) {
        const CrossSection part = part_of(section, i * width, (i + 1) * width);
        const WettedSection wet = wetted_section(part, level);
        const double side = (i == 0 ? sides.left : 0.0) + (i + 1 == count ? sides.right : 0.0);
        strips.strips.push_back({wet.area / width, (wet.perimeter + side) / width,
                                 surface_roughness_at(c, solid, (i + 0.5) * width)});
        const CrossSection middle = part_of(section, i * width, (i + 0.5) * width);
        strips.bed.push_back(middle.levels.back() - lowest);
    }
    return strips;
}

std::vector<double> canal_velocities(const Case& c, const SectionStrips& strips, double slope) {
    return lateral_profile(strips.strips, strips.width, c.fluid.gravity * slope, c.fluid.kinematic_viscosity);
}

double share_of_patches(const Case& c, double depth) {
    const Solid& canal = *section_of(c);
    if (patches_on(c, canal).empty()) return 1.0;
    // The slope drops out, but for viscosity.
    constexpr double of_level_channel = 1e-3;
    const double down = c.streamwise_gravity() / c.fluid.gravity;
    const double slope = down > 0.0 ? down : of_level_channel;
    SectionStrips strips = section_strips(c, canal, depth, strips_across);
    const auto discharge = [&] { return discharge_of(strips.strips, canal_velocities(c, strips, slope)); };
    const double with_patches = discharge();
    for (LateralStrip& strip : strips.strips) strip.equivalent_roughness = surface_roughness(c, canal);
    const double without = discharge();
    return without > 0.0 ? with_patches / without : 1.0;
}

SteadyChannel canal_by_radius(const Case& c, double unit_discharge) {
    const Solid& canal = *section_of(c);
    SteadyChannel channel =
        colebrook_channel(c.channel.slope, c.fluid.gravity, unit_discharge, surface_roughness(c, canal),
                          c.fluid.kinematic_viscosity, shape_of_section(c, canal));
    if (patches_on(c, canal).empty()) return channel;
    const std::vector<double> depth = depths_of_strips(c, channel.least_depth);
    if (depth.empty()) return channel;
    std::vector<double> share;
    share.reserve(depth.size());
    for (const double h : depth) share.push_back(share_of_patches(c, h));
    channel.state = [by_radius = channel.state, depth, share](double h) {
        SectionState state = by_radius(h);
        const double of_patches = place_in(depth, h).in(share);
        state.friction_slope /= of_patches * of_patches;
        return state;
    };
    return channel;
}

SteadyChannel canal_channel(const Case& c, double unit_discharge) {
    const Solid& canal = *section_of(c);
    SteadyChannel channel = canal_by_radius(c, unit_discharge);
    // What the velocities across add, at depths from which it is interpolated.
    const std::vector<double> depth = depths_of_strips(c, channel.least_depth);
    std::vector<double> momentum;
    std::vector<double> energy;
    for (const double h : depth) {
        const SectionStrips strips = section_strips(c, canal, h, strips_across);
        const auto [beta, alpha] =
            coefficients_of(strips, canal_velocities(c, strips, channel.state(h).friction_slope));
        momentum.push_back(beta);
        energy.push_back(alpha);
    }
    if (depth.empty()) return channel;
    channel.state = [by_radius = channel.state, depth, momentum, energy](double h) {
        SectionState state = by_radius(h);
        const TablePlace place = place_in(depth, h);
        state.momentum_coefficient = place.in(momentum);
        state.energy_coefficient = place.in(energy);
        return state;
    };
    return channel;
}

double canal_uniform_discharge(const Case& c, double depth) {
    return canal_uniform_discharge(c, *shape_of_section(c, *section_of(c)), depth);
}

double canal_uniform_discharge(const Case& c, const SectionShape& shape, double depth) {
    return shape.area(depth) * share_of_patches(c, depth) *
           colebrook_white_velocity(c.streamwise_gravity(), surface_roughness(c, *section_of(c)),
                                    shape.hydraulic_radius(depth), c.fluid.kinematic_viscosity, full_pipe);
}

}  // namespace riffle::inline column
