#include "laboratory/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/visible_text.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

namespace {

char separator_of(std::string_view line) {
    for (const char candidate : {'\t', ';'}) {
        if (line.find(candidate) != std::string_view::npos) return candidate;
    }
    return ',';
}

/// Fields of a line; a field may stand in double quotes, in which "" is a quote. None where a quote is not
/// closed.
std::optional<std::vector<std::string>> fields_of(std::string_view line, char separator) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    bool was_quoted = false;
    const auto finish = [&] {
        if (!was_quoted) fields.back() = std::string(trimmed(fields.back()));
        was_quoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted) {
            if (c != '"') {
                fields.back() += c;
            } else if (i + 1 < line.size() && line[i + 1] == '"') {
                fields.back() += '"';
                ++i;
            } else {
                quoted = false;
            }
        } else if (c == '"' && trimmed(fields.back()).empty()) {
            fields.back().clear();
            quoted = was_quoted = true;
        } else if (c == separator) {
            finish();
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    finish();
    if (quoted) return std::nullopt;
    return fields;
}

bool is_missing(std::string_view field) {
    const std::string lower = lower_case(field);
    return lower.empty() || lower == "nan" || lower == "na" || lower == "n/a";
}

/// Name and unit of a heading: the unit stands in the brackets at its end.
CsvColumn heading(std::string_view text) {
    CsvColumn column;
    const std::string_view whole = trimmed(text);
    column.name = std::string(whole);
    if (whole.empty()) return column;
    const char close = whole.back();
    if (close != ']' && close != ')') return column;
    const std::size_t open = whole.rfind(close == ']' ? '[' : '(');
    if (open == std::string_view::npos) return column;
    column.unit = std::string(trimmed(whole.substr(open + 1, whole.size() - open - 2)));
    column.name = std::string(trimmed(whole.substr(0, open)));
    return column;
}

/// Builds a table line by line.
class Reader {
  public:
    Reader(const std::filesystem::path& path, MissingValues missing) : missing_(missing) {
        table_.path = path;
    }

    void take(std::string_view line, int number) {
        line_ = number;
        const std::string_view text = trimmed(line);
        if (text.empty()) return;
        if (text.front() == '#') {
            table_.comments.push_back({number, std::string(trimmed(text.substr(1)))});
            return;
        }
        // The line itself, not the trimmed text: a tab at its end is an empty last field.
        if (!started_) table_.separator = separator_of(line);
        if (table_.separator != '\t') line = text;
        while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.remove_suffix(1);
        const auto fields = fields_of(line, table_.separator);
        if (!fields) fail("expected a closing double quote");
        if (!started_) {
            started_ = true;
            if (take_heading(*fields)) return;
            table_.columns.resize(fields->size());
        }
        take_row(*fields);
    }

    [[nodiscard]] CsvTable finish() {
        if (table_.lines.empty()) {
            throw FileError(fmt::format("{}: expected lines of numbers, found none", table_.path.string()));
        }
        return std::move(table_);
    }

  private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(fmt::format("{}:{}: {}", table_.path.string(), line_, problem));
    }

    bool take_heading(const std::vector<std::string>& fields) {
        const bool all_numbers = std::all_of(fields.begin(), fields.end(), [](const std::string& field) {
            return parse_number(field).has_value() || is_missing(field);
        });
        if (all_numbers) return false;
        table_.header_line = line_;
        for (const std::string& field : fields) {
            CsvColumn column = heading(field);
            if (const auto hidden = hidden_character(field)) {
                fail(
                    fmt::format("the heading of column {} holds the control character {}: remove it; is the "
                                "file a text?",
                                table_.columns.size() + 1, hidden->name));
            }
            if (column.name.empty()) {
                fail(fmt::format("expected a name for column {} in the header", table_.columns.size() + 1));
            }
            for (const CsvColumn& other : table_.columns) {
                if (other.name == column.name) fail(fmt::format("two columns are named \"{}\"", column.name));
            }
            table_.columns.push_back(std::move(column));
        }
        return true;
    }

