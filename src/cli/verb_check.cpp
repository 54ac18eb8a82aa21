#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/wrapped_text.hpp"
#include "case/quiet_water.hpp"
#include "case/units.hpp"
#include "cli/case_argument.hpp"
#include "cli/ends_json.hpp"
#include "cli/run_arguments.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "solver/forecast.hpp"
#include "solver/run.hpp"

namespace riffle::inline cli {

namespace {

struct CheckVerb {
    CaseArgument argument;
    int threads = 0;
    bool json = false;
};

/// Prints a line of a table within the columns of a terminal.
void print_wrapped(const std::string& line, std::size_t indent) {
    fmt::print("{}\n", wrapped_text(line, indent));
}

/// A fact of the case with its label before it.
void print_row(const char* label, const std::string& text) {
    print_wrapped(fmt::format("  {:<22} {}", label, text), 25);
}

/// A table of the instruments with what each costs.
void print_probes(const Forecast& f) {
    if (!f.probes.empty()) {
        double bytes = 0.0;
        double share = 0.0;
        for (const ProbeForecast& p : f.probes) {
            bytes += p.bytes;
            share += p.time_share;
        }
        print_row("probes", fmt::format("{} in all, {:.2g} % of the time (samples of points)",
                                        size_text(bytes), 100.0 * share));
    }
    for (const ProbeForecast& p : f.probes) {
        print_wrapped(
            fmt::format("    {:<20} {:<9} {:>7.4g} Hz {:>8.0f} of {:<5} {:>7} {:>6.2g} %", p.name, p.kind,
                        p.sampling_frequency, p.samples, p.points, size_text(p.bytes), 100.0 * p.time_share),
            6);
    }
    for (const std::string& note : f.probe_notes) print_wrapped("    " + note, 6);
}

void print_bed_patches(const Forecast& f) {
    for (const BedPatchForecast& patch : f.bed_patches) {
        print_row("patch of the bed",
                  fmt::format("{}: {}{}{}", patch.name, patch.kind,
                              patch.equivalent_roughness > 0.0
                                  ? fmt::format(", k_s = {:.4g} mm", 1e3 * patch.equivalent_roughness)
                                  : "",
                              patch.velocity > 0.0
                                  ? fmt::format(", U = {:.4g} m/s of uniform flow over such a bed alone",
                                                patch.velocity)
                                  : ""));
    }
}

nlohmann::ordered_json bed_patches_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const BedPatchForecast& patch : f.bed_patches) {
        list.push_back({{"name", patch.name},
                        {"kind", patch.kind},
                        {"equivalent_roughness", patch.equivalent_roughness},
                        {"velocity", patch.velocity}});
    }
    return list;
}

void print_surface_patches(const Forecast& f) {
    for (const SurfacePatchForecast& patch : f.surface_patches) {
        print_row("patch of a surface", fmt::format("{}: {}, k_s = {:.4g} mm", patch.name, patch.solid,
                                                    1e3 * patch.equivalent_roughness));
    }
}

nlohmann::ordered_json surface_patches_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const SurfacePatchForecast& patch : f.surface_patches) {
        list.push_back({{"name", patch.name},
                        {"solid", patch.solid},
                        {"equivalent_roughness", patch.equivalent_roughness}});
    }
    return list;
}

void print_vegetation(const Forecast& f) {
    for (const VegetationForecast& stems : f.vegetation) {
        print_row("vegetation",
                  fmt::format("{}: a = {:.4g} 1/m, phi = {:.3g}, C_D = {:.3g} at {:.3g} m/s{}", stems.name,
                              stems.frontal_area, stems.solid_fraction, stems.drag_coefficient, stems.speed,
                              stems.displacement > 0.0
                                  ? fmt::format(", displacement height {:.3g} mm", 1e3 * stems.displacement)
                                  : std::string()));
    }
}

