#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/case.hpp"
#include "cli/case_argument.hpp"
#include "cli/positive_number.hpp"
#include "cli/printed_number.hpp"
#include "cli/section_figure.hpp"
#include "cli/text_output.hpp"
#include "cli/verbs.hpp"
#include "column/section.hpp"

namespace riffle::inline cli {

namespace {

struct SectionArguments {
    CaseArgument argument;
    std::string json;
    std::string csv;
    std::string figure;
    bool force = false;
    std::optional<double> time;
    std::string from = "column";
};

const std::map<std::string, SectionStart> starts{{"column", SectionStart::column},
                                                 {"uniform", SectionStart::uniform},
                                                 {"power-law", SectionStart::power_law},
                                                 {"rest", SectionStart::rest}};

/// A transient beside the steady state.
struct Transient {
    SectionResult after;  ///< the time asked for
    std::vector<SectionMoment> moments;
};

void print_row(const char* name, const char* unit, double value, std::optional<double> reference = {},
               const char* source = "") {
    std::string text = fmt::format("  {:<46} {:>10} ", name, printed_number(value));
    if (reference) {
        const double difference = 100.0 * (value / *reference - 1.0);
        constexpr double shown = 0.05;  // what is less is printed as +0.0
        text += fmt::format("{:>10} {:>+8.1f} %  ", printed_number(*reference),
                            std::abs(difference) < shown ? 0.0 : difference);
    } else {
        text += fmt::format("{:>23}", "");
    }
    text += fmt::format("{:<6} {}", unit, source);
    text.erase(text.find_last_not_of(' ') + 1);
    fmt::print("{}\n", text);
}

void print_steady(const Case& c, const SectionResult& r) {
    const SideWallPartition& p = r.partition;
    const double density = c.fluid.density;
    const bool divided = c.side_walls.drag_form != SideDragForm::none;
    const auto theory = [divided](double value) { return divided ? std::optional(value) : std::nullopt; };
    const char* const source = divided ? "Yang & Lim" : "";
    fmt::print("{}\n", c.title.empty() ? "Cross-section twin of the case" : c.title);
    fmt::print("depth over the datum {} m, total depth {} m, width {} m, slope {}\n\n",
               printed_number(c.channel.depth), printed_number(c.total_depth()),
               printed_number(c.channel.width), printed_number(c.channel.slope));
    fmt::print("  {:<46} {:>10} {:>10} {:>10}\n", "", "section", "reference", "difference");
    print_row("depth mean over the datum at the centreline, U", "m/s", r.centreline_velocity,
              c.measured.depth_mean_velocity, c.measured.depth_mean_velocity ? "measured" : "");
    print_row("mean over the section above the datum", "m/s", r.depth_mean_velocity);
    print_row("bulk velocity over the whole section", "m/s", r.bulk_velocity);
    print_row("largest velocity", "m/s", r.maximum_velocity);
    print_row("discharge of the whole width", "m3/s", r.discharge, c.measured.discharge,
              c.measured.discharge ? "measured" : "");
    if (divided) {
        print_row("mean velocity in the layers of the side walls", "m/s", r.wall_layer_velocity);
        print_row("friction coefficient of these layers", "1/m", r.side_wall_coefficient);
    }
    print_row("weight carried by the bed", "%", 100.0 * r.drag_share, theory(100.0 * p.bed_share), source);
    print_row("weight carried by the side walls", "%", 100.0 * r.side_wall_share,
              theory(100.0 * (1.0 - p.bed_share)), source);
    if (r.vegetation_share > 0.0) {
        print_row("weight carried by the vegetation", "%", 100.0 * r.vegetation_share);
    }
    if (r.porous_share > 0.0) print_row("weight carried by porous zones", "%", 100.0 * r.porous_share);
    print_row("mean stress on the bed", "Pa", r.bed_stress, theory(density * p.bed_stress), source);
    print_row("mean stress on the side walls", "Pa", r.wall_stress, theory(density * p.wall_stress), source);
    print_row("e-folding time of the approach to it", "s", r.relaxation_time);
}

/// The first time from which on a quantity stays within 1 % of its steady value; none within the record.
std::optional<double> approach_time(const std::vector<SectionMoment>& moments,
                                    double SectionMoment::*quantity, double steady) {
    constexpr double near = 0.01;
    std::optional<double> time;
    for (const SectionMoment& m : moments) {
        const bool within = std::abs(m.*quantity - steady) <= near * std::abs(steady);
        if (!within) {
            time.reset();
        } else if (!time) {
            time = m.time;
        }
    }
    return time;
}

struct Watched {
    const char* name;
    const char* key;
    double SectionMoment::*moment;
    double SectionResult::*result;
};
constexpr Watched watched[] = {
    {"depth mean over the datum at the centreline", "centreline_velocity",
     &SectionMoment::centreline_velocity, &SectionResult::centreline_velocity},
    {"mean over the section above the datum", "depth_mean_velocity", &SectionMoment::depth_mean_velocity,
     &SectionResult::depth_mean_velocity},
    {"mean velocity in the layers of the side walls", "wall_layer_velocity",
     &SectionMoment::wall_layer_velocity, &SectionResult::wall_layer_velocity},
};

void print_transient(const SectionArguments& a, const SectionResult& steady, const Transient& t) {
    fmt::print("\n  {:<46} {:>10} {:>10} {:>10}   {}\n", fmt::format("from the start \"{}\"", a.from),
               "steady", fmt::format("{} s", printed_number(*a.time)), "difference", "within 1 % after");
    for (const Watched& w : watched) {
        const double end = steady.*w.result;
        if (!(end > 0.0)) continue;
        const double now = t.after.*w.result;
        const std::optional<double> time = approach_time(t.moments, w.moment, end);
        fmt::print("  {:<46} {:>10} {:>10} {:>+8.1f} %   {}\n", w.name, printed_number(end),
                   printed_number(now), 100.0 * (now / end - 1.0),
                   time ? printed_number(*time) + " s"
                        : "more than " + printed_number(t.moments.back().time) + " s");
    }
}

Transient transient(const SectionArguments& a, const Case& c, const SectionResult& steady) {
    Transient t;
    const auto record = [&t](double offset) {
        return [&t, offset](const SectionMoment& m) {
            t.moments.push_back(m);
            t.moments.back().time += offset;
        };
    };
    t.after = advance_section(c, start_section(c, starts.at(a.from)), *a.time, {}, record(0.0));
    // On to where the slowest mode has faded to far below the 1 % that the times of approach are told for.
    constexpr double folds = 8.0;
    const double rest = folds * steady.relaxation_time - *a.time;
    if (rest > 0.0) static_cast<void>(advance_section(c, t.after, rest, {}, record(*a.time)));
    return t;
}

nlohmann::ordered_json fields(const SectionResult& r) {
    return {{"y", r.y},
            {"z", r.z},
            {"velocity", r.velocity},
            {"mixing_length", r.mixing_length},
            {"shear_stress", r.shear_stress},
            {"lateral_shear_stress", r.lateral_shear_stress}};
}

nlohmann::ordered_json summary(const SectionResult& r) {
    return {{"centreline_velocity", r.centreline_velocity},
            {"depth_mean_velocity", r.depth_mean_velocity},
            {"bulk_velocity", r.bulk_velocity},
            {"maximum_velocity", r.maximum_velocity},
            {"wall_layer_velocity", r.wall_layer_velocity},
            {"discharge", r.discharge},
            {"drag_share", r.drag_share},
            {"side_wall_share", r.side_wall_share},
            {"vegetation_share", r.vegetation_share},
            {"porous_share", r.porous_share},
            {"bed_stress", r.bed_stress},
            {"wall_stress", r.wall_stress},
            {"side_wall_coefficient", r.side_wall_coefficient}};
}

nlohmann::ordered_json to_json(const SectionArguments& a, const Case& c, const SectionResult& r,
                               const std::optional<Transient>& t) {
    using nlohmann::ordered_json;
    ordered_json result = summary(r);
    result["title"] = c.title;
    result["relaxation_time"] = r.relaxation_time;
    result["partition"] = {{"k", r.partition.k},
                           {"bed_share", r.partition.bed_share},
                           {"bed_stress", c.fluid.density * r.partition.bed_stress},
                           {"wall_stress", c.fluid.density * r.partition.wall_stress}};
    result["measured"] = {{"depth_mean_velocity", optional_number(c.measured.depth_mean_velocity)},
                          {"discharge", optional_number(c.measured.discharge)}};
    result["section"] = fields(r);
    if (t) {
        ordered_json& block = result["transient"];
        block = summary(t->after);
        block["from"] = a.from;
        block["time"] = *a.time;
        block["section"] = fields(t->after);
        for (const Watched& w : watched) {
            block["approach_time"][w.key] = optional_number(approach_time(t->moments, w.moment, r.*w.result));
            for (const SectionMoment& m : t->moments) block["series"][w.key].push_back(m.*w.moment);
        }
        for (const SectionMoment& m : t->moments) block["series"]["time"].push_back(m.time);
    }
    return result;
}

std::string to_csv(const SectionResult& r) {
    std::string text = "y [m],z [m],u [m/s],l_x [m],tau_xz [Pa],tau_xy [Pa]\n";
    for (std::size_t iz = 0; iz < r.z.size(); ++iz) {
        for (std::size_t iy = 0; iy < r.y.size(); ++iy) {
            const std::size_t i = iz * r.y.size() + iy;
            text +=
                fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", r.y[iy], r.z[iz], r.velocity[i],
                            r.mixing_length[i], r.shear_stress[i], r.lateral_shear_stress[i]);
        }
    }
    return text;
}

void run_section(const SectionArguments& a) {
    bool to_terminal = true;
    for (const std::string& file : {a.json, a.csv, a.figure}) {
        if (file == "-") to_terminal = false;
    }
    refuse_to_replace_any({a.json, a.csv, a.figure}, a.force);
    const Case c = a.argument.read();
    const SectionResult steady = solve_section(c);
    std::optional<Transient> t;
    if (a.time) t = transient(a, c, steady);
    if (to_terminal) {
        print_steady(c, steady);
        if (t) print_transient(a, steady, *t);
        if (!c.measured.uniform) fmt::print("\nThe measured flow was not uniform; the section is.\n");
    }
    // The figure and the table of values show the state that was asked for.
    const SectionResult& shown = t ? t->after : steady;
    if (!a.json.empty()) write_text(a.json, to_json(a, c, steady, t).dump(1) + "\n");
    if (!a.csv.empty()) write_text(a.csv, to_csv(shown));
    if (!a.figure.empty()) {
        write_text(a.figure, section_figure(c, shown,
                                            t ? fmt::format("after {} s from the start \"{}\"",
                                                            printed_number(*a.time), a.from)
                                              : "steady flow of the cross-section twin"));
    }
}

}  // namespace

