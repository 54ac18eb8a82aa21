#include "case/cross_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "case/solid_shapes.hpp"
#include "case/surface_roughness.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

using BankCorners = std::vector<std::array<double, 2>>;

/// From the left side of the channel to the bottom of a trapezoid, with a floodplain beyond its banks where
/// these end before the side.
BankCorners left_bank(const Case& c, const Solid& solid) {
    const double foot = c.channel.centreline() - 0.5 * solid.bottom_width;
    const double slope = solid.bank_slope;
    const double to_side = slope > 0.0 ? foot / slope : 0.0;
    const double height = solid.bank_height.value_or(to_side);
    const double crest = foot - slope * height;
    BankCorners corners;
    if (crest > 0.0) {
        double outer = 0.0;  // of the floodplain
        if (solid.shape == SolidShape::compound && solid.floodplain_width) {
            outer = std::max(0.0, crest - *solid.floodplain_width);
            if (outer > 0.0) {
                corners.push_back({0.0, height + outer / slope});
            }
        }
        corners.push_back({outer, height});
        corners.push_back({crest, height});
    } else if (foot > 0.0) {
        corners.push_back({0.0, slope > 0.0 ? to_side : height});
    }
    corners.push_back({foot, 0.0});
    return corners;
}

/// From the left side of the channel to the bottom of a pipe that is open above its middle.
BankCorners left_half_of_pipe(const Case& c, const Solid& solid) {
    // An odd number of edges in half of the circle: one of them lies at the bottom, above the floor.
    const std::size_t edges = edges_around(c, solid.diameter) / 2 | 1U;
    const double step = std::numbers::pi / static_cast<double>(edges);
    const double radius = 0.5 * solid.diameter;
    const double outer = radius * std::sqrt(step / std::sin(step));
    BankCorners corners;
    if (c.channel.centreline() > outer) {
        corners.push_back({0.0, radius});
    }
    for (std::size_t i = 0; 2 * i < edges; ++i) {
        const double angle = static_cast<double>(i) * step;
        corners.push_back({std::max(0.0, c.channel.centreline() - outer * std::cos(angle)),
                           radius - outer * std::sin(angle)});
    }
    return corners;
}

std::string trapezoid_fault(const Case& c, const Solid& solid) {
    const auto shown = [](double value) { return shown_quantity(value, Dimension::length); };
    const bool compound = solid.shape == SolidShape::compound;
    if (solid.bottom_width > c.channel.width * (1.0 + 1e-6)) {
        return fmt::format("bottom_width is {}, the channel {} wide", shown(solid.bottom_width),
                           shown(c.channel.width));
    }
    if (!solid.bank_height && (compound || solid.bank_slope == 0.0)) {
        return compound ? "has no bank_height, at which its floodplains begin"
                        : "has upright banks (bank_slope 0) and no bank_height";
    }
    if (solid.bank_height.value_or(0.0) * solid.bank_slope >
        0.5 * (c.channel.width - solid.bottom_width) * (1.0 + 1e-6)) {
        return fmt::format("banks of {} at a slope of {:g} need {}, and {} are left beside the bottom",
                           shown(*solid.bank_height), solid.bank_slope,
                           shown(*solid.bank_height * solid.bank_slope),
                           shown(0.5 * (c.channel.width - solid.bottom_width)));
    }
    const double beside =
        0.5 * (c.channel.width - solid.bottom_width) - solid.bank_slope * solid.bank_height.value_or(0.0);
    if (compound && solid.floodplain_width.value_or(0.0) > beside * (1.0 + 1e-6)) {
        return fmt::format(
            "floodplain_width is {}, and {} are left beside the banks: without it the "
            "floodplains reach to the sides",
            shown(*solid.floodplain_width), shown(beside));
    }
    return compound && solid.floodplain_width && solid.bank_slope == 0.0
               ? "has a floodplain_width and upright banks: without it the floodplains reach to the sides"
               : "";
}

std::string pipe_fault(const Case& c, const Solid& solid) {
    const auto shown = [](double value) { return shown_quantity(value, Dimension::length); };
    if (solid.diameter > c.channel.width * (1.0 + 1e-6) || solid.diameter <= 0.0) {
        return fmt::format("diameter is {}, the channel {} wide", shown(solid.diameter),
                           shown(c.channel.width));
    }
    if (c.channel.depth > 0.5 * solid.diameter * (1.0 + 1e-6)) {
        return fmt::format(
            "the water is {} deep, and a pipe is drawn up to its middle, {}: give the closed surface of a "
            "fuller one by a file",
            shown(c.channel.depth), shown(0.5 * solid.diameter));
    }
    return "";
}

