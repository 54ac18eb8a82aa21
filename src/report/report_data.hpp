#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/results_file.hpp"
#include "report/field_data.hpp"

namespace riffle {

/// Named columns of equal length, SI; a column that the results file lacks is absent.
using Columns = std::map<std::string, std::vector<double>>;

/// Attributes of a group that are numbers.
using Values = std::map<std::string, double>;

/// What the report shows beside the figures and findings of the analysis, collected from one results file.
/// What the file lacks is empty.
struct ReportData {
    std::filesystem::path source;
    std::string title, riffle_version, build, created;
    bool complete = false;
    Case flow;  ///< the case, from its text in the file
    Values summary, column_summary;
    Values section_summary;  ///< of the section twin, between side walls
    Columns series;
    double window_start = 0, window_end = 0;  ///< averaging window, s; both 0 before there is one
    double profile_samples = 0;
    std::optional<FieldPicture> field;
};

/// Collect the report's data, with a picture of the flow field of these frames. Throws FileError if the
/// file's case is missing or cannot be read.
[[nodiscard]] ReportData collect_report_data(const std::filesystem::path& results,
                                             FieldFrames frames = FieldFrames::all);

/// The value with this name; nothing if absent or not finite.
[[nodiscard]] std::optional<double> find_value(const Values& values, const std::string& name);

/// Whether the column exists and is not empty.
[[nodiscard]] bool has_column(const Columns& columns, const std::string& name);

}  // namespace riffle
