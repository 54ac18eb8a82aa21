#include <algorithm>
#include <optional>

#include "case/gauge_face.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// Points of a grid at most: more than any display or disk makes sense of, and far below what memory holds.
constexpr double most_points = 1e6;

bool is_grid(const Probe& p) { return p.kind == ProbeKind::grid; }
bool has_heights(const Probe& p) { return p.kind == ProbeKind::velocity || p.kind == ProbeKind::pressure; }
bool has_positions(const Probe& p) {
    return has_heights(p) || p.kind == ProbeKind::wave || p.kind == ProbeKind::flow_rate;
}
bool has_spacing(const Probe& p) { return is_grid(p) || p.kind == ProbeKind::surface_line; }
/// Whether its x, y and z say which points it has.
bool has_as_many_points(const Probe& p) {
    const std::size_t n = std::max(p.x.size(), p.z.size());
    const auto fits = [n](const std::vector<double>& values) {
        return values.size() == 1 || values.size() == n;
    };
    return !p.x.empty() && !p.z.empty() && fits(p.x) && fits(p.z) && (p.y.empty() || fits(p.y));
}
std::string place_text(const Case& c, const Point3& place) {
    return in_space(c) ? fmt::format("x = {}, y = {}, z = {}", shown_length(place[0]), shown_length(place[1]),
                                     shown_length(place[2]))
                       : fmt::format("x = {}, z = {}", shown_length(place[0]), shown_length(place[2]));
}
bool sees_surface(const Probe& p) { return p.kind == ProbeKind::wave || p.kind == ProbeKind::surface_line; }

std::string kind_text(const Probe& p) { return fmt::format("kind = \"{}\"", word(p.kind)); }

bool is_group_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    });
}

Findings outside_along(const Case& c, const Probe& p) {
    Findings found;
    for (const double x : p.x) {
        if (has_positions(p) && (x < 0.0 || x > c.channel.length)) {
            found.push_back(
                {.detail = fmt::format("x = {} is outside of the channel: expected 0 to its length {}",
                                       shown_length(x), shown_length(c.channel.length))});
        }
    }
    return found;
}

Findings outside_across(const Case& c, const Probe& p) {
    Findings found;
    for (const double y : p.y) {
        if (in_space(c) && (y < 0.0 || y > c.channel.simulated_width())) {
            found.push_back(
                {.detail = fmt::format("y = {} is outside of the simulated channel: expected 0 to {}",
                                       shown_length(y), shown_length(c.channel.simulated_width()))});
        }
    }
    return found;
}

Findings outside_of_water(const Case& c, const Probe& p) {
    const bool gauge = p.kind == ProbeKind::pressure;  // which may sit on the bed
    Findings found;
    for (const double z : p.z) {
        if (has_heights(p) && (z < 0.0 || (z == 0.0 && !gauge) || z > highest_water(c))) {
            found.push_back(
                {.detail = fmt::format(
                     "z = {} is outside of the water: expected {} (the bed level) and at most {}",
                     shown_length(z), gauge ? "at least 0" : "more than 0", shown_length(highest_water(c)))});
        }
    }
    return found;
}

Findings near_end_walls(const Case& c, const Probe& p) {
    Findings found;
    for (const double x : p.x) {
        if (p.kind == ProbeKind::flow_rate && c.channel.ends == Ends::walls &&
            (x < kernel_support(c) || x > c.channel.length - kernel_support(c))) {
            found.push_back({.detail = fmt::format("x = {} is less than 2 h = {} from an end wall",
                                                   shown_length(x), shown_length(kernel_support(c)))});
        }
    }
    return found;
}

Findings uneven_across(const Case& c, const Probe& p) {
    const std::size_t points = std::max(p.x.size(), has_heights(p) ? p.z.size() : 1);
    return found_if(in_space(c) && p.y.size() > 1 && p.y.size() != points,
                    "y has {} positions: expected one, or {} as there are points", p.y.size(), points);
}

/// Where the columns and rows of a grid begin and end, m.
struct Grid {
    double step;
    double width;
    double height;

    Grid(const Case& c, const Probe& p)
        : step(p.spacing.value_or(2.0 * c.numerics.spacing)),
          width(p.x_to.value_or(c.channel.length) - p.x_from.value_or(0.0)),
          height(p.z_to.value_or(c.total_depth()) - p.z_from.value_or(0.5 * step)) {}

