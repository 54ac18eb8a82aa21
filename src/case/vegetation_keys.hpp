#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[vegetation]].
[[nodiscard]] SectionKeys vegetation_keys();

}  // namespace riffle::inline case_file
