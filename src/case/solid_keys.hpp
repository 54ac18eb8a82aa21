#pragma once

#include "case/key_table.hpp"

namespace riffle {

/// The keys of [[solid]].
[[nodiscard]] SectionKeys solid_keys();

}  // namespace riffle
