#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline laboratory {

/// A column of a table, as it stands in the file.
struct CsvColumn {
    std::string name;  ///< without its unit; empty in a file without header
    std::string unit;  ///< as written, without brackets; empty: none given
    std::vector<double> values;
};

/// A comment line without its "#", and where it stands.
struct CsvComment {
    int line = 0;
    std::string text;
};

/// A table of numbers with named columns.
struct CsvTable {
    std::filesystem::path path;
    char separator = ',';
    int header_line = 0;  ///< 0: the file has none
    std::vector<CsvColumn> columns;
    std::vector<int> lines;  ///< of each row in the file
    std::vector<CsvComment> comments;
    std::size_t missing = 0;  ///< fields without a value, which are not a number in `values`

    /// Value of a comment "# key: value" or "# key = value"; upper and lower case are the same. None if there
    /// is no such comment.
    [[nodiscard]] std::optional<std::string> comment_value(std::string_view key) const;

    /// "PATH:LINE" of a row, for messages.
    [[nodiscard]] std::string place(std::size_t row) const;

    /// "column 2 (u)" for messages.
    [[nodiscard]] std::string column_name(std::size_t column) const;
};

/// Whether empty fields, "NaN" and "NA" stand for a missing value or are errors.
enum class MissingValues { refused, allowed };

/// Read a CSV file: fields separated by commas, semicolons or tabs (the first row tells which; a tab wins
/// over a semicolon, this over a comma), numbers with a decimal point, "#" comments, empty lines passed over,
/// fields in double quotes where a name needs them. A first row with anything but numbers is the header;
/// names may carry units in brackets: "z [mm]", "u (m/s)". Throws FileError with file, line, column and what
/// was expected where something is not a number, a row has another number of fields, two columns share a
/// name, or there is no number at all.
[[nodiscard]] CsvTable read_csv_table(const std::filesystem::path& path,
                                      MissingValues missing = MissingValues::refused);

/// The same from a text; `path` names it in messages.
[[nodiscard]] CsvTable parse_csv_table(std::string_view text, const std::filesystem::path& path,
                                       MissingValues missing = MissingValues::refused);

/// Values of a column in SI, which must have the dimension of `unit` (an SI unit like "m/s"). A column
/// without unit is taken to be in SI if all units that the file gives are SI units; else, and for a unit that
/// is not understood or measures something else, FileError.
[[nodiscard]] std::vector<double> column_in_si(const CsvTable& table, std::size_t column,
                                               std::string_view unit);

/// The text with its ASCII letters small.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace riffle::inline laboratory
