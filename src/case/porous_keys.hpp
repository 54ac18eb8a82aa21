#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[porous]].
[[nodiscard]] SectionKeys porous_keys();

}  // namespace riffle::inline case_file
