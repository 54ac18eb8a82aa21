#pragma once

#include "case/key_table.hpp"

namespace riffle {

/// The keys of [start].
[[nodiscard]] SectionKeys start_keys();

}  // namespace riffle