void print_canal(const Forecast& f) {
    if (f.canal) {
        print_row("canal",
                  fmt::format("area {:.4g} m2, wetted perimeter {:.4g} m, hydraulic radius {:.4g} mm, "
                              "surface {:.4g} mm wide",
                              f.canal->wet.area, f.canal->wet.perimeter, 1e3 * f.canal->hydraulic_radius,
                              1e3 * f.canal->wet.top_width));
        print_row("by Colebrook and White",
                  fmt::format("U = {:.4g} m/s, Q = {:.4g} l/s{}", f.canal->velocity, 1e3 * f.canal->discharge,
                              f.canal->alone ? "" : ", without its stems and stones"));
    }
}

nlohmann::ordered_json canal_json(const Forecast& f) {
    if (!f.canal) return nullptr;
    return {{"area", f.canal->wet.area},
            {"wetted_perimeter", f.canal->wet.perimeter},
            {"hydraulic_radius", f.canal->hydraulic_radius},
            {"top_width", f.canal->wet.top_width},
            {"velocity", f.canal->velocity},
            {"discharge", f.canal->discharge}};
}

nlohmann::ordered_json vegetation_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const VegetationForecast& stems : f.vegetation) {
        list.push_back({{"name", stems.name},
                        {"frontal_area", stems.frontal_area},
                        {"solid_fraction", stems.solid_fraction},
                        {"speed", stems.speed},
                        {"drag_coefficient", stems.drag_coefficient},
                        {"displacement", stems.displacement}});
    }
    return list;
}

void print_porous(const Forecast& f) {
    for (const PorousForecast& zone : f.porous) {
        print_row(
            "porous zone",
            fmt::format("{}: n = {:.3g}, K = {:.3g} m2, quadratic coefficient {:.4g} 1/m, "
                        "q = {:.3g} m/s with a pore Reynolds number of {:.3g}, at which the quadratic part "
                        "has {:.0f} %",
                        zone.name, zone.porosity, zone.permeability, zone.quadratic, zone.speed,
                        zone.reynolds, 100.0 * zone.quadratic_share));
    }
}

nlohmann::ordered_json porous_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const PorousForecast& zone : f.porous) {
        list.push_back({{"name", zone.name},
                        {"porosity", zone.porosity},
                        {"permeability", zone.permeability},
                        {"quadratic", zone.quadratic},
                        {"speed", zone.speed},
                        {"reynolds", zone.reynolds},
                        {"quadratic_share", zone.quadratic_share}});
    }
    return list;
}

nlohmann::ordered_json parts_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const RecordForecast& part : f.parts) {
        list.push_back({{"name", part.name}, {"bytes", part.bytes}});
    }
    return list;
}

nlohmann::ordered_json probes_json(const Forecast& f) {
    auto list = nlohmann::ordered_json::array();
    for (const ProbeForecast& p : f.probes) {
        list.push_back({{"name", p.name},
                        {"kind", p.kind},
                        {"standard", p.standard},
                        {"sampling_frequency", p.sampling_frequency},
                        {"points", p.points},
                        {"samples", p.samples},
                        {"bytes", p.bytes},
                        {"time_share", p.time_share}});
    }
    return list;
}

