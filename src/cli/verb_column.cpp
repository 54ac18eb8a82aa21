#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "case/case.hpp"
#include "cli/case_argument.hpp"
#include "cli/printed_number.hpp"
#include "cli/verbs.hpp"
#include "column/column.hpp"
#include "column/wide_channel.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline cli {

namespace {

struct ColumnOptions {
    CaseArgument argument;
    bool json = false;
    bool csv = false;
};

void print_row(const std::string& name, const std::string& unit, double value,
               std::optional<double> measured = std::nullopt) {
    std::string line = fmt::format("  {:<44} {:>10} ", name, printed_number(value));
    if (measured) {
        line +=
            fmt::format("{:>10} {:>+8.1f} %  ", printed_number(*measured), 100.0 * (value / *measured - 1.0));
    } else {
        line += fmt::format("{:>23}", "");
    }
    line += unit;
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
}

/// A quantity that follows from the measured depth-mean velocity, where that is known.
template <class Function>
std::optional<double> from_measured_velocity(const Case& c, Function function) {
    if (!c.measured.depth_mean_velocity) return std::nullopt;
    return function(*c.measured.depth_mean_velocity);
}

void print_summary(const Case& c, const ColumnResult& r) {
    const WideChannel channel = wide_channel(c);
    fmt::print("{}\n", c.title.empty() ? "Column twin of the case" : c.title);
    fmt::print("depth over the datum {} m, total depth {} m, slope {}\n\n", printed_number(channel.depth),
               printed_number(c.total_depth()), printed_number(c.channel.slope));
    fmt::print("  {:<44} {:>10} {:>10} {:>10}\n", "", "column", "measured", "difference");
    print_row("depth-mean velocity over the datum, U", "m/s", r.depth_mean_velocity,
              c.measured.depth_mean_velocity);
    print_row("surface velocity", "m/s", r.surface_velocity);
    print_row("friction velocity u_*, stress at the crest", "m/s", r.friction_velocity,
              c.measured.friction_velocity);
    if (r.log_law.valid) {
        print_row("friction velocity u_*, log-law fit", "m/s", r.log_law.friction_velocity,
                  c.measured.friction_velocity);
        print_row("equivalent roughness k_s, log-law fit", "m", r.log_law.equivalent_roughness,
                  c.measured.equivalent_roughness);
        print_row("zero plane of the fit, over the bed level", "m", r.log_law.zero_plane);
    }
    print_row("weight carried by the bed drag", "%", 100.0 * r.drag_share);
    print_row("weight carried by the wall at z = 0", "%", 100.0 * r.wall_share);
    if (!c.vegetation.empty()) print_row("weight carried by the vegetation", "%", 100.0 * r.vegetation_share);
    if (!c.porous.empty()) print_row("weight carried by porous layers", "%", 100.0 * r.porous_share);
    if (r.depth_mean_velocity > 0.0) {
        const auto print_number = [&](const char* label, const char* unit, double of_column,
                                      double (WideChannel::*law)(double) const) {
            print_row(label, unit, of_column,
                      from_measured_velocity(c, [&](double u) { return (channel.*law)(u); }));
        };
        print_number("friction factor f", "", r.friction_factor, &WideChannel::friction_factor);
        if (channel.has_surface) {
            print_number("Manning n", "s/m^(1/3)", r.manning, &WideChannel::manning);
            print_number("Chezy C", "m^(1/2)/s", r.chezy, &WideChannel::chezy);
        }
        print_number("Reynolds number U h/nu", "", r.reynolds, &WideChannel::reynolds);
        if (channel.has_surface) {
            print_number("Froude number U/sqrt(g h)", "", r.froude, &WideChannel::froude);
        }
        print_row("e-folding time of the approach to it", "s", r.relaxation_time);
    }
    if (r.log_law.valid) {
        fmt::print("\nLog-law fit from {}z = {} m to {} m over the bed level.\n",
                   r.log_law.from == c.crest() ? "the crest, " : "", printed_number(r.log_law.from),
                   printed_number(r.log_law.to));
    }
    fmt::print("{}Wide channel: the hydraulic radius is {}.\n", r.log_law.valid ? "" : "\n",
               channel.hydraulic_radius < channel.depth ? "half of the height between the walls"
                                                        : "the depth over the datum");
    if (!c.measured.uniform) {
        fmt::print("The measured flow was not uniform; the column is.\n");
    }
}

/// The result in SI. What does not exist (the fit of a smooth bed, the time of water at rest) is null.
nlohmann::ordered_json to_json(const Case& c, const ColumnResult& r) {
    using nlohmann::ordered_json;
    ordered_json result;
    result["title"] = c.title;
    result["depth_mean_velocity"] = r.depth_mean_velocity;
    result["total_mean_velocity"] = r.total_mean_velocity;
    result["surface_velocity"] = r.surface_velocity;
    result["friction_velocity"] = r.friction_velocity;
    result["equivalent_roughness"] =
        r.log_law.valid ? ordered_json(r.log_law.equivalent_roughness) : ordered_json();
    result["zero_plane"] = r.log_law.valid ? ordered_json(r.log_law.zero_plane) : ordered_json();
    result["drag_share"] = r.drag_share;
    result["wall_share"] = r.wall_share;
    result["vegetation_share"] = r.vegetation_share;
    result["porous_share"] = r.porous_share;
    result["friction_factor"] = r.friction_factor;
    result["manning"] = r.manning;
    result["chezy"] = r.chezy;
    result["reynolds"] = r.reynolds;
    result["froude"] = r.froude;
    result["relaxation_time"] = r.relaxation_time;
    if (r.log_law.valid) {
        result["log_law"] = {{"friction_velocity", r.log_law.friction_velocity},
                             {"equivalent_roughness", r.log_law.equivalent_roughness},
                             {"zero_plane", r.log_law.zero_plane},
                             {"residual_rms", r.log_law.residual_rms},
                             {"from", r.log_law.from},
                             {"to", r.log_law.to}};
    } else {
        result["log_law"] = nullptr;
    }
    result["measured"] = {{"depth_mean_velocity", optional_number(c.measured.depth_mean_velocity)},
                          {"friction_velocity", optional_number(c.measured.friction_velocity)},
                          {"equivalent_roughness", optional_number(c.measured.equivalent_roughness)},
                          {"uniform", c.measured.uniform}};
    result["profile"] = {{"z", r.profile.z},
                         {"u", r.profile.velocity},
                         {"du_dz", r.profile.velocity_gradient},
                         {"tau", r.profile.shear_stress},
                         {"mixing_length", r.profile.mixing_length},
                         {"eddy_viscosity", r.profile.eddy_viscosity}};
    return result;
}

void print_csv(const ColumnProfile& p) {
    fmt::print("z [m],u [m/s],du/dz [1/s],tau [Pa],l_m [m],nu_t [m2/s]\n");
    for (std::size_t i = 0; i < p.z.size(); ++i) {
        fmt::print("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", p.z[i], p.velocity[i],
                   p.velocity_gradient[i], p.shear_stress[i], p.mixing_length[i], p.eddy_viscosity[i]);
    }
}

void run_column(const ColumnOptions& options) {
    const Case c = options.argument.read();
    const ColumnResult result = solve_column(c);
    if (options.json) {
        fmt::print("{}\n", to_json(c, result).dump(2));
    } else if (options.csv) {
        print_csv(result.profile);
    } else {
        print_summary(c, result);
    }
}

}  // namespace

void add_verb_column(CLI::App& app) {
    auto* const verb = app.add_subcommand(
        "column", "Solve the steady one-dimensional twin of a case and print it beside the measured values");
    const auto options = std::make_shared<ColumnOptions>();
    options->argument.add_to(*verb);
    auto* const json = verb->add_flag("--json", options->json, "Print everything as JSON, SI units");
    verb->add_flag("--csv", options->csv, "Print the profile as CSV, SI units")->excludes(json);
    verb->footer(
        "Examples:\n"
        "  riffle column my-flume.toml\n"
        "  riffle column my-flume.toml --set turbulence.closure=nezu-rodi\n"
        "  riffle column my-flume.toml --csv > profile.csv");
    verb->callback([options] { run_column(*options); });
}

}  // namespace riffle::inline cli
