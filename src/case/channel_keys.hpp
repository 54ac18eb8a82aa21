#pragma once

#include <vector>

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys before the first section and those of the flow itself: [channel], [bed], [side_walls],
/// [turbulence], [fluid]. Part of key_table().
[[nodiscard]] std::vector<SectionKeys> channel_keys();

}  // namespace riffle::inline case_file
