#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "case/end_buffers.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "case/refusals.hpp"
#include "case/solid_places.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double small = 1e-9;

/// A zone of fewer spacings is none that particles could see.
constexpr double fewest_spacings = 4.0;

/// Height up to which a zone without a top is looked at, m.
double height_of_case(const Case& c) {
    double height = std::max(c.total_depth(), c.channel.wall_height.value_or(0.0));
    for (const double z : c.start.water_z) height = std::max(height, z);
    return height;
}

/// Along x, y and z, within the bounds of the channel where the keys give none.
std::array<PatchRange, 3> extents_of(const Case& c, const Porous& zone) {
    const auto [along, across] = ranges_of(c, zone);
    if (is_seen_from_the_side(zone)) {
        const Extent x(zone.x);
        const Extent z(zone.z);
        return {{{x.low, x.high}, across, {z.low, z.high}}};
    }
    const double bottom = zone.z_from.value_or(0.0);
    const double top = zone.top_z.empty() ? zone.z_to.value_or(std::max(height_of_case(c), bottom))
                                          : Extent(zone.top_z).high;
    return {{along, across, {bottom, top}}};
}

/// The condition of a row for a fault of the outline of a zone, seen from the side or in plan.
CheckCondition has_fault(OutlineFault fault) {
    return [fault](const Case&, const Porous& zone) {
        if (!zone.y.empty()) return outline_findings({zone.x, zone.y}, fault, "", "y");
        const bool outlined = !zone.x.empty() || !zone.z.empty();
        return outlined ? outline_findings({zone.x, zone.z}, fault) : Findings{};
    };
}

/// Heights that are no line of places one after the other.
Findings broken_top(const Case& /*c*/, const Porous& zone) {
    if (zone.top_x.size() != zone.top_z.size() || zone.top_x.size() == 1) {
        return found_if(true, "{} values of top_x and {} of top_z", zone.top_x.size(), zone.top_z.size());
    }
    const auto back = std::adjacent_find(zone.top_x.begin(), zone.top_x.end(), std::greater_equal<>());
    return found_if(back != zone.top_x.end(), "top_x goes from {} to {}",
                    back != zone.top_x.end() ? shown_length(*back) : "",
                    back != zone.top_x.end() ? shown_length(*(back + 1)) : "");
}

/// More than one way of saying where a zone is.
Findings two_shapes(const Case& /*c*/, const Porous& zone) {
    const bool upright = zone.z_from || zone.z_to || !zone.top_x.empty() || !zone.top_z.empty();
    const bool along = zone.x_from || zone.x_to;
    const bool across = zone.y_from || zone.y_to;
    const auto beside = [](std::string_view what, std::string_view other) {
        return found_if(true, "{} stands beside {}", what, other);
    };
    if (!zone.y.empty() && !zone.z.empty()) return beside("an outline in plan", "one seen from the side");
    if (!zone.y.empty() && (along || across)) return beside("an outline in plan", "bounds of a box");
    if (!zone.z.empty() && (along || upright)) return beside("an outline", "bounds of a box or heights");
    return found_if((!zone.top_x.empty() || !zone.top_z.empty()) && zone.z_to,
                    "top_x and top_z stand beside z_to");
}

Findings beyond_channel(const Case& c, const Porous& zone) {
    const auto ranges = extents_of(c, zone);
    constexpr std::array axes{"x", "y", "z"};
    constexpr std::array keys{"porous.x_to", "porous.y_to", "porous.z_to"};
    const double infinite = std::numeric_limits<double>::infinity();
    const std::array extent{c.channel.length, c.channel.simulated_width(), infinite};
    // A zone without a top is as high as what may come; one that begins higher than water gets is a slip.
    const double highest =
        c.channel.top == Top::free_surface ? std::max(wave_height(c), height_of_case(c)) : c.total_depth();
    if (ranges[2].from >= highest) {
        return {{.detail = fmt::format("begins at z = {}: expected a place where water comes, below {}",
                                       shown_length(ranges[2].from), shown_length(highest)),
                 .key = "porous.z_from"}};
    }
    for (std::size_t k = 0; k < axes.size(); ++k) {
        if (k == 1 && !in_space(c)) continue;
        if (ranges[k].to > extent[k] * (1 + small) || ranges[k].from < -small * c.channel.length ||
            ranges[k].from >= ranges[k].to) {
            return {{.detail = fmt::format("reaches from {} = {} to {}: expected a stretch {}", axes[k],
                                           shown_length(ranges[k].from), shown_length(ranges[k].to),
                                           k == 2 ? std::string("above 0")
                                                  : fmt::format("between 0 and {}", shown_length(extent[k]))),
                     .key = keys[k]}};
        }
    }
    return {};
}

