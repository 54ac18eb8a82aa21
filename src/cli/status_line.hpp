#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace riffle::inline cli {

/// As many of the parts, the first ones, as fit into `columns` with " | " between them; the first one is cut
/// where it alone is longer.
[[nodiscard]] std::string fitted_line(const std::vector<std::string>& parts, std::size_t columns);

/// A line on standard error that says how far something is. On a terminal it is rewritten in place and holds
/// what fits the present width; elsewhere (a file, a pipe) whole lines follow each other, every 10 s at
/// first, later every fiftieth of the time so far.
class StatusLine {
  public:
    StatusLine();
    /// Show the parts, the most important first.
    void show(const std::vector<std::string>& parts);
    /// End the line that is being rewritten; it stays.
    void finish();
    /// Take back the line that is being rewritten.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    /// What a terminal is sent so that the line shown last goes, on each row that it takes now.
    [[nodiscard]] std::string erasure() const;

    bool terminal_;
    std::size_t shown_ = 0;  ///< letters of the line that is being rewritten
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_;  ///< of the next whole line
};

}  // namespace riffle::inline cli
