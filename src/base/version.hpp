#pragma once

#include <string>

namespace riffle::inline base {

/// Version of Riffle, e.g. "0.1.0".
[[nodiscard]] std::string version();

/// Build facts: compiler, build type, revision of the source.
[[nodiscard]] std::string build_description();

}  // namespace riffle::inline base
