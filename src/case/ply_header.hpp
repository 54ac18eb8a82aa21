#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline case_file {

/// How the numbers behind the header of a PLY file are written.
enum class PlyFormat { text, little_endian, big_endian };

/// Types of numbers of PLY files, by the bytes that they take.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t bytes_of(PlyType type);
[[nodiscard]] bool is_whole(PlyType type);

/// A number of each row of an element, or a list of them.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  ///< of a list: of its items
    bool list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list: of the number of its items
};

/// A table of a PLY file.
struct PlyElement {
    std::string name;
    std::size_t count = 0;  ///< rows
    std::vector<PlyProperty> properties;

    /// Place of a property in a row; properties.size() without it.
    [[nodiscard]] std::size_t find(std::string_view property) const;
    /// Least bytes that a row takes.
    [[nodiscard]] std::size_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< of the header
    std::size_t lines = 0;  ///< of the header
};

/// The header of a PLY file. FileError names the line, what was expected and what to do; elements with more
/// rows than the file has bytes for are a fault.
[[nodiscard]] PlyHeader parse_ply_header(std::string_view content, const std::string& name);

}  // namespace riffle::inline case_file
