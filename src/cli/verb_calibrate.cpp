#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "case/case.hpp"
#include "cli/case_argument.hpp"
#include "cli/positive_number.hpp"
#include "cli/printed_number.hpp"
#include "cli/verbs.hpp"
#include "column/calibration.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle::inline cli {

namespace {

namespace fs = std::filesystem;

struct CalibrateOptions {
    std::vector<std::string> files;
    std::vector<std::string> settings;
    CalibrationOptions calibration;
    std::vector<std::string> sections;
    std::string write;
    bool force = false;
    bool accept_worse = false;
    bool json = false;

    [[nodiscard]] CaseArgument argument(std::size_t i) const { return {files[i], settings}; }
};

/// A line of a table without the blanks of its empty last columns.
void print_line(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
}

/// Name of a parameter in the tables; of one that each condition has its own of with the condition's number.
std::string label(const FittedParameter& p) {
    return p.condition ? fmt::format("{} [{}]", p.name, *p.condition + 1) : p.name;
}

/// An end of the interval of a parameter; beyond its range the end of that.
std::string end_of_interval(double value, const FittedParameter& p) {
    return value < p.lower   ? "< " + printed_number(p.lower)
           : value > p.upper ? "> " + printed_number(p.upper)
                             : printed_number(value);
}

void print_parameters(const CalibrationResult& r) {
    fmt::print("  {:<22} {:>10} {:>10}   {:<22} {:<18} {}\n", "parameter", "start", "fitted", "95 % interval",
               "range", "unit");
    for (const FittedParameter& p : r.parameters) {
        const std::string interval = std::isfinite(p.half_width)
                                         ? fmt::format("{} to {}", end_of_interval(p.value - p.half_width, p),
                                                       end_of_interval(p.value + p.half_width, p))
                                         : "undetermined";
        const std::string range = fmt::format("{} to {}", printed_number(p.lower), printed_number(p.upper));
        print_line(fmt::format("  {:<22} {:>10} {:>10}   {:<22} {:<18} {}", label(p), printed_number(p.start),
                               printed_number(p.value), interval, range, p.unit));
    }
}

void print_correlation(const CalibrationResult& r) {
    if (r.parameters.size() < 2) return;
    fmt::print("\n  correlation           ");
    for (const FittedParameter& p : r.parameters) fmt::print(" {:>20}", label(p));
    for (std::size_t i = 0; i < r.parameters.size(); ++i) {
        fmt::print("\n  {:<20}  ", label(r.parameters[i]));
        for (const double value : r.correlation[i]) {
            fmt::print(" {:>20}", std::isfinite(value) ? fmt::format("{:.3f}", value) : "-");
        }
    }
    fmt::print("\n");
}

void print_quantities(const CalibrationResult& r) {
    fmt::print("\n  {:<22} {:>6} {:>10} {:>10}   {:>18}   {:>18}\n", "measured", "points", "value", "+- std",
               "column before", "column after");
    for (std::size_t i = 0; i < r.conditions.size(); ++i) {
        if (r.conditions.size() > 1) fmt::print("  [{}] {}\n", i + 1, r.conditions[i].name);
        for (const FittedQuantity& q : r.conditions[i].quantities) {
            const auto beside = [&](double value, double misfit) {
                return q.points > 1 ? fmt::format("{} ({:.1f} % rms)", printed_number(value), 100.0 * misfit)
                                    : fmt::format("{} ({:+.1f} %)", printed_number(value), 100.0 * misfit);
            };
            const std::string note = fmt::format("{}{}{}", q.unit, q.fitted_to ? "" : ", not fitted to",
                                                 q.worsened() ? ", worse" : "");
            fmt::print("  {:<22} {:>6} {:>10} {:>10}   {:>18}   {:>18}  {}\n", q.name, q.points,
                       printed_number(q.measured), printed_number(q.uncertainty),
                       beside(q.before, q.relative_misfit_before), beside(q.after, q.relative_misfit_after),
                       note);
        }
    }
}

void print_summary(const CalibrationResult& r) {
    if (r.conditions.size() == 1) {
        fmt::print("{}\n\n", r.conditions.front().name);
    } else {
        fmt::print("{} conditions together\n\n", r.conditions.size());
    }
    print_parameters(r);
    print_correlation(r);
    print_quantities(r);
    fmt::print("\n  chi^2 {} with {} degrees of freedom; uncertainties widened by {}\n",
               printed_number(r.chi_square), printed_number(r.degrees_of_freedom),
               printed_number(r.scatter_factor));
    for (const std::string& warning : r.warnings) fmt::print("\nWarning: {}\n", warning);
}

nlohmann::ordered_json to_json(const CalibrationResult& r) {
    using nlohmann::ordered_json;
    ordered_json result;
    result["parameters"] = ordered_json::array();
    for (const FittedParameter& p : r.parameters) {
        ordered_json parameter{{"name", p.name},
                               {"key", p.key},
                               {"unit", p.unit},
                               {"start", p.start},
                               {"value", p.value},
                               {"standard_uncertainty", p.standard_uncertainty},
                               {"half_width", p.half_width},
                               {"lower", p.lower},
                               {"upper", p.upper},
                               {"at_bound", p.at_bound}};
        if (p.condition) parameter["condition"] = r.conditions[*p.condition].name;
        result["parameters"].push_back(std::move(parameter));
    }
    result["correlation"] = r.correlation;
    result["quantities"] = ordered_json::array();
    for (const CalibratedCondition& condition : r.conditions) {
        for (const FittedQuantity& q : condition.quantities) {
            result["quantities"].push_back({{"name", q.name},
                                            {"condition", condition.name},
                                            {"unit", q.unit},
                                            {"points", q.points},
                                            {"measured", q.measured},
                                            {"uncertainty", q.uncertainty},
                                            {"before", q.before},
                                            {"after", q.after},
                                            {"relative_misfit_before", q.relative_misfit_before},
                                            {"relative_misfit_after", q.relative_misfit_after},
                                            {"fitted_to", q.fitted_to},
                                            {"worse", q.worsened()}});
        }
    }
    result["chi_square"] = r.chi_square;
    result["degrees_of_freedom"] = r.degrees_of_freedom;
    result["scatter_factor"] = r.scatter_factor;
    result["worse"] = r.worsened();
    result["warnings"] = r.warnings;
    return result;
}

/// Where the fitted case of each condition goes: the file; of several conditions the file's name in a folder.
std::vector<fs::path> written_files(const CalibrateOptions& options) {
    if (options.write.empty()) return {};
    if (options.files.size() == 1) return {options.write};
    std::vector<fs::path> files;
    for (const std::string& file : options.files) {
        files.push_back(fs::path(options.write) / fs::path(file).filename());
        for (std::size_t i = 0; i + 1 < files.size(); ++i) {
            if (files[i] == files.back()) {
                throw InputError(fmt::format(
                    "--write: two of the cases are named {}; calibrate files with different names",
                    files[i].filename().string()));
            }
        }
    }
    return files;
}

void check_writable(const CalibrateOptions& options) {
    for (const fs::path& file : written_files(options)) {
        if (!options.force) refuse_to_replace(file);
    }
}

void write_fitted_cases(const CalibrateOptions& options, const CalibrationResult& result) {
    const std::vector<fs::path> files = written_files(options);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const CaseArgument argument = options.argument(i);
        std::vector<Override> overrides = argument.overrides();
        for (const Override& fitted : fitted_overrides(result, i)) overrides.push_back(fitted);
        const Case fitted = read_case(argument.file, overrides);
        std::error_code error;
        if (files.size() > 1) fs::create_directories(options.write, error);
        write_text_atomically(files[i], fitted.text);
    }
}

