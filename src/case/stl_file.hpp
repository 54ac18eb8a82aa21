#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "case/triangle.hpp"

namespace riffle {

/// Read an STL file, binary or text. FileError names file and triangle, in a text the line: a file that is
/// cut short or of another kind, a number that is none, a facet without three corners, a file too large for
/// the memory.
[[nodiscard]] Triangles read_stl(const std::filesystem::path& file);

/// The same from the content of a file; `name` stands for it in messages.
[[nodiscard]] Triangles parse_stl(std::string_view content, const std::string& name);

}  // namespace riffle
