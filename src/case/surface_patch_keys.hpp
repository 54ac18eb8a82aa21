#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[surface_patch]].
[[nodiscard]] SectionKeys surface_patch_keys();

}  // namespace riffle::inline case_file