void add_verb_section(CLI::App& app) {
    auto* const verb = app.add_subcommand(
        "section", "Solve the flow over the cross-section of a case with side walls, steady or in time");
    const auto a = std::make_shared<SectionArguments>();
    a->argument.add_to(*verb);
    verb->add_option("--json", a->json, "Write everything to this file, SI units; - for the terminal");
    verb->add_option("--csv", a->csv, "Write the values of the cells to this file, SI units; - likewise");
    verb->add_option("--figure", a->figure, "Draw the section in this SVG file");
    verb->add_flag("--force", a->force, "Overwrite existing files");
    auto* const time =
        verb->add_option("--time", a->time, "Show the flow after this time too, s")->check(positive_number());
    verb->add_option("--from", a->from, "What the flow starts from: column, uniform, power-law, rest")
        ->check(CLI::IsMember(starts))
        ->needs(time)
        ->capture_default_str();
    verb->footer(
        "Examples:\n"
        "  riffle section cases/rough-bed-3d/condition-2.toml\n"
        "  riffle section cases/rough-bed-3d/condition-2.toml --figure section.svg\n"
        "  riffle section cases/rough-bed-3d/condition-2.toml --time 6 --from power-law");
    verb->callback([a] { run_section(*a); });
}

}  // namespace riffle::inline cli