    void take_row(const std::vector<std::string>& fields) {
        if (fields.size() != table_.columns.size()) {
            fail(fmt::format("expected {} columns as in the lines before, got {}", table_.columns.size(),
                             fields.size()));
        }
        for (std::size_t i = 0; i < fields.size(); ++i) {
            table_.columns[i].values.push_back(value(fields[i], i));
        }
        table_.lines.push_back(line_);
    }

    double value(const std::string& field, std::size_t column) {
        if (is_missing(field)) {
            if (missing_ == MissingValues::refused) {
                fail(fmt::format("expected a number in {}, it is missing", table_.column_name(column)));
            }
            ++table_.missing;
            return std::numeric_limits<double>::quiet_NaN();
        }
        const auto number = parse_number(field);
        if (!number || !std::isfinite(*number)) {
            std::string hint;
            std::string point = field;
            std::replace(point.begin(), point.end(), ',', '.');
            if (parse_number(point)) hint = " (write decimals with a point)";
            if (field.find(' ') != std::string::npos) {
                hint = " (separate columns by commas, semicolons or tabs)";
            }
            fail(fmt::format("expected a number in {}, got \"{}\"{}", table_.column_name(column), field,
                             hint));
        }
        return *number;
    }

    MissingValues missing_;
    CsvTable table_;
    int line_ = 0;
    bool started_ = false;
};

}  // namespace

std::optional<std::string> CsvTable::comment_value(std::string_view key) const {
    const std::string wanted = lower_case(key);
    for (const CsvComment& comment : comments) {
        const std::size_t stop = comment.text.find_first_of(":=");
        if (stop == std::string::npos) continue;
        const std::string_view text = comment.text;
        if (lower_case(trimmed(text.substr(0, stop))) == wanted) {
            return std::string(trimmed(text.substr(stop + 1)));
        }
    }
    return std::nullopt;
}

std::string CsvTable::place(std::size_t row) const {
    return fmt::format("{}:{}", path.string(), lines.at(row));
}

std::string CsvTable::column_name(std::size_t column) const {
    const std::string& name = columns.at(column).name;
    return name.empty() ? fmt::format("column {}", column + 1)
                        : fmt::format("column {} ({})", column + 1, name);
}

CsvTable parse_csv_table(std::string_view text, const std::filesystem::path& path, MissingValues missing) {
    Reader reader(path, missing);
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        reader.take(text.substr(0, end), line);
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return reader.finish();
}

CsvTable read_csv_table(const std::filesystem::path& path, MissingValues missing) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, error)) {
        throw FileError(fmt::format("{}: cannot be read: give an existing CSV file", path.string()));
    }
    std::ostringstream content;
    content << file.rdbuf();
    if (file.bad()) throw FileError(fmt::format("{}: cannot be read to its end", path.string()));
    return parse_csv_table(content.str(), path, missing);
}

std::vector<double> column_in_si(const CsvTable& table, std::size_t column, std::string_view unit) {
    const CsvColumn& from = table.columns.at(column);
    const auto expected = parse_unit(unit);
    const auto fail = [&](const std::string& problem) {
        throw FileError(fmt::format("{}:{}: {}", table.path.string(), table.header_line, problem));
    };
    if (from.unit.empty()) {
        for (const CsvColumn& other : table.columns) {
            const auto given = parse_unit(other.unit);
            if (given && given->is_si()) continue;
            fail(fmt::format("expected a unit for {}, like [{}], since {} has [{}]",
                             table.column_name(column), unit, other.name, other.unit));
        }
        return from.values;
    }
    const auto given = parse_unit(from.unit);
    if (!given || !given->same_dimension(*expected)) {
        fail(fmt::format("expected a unit like [{}] for {}, got [{}]", unit, table.column_name(column),
                         from.unit));
    }
    std::vector<double> result = from.values;
    for (double& value : result) value = given->to_si(value);
    return result;
}

}  // namespace riffle::inline laboratory
