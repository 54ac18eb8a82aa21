#pragma once

#include <set>
#include <string>

namespace riffle::inline case_file {

/// What to say of a section that no case has: the nearest name, and all of them.
[[nodiscard]] std::string unknown_section(const std::string& name);

/// What to say of the keys of a case that their sections have not.
class UnknownKeys {
  public:
    /// Where the key belongs, what people look for by that name, or the nearest one; and all keys of the
    /// section, once for each section. The section must be one of the key table.
    [[nodiscard]] std::string message(const std::string& section, const std::string& name);

  private:
    std::set<std::string> listed_;  ///< sections whose keys have been named
};

}  // namespace riffle::inline case_file
