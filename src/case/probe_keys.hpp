#pragma once

#include "case/key_table.hpp"

namespace riffle {

/// The keys of [[probe]].
[[nodiscard]] SectionKeys probe_keys();

}  // namespace riffle
