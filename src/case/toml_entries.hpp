#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace riffle::inline case_file {

/// Where something stands: in a file, or in an option of the command line.
struct Place {
    std::string name;   ///< the file, or the text of the option
    unsigned line = 0;  ///< 0: the file or option as a whole
    unsigned column = 0;
    bool option = false;

    /// "case.toml:7:9" or "--set channel.slope=4".
    [[nodiscard]] std::string text() const;
};

/// A TOML value that no key of a case takes, by its kind: "a table", "an array", "a date or time".
struct OtherValue {
    std::string kind;
};

using RawScalar = std::variant<bool, long long, double, std::string, OtherValue>;

/// An array, for keys that take a list.
struct RawList {
    std::vector<RawScalar> items;
};

using RawValue = std::variant<bool, long long, double, std::string, OtherValue, RawList>;

/// One `key = value` of a case file, before it is looked at.
struct Entry {
    std::string section;  ///< empty before the first section
    std::string key;
    RawValue value;
    Place key_place;
    Place value_place;
    std::size_t item = 0;   ///< which of the sections [[section]] of this name
    bool repeated = false;  ///< under [[section]], not [section]
};

/// A section of a case file, known or not.
struct SectionMention {
    std::string name;
    Place place;
    std::size_t item = 0;   ///< which of the sections [[name]]
    bool repeated = false;  ///< [[name]], not [name]
};

/// The entries and sections of a case file.
struct Document {
    std::vector<Entry> entries;
    std::vector<SectionMention> sections;
};

/// Split TOML text into its entries; `name` stands for the file. Throws InputError with line and column where
/// the text is not TOML.
[[nodiscard]] Document read_toml(const std::string& text, const std::string& name);

/// The value of a `--set` option: TOML, or else the bare text.
[[nodiscard]] RawValue read_option_value(const std::string& text);

/// The same for a key that takes any text: the bare text, if it is UTF-8.
[[nodiscard]] RawValue read_option_text(const std::string& text);

/// A basic TOML string with its quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

}  // namespace riffle::inline case_file
