#pragma once

#include <string>
#include <string_view>

#include "case/height_grid.hpp"

namespace riffle::inline case_file {

/// Heights on a grid from the content of a file; `name` stands for it in messages and says the kind: .asc an
/// ESRI ASCII grid, .tif or .tiff a GeoTIFF, else (.csv, .xyz, .txt) lines of x, y and z in any order on a
/// regular grid, of which some may be missing, with or without a line of names. FileError names the line: a
/// number that is none, counts that do not fit, points off a regular grid or twice at one place, a file
/// without a height.
[[nodiscard]] HeightGrid parse_height_grid(std::string_view content, const std::string& name);

/// Heights along a line: lines of x and z in any order, or an ESRI ASCII grid or GeoTIFF of one row.
[[nodiscard]] HeightLine parse_height_line(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
