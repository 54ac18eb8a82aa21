#include "cli/record_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/chapters.hpp"
#include "analysis/laboratory_record.hpp"
#include "analysis/run_record.hpp"
#include "analysis/window_summary.hpp"
#include "base/error.hpp"
#include "cli/positive_number.hpp"
#include "cli/terminal.hpp"
#include "output/folder_lock.hpp"
#include "output/results_file.hpp"
#include "report/report.hpp"

namespace riffle::inline cli {

namespace {

bool has_table_ending(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".csv" || ending == ".CSV" || ending == ".txt" || ending == ".dat";
}

}  // namespace

bool is_table(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) return has_table_ending(path);
    // A folder without results that holds tables is one of frames.
    if (std::filesystem::exists(path / "results.h5", error)) return false;
    for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
        if (entry.is_regular_file(error) && has_table_ending(entry.path())) return true;
    }
    return false;
}

Analysis analyse_input(const RecordInput& options, const std::string& input) {
    if (is_table(input)) {
        LaboratoryRecordOptions how;
        how.window = options.window;
        how.case_file = options.case_file;
        how.calibration = options.calibration;
        if (options.frequency > 0.0) how.sampling_frequency = options.frequency;
        return analyse(LaboratoryRecord(input, how), options.chapter);
    }
    const std::filesystem::path results = find_results_file(input);
    // All of it before any of it: damage must not turn into numbers.
    ResultsReader(results).verify();
    if (const auto lock = FolderLock::standing(folder_of(results), FolderLock::Work::run);
        lock.holder && results.filename() == "results.h5") {
        print_warning(
            fmt::format("{}: a run is still at work on it (process {}); this is what it has written so far",
                        results.string(), lock.holder->process));
    }
    RunRecordOptions how;
    how.window = options.window;
    how.measured.assign(options.measured.begin(), options.measured.end());
    const RunRecord record(results, how);
    Analysis analysis = analyse(record, options.chapter);
    if (options.window) {
        analysis.asked_window = {record.window().from, record.window().to, window_summary(record)};
    }
    if (!options.measured.empty() && !record.is_compared()) {
        analysis.warnings.emplace_back(
            "nothing of this run is compared with what --measured names: it has no time means of the velocity, or none "
            "in this chapter");
    }
    return analysis;
}

void check_record_options(const RecordInput& options) {
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

void add_record_options(CLI::App& verb, RecordInput& options) {
    verb.add_option_function<std::vector<double>>(
            "--window",
            [&options](const std::vector<double>& ends) {
                options.window = TimeWindow{ends.at(0), ends.at(1)};
            },
            "Analyse this stretch of the record, s (default: the averaging window of the run)")
        ->type_name("FROM,TO")
        ->delimiter(',')
        ->expected(2);
    verb.add_option(
            "--measured", options.measured,
            "What runs are compared with; may be given for each kind: profile (CSV of z above the "
            "datum, u), points of a cross-section (y, z, u), field of velocities (x, z, u, w; file or "
            "folder of frames)")
        ->type_name("FILE.csv")
        ->allow_extra_args(false);
    verb.add_option(
            "--case", options.case_file,
            "Case file of the flow that CSV records were measured in: depth, slope, measured velocity")
        ->type_name("CASE.toml");
    verb.add_option("--frequency", options.frequency, "Sampling frequency of CSV records without times, Hz")
        ->type_name("HZ")
        ->check(positive_number());
    verb.add_option("--calibration", options.calibration,
                    "Calibration of wave probes that recorded voltages: CSV of levels and voltages")
        ->type_name("FILE.csv");
}

}  // namespace riffle::inline cli
