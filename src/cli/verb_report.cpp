#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "cli/record_input.hpp"
#include "cli/verbs.hpp"
#include "output/replaced_file.hpp"
#include "report/report.hpp"
#include "report/thesis.hpp"

namespace riffle::inline cli {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    RecordInput records;
    std::string output;
    std::string json;
    std::string thesis;  ///< parts, "all"; empty: no page of the thesis
};

ReportSubject subject_of(const RecordInput& records, const fs::path& path) {
    if (is_table(path)) return {{}, analyse_input(records, path.string())};
    ReportSubject subject{find_results_file(path), {}};
    try {
        subject.analysis = analyse_input(records, path.string());
    } catch (const InputError& error) {
        if (records.window || !records.measured.empty()) throw;  // what was asked for cannot be done
        // A run that has only just started has no window yet: its report says so and shows what there is.
        subject.analysis.source = subject.results.string();
        subject.analysis.warnings.push_back(std::string("the run could not be analysed: ") + error.what());
    }
    return subject;
}

/// Runs in a folder of the thesis' runs: the folder itself, or the folders in it that hold results.
std::vector<fs::path> runs_in(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error) || fs::exists(folder / "results.h5", error)) return {folder};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (fs::exists(entry.path() / "results.h5", error)) found.push_back(entry.path());
    }
    if (found.empty()) {
        throw FileError(folder.string() +
                        ": neither a run (no results.h5) nor a folder of runs; expected the folders that "
                        "tools/thesis-chapter.sh or `riffle run -o` filled");
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// The folder that holds all inputs, else the current one: where a page of several runs is written.
fs::path common_folder(const std::vector<fs::path>& results) {
    std::error_code error;
    fs::path folder;
    for (const fs::path& path : results) {
        const fs::path run = fs::absolute(path, error).lexically_normal().parent_path();
        const fs::path above = path.filename() == "results.h5" ? run.parent_path() : run;
        if (!folder.empty() && above != folder) return {};
        folder = above;
    }
    const fs::path relative = folder.lexically_relative(fs::current_path(error));
    return !relative.empty() && *relative.begin() != ".." ? relative : folder;
}

/// Throws InputError where the page or its summary would take the place of anything else than an older one.
void refuse_other_files(const fs::path& html, const fs::path& json) {
    refuse_to_replace_another(html, begin_of_page, "page of Riffle");
    if (!json.empty()) refuse_to_replace_another(json, begin_of_json, "summary (JSON)");
    // A page is HTML whatever its name says.
    static const std::set<std::string> others{".pdf", ".png", ".svg", ".json",
                                              ".csv", ".txt", ".md",  ".docx"};
    if (others.contains(html.extension().string())) {
        throw InputError(fmt::format(
            "--output {}: expected the name of a page, NAME.html; to have it as PDF, open the page in "
            "a browser and print it to a file",
            html.string()));
    }
}

void print_written(const fs::path& html, const fs::path& json) {
    fmt::print("{}\n", html.string());
    if (!json.empty()) fmt::print("{}\n", json.string());
}

void report_one(const ReportOptions& options, const fs::path& input) {
    const ReportSubject subject = subject_of(options.records, input);
    const fs::path html =
        options.output.empty() ? subject.results.parent_path() / "report.html" : fs::path(options.output);
    const fs::path json = options.json.empty() ? summary_beside(html) : fs::path(options.json);
    refuse_other_files(html, json);
    write_report(subject.results, html, json, subject.analysis);
    print_written(html, json);
}

/// The parts of the thesis that were asked for; none for all that the runs are of.
std::set<ThesisPart> parts_of(const std::string& words) {
    std::set<ThesisPart> parts;
    if (words == "all") return parts;
    std::istringstream stream(words);
    for (std::string word; std::getline(stream, word, ',');) {
        const auto part = thesis_part(word);
        if (!part) {
            throw InputError(fmt::format(
                "--thesis={}: '{}' is no part of the thesis; expected one or more of 4, 5, 6 and paper, "
                "separated by commas, or --thesis alone for all",
                words, word));
        }
        parts.insert(*part);
    }
    return parts;
}

/// File of a page of several; a laboratory record alone gives its own name to its page.
fs::path name_of_page(const ReportOptions& options, const std::vector<fs::path>& inputs) {
    if (!options.thesis.empty()) return "thesis.html";
    return inputs.size() == 1 ? fs::path(inputs.front().stem()).concat(".html") : fs::path("comparison.html");
}

void report_several(const ReportOptions& options, const std::vector<fs::path>& inputs) {
    const std::set<ThesisPart> parts = parts_of(options.thesis);
    std::vector<ReportSubject> subjects;
    std::vector<fs::path> results;
    for (const fs::path& input : inputs) {
        subjects.push_back(subject_of(options.records, input));
        results.push_back(subjects.back().results.empty() ? input : subjects.back().results);
    }
    const Comparison comparison =
        options.thesis.empty() ? compare(subjects) : thesis_figures(subjects, parts);
    for (const MissingRun& missing : comparison.missing) {
        fmt::print(stderr, "riffle: warning: {} is not among the results; make it with: {}\n", missing.what,
                   missing.command);
    }
    const fs::path html = options.output.empty() ? common_folder(results) / name_of_page(options, inputs)
                                                 : fs::path(options.output);
    const fs::path json = options.json.empty() ? summary_beside(html) : fs::path(options.json);
    refuse_other_files(html, json);
    write_comparison(comparison, html, json);
    print_written(html, json);
}

void run_report(const ReportOptions& options) {
    check_record_options(options.records);
    std::vector<fs::path> inputs;
    for (const std::string& input : options.records.inputs) {
        if (!options.thesis.empty()) {
            for (const fs::path& run : runs_in(input)) inputs.push_back(run);
        } else {
            inputs.emplace_back(input);
        }
    }
    if (inputs.size() == 1 && options.thesis.empty() && !is_table(inputs.front())) {
        report_one(options, inputs.front());
    } else {
        report_several(options, inputs);
    }
}

}  // namespace

void add_verb_report(CLI::App& app) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App* const verb = app.add_subcommand(
        "report", "Make the report of a run, or of several compared: one HTML page, to be read offline");
    verb->add_option(
            "results", options->records.inputs,
            "Folders of runs or their results.h5, CSV files of a laboratory; several are compared on one "
            "page")
        ->required()
        ->type_name("RESULTS|CSV");
    verb->add_option(
            "-o,--output", options->output,
            "The page to write (default: report.html beside the results; of several runs "
            "comparison.html or thesis.html in the folder that holds theirs, else here; of a CSV file alone "
            "NAME.html beside it)")
        ->type_name("FILE.html");
    verb->add_option(
            "--json", options->json,
            "Where to write the summary as JSON, SI units (default: summary.json beside report.html, "
            "NAME-summary.json beside another NAME.html)")
        ->type_name("FILE.json");
    verb->add_flag("--thesis{all}", options->thesis,
                   "The figures of the thesis' chapters 4 to 6 and of the paper, from the runs found in the "
                   "given folders (tools/thesis-chapter.sh makes them); --thesis=4, 5, 6, paper: of these "
                   "parts alone");
    add_record_options(*verb, options->records);
    verb->footer(
        "Examples:\n"
        "  riffle report results/my-flume\n"
        "  riffle report results/coarse results/fine -o comparison.html\n"
        "  riffle report results/my-flume --measured profile.csv");
    verb->callback([options] { run_report(*options); });
}

}  // namespace riffle::inline cli
