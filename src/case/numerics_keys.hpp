#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [numerics], and of [stirring], a test of the numerics.
[[nodiscard]] SectionKeys numerics_keys();
[[nodiscard]] SectionKeys stirring_keys();

}  // namespace riffle::inline case_file
