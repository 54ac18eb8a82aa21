#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace riffle::inline report {

/// The bytes as base64 (RFC 4648) with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace riffle::inline report
