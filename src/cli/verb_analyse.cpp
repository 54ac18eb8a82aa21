#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "analysis/analysis_json.hpp"
#include "analysis/analysis_text.hpp"
#include "analysis/figure_csv.hpp"
#include "base/error.hpp"
#include "cli/record_input.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle {

namespace {

struct AnalyseOptions {
    RecordInput records;
    std::string json;
    std::string csv;
};

/// Names of the analyses made different where they are the same, by the folder or the file.
void tell_apart(std::vector<Analysis>& analyses) {
    std::vector<std::string> names;
    names.reserve(analyses.size());
    for (const Analysis& analysis : analyses) names.push_back(analysis.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < names.size(); ++j) {
            if (i != j && names[i] == names[j]) {
                analyses[i].name = names[i] + " (" + analyses[i].source + ")";
            }
        }
    }
}

/// A file of figures or findings, to be written.
struct CsvOutput {
    std::filesystem::path path;
    std::string content;
};

/// The CSV files of the analyses: in the folder itself, of several analyses in one subfolder each.
std::vector<CsvOutput> csv_outputs(const std::vector<Analysis>& analyses,
                                   const std::filesystem::path& folder) {
    std::vector<CsvOutput> outputs;
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        const std::filesystem::path place = analyses.size() == 1 ? folder : folder / fmt::format("{}", i + 1);
        for (const Figure& figure : analyses[i].figures) {
            for (CsvFile& file : figure_to_csv(figure)) {
                outputs.push_back({place / file.name, std::move(file.content)});
            }
        }
    }
    outputs.push_back({folder / "findings.csv", findings_to_csv(analyses)});
    return outputs;
}

void write_csv(const std::vector<Analysis>& analyses, const std::filesystem::path& folder) {
    const std::vector<CsvOutput> outputs = csv_outputs(analyses, folder);
    // An older table begins with the same line: the title of the figure, or the names of the columns.
    for (const CsvOutput& output : outputs) {
        refuse_to_replace_another(output.path,
                                  std::string_view(output.content).substr(0, output.content.find('\n')),
                                  "older table of this name by riffle analyse");
    }
    for (const CsvOutput& output : outputs) {
        std::error_code error;
        std::filesystem::create_directories(output.path.parent_path(), error);
        if (error) {
            throw FileError(fmt::format("{}: the folder cannot be made: {}",
                                        output.path.parent_path().string(), error.message()));
        }
        write_text_atomically(output.path, output.content);
    }
    fmt::print("{} (findings.csv and {} files of figures)\n", folder.string(), outputs.size() - 1);
}

void run_analyse(const AnalyseOptions& options) {
    const RecordInput& records = options.records;
    check_record_options(records);
    if (!options.json.empty()) refuse_to_replace_another(options.json, begin_of_json, "JSON file");
    std::vector<Analysis> analyses;
    for (const std::string& input : records.inputs) analyses.push_back(analyse_input(records, input));
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
    verb->add_option("inputs", options->records.inputs,
                     "Folders of runs or their results.h5, CSV files of a laboratory; several are compared")
        ->required()
        ->type_name("RESULTS|CSV");
    verb->add_option("--json", options->json, "Write findings and figures with their data to this file")
        ->type_name("FILE.json");
    verb->add_option("--csv", options->csv, "Write one CSV file per figure and findings.csv to this folder")
        ->type_name("DIR");
    verb->add_option("--chapter", options->records.chapter, "Only this chapter")->type_name("NAME");
    add_record_options(*verb, options->records);
    verb->footer(
        "Examples:\n"
        "  riffle analyse results/my-flume\n"
        "  riffle analyse results/my-flume --window 20,60 --measured profile.csv\n"
        "  riffle analyse results/my-flume --chapter surface --csv figures\n"
        "  riffle analyse wave-probes.csv --case my-flume.toml");
    verb->callback([options] { run_analyse(*options); });
}

}  // namespace riffle
