#include "case/mesh_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "base/error.hpp"
#include "case/obj_file.hpp"
#include "case/ply_file.hpp"
#include "case/stl_file.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

Triangles read_mesh(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::string name = file.string();
    // Beside the file: its triangles, their edges and corners, and the tree that finds them again. Shared
    // corners make the other kinds shorter.
    const bool shared = ending == ".obj" || ending == ".ply";
    const std::string content = data_file_content(name,
                                                  ending == ".obj"   ? "OBJ file"
                                                  : ending == ".ply" ? "PLY file"
                                                                     : "STL file",
                                                  shared ? 25.0 : 7.0);
    if (ending == ".obj") return parse_obj(content, name);
    if (ending == ".ply") return parse_ply(content, name);
    try {
        return parse_stl(content, name);
    } catch (const FileError& e) {
        if (ending == ".stl") throw;
        throw FileError(std::string(e.what()) +
                        " (a file is read by its ending: .stl, .obj or .ply; this one was taken for STL)");
    }
}

}  // namespace riffle::inline case_file
