#include "output/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string_view>

#include "output/checksum.hpp"

namespace riffle::inline output {
namespace {

template <class Number>
std::optional<Number> number_after(std::string_view line, std::string_view word, int base = 10) {
    const std::size_t found = line.find(word);
    if (found == std::string_view::npos) return {};
    Number number = 0;
    const char* start = line.data() + found + word.size();
    const auto [end, error] = std::from_chars(start, line.data() + line.size(), number, base);
    if (error != std::errc() || end == start) return {};
    return number;
}

std::string line_without_identity(SealKind kind, const Seal& seal) {
    return fmt::format("{} {} size {} pages {:016x}", kind.word, kind.version, seal.size, seal.table);
}

}  // namespace

Seal make_seal(SealKind kind, std::uint64_t size, const PageTable& table) {
    Seal seal{.size = size, .table = crc64(std::as_bytes(std::span(table)))};
    const std::string line = line_without_identity(kind, seal);
    seal.identity = crc64(std::as_bytes(std::span(line)));
    return seal;
}

SealBlock seal_block(SealKind kind, const Seal& seal) {
    const std::string line =
        fmt::format("{} seal {:016x}\n", line_without_identity(kind, seal), seal.identity);
    SealBlock block = {};
    std::memcpy(block.data(), line.data(), line.size());
    return block;
}

bool starts_like_hdf5(std::span<const std::byte> start) {
    constexpr std::array<unsigned char, 8> signature = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    return start.size() >= signature.size() &&
           std::memcmp(start.data(), signature.data(), signature.size()) == 0;
}

Seal read_seal(SealKind kind, std::span<const std::byte> start) {
    std::string line(std::min(start.size(), seal_bytes), '\0');
    std::memcpy(line.data(), start.data(), line.size());
    const std::string word = std::string(kind.word) + " ";
    if (!std::string_view(word).starts_with(std::string_view(line).substr(0, word.size()))) {
        throw NotSealed(
            fmt::format("does not begin as a file of the kind {}, or its beginning is damaged", kind.word));
    }
    if (start.size() < seal_bytes) {
        throw NotWhole(fmt::format("is truncated: it has only {} bytes", start.size()));
    }
    line = line.substr(0, line.find('\n'));
    const auto version = number_after<int>(line, word);
    const auto size = number_after<std::uint64_t>(line, " size ");
    const auto table = number_after<std::uint64_t>(line, " pages ", 16);
    const auto identity = number_after<std::uint64_t>(line, " seal ", 16);
    if (size && table && identity) {
        const Seal seal{.size = *size, .table = *table, .identity = *identity};
        const SealBlock expected = seal_block(kind, seal);
        const std::string known = line_without_identity(kind, seal);
        const bool same = std::equal(expected.begin(), expected.end(), start.begin());
        if (same && crc64(std::as_bytes(std::span(known))) == seal.identity) return seal;
    }
    if (version && *version != kind.version) {
        throw NotWhole(fmt::format(
            "has the format version {}, this Riffle reads version {} (use the Riffle that wrote it)",
            *version, kind.version));
    }
    throw NotWhole("has been altered or damaged: its first line does not fit its content");
}

}  // namespace riffle::inline output
