#pragma once

#include <string>
#include <string_view>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Triangles of an STL file, binary or text, from its content; `name` stands for it in messages. FileError
/// names file and triangle, in a text the line: a file that is cut short or of another kind, a number that is
/// none, a facet without three corners.
[[nodiscard]] Triangles parse_stl(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
