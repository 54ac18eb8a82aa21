#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[probe]].
[[nodiscard]] SectionKeys probe_keys();

}  // namespace riffle::inline case_file
