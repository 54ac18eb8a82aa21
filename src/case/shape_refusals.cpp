#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "case/cross_section.hpp"
#include "case/refusals.hpp"
#include "case/solid_shapes.hpp"
#include "case/sphere_tiling.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

bool has_shape(const Solid& solid, std::initializer_list<SolidShape> shapes) {
    return std::find(shapes.begin(), shapes.end(), solid.shape) != shapes.end();
}

Findings wrong_dimensions(const Case& c, const Solid& solid) {
    const int own = dimensions_of(solid.shape);
    return found_if(own != 0 && own != c.channel.dimensions, "shape = \"{}\" is one of {} dimensions",
                    word(solid.shape), own == 2 ? "two" : "three");
}

Findings wrong_count(const Case& c, const char* key, const std::vector<double>& values) {
    return found_if(values.size() != static_cast<std::size_t>(c.channel.dimensions),
                    "{} holds {} {}; expected {}", key, values.size(),
                    values.size() == 1 ? "value" : "values",
                    in_space(c) ? "three: x, y and z" : "two: x and z");
}

Findings no_size(const Solid& solid) {
    if (has_shape(solid, {SolidShape::box, SolidShape::rectangle})) {
        return found_if(std::any_of(solid.size.begin(), solid.size.end(), [](double v) { return v <= 0.0; }),
                        "size holds a length that is not above zero");
    }
    if (has_shape(solid,
                  {SolidShape::sphere, SolidShape::cylinder, SolidShape::circle, SolidShape::spheres}) &&
        solid.diameter <= 0.0) {
        return found_if(true, "has no diameter");
    }
    return found_if(solid.shape == SolidShape::cylinder && solid.length <= 0.0, "has no length");
}

/// What is wrong with the sizes of a layer of spheres.
Findings wrong_sizes(const Solid& solid) {
    const std::vector<double>& smaller = solid.smaller_diameters;
    if (solid.shape != SolidShape::spheres || (smaller.empty() && solid.area_shares.empty())) return {};
    const bool falls = std::is_sorted(smaller.begin(), smaller.end(), std::greater<>()) &&
                       (smaller.empty() || (smaller.front() < solid.diameter && smaller.back() > 0.0));
    if (solid.packing != SolidPacking::random) {
        return found_if(true, "has smaller_diameters or area_shares, and its packing is \"{}\"",
                        word(solid.packing));
    }
    if (!falls) return found_if(true, "smaller_diameters do not fall from below the diameter to above zero");
    const double sum = std::accumulate(solid.area_shares.begin(), solid.area_shares.end(), 0.0);
    constexpr double most = 0.5;
    const bool positive = std::all_of(solid.area_shares.begin(), solid.area_shares.end(),
                                      [](double share) { return share > 0.0; });
    return found_if(
        !solid.area_shares.empty() && (solid.area_shares.size() != smaller.size() || !positive || sum > most),
        "area_shares holds {} shares of {:.3g} in all, and {} sizes are larger than the smallest",
        solid.area_shares.size(), sum, smaller.size());
}

/// A lattice of spheres that a periodic channel does not hold a whole number of.
Findings stretched_spheres(const Case& c, const Solid& solid) {
    if (solid.shape != SolidShape::spheres || solid.diameter <= 0.0 ||
        solid.packing == SolidPacking::random) {
        return {};
    }
    const double across =
        solid.packing == SolidPacking::hexagonal ? std::numbers::sqrt3 * solid.diameter : solid.diameter;
    Findings found;
    const auto look = [&](const char* name, double extent, double period, bool periodic) {
        const double whole = whole_periods(extent, period) * period;
        if (periodic && std::abs(extent / whole - 1.0) > largest_stretch) {
            found.push_back({.detail = fmt::format(
                                 "{} is {}, and {} is the nearest whole number of spheres of {}", name,
                                 shown_length(extent), shown_length(whole), shown_length(solid.diameter))});
        }
    };
    look("length", c.channel.length, solid.diameter, c.channel.ends == Ends::periodic);
    look("width", c.channel.simulated_width(), across, c.channel.sides == Sides::periodic);
    return found;
}

Findings needless_blend(const Case& c, const Solid& solid) {
    const bool along = c.channel.ends == Ends::periodic;
    const bool across = in_space(c) && c.channel.sides == Sides::periodic;
    const bool open = c.channel.ends == Ends::open;
    return found_if(solid.blend > 0.0 && !along && !across && !open,
                    "blend is {}, and the channel has no periodic {} and no open ends",
                    shown_length(solid.blend), in_space(c) ? "ends or sides" : "ends");
}

Findings long_blend(const Case& c, const Solid& solid) {
    const bool across = in_space(c) && c.channel.sides == Sides::periodic;
    const double extent = across ? std::min(c.channel.length, c.channel.simulated_width()) : c.channel.length;
    return found_if(solid.blend > 0.5 * extent, "blend is {}, more than half of the {} between periodic ends",
                    shown_length(solid.blend), shown_length(extent));
}

}  // namespace

