#pragma once

#include <string>
#include <string_view>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Triangles of a Wavefront OBJ file from its content; `name` stands for it in messages. Faces of more than
/// three corners are cut into triangles; textures, normals, groups, lines and points are passed over.
/// FileError names the line: a number that is none, a corner that the file does not hold, a face of fewer
/// than three corners or that crosses itself, curves and curved surfaces, a file without a face.
[[nodiscard]] Triangles parse_obj(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
