#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[bed_patch]].
[[nodiscard]] SectionKeys bed_patch_keys();

}  // namespace riffle::inline case_file
