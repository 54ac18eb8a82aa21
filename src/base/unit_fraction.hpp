#pragma once

#include <cstdint>

namespace riffle::inline base {

/// A number from 0 up to, not including, 1 of 64 random bits: the upper 53 of them, which give the same
/// number on every machine, unlike std::uniform_real_distribution.
[[nodiscard]] constexpr double unit_fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

}  // namespace riffle::inline base
