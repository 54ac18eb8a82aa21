#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/case.hpp"
#include "cli/case_argument.hpp"
#include "cli/positive_number.hpp"
#include "cli/verbs.hpp"
#include "column/calibration.hpp"
#include "output/atomic_file.hpp"

namespace riffle {

namespace {

struct CalibrateOptions {
    CaseArgument argument;
    CalibrationOptions calibration;
    std::string write;
    bool force = false;
    bool json = false;
};

std::string number(double value) { return fmt::format("{:.4g}", value); }

/// A line of a table without the blanks of its empty last columns.
void print_line(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
}

void print_summary(const Case& c, const CalibrationResult& r) {
    fmt::print("{}\n\n", c.title.empty() ? "Calibration of the case" : c.title);
    fmt::print("  {:<20} {:>10} {:>10}   {:<12} {:<18} {}\n", "parameter", "start", "fitted", "+- standard",
               "range", "unit");
    for (const FittedParameter& p : r.parameters) {
        const std::string uncertainty =
            std::isfinite(p.standard_uncertainty) ? number(p.standard_uncertainty) : "undetermined";
        const std::string range = fmt::format("{} to {}", number(p.lower), number(p.upper));
        print_line(fmt::format("  {:<20} {:>10} {:>10}   {:<12} {:<18} {}", p.name, number(p.start),
                               number(p.value), uncertainty, range, p.unit));
    }
    if (r.parameters.size() > 1) {
        fmt::print("\n  correlation         ");
        for (const FittedParameter& p : r.parameters) fmt::print(" {:>16}", p.name);
        for (std::size_t i = 0; i < r.parameters.size(); ++i) {
            fmt::print("\n  {:<18}  ", r.parameters[i].name);
            for (const double value : r.correlation[i]) {
                fmt::print(" {:>16}", std::isfinite(value) ? fmt::format("{:.3f}", value) : "-");
            }
        }
        fmt::print("\n");
    }
    fmt::print("\n  {:<20} {:>6} {:>10} {:>10}   {:>18}   {:>18}\n", "measured", "points", "value", "+- std",
               "column before", "column after");
    for (const FittedQuantity& q : r.quantities) {
        const auto beside = [&](double value, double misfit) {
            return q.points > 1 ? fmt::format("{} ({:.1f} % rms)", number(value), 100.0 * misfit)
                                : fmt::format("{} ({:+.1f} %)", number(value), 100.0 * misfit);
        };
        fmt::print("  {:<20} {:>6} {:>10} {:>10}   {:>18}   {:>18}  {}\n", q.name, q.points,
                   number(q.measured), number(q.uncertainty), beside(q.before, q.relative_misfit_before),
                   beside(q.after, q.relative_misfit_after), q.unit);
    }
    fmt::print("\n  chi^2 {} with {} degrees of freedom; uncertainties widened by {}\n", number(r.chi_square),
               number(r.degrees_of_freedom), number(r.scatter_factor));
    for (const std::string& warning : r.warnings) fmt::print("\nWarning: {}\n", warning);
}

nlohmann::ordered_json to_json(const CalibrationResult& r) {
    using nlohmann::ordered_json;
    ordered_json result;
    result["parameters"] = ordered_json::array();
    for (const FittedParameter& p : r.parameters) {
        result["parameters"].push_back({{"name", p.name},
                                        {"key", p.key},
                                        {"unit", p.unit},
                                        {"start", p.start},
                                        {"value", p.value},
                                        {"standard_uncertainty", p.standard_uncertainty},
                                        {"lower", p.lower},
                                        {"upper", p.upper},
                                        {"at_bound", p.at_bound}});
    }
    result["correlation"] = r.correlation;
    result["quantities"] = ordered_json::array();
    for (const FittedQuantity& q : r.quantities) {
        result["quantities"].push_back({{"name", q.name},
                                        {"unit", q.unit},
                                        {"points", q.points},
                                        {"measured", q.measured},
                                        {"uncertainty", q.uncertainty},
                                        {"before", q.before},
                                        {"after", q.after},
                                        {"relative_misfit_before", q.relative_misfit_before},
                                        {"relative_misfit_after", q.relative_misfit_after}});
    }
    result["chi_square"] = r.chi_square;
    result["degrees_of_freedom"] = r.degrees_of_freedom;
    result["scatter_factor"] = r.scatter_factor;
    result["warnings"] = r.warnings;
    return result;
}

void write_fitted_case(const CalibrateOptions& options, const CalibrationResult& result) {
    std::vector<Override> overrides = options.argument.overrides();
    for (const Override& fitted : fitted_overrides(result)) overrides.push_back(fitted);
    const Case fitted = read_case(options.argument.file, overrides);
    write_text_atomically(options.write, fitted.text);
}

void run_calibrate(const CalibrateOptions& options) {
    if (!options.write.empty() && std::filesystem::exists(options.write) && !options.force) {
        throw InputError(fmt::format(
            "{}: the file exists already; give another name, or --force to overwrite it", options.write));
    }
    const Case c = options.argument.read();
    const CalibrationResult result = calibrate_column(c, options.calibration);
    if (!options.write.empty()) write_fitted_case(options, result);
    if (options.json) {
        fmt::print("{}\n", to_json(result).dump(2));
        return;
    }
    print_summary(c, result);
    if (!options.write.empty()) fmt::print("\n{} written\n", options.write);
}

}  // namespace

void add_verb_calibrate(CLI::App& app) {
    auto* const verb =
        app.add_subcommand("calibrate", "Fit parameters of the column twin to the measured values of a case");
    const auto options = std::make_shared<CalibrateOptions>();
    options->argument.add_to(*verb);
    verb->add_option("--fit", options->calibration.parameters,
                     "Parameters to fit, separated by commas: roughness_height, drag_coefficient, lambda")
        ->delimiter(',')
        ->capture_default_str();
    verb->add_option("--mean-uncertainty", options->calibration.depth_mean_uncertainty,
                     "Relative standard uncertainty of the measured depth-mean velocity")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--friction-uncertainty", options->calibration.friction_velocity_uncertainty,
                     "Relative standard uncertainty of the measured friction velocity")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--profile-uncertainty", options->calibration.profile_uncertainty,
                     "Relative standard uncertainty of a profile velocity without its own")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--write", options->write, "Write the case with the fitted values to this file");
    verb->add_flag("--force", options->force, "Let --write overwrite an existing file");
    verb->add_flag("--json", options->json, "Print everything as JSON, SI units");
    verb->footer(
        "Examples:\n"
        "  riffle calibrate cases/rough-bed-2d/condition-2.toml\n"
        "  riffle calibrate my-flume.toml --fit drag_coefficient,lambda\n"
        "  riffle calibrate my-flume.toml --write calibrated.toml");
    verb->callback([options] { run_calibrate(*options); });
}

}  // namespace riffle
