#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [inflow] and of [outflow].
[[nodiscard]] SectionKeys inflow_keys();
[[nodiscard]] SectionKeys outflow_keys();

}  // namespace riffle::inline case_file
