#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline case_file {

/// The lines of a text file of numbers, with the words of each; faults name file and line.
class TextLines {
  public:
    /// `name` stands for the file in messages. `separators`: what stands between words beside blanks.
    TextLines(std::string_view content, std::string name, std::string_view separators = "");

    /// Go to the next line that holds a word; false at the end of the file.
    bool next();
    [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
    /// The number of the line, from 1.
    [[nodiscard]] std::size_t line() const { return line_; }
    /// Bytes behind the line.
    [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }
    /// What stands behind the line.
    [[nodiscard]] std::string_view rest() const { return rest_; }

    /// Throws FileError "file:line: what".
    [[noreturn]] void fault(const std::string& what) const;
    /// A finite number; a fault where the word is none. `expected`: what should stand there, for the message.
    [[nodiscard]] double number(std::string_view word, std::string_view expected) const;
    /// A whole number.
    [[nodiscard]] long long integer(std::string_view word, std::string_view expected) const;

  private:
    std::string_view rest_;
    std::string name_;
    std::string_view separators_;
    std::vector<std::string_view> words_;
    std::size_t line_ = 0;
};

/// A word of a file for messages, shortened and without control characters.
[[nodiscard]] std::string shown_word(std::string_view word);

/// A word without the plus sign of a number, which std::from_chars does not take.
[[nodiscard]] std::string_view without_plus(std::string_view word);

/// The number that a word holds; NaN and infinities where it spells them. False where it holds none, or one
/// beyond the range of doubles.
[[nodiscard]] bool read_number(std::string_view word, double& value);

/// The content of a file of data that belongs to a case, `kind` of file for messages ("STL file"). FileError
/// where it is none, cannot be read, or is larger than a share of the free memory: `memory_per_byte` of it
/// are needed for each byte.
[[nodiscard]] std::string data_file_content(const std::string& file, std::string_view kind,
                                            double memory_per_byte);

}  // namespace riffle::inline case_file