double thinnest(const Case& c, const Porous& zone) {
    const auto [along, across, upright] = extents_of(c, zone);
    const double beside = in_space(c) ? std::min(along.size(), across.size()) : along.size();
    return std::min(is_outlined(zone) ? least_extent(c, zone) : beside, upright.size());
}

/// A place, of places on a lattice over a zone, that lies in something else as well; for messages.
std::string shared_place(const Case& c, const Porous& zone,
                         const std::function<bool(double, double, double)>& elsewhere) {
    const PorousZone own(c, zone);
    const auto ranges = extents_of(c, zone);
    // As near to each other as the particles, but no more than some ten thousands.
    const double most = in_space(c) ? 24.0 : 160.0;
    const auto steps = [&](std::size_t axis) {
        return static_cast<int>(std::clamp(ranges[axis].size() / c.numerics.spacing, 1.0, most));
    };
    const int files = in_space(c) ? steps(1) : 1;
    for (int i = 0; i < steps(0); ++i) {
        for (int j = 0; j < files; ++j) {
            for (int k = 0; k < steps(2); ++k) {
                const auto at = [&](std::size_t axis, int number, int of) {
                    return ranges[axis].from + (number + 0.5) / of * ranges[axis].size();
                };
                const double x = at(0, i, steps(0));
                const double y = in_space(c) ? at(1, j, files) : 0.0;
                const double z = at(2, k, steps(2));
                if (own.holds(x, y, z) && elsewhere(x, y, z)) {
                    return fmt::format("at x = {}, {}z = {}", shown_length(x),
                                       in_space(c) ? fmt::format("y = {}, ", shown_length(y)) : "",
                                       shown_length(z));
                }
            }
        }
    }
    return "";
}

/// Whether two zones with level tops lie in each other: exact where places on a lattice may miss it.
bool lie_in_each_other(const Case& c, const Porous& zone, const Porous& other) {
    for (const Porous* one : {&zone, &other}) {
        if (is_seen_from_the_side(*one) || !one->top_z.empty()) return false;
    }
    return extents_of(c, zone)[2].overlap(extents_of(c, other)[2]) > small * c.channel.length &&
           lie_over_each_other(c, zone, other);
}

/// With a zone before it in the file.
Findings in_another_zone(const Case& c, const Porous& zone) {
    for (const Porous* other = c.porous.data(); other != &zone; ++other) {
        if (lie_in_each_other(c, zone, *other)) {
            return found_if(true, "a part of it lies in \"{}\" too", other->name);
        }
        const PorousZone there(c, *other);
        const std::string place =
            shared_place(c, zone, [&](double x, double y, double z) { return there.holds(x, y, z); });
        if (!place.empty()) {
            return found_if(true, "{} it lies in \"{}\" too", place, other->name);
        }
    }
    return {};
}

Findings in_a_solid(const Case& c, const Porous& zone) {
    const SolidPlaces solids(c);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const std::string place = shared_place(c, zone, [&](double x, double y, double z) {
            return solids.holds(k, {x, y, z});
        });
        if (!place.empty()) {
            return found_if(true, "{} it lies in the solid \"{}\"", place, c.solids[k].name);
        }
    }
    return {};
}

/// Beside open ends particles are made and moved by the ends.
Findings at_open_end(const Case& c, const Porous& zone) {
    if (c.channel.ends != Ends::open) {
        return {};
    }
    const double clear = watched_stretch(c) + porous_edge(c, zone);
    const PatchRange along = extents_of(c, zone)[0];
    return found_if(along.from < clear * (1 - small) || along.to > c.channel.length - clear * (1 - small),
                    "reaches from x = {} to {}: expected from {} to {} at most", shown_length(along.from),
                    shown_length(along.to), shown_length(clear), shown_length(c.channel.length - clear));
}

/// Row of a check of the keys of how much a medium resists.
CaseCheck medium_row(std::vector<std::string> keys, std::string_view what, std::string_view why,
                     std::string_view cure, CheckCondition condition) {
    return {std::move(keys), what, why, cure, std::move(condition)};
}

}  // namespace

