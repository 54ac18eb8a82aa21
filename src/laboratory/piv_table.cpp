// Text exports of image velocimetry as tables: OpenPIV's and DaVis' headings stand in comments, and columns
// may be separated by blanks.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "base/error.hpp"
#include "laboratory/unit.hpp"
#include "laboratory/velocity_field.hpp"

namespace riffle::inline laboratory {

namespace {

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

std::vector<std::string> quoted_in(std::string_view text) {
    std::vector<std::string> quoted;
    for (std::size_t open = text.find('"'); open != std::string_view::npos;) {
        const std::size_t close = text.find('"', open + 1);
        if (close == std::string_view::npos) break;
        quoted.emplace_back(text.substr(open + 1, close - open - 1));
        open = text.find('"', close + 1);
    }
    return quoted;
}

bool is_davis(std::string_view comment) { return trimmed(comment).substr(0, 5) == "DaVis"; }

/// The heading that DaVis' first line stands for: its quoted texts are name and unit of x, y and the
/// velocity.
std::string davis_heading(std::string_view comment, const std::filesystem::path& path, int line) {
    const std::vector<std::string> quoted = quoted_in(comment);
    constexpr std::size_t names_and_units = 6;
    if (quoted.size() < names_and_units) {
        throw FileError(fmt::format(
            "{}:{}: expected DaVis' line with the units in quotes, like #DaVis 8.4 2D-vector 16 80 60 "
            "\"x\" \"mm\" \"y\" \"mm\" \"velocity\" \"m/s\"",
            path.string(), line));
    }
    return fmt::format("x [{}]\ty [{}]\tu [{}]\tv [{}]", quoted[1], quoted[3], quoted[5], quoted[5]);
}

/// Whether a comment is the heading of OpenPIV.
bool is_openpiv(std::string_view comment) {
    const std::vector<std::string> words = words_of(comment);
    return words.size() >= 4 && words[0] == "x" && words[1] == "y" && words[2] == "u" && words[3] == "v";
}

/// A line of columns between blanks with tabs between them instead.
std::string with_tabs(std::string_view line) {
    std::string result;
    for (const std::string& word : words_of(line)) result += (result.empty() ? "" : "\t") + word;
    return result;
}

class Rewriter {
  public:
    explicit Rewriter(const std::filesystem::path& path) : path_(path) {}

    /// The line as the table's reader takes it; lines keep their numbers.
    std::string take(std::string_view line, int number) {
        const std::string_view text = trimmed(line);
        if (text.empty()) return {};
        if (text.front() == '#') {
            const std::string_view comment = text.substr(1);
            if (!headed_ && is_davis(comment)) {
                headed_ = davis_ = true;
                return davis_heading(comment, path_, number);
            }
            if (!headed_ && is_openpiv(comment)) {
                headed_ = true;
                return with_tabs(comment);
            }
            return std::string(line);
        }
        if (!started_) {
            started_ = true;
            between_blanks_ = text.find_first_of(";\t") == std::string_view::npos &&
                              (davis_ || text.find(',') == std::string_view::npos) &&
                              words_of(text).size() > 1;
        }
        std::string result = between_blanks_ ? with_tabs(text) : std::string(line);
        // DaVis writes decimals as the language of its computer has them.
        if (davis_) std::replace(result.begin(), result.end(), ',', '.');
        if (davis_) std::replace(result.begin(), result.end(), ';', '\t');
        return result;
    }

    [[nodiscard]] bool davis() const { return davis_; }

  private:
    const std::filesystem::path& path_;
    bool headed_ = false;
    bool davis_ = false;
    bool started_ = false;
    bool between_blanks_ = false;
};

}  // namespace

CsvTable read_field_table(const std::filesystem::path& path) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, error)) {
        throw FileError(fmt::format("{}: cannot be read: give an existing file", path.string()));
    }
    std::string text;
    Rewriter rewriter(path);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (++number == 1 && line.rfind(byte_order_mark, 0) == 0) line.erase(0, byte_order_mark.size());
        text += rewriter.take(line, number) + "\n";
    }
    if (file.bad()) throw FileError(fmt::format("{}: cannot be read to its end", path.string()));
    CsvTable table = parse_csv_table(text, path, MissingValues::allowed);
    if (rewriter.davis()) table.comments.push_back({0, "zero vectors: missing"});
    return table;
}

}  // namespace riffle::inline laboratory
