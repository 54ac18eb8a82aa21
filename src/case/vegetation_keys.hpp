#pragma once

#include "case/key_table.hpp"

namespace riffle {

/// The keys of [[vegetation]].
[[nodiscard]] SectionKeys vegetation_keys();

}  // namespace riffle