std::string corners_fault(const Case& c, const Solid& solid) {
    const auto shown = [](double value) { return shown_quantity(value, Dimension::length); };
    if (solid.y.size() < 2 || solid.y.size() != solid.levels.size()) {
        return fmt::format("y holds {} places and levels {} heights: expected two or more, as many of each",
                           solid.y.size(), solid.levels.size());
    }
    for (std::size_t i = 1; i < solid.y.size(); ++i) {
        if (solid.y[i] < solid.y[i - 1] || (i > 1 && solid.y[i] == solid.y[i - 2])) {
            return fmt::format("y goes back, or stays for more than two corners, at {}", shown(solid.y[i]));
        }
    }
    const double width = c.channel.simulated_width();
    if (solid.y.front() > 1e-6 * width || solid.y.back() < width * (1 - 1e-6)) {
        return fmt::format("y reaches from {} to {}, the channel from 0 to {}", shown(solid.y.front()),
                           shown(solid.y.back()), shown(width));
    }
    const double lowest = *std::min_element(solid.levels.begin(), solid.levels.end());
    if (lowest < 0.0) {
        return fmt::format("levels go down to {}, below the bed level z = 0, where the floor stands",
                           shown(lowest));
    }
    const double jump = std::abs(solid.levels.front() - solid.levels.back());
    if (c.channel.sides == Sides::periodic && jump > 0.5 * c.numerics.spacing) {
        return fmt::format("levels differ by {} between the two sides, which are periodic", shown(jump));
    }
    return "";
}

}  // namespace

bool is_section(SolidShape shape) {
    return shape == SolidShape::section || shape == SolidShape::trapezoid || shape == SolidShape::compound ||
           shape == SolidShape::pipe;
}

CrossSection cross_section(const Case& c, const Solid& solid) {
    if (solid.shape == SolidShape::section) {
        return {solid.y, solid.levels};
    }
    const BankCorners left =
        solid.shape == SolidShape::pipe ? left_half_of_pipe(c, solid) : left_bank(c, solid);
    const double middle = c.channel.centreline();
    CrossSection section;
    for (const auto& [y, level] : left) {
        section.y.push_back(y);
        section.levels.push_back(level);
    }
    if (c.channel.sides == Sides::half) {
        if (section.y.back() < middle) {
            section.y.push_back(middle);
            section.levels.push_back(section.levels.back());
        }
        return section;
    }
    for (std::size_t i = left.size(); i-- > 0;) {
        if (left[i][0] < middle) {
            section.y.push_back(2.0 * middle - left[i][0]);
            section.levels.push_back(left[i][1]);
        }
    }
    return section;
}

std::string section_fault(const Case& c, const Solid& solid) {
    switch (solid.shape) {
        case SolidShape::trapezoid:
        case SolidShape::compound:
            return trapezoid_fault(c, solid);
        case SolidShape::pipe:
            return pipe_fault(c, solid);
        case SolidShape::section:
        case SolidShape::free_form:
        case SolidShape::box:
        case SolidShape::sphere:
        case SolidShape::cylinder:
        case SolidShape::rectangle:
        case SolidShape::circle:
        case SolidShape::bed:
        case SolidShape::spheres:
            break;
    }
    return corners_fault(c, solid);
}

WettedSection wetted_section(const CrossSection& section, double level) {
    WettedSection wet;
    const auto depth = [&](std::size_t i) { return level - section.levels[i]; };
    for (std::size_t i = 1; i < section.y.size(); ++i) {
        const double a = depth(i - 1);
        const double b = depth(i);
        if (a <= 0.0 && b <= 0.0) continue;
        // The part of the edge under the level.
        const double share = a >= 0.0 && b >= 0.0 ? 1.0 : std::max(a, b) / std::abs(a - b);
        const double width = share * (section.y[i] - section.y[i - 1]);
        wet.area += 0.5 * width * (std::max(a, 0.0) + std::max(b, 0.0));
        wet.perimeter += share * std::hypot(section.y[i] - section.y[i - 1], a - b);
        wet.top_width += width;
    }
    return wet;
}

WettedSides wetted_sides(const Case& c, const CrossSection& section, double level) {
    WettedSides wet;
    if (!c.has_side_wall_drag()) return wet;
    wet.left = std::max(0.0, level - section.levels.front());
    if (c.channel.sides != Sides::half) wet.right = std::max(0.0, level - section.levels.back());
    return wet;
}

const Solid* section_of(const Case& c) {
    if (c.channel.dimensions != 3) return nullptr;
    const Solid* found = nullptr;
    for (const Solid& solid : c.solids) {
        if (!is_section(solid.shape)) continue;
        if (found != nullptr || !section_fault(c, solid).empty()) return nullptr;
        found = &solid;
    }
    return found;
}

const Solid* measured_bed_of(const Case& c) {
    const auto found = std::find_if(c.solids.begin(), c.solids.end(),
                                    [](const Solid& solid) { return solid.shape == SolidShape::bed; });
    return c.channel.dimensions == 3 && found != c.solids.end() ? &*found : nullptr;
}

const Solid* uneven_bed_of(const Case& c) {
    const Solid* const section = section_of(c);
    return section != nullptr ? section : measured_bed_of(c);
}

const Solid* canal_of(const Case& c) {
    const Solid* const solid = section_of(c);
    if (solid == nullptr || solid->surface != SolidSurface::log_law || !has_strips_alone(c, *solid)) {
        return nullptr;
    }
    if (c.channel.ends == Ends::open) return solid;
    const bool uniform = c.channel.ends == Ends::periodic && c.channel.slope > 0.0 && c.solids.size() == 1;
    return uniform ? solid : nullptr;
}

bool has_solids_beside_section(const Case& c) { return c.solids.size() > (canal_of(c) != nullptr ? 1U : 0U); }

}  // namespace riffle::inline case_file
