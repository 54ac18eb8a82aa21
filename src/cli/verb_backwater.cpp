#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/bed_patch.hpp"
#include "case/case.hpp"
#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "case/surface_roughness.hpp"
#include "cli/backwater_figure.hpp"
#include "cli/backwater_output.hpp"
#include "cli/case_argument.hpp"
#include "cli/printed_number.hpp"
#include "cli/quantity_argument.hpp"
#include "cli/terminal.hpp"
#include "cli/text_output.hpp"
#include "cli/verbs.hpp"
#include "column/canal_channel.hpp"
#include "column/twin_channel.hpp"
#include "column/twin_reaches.hpp"
#include "ends/end_input.hpp"
#include "hydraulics/varied_flow.hpp"

namespace riffle::inline cli {

namespace {

struct BackwaterArguments {
    CaseArgument argument;
    std::string discharge;
    std::string downstream;
    std::string upstream;
    std::string length;
    std::optional<double> slope;
    std::optional<double> manning;
    std::string equivalent_roughness;
    int stations = 0;
    std::string json;
    std::string csv;
    std::string figure;
    bool force = false;
};

/// How many places a table has where the user does not say: a screen of them, or enough for a plot.
constexpr int stations_on_screen = 13;
constexpr int stations_in_files = 201;

/// How near to the normal depth a channel reaches whose length is not given.
constexpr double approach = 0.01;

/// What Manning's n may be, s/m^(1/3): glass has 0.009, a flood plain of brush 0.15.
constexpr double least_manning = 0.001;
constexpr double most_manning = 1.0;

/// What takes the place of the column twin's friction; at most one of them.
struct GivenFriction {
    std::optional<double> manning;               ///< n, s/m^(1/3)
    std::optional<double> equivalent_roughness;  ///< k_s, m
};

bool is_given(const GivenFriction& friction) { return friction.manning || friction.equivalent_roughness; }

GivenFriction friction_of(const BackwaterArguments& a) {
    GivenFriction friction{a.manning, std::nullopt};
    if (!a.equivalent_roughness.empty()) {
        friction.equivalent_roughness =
            quantity_argument("--equivalent-roughness", a.equivalent_roughness, Dimension::length);
    }
    return friction;
}

/// The cross-section of the channel of a case, where it has one of its own.
std::shared_ptr<const SectionShape> section_shape(const Case& c) {
    const Solid* const section = section_of(c);
    return section != nullptr ? shape_of_section(c, *section) : nullptr;
}

/// Whether that has a friction of its own.
bool is_canal(const Case& c) {
    const Solid* const section = section_of(c);
    return section != nullptr && section->surface == SolidSurface::log_law;
}

/// Unit discharge, as given (m3/s of the whole width, or m2/s) or that of the case's uniform flow.
double unit_discharge(const std::string& given, const GivenFriction& friction, const Case& c) {
    if (!given.empty()) {
        const std::optional<Quantity> quantity = split_quantity(given);
        const bool of_unit_width =
            quantity && dimension_of_unit(quantity->unit) == Dimension::kinematic_viscosity;
        if (!quantity || !(quantity->value > 0.0) ||
            !(of_unit_width || quantity->unit.empty() || to_si(*quantity, Dimension::discharge))) {
            throw InputError(fmt::format(
                "--discharge must be a discharge greater than 0, of the whole width (m3/s, l/s; m3/s where no unit is "
                "given) or of a unit of it (m2/s), but is \"{}\"",
                given));
        }
        return of_unit_width
                   ? quantity_argument("--discharge", given, Dimension::kinematic_viscosity)
                   : quantity_argument("--discharge", given, Dimension::discharge) / c.channel.width;
    }
    if (!(c.channel.slope > 0.0)) {
        throw InputError(
            "the bed of the case does not fall (channel.slope = 0), so that it has no uniform flow whose discharge could "
            "be taken: give --discharge");
    }
    const auto shape = section_shape(c);
    if (friction.manning) {
        return manning_unit_discharge(c.channel.slope, c.channel.depth, *friction.manning, shape.get());
    }
    if (const auto& k = friction.equivalent_roughness; k && shape) {
        Case other = c;
        other.solids[static_cast<std::size_t>(section_of(c) - c.solids.data())].equivalent_roughness = *k;
        return canal_uniform_discharge(other, c.channel.depth);
    }
    if (const auto& k = friction.equivalent_roughness) {
        if (c.channel.depth < *k) {
            throw InputError(fmt::format(
                "the depth of the case, {}, is less than the equivalent roughness: give --discharge, or a smaller "
                "--equivalent-roughness",
                shown_length(c.channel.depth)));
        }
        return rough_unit_discharge(c.channel.slope, c.fluid.gravity, c.channel.depth, *k);
    }
    return uniform_unit_discharge(c);
}

SteadyChannel channel_of(const GivenFriction& friction, const Case& c, double q) {
    const auto shape = section_shape(c);
    if (friction.manning) {
        return manning_channel(c.channel.slope, c.fluid.gravity, q, *friction.manning, shape);
    }
    if (const auto& k = friction.equivalent_roughness; k && shape) {
        return colebrook_channel(c.channel.slope, c.fluid.gravity, q, *k, c.fluid.kinematic_viscosity, shape);
    }
    if (is_canal(c)) {
        if (!has_strips_alone(c, *section_of(c))) {
            throw InputError(
                "a [[surface_patch]] of the canal lies in a part of its length, or has an outline: the friction of one "
                "section all along is not known. Give --manning or --equivalent-roughness, or let the patch reach from "
                "end to end");
        }
        return canal_channel(c, q);
    }
    if (const auto& k = friction.equivalent_roughness) {
        return rough_channel(c.channel.slope, c.fluid.gravity, q, *k);
    }
    if (!channel_or_walls_resist(c)) {
        throw InputError(
            "nothing in the case brakes the flow, so no friction of its bed is known: give --manning or "
            "--equivalent-roughness, or [bed] a kind that resists (\"spheres\", \"roughness\", \"smooth\" or \"no-slip\")");
    }
    return twin_channel(with_bed_at(c, c.channel.length), q);
}

/// The beds one behind the other; one of them where the friction is given.
std::vector<Reach> reaches_of(const GivenFriction& friction, const Case& c, const Backwater& b) {
    return is_given(friction) || is_canal(c) ? std::vector<Reach>{{"", 0.0, b.length, b.channel}}
                                             : twin_reaches(c, b.channel.unit_discharge, b.length);
}

std::string friction_text(const GivenFriction& friction, const Case& c) {
    if (friction.manning) return fmt::format("Manning n {} s/m^(1/3)", printed_number(*friction.manning));
    const auto by_radius = [](double k) {
        return fmt::format("Colebrook and White, k_s {} m, by the hydraulic radius", printed_number(k));
    };
    if (const auto& k = friction.equivalent_roughness) {
        return section_of(c) != nullptr ? by_radius(*k)
                                        : fmt::format("rough log law, k_s {} m", printed_number(*k));
    }
    if (is_canal(c)) {
        const Solid& canal = *section_of(c);
        const std::size_t patches = patches_on(c, canal).size();
        return by_radius(surface_roughness(c, canal)) +
               (patches > 0
                    ? fmt::format(", {} patch{} by the velocities across", patches, patches > 1 ? "es" : "")
                    : "");
    }
    return has_section_reach(c) ? "section twin, between side walls" : "column twin";
}

/// Warns of a depth without a unit that is too large to be meant in metres.
void warn_of_metres(const std::string& option, const std::string& text, double depth, const Case& c) {
    constexpr double depths = 10.0;
    const std::optional<Quantity> quantity = split_quantity(text);
    if (quantity && quantity->unit.empty() && depth > depths * c.channel.depth) {
        print_warning(fmt::format(
            "{} {}: {:.0f} times the depth of the case, {}: is {}mm meant? A number without unit is in metres",
            option, text, depth / c.channel.depth, shown_length(c.channel.depth), text));
    }
}

/// A depth given as a length, or by one of the words for the channel's own depths.
std::optional<double> control(const std::string& option, const std::string& text, const Case& c,
                              const SteadyChannel& channel) {
    if (text.empty()) return std::nullopt;
    if (text == "critical") return critical_depth(channel);
    if (text == "normal") {
        const std::optional<double> depth = normal_depth(channel);
        if (!depth) {
            throw InputError(option + " normal: a bed that does not fall has no normal depth; give a length");
        }
        return depth;
    }
    const double depth = quantity_argument(option, text, Dimension::length);
    warn_of_metres(option, text, depth, c);
    if (depth < channel.least_depth) {
        throw InputError(fmt::format("{} {}: the friction of the bed is known from a depth of {} on", option,
                                     text, shown_length(channel.least_depth)));
    }
    return depth;
}

void choose_length(const BackwaterArguments& a, Backwater& b, ChannelControls& controls) {
    if (!a.length.empty()) {
        controls.length = quantity_argument("--length", a.length, Dimension::length);
        return;
    }
    const std::optional<double> length = approach_length(b.channel, controls, approach);
    if (!length && !(b.channel.slope > 0.0)) {
        throw InputError(
            "a bed that does not fall has no uniform flow that the surface could approach: give --length");
    }
    if (!length) {
        throw InputError(
            "the place of the flow between both ends depends on how far apart they are: give --length");
    }
    constexpr double depths_shown = 100.0;
    controls.length = *length > 0.0 ? *length : depths_shown * *normal_depth(b.channel);
    b.notes.push_back(
        *length > 0.0
            ? fmt::format(
                  "The channel is as long as the depth needs to come within {:.0f} % of the normal depth.",
                  100.0 * approach)
            : fmt::format(
                  "The depth is within {:.0f} % of the normal depth all along; a hundred depths of it are shown.",
                  100.0 * approach));
}

/// What rules the flow of a case with open ends: what it gives, as far as the options do not say otherwise.
ChannelControls controls_between_ends(const BackwaterArguments& a, const Case& c, const EndInput& ends,
                                      Backwater& b) {
    ChannelControls controls = controls_at_ends(c, ends, b.channel);
    // With another discharge, slope or friction the flow has another normal depth than the case.
    const bool is_other = a.slope || !a.discharge.empty() || is_given(friction_of(a));
    if (is_other && c.outflow.kind == OutflowKind::normal_depth && a.downstream.empty()) {
        const std::optional<double> normal = normal_depth(b.channel);
        if (!normal) {
            throw InputError(
                "the outflow of the case holds the normal depth ([outflow] kind), and a bed that does not fall has "
                "none: give --downstream");
        }
        controls.downstream_depth = std::max(critical_depth(b.channel), *normal);
    }
    if (!a.length.empty()) controls.length = quantity_argument("--length", a.length, Dimension::length);
    if (!a.downstream.empty()) {
        controls.downstream_depth = control("--downstream", a.downstream, c, b.channel);
    }
    if (!a.upstream.empty()) {
        controls.upstream_depth = control("--upstream", a.upstream, c, b.channel);
    } else if (controls.upstream_depth && *controls.upstream_depth > critical_depth(b.channel)) {
        controls.upstream_depth.reset();
        b.notes.emplace_back(
            "[inflow] depth is that of slow water, which is ruled from downstream: it takes no part, and the flow of the "
            "case has another discharge where the depth there is another one.");
    }
    if (a.upstream.empty() && a.downstream.empty()) {
        b.notes.emplace_back(
            "What holds the depths at the ends is that of the case, [inflow] and [outflow].");
    } else {
        b.notes.emplace_back(
            "What the options leave open, length and depths at the ends, is that of the case with open ends.");
    }
    return controls;
}

Backwater solve(const BackwaterArguments& a, Case c) {
    if (c.channel.top != Top::free_surface) {
        throw InputError(
            "the case has no free surface (channel.top) that could vary: backwater is for open channels");
    }
    constexpr double steepest = 1.0;  // as in a case
    if (a.slope && !(std::abs(*a.slope) <= steepest)) {
        throw InputError(fmt::format("--slope must be a number from -1 to 1, but is {}", *a.slope));
    }
    Backwater b;
    const GivenFriction friction = friction_of(a);
    b.friction = friction_text(friction, c);
    std::optional<EndInput> ends;
    if (c.channel.ends == Ends::open) ends = read_end_levels(c);
    const bool by_the_case = ends && ends->unit_discharge && a.discharge.empty();
    const double q = by_the_case ? ends->unit_discharge->at(0.0) : unit_discharge(a.discharge, friction, c);
    if (by_the_case && !(q > 0.0)) {
        throw InputError(
            "[inflow] brings nothing at t = 0, and still water has no such flow: give --discharge");
    }
    if (by_the_case) b.notes.emplace_back("The discharge is that of the case, [inflow], at t = 0.");
    if (a.slope) c.channel.slope = *a.slope;
    b.channel = channel_of(friction, c, q);
    b.discharge = q * c.channel.width;
    b.width = c.channel.width;
    ChannelControls controls;
    if (ends) {
        controls = controls_between_ends(a, c, *ends, b);
    } else {
        controls.upstream_depth = control("--upstream", a.upstream, c, b.channel);
        controls.downstream_depth = control("--downstream", a.downstream, c, b.channel);
        if (a.length.empty() && !c.bed_patches.empty() && !is_given(friction)) {
            controls.length = c.channel.length;
            b.notes.emplace_back("The channel is as long as that of the case, along which its bed changes.");
        } else {
            choose_length(a, b, controls);
        }
    }
    b.length = controls.length;
    b.flow = solve_varied_reaches(reaches_of(friction, c, b), controls);
    if (c.solids.size() > (section_of(c) != nullptr ? 1U : 0U)) {
        b.notes.emplace_back(
            "The solids of the case take no part: this is the flow along its bed without them, and what they raise the water "
            "by is what a run has more.");
    }
    if (!c.vegetation.empty() && is_given(friction)) {
        b.notes.emplace_back(
            "The given friction is that of all that holds the water back: the stems of the case take no part.");
    }
    if (!c.porous.empty() && is_given(friction)) {
        b.notes.emplace_back(
            "The given friction is that of all that holds the water back: the porous zones of the case take no part, and "
            "their room counts as water.");
    }
    if (!c.bed_patches.empty() && is_given(friction)) {
        b.notes.emplace_back("The given friction is that of the whole bed: its patches take no part.");
    }
    if (c.has_side_walls() && section_of(c) == nullptr && (is_given(friction) || !has_section_reach(c))) {
        b.notes.emplace_back(
            "The friction of the side walls takes no part: the channel is as good as endlessly wide.");
    }
    return b;
}

void run_backwater(const BackwaterArguments& a) {
    refuse_to_replace_any({a.json, a.csv, a.figure}, a.force);
    const Case c = a.argument.read();
    const Backwater b = solve(a, c);
    const bool to_terminal = a.json != "-" && a.csv != "-" && a.figure != "-";
    if (to_terminal) {
        print_backwater(c, b, backwater_stations(b, a.stations > 0 ? a.stations : stations_on_screen));
    }
    const auto stations = backwater_stations(b, a.stations > 0 ? a.stations : stations_in_files);
    if (!a.json.empty()) write_text(a.json, backwater_json(c, b, stations).dump(1) + "\n");
    if (!a.csv.empty()) write_text(a.csv, backwater_csv(stations));
    if (!a.figure.empty()) {
        write_text(a.figure,
                   backwater_figure(c.title.empty() ? "Steady varied flow" : c.title,
                                    fmt::format("discharge {} m2/s, slope {}, friction: {}",
                                                printed_number(b.channel.unit_discharge),
                                                printed_number(b.channel.slope), b.friction),
                                    b.channel, b.flow,
                                    backwater_stations(b, stations_in_files, Places::dense_at_ends)));
    }
}

}  // namespace

void add_verb_backwater(CLI::App& app) {
    auto* const verb = app.add_subcommand(
        "backwater",
        "Solve the steady gradually varied flow along a channel: surface, energy, hydraulic jump");
    const auto a = std::make_shared<BackwaterArguments>();
    a->argument.add_to(*verb);
    verb->add_option(
        "--discharge", a->discharge,
        "Of the whole width (\"8 l/s\"; m3/s) or of a unit of it (\"0.02 m2/s\"); default: of the "
        "inflow of a case with open ends, else of the uniform flow of the case, at its slope");
    verb->add_option(
        "--downstream", a->downstream,
        "Depth at the downstream end, or: normal, critical; default: by [inflow] and [outflow] of a case with "
        "open ends, else normal, on a steep bed none");
    verb->add_option("--upstream", a->upstream,
                     "Depth at the upstream end where the flow is supercritical there, or: normal, critical");
    verb->add_option(
        "--length", a->length,
        "Of the channel; default: that of a case with open ends, else until the flow is uniform within 1 %");
    verb->add_option("--slope", a->slope, "Of the bed instead of the case's; below 0: adverse");
    auto* const manning = verb->add_option("--manning", a->manning,
                                           "Friction by Manning's n, s/m^(1/3), instead of the column twin")
                              ->check(CLI::Range(least_manning, most_manning));
    verb->add_option("--equivalent-roughness", a->equivalent_roughness,
                     "Friction by k_s and the rough log law instead")
        ->excludes(manning);
    verb->add_option("--stations", a->stations, "Places of the tables; default: 13, in files 201")
        ->check(CLI::Range(2, 1000000));
    verb->add_option("--json", a->json, "Write everything to this file, SI units; - for the terminal");
    verb->add_option("--csv", a->csv, "Write the table to this file, SI units; - likewise");
    verb->add_option("--figure", a->figure, "Draw the long profile in this SVG file");
    verb->add_flag("--force", a->force, "Overwrite existing files");
    verb->footer(
        "Examples:\n"
        "  riffle backwater my-flume.toml --downstream 80mm\n"
        "  riffle backwater my-flume.toml --downstream critical --figure m2.svg\n"
        "  riffle backwater my-flume.toml --discharge 20l/s --upstream 25mm --length 6\n"
        "  riffle backwater my-flume.toml --manning 0.02 --csv - > profile.csv");
    verb->callback([a] { run_backwater(*a); });
}

}  // namespace riffle::inline cli
