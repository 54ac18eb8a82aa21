#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/verbs.hpp"
#include "report/report.hpp"

namespace riffle {

namespace {

struct ReportOptions {
    std::string results;
    std::string output;
    std::string json;
};

void run_report(const ReportOptions& options) {
    const std::filesystem::path results = find_results_file(options.results);
    const std::filesystem::path html = options.output.empty() ? results.parent_path() / "report.html"
                                                              : std::filesystem::path(options.output);
    write_report(results, html, options.json);
    fmt::print("{}\n", html.string());
    if (!options.json.empty()) fmt::print("{}\n", options.json);
}

}  // namespace

void add_verb_report(CLI::App& app) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App* const verb =
        app.add_subcommand("report", "Make the report of a run: one HTML page, to be read offline");
    verb->add_option("results", options->results, "Folder of the run, or its results.h5")
        ->required()
        ->type_name("RESULTS");
    verb->add_option("-o,--output", options->output,
                     "The page to write (default: report.html beside the results)")
        ->type_name("FILE.html");
    verb->add_option("--json", options->json, "Write the summary as JSON (SI units) to this file too")
        ->type_name("FILE.json");
    verb->callback([options] { run_report(*options); });
}

}  // namespace riffle
