#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle {

/// The curves of a figure as CSV, one line per point: `curve,run,origin,<x axis> [unit],<y axis> [unit]`,
/// then the half-widths of the 95 % intervals of x and y where a curve has them. Comment lines (#) before the
/// heading name the figure, its source and its caption. SI, 9 significant digits; a value that is not finite
/// is an empty cell. Empty if the figure has no curves.
[[nodiscard]] std::string curves_to_csv(const Figure& figure);

/// A map of a figure as CSV, one line per value: `<x axis> [unit],<y axis> [unit],<label> [unit]`.
[[nodiscard]] std::string map_to_csv(const Figure& figure, const ColourMap& map);

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

}  // namespace riffle
