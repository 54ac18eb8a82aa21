#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "analysis/analysis_json.hpp"
#include "analysis/analysis_text.hpp"
#include "cli/analysis_tables.hpp"
#include "cli/record_input.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle::inline cli {

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
            if (i != j && names[i] == names[j]) analyses[i].name = names[i] + " (" + analyses[i].source + ")";
        }
    }
}

void run_analyse(const AnalyseOptions& options) {
    const RecordInput& records = options.records;
    check_record_options(records);
    if (!options.json.empty()) refuse_to_replace_another(options.json, begin_of_json, "JSON file");
    if (!options.csv.empty()) refuse_to_lose_tables(options.csv, records.inputs.size(), records.chapter);
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
    if (!options.csv.empty()) {
        const std::size_t figures = write_tables(analyses, options.csv);
        fmt::print("{} (findings.csv and {} files of figures)\n", options.csv, figures);
    }
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

}  // namespace riffle::inline cli
