#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle::inline analysis {

inline constexpr int analysis_json_version = 1;

/// The analyses as one JSON text, described in docs/analysis.md: `format` "riffle-analysis",
/// `format_version`, `riffle_version`, and `analyses`, a list of objects with the members of Analysis,
/// Finding, Figure, Curve, ColourMap and Axis under their names. SI units; values that are not finite are
/// null; numbers of figures keep 9 significant digits, those of maps 6. `indent`: spaces per level, negative:
/// all on one line.
[[nodiscard]] std::string analysis_to_json(const std::vector<Analysis>& analyses, int indent = -1);

/// One figure as JSON, the element of `figures` in the above.
[[nodiscard]] std::string figure_to_json(const Figure& figure, int indent = -1);

/// The word of an origin or a mark in the JSON and CSV files: the enumerator's name.
[[nodiscard]] const char* word(Origin origin);
[[nodiscard]] const char* word(Mark mark);

}  // namespace riffle::inline analysis