void print_forecast(const Case& c, const Forecast& f) {
    fmt::print("{}\nvalid\n", c.title.empty() ? c.path.string() : c.title);
    print_row("particles", fmt::format("{} fluid, {} wall", f.particles, f.wall_particles));
    print_row("spacing, h",
              fmt::format("{:.4g} mm, {:.4g} mm", 1e3 * c.numerics.spacing, 1e3 * f.smoothing_length));
    if (const auto note = quiet_water_note(c)) print_row("still water", *note);
    print_row("sound speed",
              fmt::format("{:.4g} m/s{}", f.sound_speed,
                          f.maximum_velocity > 0.0 ? fmt::format(" ({:.3g} times the largest velocity)",
                                                                 f.sound_speed / f.maximum_velocity)
                                                   : ""));
    print_row("time step", fmt::format("{:.3g} s", f.time_step));
    if (f.relaxation_time) {
        print_row("relaxation time", fmt::format("{:.3g} s", *f.relaxation_time));
    }
    for (const EndFact& fact : f.end_facts) print_row(fact.label.c_str(), fact.text);
    if (!f.racks.empty()) {
        print_row("racks", fmt::format("free bodies are held back at x = {} and {}; the water passes",
                                       shown_length(f.racks.front()), shown_length(f.racks.back())));
    }
    print_canal(f);
    print_bed_patches(f);
    print_surface_patches(f);
    print_vegetation(f);
    print_porous(f);
    print_row("simulated time",
              c.run.until == RunUntil::converged
                  ? fmt::format("about {:.3g} s until converged, at most {:.3g} s", f.end_time, f.latest_end)
                  : fmt::format("{:.4g} s", f.end_time));
    print_row("steps", fmt::format("{:.3g}", f.steps));
    print_row("time", fmt::format("about {} here ({:.2f} M particle updates/s measured)",
                                  duration_text(f.wall_seconds), f.updates_per_second * 1e-6));
    print_row("memory", fmt::format("{} at the peak", size_text(f.memory_bytes)));
    print_row("disk", fmt::format("at most {}, {} more while files are replaced", size_text(f.disk_bytes),
                                  size_text(f.replacing_bytes)));
    for (const RecordForecast& part : f.parts) {
        fmt::print("    {:<20} {}\n", part.name, size_text(part.bytes));
    }
    print_probes(f);
    for (std::size_t i = 0; i < c.solid_notes.size(); ++i) {
        print_row(i == 0 ? "beds from data" : "", c.solid_notes[i]);
    }
}

void print_json(const Case& c, const Forecast& f, const std::vector<std::string>& warnings) {
    const nlohmann::ordered_json json = {{"particles", f.particles},
                                         {"wall_particles", f.wall_particles},
                                         {"sound_speed", f.sound_speed},
                                         {"time_step", f.time_step},
                                         {"end_time", f.end_time},
                                         {"latest_end", f.latest_end},
                                         {"steps", f.steps},
                                         {"particle_updates_per_second", f.updates_per_second},
                                         {"wall_seconds", f.wall_seconds},
                                         {"memory_bytes", f.memory_bytes},
                                         {"disk_bytes", f.disk_bytes},
                                         {"replacing_bytes", f.replacing_bytes},
                                         {"disk_parts", parts_json(f)},
                                         {"still_water", quiet_water_note(c).value_or("")},
                                         {"ends", ends_json(f)},
                                         {"racks", f.racks},
                                         {"canal", canal_json(f)},
                                         {"bed_patches", bed_patches_json(f)},
                                         {"surface_patches", surface_patches_json(f)},
                                         {"vegetation", vegetation_json(f)},
                                         {"porous", porous_json(f)},
                                         {"probes", probes_json(f)},
                                         {"probe_notes", f.probe_notes},
                                         {"solid_notes", c.solid_notes},
                                         {"warnings", warnings}};
    fmt::print("{}\n", json.dump(2));
}

void check(const CheckVerb& verb) {
    show_notices();
    const Case c = verb.argument.read();
    verb.argument.check_size_of(c);
    check_runnable(c);
    const std::vector<std::string> warnings = case_warnings(c);
    for (const std::string& warning : warnings) print_warning(warning);
    const Forecast f = forecast_run(c, verb.threads);
    if (verb.json) {
        print_json(c, f, warnings);
    } else {
        print_forecast(c, f);
    }
}

}  // namespace

void add_verb_check(CLI::App& app) {
    const auto verb = std::make_shared<CheckVerb>();
    CLI::App* const command =
        app.add_subcommand("check", "Validate a case; particles, steps, time, memory and disk of its run");
    verb->argument.add_to(*command);
    verb->argument.add_large_to(*command);
    add_threads_option(*command, verb->threads,
                       "Threads of the forecast (default: all processors that may be used)");
    command->add_flag("--json", verb->json, "Print the forecast as JSON (SI units)");
    command->footer(
        "Examples:\n"
        "  riffle check my-flume.toml\n"
        "  riffle check my-flume.toml --set numerics.spacing=1mm   what would a finer one cost?\n"
        "  riffle check my-flume.toml --json > forecast.json");
    command->callback([verb] { check(*verb); });
}

}  // namespace riffle::inline cli
