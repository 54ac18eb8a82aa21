#include "base/visible_text.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace riffle::inline base {

namespace {

struct Letter {
    std::uint32_t code = 0;
    std::size_t length = 0;  ///< bytes; 0: no UTF-8
};

Letter letter_at(std::string_view text, std::size_t place) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(place);
    if (first < 0x80U) {
        return {first, 1};
    }
    const std::size_t length = first >= 0xf0U ? 4 : first >= 0xe0U ? 3 : 2;
    if (first < 0xc2U || first > 0xf4U || place + length > text.size()) {
        return {};
    }
    std::uint32_t code = first & (0xffU >> (length + 1));
    for (std::size_t i = place + 1; i < place + length; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) {
            return {};
        }
        code = (code << 6U) | (byte(i) & 0x3fU);
    }
    const bool too_long = (length == 3 && code < 0x800U) || (length == 4 && code < 0x10000U);
    const bool no_letter = code > 0x10ffffU || (code >= 0xd800U && code <= 0xdfffU);
    return too_long || no_letter ? Letter{} : Letter{code, length};
}

bool is_hidden(std::uint32_t code) {
    return code < 0x20U || (code >= 0x7fU && code <= 0x9fU) || code == 0x061cU || code == 0x200eU ||
           code == 0x200fU || (code >= 0x202aU && code <= 0x202eU) || (code >= 0x2066U && code <= 0x2069U);
}

}  // namespace

std::optional<HiddenCharacter> hidden_character(std::string_view text, std::size_t from,
                                                std::string_view allowed) {
    for (std::size_t i = from; i < text.size();) {
        const Letter letter = letter_at(text, i);
        if (letter.length == 0) {
            return HiddenCharacter{i, 1,
                                   fmt::format("the byte 0x{:02x}", static_cast<unsigned char>(text[i]))};
        }
        const bool is_allowed =
            letter.length == 1 && allowed.find(static_cast<char>(letter.code)) != std::string_view::npos;
        if (is_hidden(letter.code) && !is_allowed) {
            return HiddenCharacter{i, letter.length, fmt::format("U+{:04X}", letter.code)};
        }
        i += letter.length;
    }
    return std::nullopt;
}

std::string visible_text(std::string_view text, std::string_view allowed) {
    std::string shown;
    std::size_t from = 0;
    while (const auto hidden = hidden_character(text, from, allowed)) {
        shown.append(text.substr(from, hidden->place - from)).append("<" + hidden->name + ">");
        from = hidden->place + hidden->length;
    }
    return shown.append(text.substr(from));
}

std::string shortened(const std::string& text) {
    constexpr std::size_t longest = 60;
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace riffle::inline base
