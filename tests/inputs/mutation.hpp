#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace riffle::inputs {

/// What kind of file an input is.
enum class Kind { case_file, csv, stl };

/// Changes right inputs into others, most of them wrong: bytes, lines, numbers, keys, triangles. The same
/// seed gives the same inputs on every machine.
class Mutator {
  public:
    Mutator(Kind kind, std::vector<std::string> seeds, std::uint64_t seed);
    /// The next input.
    [[nodiscard]] std::string next();
    /// One of the changes to a text, at most so long afterwards.
    void change(std::string& text, std::size_t longest);

  private:
    [[nodiscard]] std::size_t below(std::size_t n) { return n == 0 ? 0 : generator_() % n; }
    template <class T>
    [[nodiscard]] const T& one_of(const std::vector<T>& list) {
        return list[below(list.size())];
    }
    void change_bytes(std::string& text);
    void change_lines(std::string& text);
    void change_number(std::string& text);
    void change_key(std::string& text);
    void change_triangles(std::string& text);
    void repeat_something(std::string& text);
    [[nodiscard]] std::string value_of_any_kind();

    Kind kind_;
    std::vector<std::string> seeds_;
    std::mt19937_64 generator_;
};

/// Surfaces to begin with: boxes as text and binary, two shells that overlap, a hollow.
[[nodiscard]] std::vector<std::string> stl_seeds();

}  // namespace riffle::inputs
