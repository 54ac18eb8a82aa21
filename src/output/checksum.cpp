#include "output/checksum.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace riffle::inline output {
namespace {

constexpr std::uint64_t polynomial = 0xC96C5795D7870F42ULL;
using Table = std::array<std::array<std::uint64_t, 256>, 8>;

/// table[k][b]: the remainder of byte b followed by k zero bytes, so that eight bytes are taken at a time.
constexpr Table make_table() {
    Table table = {};
    for (std::size_t byte = 0; byte < 256; ++byte) {
        std::uint64_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit) {
            remainder = (remainder >> 1U) ^ ((remainder & 1U) != 0 ? polynomial : 0);
        }
        table[0][byte] = remainder;
    }
    for (std::size_t k = 1; k < 8; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint64_t before = table[k - 1][byte];
            table[k][byte] = (before >> 8U) ^ table[0][before & 0xFFU];
        }
    }
    return table;
}

constexpr Table table = make_table();
static_assert(std::endian::native == std::endian::little,
              "the checksum reads eight bytes as a little-endian word");

}  // namespace

std::uint64_t crc64(std::span<const std::byte> bytes, std::uint64_t before) {
    std::uint64_t remainder = ~before;
    while (bytes.size() >= 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), 8);
        word ^= remainder;
        remainder = 0;
        for (std::size_t k = 0; k < 8; ++k) remainder ^= table[7 - k][(word >> (8 * k)) & 0xFFU];
        bytes = bytes.subspan(8);
    }
    for (const std::byte byte : bytes) {
        remainder = (remainder >> 8U) ^ table[0][(remainder ^ std::to_integer<std::uint64_t>(byte)) & 0xFFU];
    }
    return ~remainder;
}

}  // namespace riffle::inline output
