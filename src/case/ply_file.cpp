#include "case/ply_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "case/ply_header.hpp"
#include "case/polygon.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

/// A row of an element: its numbers, of a list its items.
using PlyRow = std::vector<std::vector<double>>;

/// Rows of a text, one a line.
class PlyTextRows {
  public:
    PlyTextRows(std::string_view content, const std::string& name, std::size_t lines_before)
        : lines_(content, name), before_(lines_before), name_(name) {}

    void read(const PlyElement& element, PlyRow& row) {
        if (!lines_.next()) {
            fault(fmt::format("cut short: expected a row of `{}`", shown_word(element.name)));
        }
        std::size_t word = 0;
        const auto next = [&] {
            if (word == lines_.words().size()) {
                fault(fmt::format("a row of `{}` holds {} numbers: expected more", shown_word(element.name),
                                  word));
            }
            double value = 0.0;
            const std::string_view text = lines_.words()[word++];
            if (!read_number(text, value)) {
                fault(fmt::format("expected a number of a row of `{}`, found `{}`", shown_word(element.name),
                                  shown_word(text)));
            }
            return value;
        };
        row.resize(element.properties.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i].clear();
            double items = 1.0;
            if (element.properties[i].list) {
                items = next();
                if (!(items >= 0.0 && items <= static_cast<double>(lines_.words().size() - word))) {
                    fault(fmt::format("a list of `{}` announces {} items, and {} follow",
                                      shown_word(element.name), items, lines_.words().size() - word));
                }
            }
            for (std::size_t item = 0; item < static_cast<std::size_t>(items); ++item) {
                row[i].push_back(next());
            }
        }
        if (word != lines_.words().size()) {
            fault(fmt::format("a row of `{}` holds {} numbers: expected {}", shown_word(element.name),
                              lines_.words().size(), word));
        }
    }

    [[nodiscard]] bool ends() { return !lines_.next(); }

    [[noreturn]] void fault(const std::string& what) const {
        throw FileError(fmt::format("{}:{}: {}", name_, before_ + lines_.line(), what));
    }

  private:
    TextLines lines_;
    std::size_t before_ = 0;
    std::string name_;
};

/// Rows of binary numbers.
class PlyBinaryRows {
  public:
    PlyBinaryRows(std::string_view content, std::string name, std::size_t before, PlyFormat format)
        : rest_(content),
          size_(content.size()),
          before_(before),
          name_(std::move(name)),
          swap_((format == PlyFormat::big_endian) != (std::endian::native == std::endian::big)) {}

    void read(const PlyElement& element, PlyRow& row) {
        row.resize(element.properties.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            const double items = property.list ? number(property.count_type) : 1.0;
            const std::size_t left = rest_.size() / bytes_of(property.type);
            const auto room = static_cast<double>(left);
            if (!(items >= 0.0 && items <= room)) {
                fault(fmt::format("cut short: a row of `{}` needs {} numbers, and there is room for {}",
                                  shown_word(element.name), items, room));
            }
            row[i].clear();
            for (std::size_t item = 0; item < static_cast<std::size_t>(items); ++item) {
                row[i].push_back(number(property.type));
            }
        }
    }

    [[nodiscard]] bool ends() const { return rest_.empty(); }

    [[noreturn]] void fault(const std::string& what) const {
        throw FileError(fmt::format("{}: byte {}: {}", name_, before_ + size_ - rest_.size(), what));
    }

  private:
    template <class T>
    double as_number(const std::array<char, 8>& bytes) const {
        T value{};
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }

    double number(PlyType type) {
        const std::size_t count = bytes_of(type);
        if (rest_.size() < count) fault("cut short: expected another number");
        std::array<char, 8> bytes{};
        std::copy_n(rest_.begin(), count, bytes.begin());
        if (swap_) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
        rest_.remove_prefix(count);
        switch (type) {
            case PlyType::int8:
                return as_number<std::int8_t>(bytes);
            case PlyType::uint8:
                return as_number<std::uint8_t>(bytes);
            case PlyType::int16:
                return as_number<std::int16_t>(bytes);
            case PlyType::uint16:
                return as_number<std::uint16_t>(bytes);
            case PlyType::int32:
                return as_number<std::int32_t>(bytes);
            case PlyType::uint32:
                return as_number<std::uint32_t>(bytes);
            case PlyType::float32:
                return as_number<float>(bytes);
            case PlyType::float64:
                return as_number<double>(bytes);
        }
        return 0.0;
    }

