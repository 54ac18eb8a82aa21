#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline cli {

/// What a command line says of the records that it names: runs, and tables of a laboratory.
struct RecordInput {
    std::vector<std::string> inputs;    ///< folders of runs, results files, CSV files
    std::optional<TimeWindow> window;   ///< unset: that of the run, all of a laboratory record
    std::vector<std::string> measured;  ///< what runs are compared with: profile, cross-section, field
    std::string chapter;                ///< only this one; empty: all
    std::string case_file;              ///< of laboratory records
    std::string calibration;            ///< of their wave probes
    double frequency = 0.0;             ///< Hz, of those without times; 0: not given
};

/// Whether a path names a table of a laboratory, by its ending, or a folder of frames.
[[nodiscard]] bool is_table(const std::filesystem::path& path);

/// Options of how records are read: --window and --measured, and --case, --frequency and --calibration of
/// laboratory records.
void add_record_options(CLI::App& verb, RecordInput& options);

/// Throws InputError where an option is given that concerns none of the inputs.
void check_record_options(const RecordInput& options);

/// The analysis of one of the inputs. Throws what reading it throws.
[[nodiscard]] Analysis analyse_input(const RecordInput& options, const std::string& input);

}  // namespace riffle::inline cli
