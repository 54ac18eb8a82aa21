#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "output/seal.hpp"

namespace riffle::inline output {

/// What of a sealed file lies in pages that do not fit their checksums: "2 of its 81 pages do not fit their
/// checksums. Lost: rows 4096 to 6143 of /surface/elevation, ...; the rest is whole."
[[nodiscard]] std::string damage_text(const std::filesystem::path& path, SealKind kind,
                                      const std::vector<std::uint64_t>& pages);

}  // namespace riffle::inline output
