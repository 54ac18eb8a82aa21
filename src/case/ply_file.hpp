#pragma once

#include <string>
#include <string_view>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Triangles of a PLY file, text or binary of either byte order, from its content; `name` stands for it in
/// messages. Faces of more than three corners are cut into triangles; other elements and properties are
/// passed over. FileError says where: a header that is none, counts that the file cannot hold, a corner that
/// it does not hold, a number that is none, a face of fewer than three corners or that crosses itself.
[[nodiscard]] Triangles parse_ply(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
