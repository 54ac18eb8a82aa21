#include <algorithm>
#include <optional>

#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

/// Points of a grid at most: more than any display or disk makes sense of, and far below what memory holds.
constexpr double most_points = 1e6;

bool is_grid(const Probe& p) { return p.kind == ProbeKind::grid; }
bool has_heights(const Probe& p) { return p.kind == ProbeKind::velocity || p.kind == ProbeKind::pressure; }
bool has_positions(const Probe& p) {
    return has_heights(p) || p.kind == ProbeKind::wave || p.kind == ProbeKind::flow_rate;
}
bool has_spacing(const Probe& p) { return is_grid(p) || p.kind == ProbeKind::surface_line; }
bool sees_surface(const Probe& p) { return p.kind == ProbeKind::wave || p.kind == ProbeKind::surface_line; }

std::string kind_text(const Probe& p) { return fmt::format("kind = \"{}\"", word(p.kind)); }

bool is_group_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    });
}

/// Whether a probe before this one has its name.
bool repeats_a_name(const Case& c, const Probe& p) {
    return std::any_of(c.probes.data(), &p, [&](const Probe& other) { return other.name == p.name; });
}

/// Greatest height that an instrument may have: waves may rise above the depth, and a gauge may sit high on a
/// wall.
double highest(const Case& c, const Probe& p) {
    if (!has_free_surface(c)) {
        return c.total_depth();
    }
    return p.kind == ProbeKind::pressure ? std::max(wave_height(c), c.channel.wall_height.value_or(0.0))
                                         : wave_height(c);
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
        if (has_heights(p) && (z < 0.0 || (z == 0.0 && !gauge) || z > highest(c, p))) {
            found.push_back(
                {.detail = fmt::format(
                     "z = {} is outside of the water: expected {} (the bed level) and at most {}",
                     shown_length(z), gauge ? "at least 0" : "more than 0", shown_length(highest(c, p)))});
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
          Edge{"z_from", p.z_from, highest(c, p)}, Edge{"z_to", p.z_to, highest(c, p)}}) {
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
             return found_if(is_group_name(p.name) && repeats_a_name(c, p),
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
         "`z` below the bed level, or above the total depth; under a free surface above one and a half times that, of a pressure probe above the end walls too",
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

}  // namespace riffle
