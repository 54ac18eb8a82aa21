#include "case/text_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/machine.hpp"
#include "base/notice.hpp"
#include "base/visible_text.hpp"

namespace riffle::inline case_file {

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

TextLines::TextLines(std::string_view content, std::string name, std::string_view separators)
    : rest_(content), name_(std::move(name)), separators_(separators) {
    if (rest_.starts_with("\xEF\xBB\xBF")) {  // a mark that editors of other systems put before a text
        rest_.remove_prefix(3);
    }
}

bool TextLines::next() {
    const auto parts = [&](char c) {
        return c == ' ' || (c >= '\t' && c <= '\r') || separators_.find(c) != std::string_view::npos;
    };
    words_.clear();
    while (words_.empty() && !rest_.empty()) {
        const std::string_view line = rest_.substr(0, rest_.find('\n'));
        rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
        ++line_;
        for (std::size_t begin = 0; begin < line.size();) {
            std::size_t end = begin;
            while (end < line.size() && !parts(line[end])) ++end;
            if (end > begin) words_.push_back(line.substr(begin, end - begin));
            begin = end + 1;
        }
    }
    return !words_.empty();
}

void TextLines::fault(const std::string& what) const {
    throw FileError(fmt::format("{}:{}: {}", name_, line_, what));
}

double TextLines::number(std::string_view word, std::string_view expected) const {
    double value = 0.0;
    if (!read_number(word, value)) {
        fault(fmt::format("expected {}, found `{}`", expected, shown_word(word)));
    }
    if (!std::isfinite(value)) {
        fault(
            fmt::format("expected {}, found `{}`, which is not a finite number", expected, shown_word(word)));
    }
    return value;
}

long long TextLines::integer(std::string_view word, std::string_view expected) const {
    const std::string_view digits = without_plus(word);
    long long value = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (status != std::errc() || end != digits.data() + digits.size()) {
        fault(fmt::format("expected {}, found `{}`", expected, shown_word(word)));
    }
    return value;
}

std::string shown_word(std::string_view word) {
    constexpr std::size_t longest = 40;
    return visible_text(std::string(word.substr(0, longest))) + (word.size() > longest ? "..." : "");
}

bool read_number(std::string_view word, double& value) {
    const std::string_view digits = without_plus(word);
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return status == std::errc() && !digits.empty() && end == digits.data() + digits.size();
}

std::string data_file_content(const std::string& file, std::string_view kind, double memory_per_byte) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::is_regular_file(file, error)
                                    ? std::filesystem::file_size(file, error)
                                    : static_cast<std::uintmax_t>(-1);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream || size == static_cast<std::uintmax_t>(-1)) {
        throw FileError(fmt::format("{}: there is no such {}, or it cannot be read", file, kind));
    }
    const double needed = memory_per_byte * static_cast<double>(size);
    const auto available = available_memory();
    if (available && needed > static_cast<double>(*available)) {
        throw FileError(fmt::format(
            "{}: has {:.3g} GB, for which {:.3g} GB of memory are needed, and {:.3g} GB are free: "
            "give the surface with fewer triangles or points",
            file, 1e-9 * static_cast<double>(size), 1e-9 * needed, 1e-9 * static_cast<double>(*available)));
    }
    constexpr std::uintmax_t takes_a_while = 20000000;
    if (size > takes_a_while) {
        notice(fmt::format("reading {}, {:.0f} MB", file, 1e-6 * static_cast<double>(size)));
    }
    std::string content(size, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (stream.gcount() != static_cast<std::streamsize>(content.size())) {
        throw FileError(fmt::format("{}: cannot be read to its end", file));
    }
    return content;
}

}  // namespace riffle::inline case_file
