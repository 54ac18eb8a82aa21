#pragma once

#include <filesystem>
#include <string>

#include "analysis/figure.hpp"
#include "report/comparison.hpp"

namespace riffle::inline report {

/// The report of a run as one HTML page that needs nothing beside itself. `results` is the results file,
/// `analysis` gives the page its chapters. Throws FileError if the file cannot be read.
[[nodiscard]] std::string report_html(const std::filesystem::path& results, const Analysis& analysis = {});

/// The report's summary for machines: JSON in SI units, described in docs/results-format.md.
[[nodiscard]] std::string report_summary_json(const std::filesystem::path& results,
                                              const Analysis& analysis = {});

/// The page of a comparison.
[[nodiscard]] std::string comparison_html(const Comparison& comparison);

/// The results file that `path` means: itself, or results.h5 in it if it is a folder. Throws FileError if
/// there is none.
[[nodiscard]] std::filesystem::path find_results_file(const std::filesystem::path& path);

/// Where the summary of a page lies: summary.json beside report.html, NAME-summary.json beside another
/// NAME.html; nowhere beside a device.
[[nodiscard]] std::filesystem::path summary_beside(const std::filesystem::path& html);

/// Write the report to `html` and, unless `json` is empty, its summary to `json`, each in one atomic step.
/// Throws FileError if the results cannot be read or a file cannot be written.
void write_report(const std::filesystem::path& results, const std::filesystem::path& html,
                  const std::filesystem::path& json = {}, const Analysis& analysis = {});

/// The same for a comparison.
void write_comparison(const Comparison& comparison, const std::filesystem::path& html,
                      const std::filesystem::path& json = {});

}  // namespace riffle::inline report
