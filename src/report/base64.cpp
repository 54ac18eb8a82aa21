#include "report/base64.hpp"

#include <cstddef>

namespace riffle::inline report {

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16U |
                                    (left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8U : 0U) |
                                    (left > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0U);
        text += letters[group >> 18U & 63U];
        text += letters[group >> 12U & 63U];
        text += left > 1 ? letters[group >> 6U & 63U] : '=';
        text += left > 2 ? letters[group & 63U] : '=';
    }
    return text;
}

}  // namespace riffle::inline report
