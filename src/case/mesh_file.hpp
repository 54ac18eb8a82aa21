#pragma once

#include <filesystem>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Read the triangles of an STL, OBJ or PLY file, by its ending; a file with another ending is taken for an
/// STL file. FileError names file and place: a file that is cut short or of another kind, a number that is
/// none, a file too large for the memory; see parse_stl(), parse_obj() and parse_ply().
[[nodiscard]] Triangles read_mesh(const std::filesystem::path& file);

}  // namespace riffle::inline case_file