    [[nodiscard]] double points() const { return (width / step + 1.0) * (height / step + 1.0); }
};

Findings edges_outside(const Case& c, const Probe& p) {
    struct Edge {
        const char* name;
        const std::optional<double>& value;
        double most;
    };
    Findings found;
    for (const Edge& edge :
         {Edge{"x_from", p.x_from, c.channel.length}, Edge{"x_to", p.x_to, c.channel.length},
          Edge{"z_from", p.z_from, highest_water(c)}, Edge{"z_to", p.z_to, highest_water(c)}}) {
        if (is_grid(p) && edge.value && (*edge.value < 0.0 || *edge.value > edge.most)) {
            found.push_back(
                {.detail = fmt::format("{} = {} is outside of the water: expected 0 to {}", edge.name,
                                       shown_length(*edge.value), shown_length(edge.most)),
                 .key = fmt::format("probe.{}", edge.name)});
        }
    }
    return found;
}

Findings too_fine(const Case& c, const Probe& p) {
    const double finest = 0.5 * c.numerics.spacing;
    const double spacing = p.spacing.value_or(finest);
    return found_if(has_spacing(p) && spacing < finest,
                    "spacing is {}, too fine between particles {} apart (expected {} or more)",
                    shown_length(spacing), shown_length(c.numerics.spacing), shown_length(finest));
}

bool has_surface_place(const Case& c, const Probe& p) { return !p.solid.empty() && solid_named(c, p.solid); }

/// Gauges farther than a spacing from the surface of their solid.
Findings beside_their_solid(const Case& c, const Probe& p) {
    Findings found;
    if (!has_surface_place(c, p) || !has_as_many_points(p)) return found;
    for (const Point3& point : probe_points(c, p)) {
        const auto near = nearest_on_solid(c, c.solids[*solid_named(c, p.solid)], point);
        if (near && near->distance > c.numerics.spacing) {
            found.push_back({.detail = fmt::format(
                                 "x = {}, z = {} is {} from the surface of solid \"{}\": expected at most "
                                 "a spacing, {}; the nearest place is {}",
                                 shown_length(point[0]), shown_length(point[2]), shown_length(near->distance),
                                 p.solid, shown_length(c.numerics.spacing), place_text(c, near->place))});
        }
    }
    return found;
}

/// Gauges with a face that lie on no wall.
Findings faces_in_the_water(const Case& c, const Probe& p) {
    Findings found;
    if (p.kind != ProbeKind::pressure || p.diameter == 0.0 || !p.solid.empty() || !has_as_many_points(p)) {
        return found;
    }
    for (const Point3& point : probe_points(c, p)) {
        if (!place_on_walls(c, point)) {
            found.push_back({.detail = fmt::format("{} lies on no wall", place_text(c, point))});
        }
    }
    return found;
}

/// Across so many spacings a face may reach at most: it is read at two points a spacing.
constexpr double widest_face = 100.0;

Findings faces_too_wide(const Case& c, const Probe& p) {
    return found_if(p.kind == ProbeKind::pressure && p.diameter > widest_face * c.numerics.spacing,
                    "diameter is {}: expected at most {}", shown_length(p.diameter),
                    shown_length(widest_face * c.numerics.spacing));
}

/// Faces of which a part reaches beyond the channel, or beside the solid that they sit on.
Findings faces_beyond(const Case& c, const Probe& p) {
    Findings found;
    if (p.kind != ProbeKind::pressure || p.diameter == 0.0 || !has_as_many_points(p) ||
        (!p.solid.empty() && !has_surface_place(c, p)) || !faces_too_wide(c, p).empty()) {
        return found;
    }
    const auto beyond = [](double place, double extent) { return place < -1e-9 || place > extent + 1e-9; };
    const Solid* const solid = p.solid.empty() ? nullptr : &c.solids[*solid_named(c, p.solid)];
    const auto outside = [&](const Point3& place) {
        const bool side_walls = in_space(c) && c.channel.sides != Sides::periodic;
        return place[2] < -1e-9 || (c.channel.top == Top::wall && beyond(place[2], c.total_depth())) ||
               (c.channel.ends != Ends::periodic && beyond(place[0], c.channel.length)) ||
               // Behind a plane of symmetry the water is its mirror image.
               (side_walls && (place[1] < -1e-9 || (c.channel.sides == Sides::walls &&
                                                    beyond(place[1], c.channel.simulated_width())))) ||
               (solid != nullptr && nearest_on_solid(c, *solid, place)->distance > c.numerics.spacing);
    };
    for (const Point3& point : probe_points(c, p)) {
        const auto face = gauge_face(c, p, point);
        if (face && std::any_of(face->points.begin(), face->points.end(), outside)) {
            found.push_back(
                {.detail = fmt::format("the face of {} around {} reaches beyond a wall, or stands "
                                       "off its solid by more than a spacing",
                                       shown_length(p.diameter), place_text(c, face->middle))});
        }
    }
    return found;
}

}  // namespace

