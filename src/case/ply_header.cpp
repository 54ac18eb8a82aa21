#include "case/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

struct PlyTypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<PlyTypeName, 16> ply_types{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class PlyHeaderReader {
  public:
    PlyHeaderReader(std::string_view content, const std::string& name)
        : lines_(content, name), size_(content.size()) {}

    PlyHeader read() {
        if (!lines_.next() || lines_.words().front() != "ply") {
            lines_.fault("expected `ply` in the first line: not a PLY file");
        }
        bool has_format = false;
        for (;;) {
            if (!lines_.next()) lines_.fault("cut short: `end_header` is missing");
            const auto& words = lines_.words();
            if (words[0] == "end_header") break;
            if (words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "format") {
                read_format();
                has_format = true;
            } else if (words[0] == "element") {
                add_element();
            } else if (words[0] == "property") {
                add_property();
            } else {
                lines_.fault(fmt::format(
                    "expected `format`, `element`, `property`, `comment` or `end_header`, found `{}`",
                    shown_word(words[0])));
            }
        }
        if (!has_format) {
            lines_.fault(
                "a line `format ascii 1.0`, or binary_little_endian or binary_big_endian, is missing");
        }
        header_.bytes = size_ - lines_.bytes_left();
        header_.lines = lines_.line();
        check_counts();
        return std::move(header_);
    }

  private:
    void read_format() {
        static constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian",
                                                                 "binary_big_endian"};
        const auto& words = lines_.words();
        const auto* const found =
            words.size() == 3 ? std::find(formats.begin(), formats.end(), words[1]) : formats.end();
        if (found == formats.end() || words[2] != "1.0") {
            lines_.fault("expected `format`, then ascii, binary_little_endian or binary_big_endian, and 1.0");
        }
        header_.format = static_cast<PlyFormat>(found - formats.begin());
    }

    void add_element() {
        const auto& words = lines_.words();
        constexpr std::string_view expected = "`element`, its name and the number of its rows";
        if (words.size() != 3) {
            lines_.fault(fmt::format("expected {}", expected));
        }
        const long long count = lines_.integer(words[2], expected);
        if (count < 0) {
            lines_.fault(fmt::format("expected {}, found {} rows", expected, count));
        }
        header_.elements.push_back({std::string(words[1]), static_cast<std::size_t>(count), {}});
    }

    [[nodiscard]] PlyType type_of(std::string_view word) const {
        const auto* const found = std::find_if(ply_types.begin(), ply_types.end(),
                                               [&](const PlyTypeName& t) { return t.name == word; });
        if (found == ply_types.end()) {
            lines_.fault(
                fmt::format("expected a type of numbers (char, uchar, short, ushort, int, uint, "
                            "float, double), found `{}`",
                            shown_word(word)));
        }
        return found->type;
    }

    void add_property() {
        const auto& words = lines_.words();
        const bool list = words.size() > 1 && words[1] == "list";
        if (header_.elements.empty() || words.size() != (list ? 5U : 3U)) {
            lines_.fault("expected `property TYPE NAME` or `property list TYPE TYPE NAME` behind an element");
        }
        PlyProperty property{std::string(words.back()), type_of(words[list ? 3 : 1]), list};
        if (list) {
            property.count_type = type_of(words[2]);
            if (!is_whole(property.count_type)) {
                lines_.fault("the number of items of a list must be of a whole type, such as uchar");
            }
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    /// A file cannot hold more rows than bytes: nothing is laid out for rows that are not there.
    void check_counts() const {
        std::size_t left = lines_.bytes_left();
        for (const PlyElement& element : header_.elements) {
            const std::size_t least = element.least_bytes(header_.format);
            if (element.count > 0 && element.properties.empty()) {
                lines_.fault(
                    fmt::format("the element `{}` has rows without a property", shown_word(element.name)));
            }
            // The last line of a text may end without a break.
            if (element.count > (left + 1) / std::max<std::size_t>(least, 1)) {
                lines_.fault(fmt::format(
                    "cut short: {} rows of `{}` are announced, at least {} bytes each, and {} bytes are left",
                    element.count, shown_word(element.name), least, left));
            }
            left -= std::min(left, element.count * least);
        }
    }

    TextLines lines_;
    std::size_t size_ = 0;
    PlyHeader header_;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
    static constexpr std::array<std::size_t, 8> bytes{1, 1, 2, 2, 4, 4, 4, 8};
    return bytes[static_cast<std::size_t>(type)];
}

bool is_whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

std::size_t PlyElement::find(std::string_view property) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const PlyProperty& p) { return p.name == property; });
    return static_cast<std::size_t>(found - properties.begin());
}

std::size_t PlyElement::least_bytes(PlyFormat format) const {
    std::size_t sum = 0;
    for (const PlyProperty& property : properties) {
        // In a text at least a digit and what parts it from the next.
        sum += format == PlyFormat::text ? 2 : bytes_of(property.list ? property.count_type : property.type);
    }
    return sum;
}

PlyHeader parse_ply_header(std::string_view content, const std::string& name) {
    return PlyHeaderReader(content, name).read();
}

}  // namespace riffle::inline case_file
