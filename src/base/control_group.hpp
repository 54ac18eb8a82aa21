#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline base {

/// Where the system says what the process may use; another root for tests.
struct SystemFiles {
    std::string root;  ///< before "/sys" and "/proc"; empty: the system's own
};

/// A folder in which the system describes a control group (containers, batch systems).
struct ControlGroupFolder {
    std::string path;
    int version = 2;  ///< of the control groups, which name their files differently
};

/// The folders of the control group of the process and of those above it, for one controller ("cpu",
/// "memory"); some of them may not be there.
[[nodiscard]] std::vector<ControlGroupFolder> control_group_folders(const SystemFiles& files,
                                                                    std::string_view controller);

/// First line of a file; empty where there is none.
[[nodiscard]] std::string first_line(const std::string& file);

}  // namespace riffle::inline base
