#pragma once

#include <string>

namespace riffle {

/// Whether standard error is a terminal that shows colours (not redirected, NO_COLOR unset, TERM not "dumb").
[[nodiscard]] bool error_stream_has_colours();

/// Whether standard error is a terminal.
[[nodiscard]] bool error_stream_is_terminal();

/// "riffle: error: ..." on standard error.
void print_error(const std::string& message);

/// "riffle: warning: ..." on standard error.
void print_warning(const std::string& message);

/// Seconds as a person says them: "45 s", "12 min", "3.2 h".
[[nodiscard]] std::string duration_text(double seconds);

/// Bytes as a person says them: "340 kB", "1.2 GB".
[[nodiscard]] std::string size_text(double bytes);

}  // namespace riffle
