#pragma once

#include <filesystem>
#include <string>

namespace riffle {

/// The report of a run as one HTML page that needs nothing beside itself. `results` is the results file.
/// Throws FileError if it cannot be read.
[[nodiscard]] std::string report_html(const std::filesystem::path& results);

/// The report's summary for machines: JSON in SI units, described in docs/results-format.md.
[[nodiscard]] std::string report_summary_json(const std::filesystem::path& results);

/// The results file that `path` means: itself, or results.h5 in it if it is a folder. Throws FileError if
/// there is none.
[[nodiscard]] std::filesystem::path find_results_file(const std::filesystem::path& path);

/// Write the report to `html` and, unless `json` is empty, its summary to `json`, each in one atomic step.
/// Throws FileError if the results cannot be read or a file cannot be written.
void write_report(const std::filesystem::path& results, const std::filesystem::path& html,
                  const std::filesystem::path& json = {});

}  // namespace riffle
