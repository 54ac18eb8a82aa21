#pragma once

#include <cstddef>
#include <string>

namespace riffle::inline cli {

/// Whether standard error is a terminal that shows colours (not redirected, NO_COLOR unset, TERM not "dumb").
[[nodiscard]] bool error_stream_has_colours();

/// Whether standard error is a terminal.
[[nodiscard]] bool error_stream_is_terminal();

/// Whether it is one that obeys escape sequences, so that a line can be written anew (TERM not "dumb").
[[nodiscard]] bool error_stream_can_rewrite();

/// Columns of the terminal that standard error goes to, as wide as it is now; 80 where it does not tell.
[[nodiscard]] std::size_t terminal_columns();

/// "riffle: error: ..." on standard error.
void print_error(const std::string& message);

/// "riffle: warning: ..." on standard error.
void print_warning(const std::string& message);

/// Show what takes long before a run shows progress (base/notice.hpp) on standard error.
void show_notices();

/// Seconds as a person says them: "45 s", "12 min", "3.2 h".
[[nodiscard]] std::string duration_text(double seconds);

/// Bytes as a person says them: "340 kB", "1.2 GB".
[[nodiscard]] std::string size_text(double bytes);

}  // namespace riffle::inline cli
