#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace riffle::test {

/// Write the STL file of an upright box, m.
inline void write_stl_box(const std::filesystem::path& path, const std::array<double, 3>& low,
                          const std::array<double, 3>& high) {
    const auto corner = [&](int n) {
        std::string text;
        for (std::size_t k = 0; k < 3; ++k) {
            text += " " + std::to_string((n >> k & 1) != 0 ? high[k] : low[k]);
        }
        return text;
    };
    // The corners of the faces against the clock as seen from outside; bit k of a corner: the upper side of
    // axis k.
    const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    std::ofstream file(path);
    file << "solid box\n";
    for (const auto& face : faces) {
        for (const int second : {1, 2}) {
            file << "facet normal 0 0 0\nouter loop\nvertex" << corner(face[0]) << "\nvertex"
                 << corner(face[second]) << "\nvertex" << corner(face[second + 1]) << "\nendloop\nendfacet\n";
        }
    }
    file << "endsolid box\n";
}

}  // namespace riffle::test
