#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle::inline analysis {

/// The curves of a figure as CSV, one line per point: `curve,run,origin,<x axis> [unit],<y axis> [unit]`,
/// then the half-widths of the 95 % intervals of x and y where a curve has them. Comment lines (#) before the
/// heading name the figure, its source and its caption. SI, 9 significant digits; a value that is not finite
/// is an empty cell. Empty if the figure has no curves.
[[nodiscard]] std::string curves_to_csv(const Figure& figure);

/// A map of a figure as CSV, one line per value: `<x axis> [unit],<y axis> [unit],<label> [unit]`.
[[nodiscard]] std::string map_to_csv(const Figure& figure, const ColourMap& map);

/// Name and heading of the table of findings.
inline constexpr std::string_view findings_file = "findings.csv";
inline constexpr std::string_view findings_heading =
    "run,chapter,key,label,value,half_width,reference,reference_name,unit,remark";

/// Findings as CSV, one line each: name of the analysis, chapter, key, label, value, half-width, reference,
/// name of the reference, unit, remark.
[[nodiscard]] std::string findings_to_csv(const std::vector<Analysis>& analyses);

/// A text file to be written.
struct CsvFile {
    std::string name;  ///< e.g. "velocity_profile.csv"
    std::string content;
};

/// The files of a figure: KEY.csv with the curves, KEY_map.csv (KEY_map_2.csv ...) with the maps. None for a
/// figure that has nothing to draw.
[[nodiscard]] std::vector<CsvFile> figure_to_csv(const Figure& figure);

/// Whether an analysis, or the named chapter of it, may write a table of a figure under this name.
[[nodiscard]] bool is_figure_csv_name(std::string_view name, std::string_view chapter = {});

/// Whether a file begins like a table of findings or of a figure, whichever it is of.
[[nodiscard]] bool begins_like_analysis_csv(std::istream& file);

}  // namespace riffle::inline analysis