void run_calibrate(const CalibrateOptions& options) {
    check_writable(options);
    std::vector<Case> cases;
    for (std::size_t i = 0; i < options.files.size(); ++i) cases.push_back(options.argument(i).read());
    CalibrationOptions how = options.calibration;
    how.sections.assign(options.sections.begin(), options.sections.end());
    const CalibrationResult result = calibrate_columns(cases, how);
    if (options.json) {
        fmt::print("{}\n", to_json(result).dump(2));
    } else {
        print_summary(result);
    }
    if (options.write.empty()) return;
    if (result.worsened() && !options.accept_worse) {
        throw InputError(
            "the fitted values make a measured quantity worse and miss it, as said above, and are not "
            "written: fit other parameters, choose with --use what to trust, or write them all the same "
            "with --accept-worse");
    }
    write_fitted_cases(options, result);
    if (!options.json) fmt::print("\n{} written\n", options.write);
}

}  // namespace

void add_verb_calibrate(CLI::App& app) {
    auto* const verb = app.add_subcommand(
        "calibrate",
        "Fit parameters of the column twin to the measured values of a case, or of several together");
    const auto options = std::make_shared<CalibrateOptions>();
    std::string known;
    for (const std::string& name : calibration_parameters()) known += (known.empty() ? "" : ", ") + name;
    verb->add_option("cases", options->files, "Case files; several are fitted together")
        ->required()
        ->type_name("CASE.toml");
    verb->add_option("--set", options->settings, "Change a key of all cases: section.key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->add_option("--fit", options->calibration.parameters,
                     "Parameters to fit, one value for all cases, separated by commas: " + known)
        ->delimiter(',')
        ->capture_default_str();
    verb->add_option("--each", options->calibration.each,
                     "Parameters to fit with a value of its own for each case, separated by commas")
        ->delimiter(',');
    verb->add_option(
            "--use", options->calibration.use,
            "Measured quantities to fit to, separated by commas (default: all that there are): depth-mean, "
            "profile, friction-velocity, section")
        ->delimiter(',');
    verb->add_option(
            "--section", options->sections,
            "Measured points of a cross-section, CSV of y, z, u, -u'w'; of several cases one for each, in "
            "their order")
        ->type_name("FILE.csv")
        ->allow_extra_args(false);
    verb->add_option("--mean-uncertainty", options->calibration.depth_mean_uncertainty,
                     "Relative standard uncertainty of the measured depth-mean velocity")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--friction-uncertainty", options->calibration.friction_velocity_uncertainty,
                     "Relative standard uncertainty of the measured friction velocity")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--profile-uncertainty", options->calibration.profile_uncertainty,
                     "Relative standard uncertainty of a velocity of a profile or section without its own")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option("--stress-uncertainty", options->calibration.stress_uncertainty,
                     "Standard uncertainty of a Reynolds stress of a section over g S0 h")
        ->check(positive_number())
        ->capture_default_str();
    verb->add_option(
        "--write", options->write,
        "Write the case with the fitted values to this file; of several cases to files of their names in "
        "this folder");
    verb->add_flag("--force", options->force, "Let --write overwrite an existing file");
    verb->add_flag("--accept-worse", options->accept_worse,
                   "Let --write write values that make a measured quantity worse");
    verb->add_flag("--json", options->json, "Print everything as JSON, SI units");
    verb->footer(
        "Examples:\n"
        "  riffle calibrate cases/rough-bed-2d/condition-2.toml\n"
        "  riffle calibrate my-flume.toml --fit drag_coefficient,lambda\n"
        "  riffle calibrate my-flume.toml --write calibrated.toml");
    verb->callback([options] { run_calibrate(*options); });
}

}  // namespace riffle::inline cli
