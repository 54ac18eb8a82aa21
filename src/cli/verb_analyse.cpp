#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "analysis/analysis_json.hpp"
#include "analysis/analysis_text.hpp"
#include "analysis/chapters.hpp"
#include "analysis/figure_csv.hpp"
#include "analysis/laboratory_record.hpp"
#include "analysis/run_record.hpp"
#include "base/error.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "report/report.hpp"

namespace riffle {

namespace {

struct AnalyseOptions {
    std::vector<std::string> inputs;
    std::string json;
    std::string csv;
    std::string chapter;
    std::string measured;
    std::vector<double> window;
    std::string case_file;
    std::string calibration;
    double frequency = 0.0;
};

/// Names of the analyses made different where they are the same, by the folder or the file.
void tell_apart(std::vector<Analysis>& analyses) {
    std::vector<std::string> names;
    for (const Analysis& analysis : analyses) names.push_back(analysis.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < names.size(); ++j) {
            if (i != j && names[i] == names[j]) {
                analyses[i].name = names[i] + " (" + analyses[i].source + ")";
            }
        }
    }
}

/// The CSV files of the analyses: in the folder itself, of several analyses in one subfolder each.
void write_csv(const std::vector<Analysis>& analyses, const std::filesystem::path& folder) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        const std::filesystem::path place = analyses.size() == 1 ? folder : folder / fmt::format("{}", i + 1);
        std::error_code error;
        std::filesystem::create_directories(place, error);
        if (error) {
            throw FileError(
                fmt::format("{}: the folder cannot be made: {}", place.string(), error.message()));
        }
        for (const Figure& figure : analyses[i].figures) {
            for (const CsvFile& file : figure_to_csv(figure)) {
                write_text_atomically(place / file.name, file.content);
                ++count;
            }
        }
    }
    write_text_atomically(folder / "findings.csv", findings_to_csv(analyses));
    fmt::print("{} (findings.csv and {} files of figures)\n", folder.string(), count);
}

bool is_table(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".csv" || ending == ".CSV" || ending == ".txt" || ending == ".dat";
}

Analysis analyse_input(const AnalyseOptions& options, const std::string& input) {
    std::optional<TimeWindow> window;
    if (!options.window.empty()) window = TimeWindow{options.window.at(0), options.window.at(1)};
    if (is_table(input)) {
        LaboratoryRecordOptions how;
        how.window = window;
        how.case_file = options.case_file;
        how.calibration = options.calibration;
        if (options.frequency > 0.0) how.sampling_frequency = options.frequency;
        return analyse(LaboratoryRecord(input, how), options.chapter);
    }
    RunRecordOptions how;
    how.window = window;
    how.measured = options.measured;
    return analyse(RunRecord(find_results_file(input), how), options.chapter);
}

/// Options that say something of one kind of input only are an error where there is none of it.
void check_options(const AnalyseOptions& options) {
    const bool only_tables = std::all_of(options.inputs.begin(), options.inputs.end(),
                                         [](const std::string& input) { return is_table(input); });
    if (!options.measured.empty() && only_tables) {
        throw InputError(
            "--measured is what a run is compared with, but no results file is given; a CSV file alone "
            "is analysed by naming it as an input");
    }
    const bool any = std::any_of(options.inputs.begin(), options.inputs.end(),
                                 [](const std::string& input) { return is_table(input); });
    const char* const given = !options.case_file.empty()     ? "--case"
                              : !options.calibration.empty() ? "--calibration"
                              : options.frequency > 0.0      ? "--frequency"
                                                             : nullptr;
    if (given != nullptr && !any) {
        throw InputError(std::string(given) +
                         " is about laboratory records, but no CSV file is given; a results "
                         "file holds its own case and times");
    }
}

void run_analyse(const AnalyseOptions& options) {
    check_options(options);
    std::vector<Analysis> analyses;
    for (const std::string& input : options.inputs) analyses.push_back(analyse_input(options, input));
    tell_apart(analyses);
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        fmt::print("{}{}", i == 0 ? "" : "\n", analysis_to_text(analyses[i]));
    }
    if (analyses.size() > 1) fmt::print("\n{}", comparison_to_text(analyses));
    if (!options.json.empty() || !options.csv.empty()) fmt::print("\n");
    if (!options.json.empty()) {
        write_text_atomically(options.json, analysis_to_json(analyses) + "\n");
        fmt::print("{}\n", options.json);
    }
    if (!options.csv.empty()) write_csv(analyses, options.csv);
}

}  // namespace

void add_verb_analyse(CLI::App& app) {
    const auto options = std::make_shared<AnalyseOptions>();
    CLI::App* const verb = app.add_subcommand(
        "analyse",
        "Measure a flow as a laboratory would: statistics, profiles, fitted laws, surface, spectra, forces");
    verb->add_option("inputs", options->inputs,
                     "Folders of runs or their results.h5, CSV files of a laboratory; several are compared")
        ->required()
        ->type_name("RESULTS|CSV");
    verb->add_option("--json", options->json, "Write findings and figures with their data to this file")
        ->type_name("FILE.json");
    verb->add_option("--csv", options->csv, "Write one CSV file per figure and findings.csv to this folder")
        ->type_name("DIR");
    verb->add_option("--chapter", options->chapter, "Only this chapter")->type_name("NAME");
    verb->add_option("--window", options->window,
                     "Average over this stretch of the record, s (default: the averaging window of the run)")
        ->type_name("FROM,TO")
        ->delimiter(',')
        ->expected(2);
    verb->add_option("--measured", options->measured,
                     "Measured velocity profile to compare with: CSV of z above the datum, u, in SI")
        ->type_name("FILE.csv");
    verb->add_option(
            "--case", options->case_file,
            "Case file of the flow that CSV records were measured in: depth, slope, measured velocity")
        ->type_name("CASE.toml");
    verb->add_option("--frequency", options->frequency, "Sampling frequency of CSV records without times, Hz")
        ->type_name("HZ")
        ->check(CLI::PositiveNumber);
    verb->add_option("--calibration", options->calibration,
                     "Calibration of wave probes that recorded voltages: CSV of levels and voltages")
        ->type_name("FILE.csv");
    verb->callback([options] { run_analyse(*options); });
}

}  // namespace riffle
