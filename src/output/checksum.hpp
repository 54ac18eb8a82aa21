#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace riffle::inline output {

/// CRC-64 (ECMA-182 polynomial, reflected, as in the .xz format): finds each error of up to 64 neighbouring
/// bits, and others but for one in 2^64. `before`: the checksum of the bytes that stand before these, where
/// they come in parts.
[[nodiscard]] std::uint64_t crc64(std::span<const std::byte> bytes, std::uint64_t before = 0);

}  // namespace riffle::inline output
