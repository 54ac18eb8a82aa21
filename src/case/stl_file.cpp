// STL files: triangles without a unit. Binary: 80 bytes, a count, 50 bytes for each triangle (normal, three
// corners, two spare bytes). Text: "solid", then "facet ... vertex x y z" three times ... "endfacet", and so
// on until "endsolid"; several of these may follow each other.

#include "case/stl_file.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <system_error>

#include "base/error.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL files are little-endian");

constexpr std::size_t header = 84;
constexpr std::size_t record = 50;

/// Words of a text, with the line that each stands on.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : rest_(text) {}

    /// The next word; empty at the end.
    std::string_view next() {
        std::size_t begin = 0;
        for (; begin < rest_.size() && is_blank(rest_[begin]); ++begin) {
            line_ += rest_[begin] == '\n' ? 1U : 0U;
        }
        std::size_t end = begin;
        while (end < rest_.size() && !is_blank(rest_[end])) ++end;
        const std::string_view word = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return word;
    }
    void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
    [[nodiscard]] std::size_t line() const { return line_; }

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    std::string_view rest_;
    std::size_t line_ = 1;
};

class TextReader {
  public:
    TextReader(std::string_view content, const std::string& name) : words_(content), name_(name) {}

    Triangles read() {
        bool in_solid = false;
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (!in_solid) {
                if (word != "solid") {
                    fault(
                        fmt::format("expected `solid` or the end of the file, found `{}`", shown_word(word)));
                }
                words_.skip_line();  // a name of any words
                in_solid = true;
            } else if (word == "facet") {
                read_facet();
            } else if (word == "endsolid") {
                words_.skip_line();
                in_solid = false;
            } else {
                fault(fmt::format("expected `facet` or `endsolid`, found `{}`", shown_word(word)));
            }
        }
        if (in_solid) fault("cut short: `endsolid` is missing");
        return std::move(triangles_);
    }

  private:
    [[noreturn]] void fault(const std::string& what) const {
        throw FileError(fmt::format("{}:{}: {}", name_, words_.line(), what));
    }
    [[noreturn]] void facet_fault(const std::string& what) const {
        fault(fmt::format("triangle {}: {}", triangles_.size() + 1, what));
    }

    void read_facet() {
        Triangle t{};
        std::size_t corners = 0;
        for (std::string_view word = words_.next(); word != "endfacet"; word = words_.next()) {
            if (word.empty()) facet_fault("cut short: `endfacet` is missing");
            if (word == "facet" || word == "endsolid") {
                facet_fault(fmt::format("expected `endfacet`, found `{}`", word));
            }
            if (word != "vertex") {
                continue;  // "normal", its numbers, "outer loop", "endloop"
            }
            if (corners == 3) facet_fault("expected three lines `vertex x y z`, found more");
            for (double& x : t[corners]) x = number(words_.next());
            ++corners;
        }
        if (corners != 3) {
            facet_fault(fmt::format("has {} corners instead of 3", corners));
        }
        triangles_.push_back(t);
    }

    [[nodiscard]] double number(std::string_view word) const {
        const std::string_view digits = without_plus(word);
        double value = 0.0;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (end != digits.data() + digits.size() || status == std::errc::invalid_argument || digits.empty()) {
            facet_fault(fmt::format("expected `vertex` and three numbers, found `{}`", shown_word(word)));
        }
        if (status == std::errc::result_out_of_range) {
            facet_fault(fmt::format("the number {} is too large or too small", shown_word(word)));
        }
        return value;
    }

    WordReader words_;
    const std::string& name_;
    Triangles triangles_;
};

Triangles read_binary(std::string_view content, std::size_t count) {
    Triangles triangles(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 9> numbers{};
        std::memcpy(numbers.data(), content.data() + header + record * i + 12, sizeof numbers);
        for (std::size_t k = 0; k < 9; ++k) triangles[i][k / 3][k % 3] = static_cast<double>(numbers[k]);
    }
    return triangles;
}

/// Whether a file that begins with "solid" is a text: some programs begin binary files so, too.
bool is_text(std::string_view content) {
    return content.starts_with("solid") && content.find('\0') == std::string_view::npos;
}

}  // namespace

Triangles parse_stl(std::string_view content, const std::string& name) {
    std::uint32_t count = 0;
    if (content.size() >= header) std::memcpy(&count, content.data() + 80, sizeof count);
    const std::size_t announced = header + record * static_cast<std::size_t>(count);
    const bool binary = content.size() == announced;
    if (!binary && is_text(content)) {
        Triangles triangles = TextReader(content, name).read();
        if (triangles.empty()) {
            throw FileError(fmt::format("{}: holds no triangle: give the closed surface of a body", name));
        }
        return triangles;
    }
    if (content.size() < header) {
        throw FileError(
            fmt::format("{}: not an STL file: shorter than the head of one and without \"solid\"", name));
    }
    if (!binary) {
        throw FileError(
            fmt::format("{}: not an STL file, or {}: it announces {} triangles, {} bytes, and "
                        "has {}; write it anew",
                        name, content.size() < announced ? "cut short" : "with something behind it", count,
                        announced, content.size()));
    }
    if (count == 0) {
        throw FileError(fmt::format("{}: holds no triangle: give the closed surface of a body", name));
    }
    return read_binary(content, count);
}

}  // namespace riffle::inline case_file
