#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[solid]].
[[nodiscard]] SectionKeys solid_keys();

}  // namespace riffle::inline case_file