    std::string_view rest_;
    std::size_t size_ = 0;
    std::size_t before_ = 0;
    std::string name_;
    bool swap_ = false;
};

/// Puts the triangles together from the rows of vertices and faces.
class PlySurface {
  public:
    explicit PlySurface(const PlyHeader& header) : header_(header) {}

    template <class Rows>
    Triangles read(Rows& rows, const std::string& name) {
        bool has_vertices = false;
        PlyRow row;
        for (const PlyElement& element : header_.elements) {
            const bool vertices = element.name == "vertex";
            const bool faces = element.name == "face";
            const std::array<std::size_t, 3> places{element.find("x"), element.find("y"), element.find("z")};
            const std::size_t list = std::min(element.find("vertex_indices"), element.find("vertex_index"));
            const std::size_t none = element.properties.size();
            if (vertices && *std::max_element(places.begin(), places.end()) == none) {
                throw FileError(fmt::format("{}: its vertices have no x, y and z: not a surface", name));
            }
            if (faces && (list == none || !element.properties[list].list)) {
                throw FileError(
                    fmt::format("{}: its faces have no list vertex_indices: not a surface", name));
            }
            if (faces && !has_vertices) {
                throw FileError(fmt::format("{}: its faces stand before its vertices; write it anew", name));
            }
            for (std::size_t i = 0; i < element.count; ++i) {
                rows.read(element, row);
                if (vertices) {
                    if (std::any_of(places.begin(), places.end(),
                                    [&](std::size_t place) { return row[place].size() != 1; })) {
                        rows.fault("x, y and z of a vertex must be numbers, not lists");
                    }
                    corners_.push_back({row[places[0]][0], row[places[1]][0], row[places[2]][0]});
                } else if (faces) {
                    add_face(rows, i, row[list]);
                }
            }
            has_vertices = has_vertices || vertices;
        }
        if (!rows.ends()) {
            rows.fault("something follows behind the rows that the header announces; write the file anew");
        }
        if (triangles_.empty()) {
            throw FileError(fmt::format("{}: holds no face: give the closed surface of a body", name));
        }
        return std::move(triangles_);
    }

  private:
    template <class Rows>
    void add_face(const Rows& rows, std::size_t number, const std::vector<double>& indices) {
        constexpr std::size_t most = 1000;
        if (indices.size() < 3 || indices.size() > most) {
            rows.fault(fmt::format("face {} has {} corners: expected 3 to {}", number, indices.size(), most));
        }
        std::vector<Point3> face;
        for (const double index : indices) {
            if (!(index >= 0.0 && index < static_cast<double>(corners_.size())) ||
                index != std::floor(index)) {
                rows.fault(
                    fmt::format("face {} names vertex {:g}: expected one of the {} from 0 on; the "
                                "file is damaged, write it anew",
                                number, index, corners_.size()));
            }
            face.push_back(corners_[static_cast<std::size_t>(index)]);
        }
        if (face.size() == 3) {
            triangles_.push_back({face[0], face[1], face[2]});
            return;
        }
        const auto parts = polygon_triangles(face);
        if (parts.empty()) {
            rows.fault(
                fmt::format("face {} crosses itself or has no area: mend it, or write triangles", number));
        }
        for (const auto& part : parts) {
            triangles_.push_back({face[part[0]], face[part[1]], face[part[2]]});
        }
    }

    const PlyHeader& header_;
    std::vector<Point3> corners_;
    Triangles triangles_;
};

}  // namespace

Triangles parse_ply(std::string_view content, const std::string& name) {
    const PlyHeader header = parse_ply_header(content, name);
    const std::string_view body = content.substr(header.bytes);
    PlySurface surface(header);
    if (header.format == PlyFormat::text) {
        PlyTextRows rows(body, name, header.lines);
        return surface.read(rows, name);
    }
    PlyBinaryRows rows(body, name, header.bytes, header.format);
    return surface.read(rows, name);
}

}  // namespace riffle::inline case_file
