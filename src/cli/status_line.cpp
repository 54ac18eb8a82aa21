#include "cli/status_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "base/wrapped_text.hpp"
#include "cli/terminal.hpp"

namespace riffle::inline cli {

namespace {

constexpr std::string_view separator = " | ";

/// The first letters of a text.
std::string cut(const std::string& text, std::size_t columns) {
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size(); ++end) {
        count += (static_cast<unsigned char>(text[end]) & 0xc0U) != 0x80U ? 1U : 0U;
        if (count > columns) break;
    }
    return text.substr(0, end);
}

}  // namespace

std::string fitted_line(const std::vector<std::string>& parts, std::size_t columns) {
    if (parts.empty()) return "";
    std::string line = cut(parts.front(), columns);
    std::size_t used = columns_of(line);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        used += separator.size() + columns_of(parts[i]);
        if (used > columns) break;
        line.append(separator).append(parts[i]);
    }
    return line;
}

StatusLine::StatusLine() : terminal_(error_stream_can_rewrite()) {}

std::string StatusLine::erasure() const {
    // A terminal that has become narrower has broken the line into several rows: begin at the first of them.
    const std::size_t columns = terminal_columns();
    const std::size_t rows_above = shown_ > 0 ? (shown_ - 1) / columns : 0;
    return rows_above > 0 ? fmt::format("\r\x1b[{}A\x1b[J", rows_above) : "\r\x1b[K";
}

void StatusLine::show(const std::vector<std::string>& parts) {
    if (terminal_) {
        // Not into the last column: some terminals then go on to the next row.
        const std::string line = fitted_line(parts, terminal_columns() - 1);
        fmt::print(stderr, "{}{}", erasure(), line);
        std::fflush(stderr);
        shown_ = columns_of(line);
        return;
    }
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::max<Clock::duration>(std::chrono::seconds(10), (now - begin_) / 50);
    fmt::print(stderr, "{}\n", fmt::join(parts, separator));
}

void StatusLine::finish() {
    if (shown_ > 0) {
        fmt::print(stderr, "\n");
        shown_ = 0;
    }
}

void StatusLine::clear() {
    if (shown_ > 0) {
        fmt::print(stderr, "{}", erasure());
        std::fflush(stderr);
        shown_ = 0;
    }
}

}  // namespace riffle::inline cli