CheckList shape_refusals() {
    using enum SolidShape;
    return {{
        {{"solid.shape", "channel.dimensions"},
         "a `shape` of the other number of dimensions",
         "",
         R"(in two dimensions choose "rectangle" or "circle", in three "box", "sphere", "cylinder", a cross-section or "spheres"; "free-form" and "bed" go with both)",
         wrong_dimensions,
         true},
        {{"solid.centre"},
         "`centre` missing, or without as many values as the case has dimensions",
         "",
         R"(give it, for example centre = ["100 mm", "50 mm", "20 mm"], in two dimensions x and z alone)",
         [](const Case& c, const Solid& solid) {
             return has_shape(solid, {box, sphere, cylinder, rectangle, circle})
                        ? wrong_count(c, "centre", solid.centre)
                        : Findings{};
         },
         true},
        {{"solid.size"},
         "`size` missing, or without as many values as the case has dimensions",
         "",
         R"(give it, for example size = ["40 mm", "20 mm", "20 mm"], in two dimensions along x and z alone)",
         [](const Case& c, const Solid& solid) {
             return has_shape(solid, {box, rectangle}) ? wrong_count(c, "size", solid.size) : Findings{};
         },
         true},
        {{"solid.size", "solid.diameter", "solid.length"},
         "a shape without a `size`, `diameter` or `length` above zero",
         "",
         "give it",
         [](const Case&, const Solid& solid) { return no_size(solid); },
         true},
        {{"solid.heights"},
         "a bed without `heights`",
         "",
         "give the file of its heights, for example heights = \"gravel.asc\"",
         [](const Case&, const Solid& solid) {
             return found_if(solid.shape == bed && solid.heights.empty(), "heights is missing");
         },
         true},
        {{"solid.origin"},
         "`origin` without as many numbers as the case has dimensions",
         "",
         "give all of them, or remove the key",
         [](const Case& c, const Solid& solid) {
             return solid.origin.empty() ? Findings{} : wrong_count(c, "origin", solid.origin);
         },
         true},
        {{"solid.moment_about"},
         "`moment_about` without as many values as the case has dimensions",
         "",
         "give x, y and z of the point, in two dimensions x and z alone, or remove the key for the centroid",
         [](const Case& c, const Solid& solid) {
             return solid.moment_about.empty() ? Findings{}
                                               : wrong_count(c, "moment_about", solid.moment_about);
         },
         true},
        {{"solid.smaller_diameters", "solid.area_shares", "solid.packing"},
         "several sizes of spheres that are not in random places, do not become smaller, or whose `area_shares` are not one for each but the smallest, above 0, and 0.5 in all at most",
         "spheres in random places cover hardly more than half of the plan",
         "set packing = \"random\", order the sizes, and give each but the smallest its share",
         [](const Case&, const Solid& solid) { return wrong_sizes(solid); },
         true},
        {{"solid.blend", "channel.ends"},
         "`blend` without periodic ends or sides or open ends",
         "there is nothing to join",
         "remove the key",
         needless_blend},
        {{"solid.blend", "channel.length"},
         "a `blend` longer than half of the channel",
         "the two would meet",
         "choose a shorter one",
         long_blend},
        {{"solid.y", "solid.levels", "solid.bottom_width", "solid.bank_height", "solid.diameter"},
         "a cross-section that does not reach from side to side on the bed, by as many `levels` as `y`, or by the widths, heights and slopes of its banks",
         "it stands under all of the channel",
         "correct its corners (y grows from 0 to the width, levels are at least 0, and equal at periodic sides), its banks or the channel's width",
         [](const Case& c, const Solid& solid) {
             const std::string fault = is_section(solid.shape) ? section_fault(c, solid) : std::string();
             return found_if(!fault.empty(), "{}", fault);
         },
         true},
        {{"solid.diameter", "channel.length", "channel.width"},
         "spheres of which a periodic channel does not hold a whole number",
         "their lattice would be stretched by more than a hundredth",
         "choose the length, the width or the diameter so that it does",
         stretched_spheres},
        {{"solid.motion", "solid.shape"},
         "a bed, a section or spheres that move",
         "they lie under all of the channel",
         "set motion = \"fixed\"",
         [](const Case&, const Solid& solid) {
             return found_if(is_bed_shape(solid.shape) && !solid.rests(), "motion is \"{}\"",
                             word(solid.motion));
         }},
        {{"solid.part_of_bed", "solid.motion"},
         "a solid that is `part_of_bed` and moves",
         "the bed stands still",
         "set motion = \"fixed\", or part_of_bed = false",
         [](const Case&, const Solid& solid) {
             return found_if(solid.part_of_bed && !solid.rests(), "motion is \"{}\"", word(solid.motion));
         }},
        {{"solid.part_of_bed", "channel.ends"},
         "a solid that is `part_of_bed` without `channel.ends = \"periodic\"`",
         "only there is the flow the same all along the channel, but for the elements of its bed",
         "set channel.ends = \"periodic\", or part_of_bed = false",
         [](const Case& c, const Solid& solid) {
             return found_if(solid.part_of_bed && c.channel.ends != Ends::periodic, "channel.ends is \"{}\"",
                             word(c.channel.ends));
         }},
    }};
}

}  // namespace riffle::inline case_file
