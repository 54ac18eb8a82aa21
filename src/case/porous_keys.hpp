#pragma once

#include "case/key_table.hpp"

namespace riffle {

/// The keys of [[porous]].
[[nodiscard]] SectionKeys porous_keys();

}  // namespace riffle
