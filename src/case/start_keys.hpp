#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [start].
[[nodiscard]] SectionKeys start_keys();

}  // namespace riffle::inline case_file
