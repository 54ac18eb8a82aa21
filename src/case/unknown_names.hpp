#pragma once

#include <string>

namespace riffle {

/// What to say of a section that no case has: the nearest name, and all of them.
[[nodiscard]] std::string unknown_section(const std::string& name);

/// What to say of a key that a section has not: where it belongs, what people look for by that name, or the
/// nearest one, and all keys of the section. The section must be one of the key table.
[[nodiscard]] std::string unknown_key(const std::string& section, const std::string& name);

}  // namespace riffle