CheckList porous_refusals() {
    return {
        {
            {{"porous.name", "channel.top"},
             "a `[[porous]]` with `channel.top = \"periodic\"`",
             "a box that repeats over its height has no bed from which the heights of a zone are counted",
             R"(set [channel] top = "free-surface" or "wall", or remove the zone)",
             [](const Case& c) { return c.channel.top == Top::periodic; },
             true},
            {{"porous.name", "channel.lid_velocity"},
             "`[[porous]]` below a lid that moves",
             "what touches the lid would be the grains as well, which stand still",
             "set lid_velocity = 0, or leave the zone out",
             [](const Case& c) { return c.channel.lid_velocity != 0.0; }},
            {{"porous.name", "vegetation.name"},
             "`[[porous]]` and `[[vegetation]]` in one case",
             "the mixing lengths of pores and canopies know nothing of each other",
             "leave one of the two out",
             [](const Case& c) { return !c.vegetation.empty(); }},
            {{"porous.name", "numerics.pressure_form"},
             "`[[porous]]` with another `pressure_form` than `corrected`",
             "the room that the grains take up stands in the volumes that this form weighs by",
             R"(set [numerics] pressure_form = "corrected")",
             [](const Case& c) { return c.numerics.pressure_form != PressureForm::corrected; }},
            {{"porous.name", "numerics.stepping"},
             "`[[porous]]` with a `stepping` of several evaluations",
             "the resistance is implicit in a step of one evaluation",
             R"(set [numerics] stepping = "leapfrog" or "semi-implicit-euler")",
             [](const Case& c) {
                 return c.numerics.stepping != Stepping::leapfrog &&
                        c.numerics.stepping != Stepping::semi_implicit_euler;
             }},
            {{"porous.name", "numerics.wall"},
             "`[[porous]]` with another `wall` than `dummy`",
             "other walls take their density from sums that do not know the grains",
             R"(set [numerics] wall = "dummy")",
             [](const Case& c) { return c.numerics.wall != WallKind::dummy; }},
            {{"porous.name", "numerics.viscosity"},
             "`[[porous]]` with another `viscosity` than `morris`",
             "the shear stress of a medium is that of the discharge of an area",
             R"(set [numerics] viscosity = "morris")",
             [](const Case& c) { return c.numerics.viscosity != ViscosityForm::morris; }},
            {{"porous.name", "numerics.eddy_stress"},
             "`[[porous]]` with `eddy_stress = \"stress-divergence\"` and a closure",
             "the eddy stress stands with the pressure there, which acts on the pores alone",
             R"(set [numerics] eddy_stress = "two-point")",
             [](const Case& c) {
                 return has_closure(c) && c.numerics.eddy_stress == EddyStress::stress_divergence;
             }},
            {{"porous.name", "numerics.xsph"},
             "`[[porous]]` with `xsph`",
             "it would move particles with the mean of discharges",
             "set [numerics] xsph = 0",
             [](const Case& c) { return c.numerics.xsph > 0.0; }},
            {{"porous.name", "numerics.density_filter"},
             "`[[porous]]` with a `density_filter`",
             "it makes the density of masses, which do not fill the room between grains",
             R"(set [numerics] density_filter = "none")",
             [](const Case& c) { return c.numerics.density_filter != DensityFilter::none; }},
            {{"porous.name"},
             "an empty `name`",
             "messages name the zone",
             "give one",
             [](const Case&, const Porous& zone) { return found_if(zone.name.empty(), "name is empty"); }},
            {{"porous.name"},
             "the `name` of another porous zone",
             "each needs its own",
             "choose another one",
             [](const Case& c, const Porous& zone) {
                 return found_if(repeats_a_name(c.porous, zone), "another zone has this name already");
             }},
            medium_row({"porous.grain_size", "porous.permeability", "porous.name"},
                       "both `grain_size` and `permeability`, or neither",
                       "the one follows from the other, and without both nothing says how the medium resists",
                       "give one of the two",
                       [](const Case&, const Porous& zone) {
                           const bool both = zone.grain_size && zone.permeability;
                           return found_if(zone.grain_size.has_value() == zone.permeability.has_value(), "{}",
                                           both ? "grain_size and permeability are both given"
                                                : "neither grain_size nor permeability is given");
                       }),
            medium_row({"porous.forchheimer", "porous.grain_size"}, "`forchheimer` with `grain_size`",
                       "the quadratic resistance of grains is that of inertial_coefficient",
                       "give a permeability, or inertial_coefficient",
                       [](const Case&, const Porous& zone) {
                           return found_if(zone.forchheimer > 0.0 && zone.grain_size, "forchheimer is {:g}",
                                           zone.forchheimer);
                       }),
            medium_row({"porous.laminar_coefficient", "porous.inertial_coefficient", "porous.permeability"},
                       "`laminar_coefficient` or `inertial_coefficient` with `permeability`",
                       "they belong to the law of the grain size",
                       "give grain_size, or forchheimer in place of them",
                       [](const Case&, const Porous& zone) {
                           const Porous usual;
                           return found_if(zone.permeability && !zone.grain_size &&
                                               (zone.laminar_coefficient != usual.laminar_coefficient ||
                                                zone.inertial_coefficient != usual.inertial_coefficient),
                                           "the coefficients are {:g} and {:g}", zone.laminar_coefficient,
                                           zone.inertial_coefficient);
                       }),
            {{"porous.x", "porous.top_x", "porous.z_to", "porous.name"},
             "an outline beside bounds of a box or heights of a top that it gives itself, outlines in plan and seen from "
             "the side, or heights of a top beside `z_to`",
             "each says by itself where the zone is",
             "keep one of them",
             two_shapes,
             true},
            outline_row(OutlineFault::uneven, {"porous.x", "porous.y", "porous.z"},
                        "not as many values of `x` as of `z` or `y`", has_fault(OutlineFault::uneven)),
            outline_row(OutlineFault::few, {"porous.x", "porous.y", "porous.z"},
                        "an outline of fewer than three corners", has_fault(OutlineFault::few)),
            outline_row(OutlineFault::crossing, {"porous.x", "porous.y", "porous.z"},
                        "an outline that crosses or touches itself", has_fault(OutlineFault::crossing)),
            {{"porous.top_x", "porous.top_z"},
             "`top_x`, `top_z` of one place, of different lengths or not in order",
             "the top runs straight from place to place",
             "give at least two places, one after the other, and a height for each",
             broken_top,
             true},
            {{"porous.x_from", "porous.x_to", "porous.y_from", "porous.y_to", "porous.z_from", "porous.z_to",
              "porous.x", "porous.top_z", "porous.name"},
             "a zone that begins or ends outside of the channel, or ends before it begins",
             "",
             "correct the bounds; without the keys the zone covers the whole channel",
             beyond_channel,
             true},
            {{"porous.z_to", "porous.x_to", "porous.y_to", "porous.name", "numerics.spacing"},
             "a zone thinner than four spacings of the particles",
             "no particle would feel the whole of it",
             "make the spacing smaller or the zone larger",
             [](const Case& c, const Porous& zone) {
                 const double least = thinnest(c, zone);
                 return found_if(least < fewest_spacings * c.numerics.spacing * (1 - small),
                                 "is {} in one direction, and the particles stand {} apart",
                                 shown_length(least), shown_length(c.numerics.spacing));
             }},
            {{"porous.grain_size", "porous.name"},
             "grains coarser than the zone",
             "the law of a medium is that of many grains; of single ones the water sees the shape",
             "correct the size, or give the grains as [[solid]]",
             [](const Case& c, const Porous& zone) {
                 const double grain = zone.grain_size.value_or(0.0);
                 const double least = thinnest(c, zone);
                 return found_if(grain > least, "the grains have {}, and the zone {} in one direction",
                                 shown_length(grain), shown_length(least));
             }},
            {{"porous.x_from", "porous.x_to", "porous.x", "porous.name", "channel.ends"},
             "a zone beside an open end",
             "the water there is moved by what the end gives",
             "let it begin and end within these bounds, or close the ends",
             at_open_end},
            {{"porous.name", "solid.name"},
             "a zone that lies in a solid",
             "a solid has no pores that water could fill",
             "let them touch, but not lie in each other",
             in_a_solid},
            {{"porous.name"},
             "a zone that lies in another one",
             "a place has one porosity",
             "give zones beside each other",
             in_another_zone},
        },
        [](const Case& c) { return !c.porous.empty(); }};
}

}  // namespace riffle::inline case_file
