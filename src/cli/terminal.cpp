#include "cli/terminal.hpp"

#include <fmt/color.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/notice.hpp"
#include "base/visible_text.hpp"
#include "base/wrapped_text.hpp"

namespace riffle::inline cli {

namespace {

void print_labelled(const char* label, fmt::color colour, const std::string& text) {
    // It may quote file names, keys or words of a file, with whatever they hold.
    const std::string message = visible_text(text, "\n\t");
    if (error_stream_has_colours()) {
        fmt::print(stderr, "riffle: {}: {}\n", fmt::styled(label, fmt::emphasis::bold | fmt::fg(colour)),
                   message);
    } else {
        fmt::print(stderr, "riffle: {}: {}\n", label, message);
    }
}

}  // namespace

bool error_stream_is_terminal() { return isatty(STDERR_FILENO) != 0; }

bool error_stream_can_rewrite() {
    // Read before any thread starts.
    const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe)
    return error_stream_is_terminal() && terminal != nullptr && std::string_view(terminal) != "dumb";
}

bool error_stream_has_colours() {
    const char* no_colour = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe)
    return error_stream_can_rewrite() && (no_colour == nullptr || *no_colour == '\0');
}

std::size_t terminal_columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : usual_columns;
}

void print_error(const std::string& message) { print_labelled("error", fmt::color::crimson, message); }

void print_warning(const std::string& message) {
    print_labelled("warning", fmt::color::dark_orange, message);
}

void show_notices() {
    set_notices([](const std::string& what) {
        fmt::print(stderr, "riffle: {} ...\n", visible_text(what));
        std::fflush(stderr);
    });
}

std::string duration_text(double seconds) {
    if (seconds < 90.0) {
        return fmt::format("{:.0f} s", seconds);
    }
    if (seconds < 90.0 * 60.0) {
        return fmt::format("{:.0f} min", seconds / 60.0);
    }
    return seconds < 48.0 * 3600.0 ? fmt::format("{:.1f} h", seconds / 3600.0)
                                   : fmt::format("{:.1f} days", seconds / 86400.0);
}

std::string size_text(double bytes) {
    if (bytes < 1e6) {
        return fmt::format("{:.0f} kB", bytes / 1e3);
    }
    return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6) : fmt::format("{:.2f} GB", bytes / 1e9);
}

}  // namespace riffle::inline cli