CheckList probe_refusals() {
    return {{
        {{"probe.name"},
         "a `name` of other than letters a-z, A-Z, digits, _ and -",
         "it names a group in the results",
         "choose such a name",
         [](const Case&, const Probe& p) {
             return found_if(!is_group_name(p.name), "name: expected letters a-z, A-Z, digits, _ and -");
         }},
        {{"probe.name"},
         "a `name` that begins with `standard_`",
         "such names are those of the instruments that record without asking",
         "choose another name (output.standard_probes = false switches those off)",
         [](const Case&, const Probe& p) { return p.name.rfind(standard_probe_prefix, 0) == 0; }},
        {{"probe.name"},
         "the `name` of another probe",
         "each needs its own",
         "choose another one",
         [](const Case& c, const Probe& p) {
             return found_if(is_group_name(p.name) && repeats_a_name(c.probes, p),
                             "name = \"{}\" is that of another probe already", p.name);
         }},
        {{"probe.start"},
         "`start` at the end of the run or later",
         "it would record nothing",
         "make it smaller",
         [](const Case& c, const Probe& p) {
             return found_if(p.start >= c.run.time,
                             "start is {:.6g} s, not before the end of the run at {:.6g} s", p.start,
                             c.run.time);
         }},
        {{"probe.kind"},
         R"(`kind = "wave"` or `"surface_line"` without a free surface)",
         "the water of this case has no free surface",
         "choose another kind",
         [](const Case& c, const Probe& p) { return sees_surface(p) && !has_free_surface(c); }},
        {{"probe.x"},
         R"(`x` missing with `kind = "velocity"`, `"wave"`, `"flow_rate"` or `"pressure"`)",
         "such a probe needs at least one position",
         "give one, for example x = \"100 mm\"",
         [](const Case&, const Probe& p) {
             return found_if(has_positions(p) && p.x.empty(), "x is missing with {}", kind_text(p));
         }},
        {{"probe.x"}, "`x` outside of the channel", "", "move it", outside_along},
        {{"probe.y", "channel.dimensions"},
         "`y` in two dimensions",
         "positions across the channel go with [channel] dimensions = 3",
         "remove the key",
         [](const Case& c, const Probe& p) { return !p.y.empty() && !in_space(c); }},
        {{"probe.y"}, "several `y`, not as many as points", "", "give one, or as many", uneven_across},
        {{"probe.y"}, "`y` outside of the simulated width", "", "move it", outside_across},
        {{"probe.z"},
         R"(`z` missing with `kind = "velocity"` or `"pressure"`)",
         "such a probe needs at least one height above the bed level",
         "give one, for example z = \"20 mm\"",
         [](const Case&, const Probe& p) {
             return found_if(has_heights(p) && p.z.empty(), "z is missing with {}", kind_text(p));
         }},
        {{"probe.z"},
         "`z` below the bed level, or above the total depth; under a free surface above what its water may reach: one and a half times that, the walls, the water of the start, the levels at its ends with waves",
         "",
         "move it",
         outside_of_water},
        {{"probe.z", "probe.x"},
         "several `x` and several `z`, not as many of both",
         "they are taken as pairs",
         "give one of either, or as many of both",
         [](const Case&, const Probe& p) {
             return found_if(has_heights(p) && p.x.size() > 1 && p.z.size() > 1 && p.x.size() != p.z.size(),
                             "{} values of x and {} of z", p.x.size(), p.z.size());
         }},
        {{"probe.solid"},
         "a `solid` that no [[solid]] has the name of",
         "gauges move with the solid that they sit on",
         "correct the name, or remove the key for gauges that stand still",
         [](const Case& c, const Probe& p) {
             return found_if(!p.solid.empty() && !solid_named(c, p.solid), "no [[solid]] has the name \"{}\"",
                             p.solid);
         }},
        {{"probe.x", "probe.z", "probe.solid"},
         "a point of a gauge on a solid more than a spacing from its surface",
         "it would sit somewhere else than it was meant to",
         "move it to the surface",
         beside_their_solid},
        {{"probe.diameter"},
         "a `diameter` of a gauge on no wall or solid",
         "a face needs a wall or a solid to lie in",
         "move it onto the bed, an end wall or a side wall, name its solid, or remove the diameter",
         faces_in_the_water},
        {{"probe.diameter", "numerics.spacing"},
         "a `diameter` of more than a hundred spacings",
         "it is read at two points a spacing, and no transducer is as wide",
         "make it smaller, or take several gauges",
         faces_too_wide},
        {{"probe.diameter"},
         "a face of a gauge that reaches beyond a wall of the channel, or beside its solid",
         "a part of it would be no part of that surface",
         "move it or make it smaller",
         faces_beyond},
        {{"probe.sampling_length"},
         "`sampling_length` above the total depth",
         "no water is as high",
         "make it smaller",
         [](const Case& c, const Probe& p) {
             return found_if(has_heights(p) && p.sampling_length > c.total_depth(),
                             "sampling_length is {}, more than the total depth {}",
                             shown_length(p.sampling_length), shown_length(c.total_depth()));
         }},
        {{"probe.spacing", "numerics.spacing"},
         "`spacing` below half of `numerics.spacing`",
         "they carry nothing finer than half of that",
         "make it larger",
         too_fine},
        {{"probe.spacing", "channel.length"},
         "`spacing` above the length of the channel",
         "there would be one point",
         "make it smaller",
         [](const Case& c, const Probe& p) {
             const double spacing = p.spacing.value_or(0.0);
             return found_if(has_spacing(p) && spacing > c.channel.length,
                             "spacing is {}, the channel {} long", shown_length(spacing),
                             shown_length(c.channel.length));
         }},
        {{"probe.x_from", "probe.x_to", "probe.z_from", "probe.z_to"},
         "an edge of a grid outside of the water",
         "",
         "move it",
         edges_outside},
        {{"probe.x_to", "probe.x_from"},
         "`x_to` below `x_from`",
         "",
         "exchange them",
         [](const Case& c, const Probe& p) {
             return found_if(is_grid(p) && Grid(c, p).width < 0.0, "x_to lies before x_from");
         }},
        {{"probe.z_to", "probe.z_from"},
         "`z_to` below `z_from`",
         "",
         "exchange them",
         [](const Case& c, const Probe& p) {
             return found_if(is_grid(p) && Grid(c, p).height < 0.0, "z_to lies below z_from");
         }},
        {{"probe.spacing"},
         "a grid of more than 1 000 000 points",
         "no display or disk makes sense of more",
         "make its spacing larger",
         [](const Case& c, const Probe& p) {
             return found_if(is_grid(p) && Grid(c, p).points() > most_points,
                             "the grid has {:.3g} points, too fine: expected at most {:.0g}",
                             Grid(c, p).points(), most_points);
         }},
        {{"probe.averaging_time", "probe.sampling_frequency"},
         "`averaging_time` shorter than two samples",
         "a window needs two samples for its second moments",
         "make it longer",
         [](const Case&, const Probe& p) {
             return found_if(is_grid(p) && p.averaging_time > 0.0 &&
                                 p.averaging_time * p.sampling_frequency < 2.0 * (1.0 - 1e-9),
                             "averaging_time is {:.6g} s, less than two samples at {:.6g} Hz",
                             p.averaging_time, p.sampling_frequency);
         }},
        {{"probe.averaging_time", "probe.start"},
         "`averaging_time` longer than the run after `start`",
         "no window would end before the run does",
         "make it shorter",
         [](const Case& c, const Probe& p) {
             return found_if(is_grid(p) && p.averaging_time > 0.0 &&
                                 p.start + p.averaging_time > c.run.time * (1.0 + 1e-9),
                             "averaging_time is {:.6g} s from {:.6g} s on, the run ends at {:.6g} s",
                             p.averaging_time, p.start, c.run.time);
         }},
        {{"probe.x", "channel.ends"},
         "`x` of a flow rate less than one kernel support of 2 h from an end wall",
         "the kernel of a section must lie in the water",
         "move it",
         near_end_walls},
    }};
}

}  // namespace riffle::inline case_file
