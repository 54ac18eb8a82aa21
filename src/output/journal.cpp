#include "output/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "output/checksum.hpp"
#include "output/file_replace.hpp"

namespace riffle::inline output {
namespace {

/// The head of a journal: numbers as this machine has them, for it is read where it was written.
struct Head {
    std::array<char, 16> word = {'r', 'i', 'f', 'f', 'l', 'e', '-', 'j',
                                 'o', 'u', 'r', 'n', 'a', 'l', '1', '\n'};
    std::uint64_t from = 0, to = 0, file_size = 0, patches = 0, bytes = 0;
    std::uint64_t checksum = 0;  ///< of the head up to here, the places and the bytes
};
struct Place {
    std::uint64_t at = 0, size = 0;
};

template <class T>
std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

std::uint64_t checksum_of(const Head& head, std::span<const Place> places) {
    const std::uint64_t start = crc64(bytes_of(head).first(offsetof(Head, checksum)));
    return crc64(std::as_bytes(places), start);
}

}  // namespace

std::filesystem::path journal_of(const std::filesystem::path& file) {
    return std::filesystem::path(file) += ".journal";
}

void write_journal(const std::filesystem::path& file, const Journal& journal) {
    Head head{.from = journal.from,
              .to = journal.to,
              .file_size = journal.file_size,
              .patches = journal.patches.size()};
    std::vector<Place> places;
    for (const Patch& patch : journal.patches) {
        places.push_back({patch.at, patch.bytes.size()});
        head.bytes += patch.bytes.size();
    }
    head.checksum = checksum_of(head, places);
    for (const Patch& patch : journal.patches) head.checksum = crc64(patch.bytes, head.checksum);
    const std::filesystem::path path = journal_of(file);
    try {
        FileDescriptor descriptor(path, O_WRONLY | O_CREAT | O_TRUNC);
        descriptor.write(bytes_of(head));
        descriptor.write(std::as_bytes(std::span(places)));
        for (const Patch& patch : journal.patches) descriptor.write(patch.bytes);
        descriptor.sync();
        descriptor.close();
        sync_folder(folder_of(path));
    } catch (...) {
        ::unlink(path.c_str());
        throw;
    }
}

std::optional<Journal> read_journal(const std::filesystem::path& file) {
    std::vector<std::byte> content;
    try {
        content = read_file_bytes(journal_of(file));
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::no_such_file_or_directory) return {};
        throw;
    }
    Head head;
    if (content.size() < sizeof(Head)) return {};
    std::memcpy(&head, content.data(), sizeof(Head));
    std::span<const std::byte> rest = std::span(content).subspan(sizeof(Head));
    if (head.word != Head().word || head.patches > rest.size() / sizeof(Place)) return {};
    std::vector<Place> places(head.patches);
    const std::size_t place_bytes = places.size() * sizeof(Place);
    std::memcpy(places.data(), rest.data(), place_bytes);
    rest = rest.subspan(place_bytes);
    if (head.bytes != rest.size() || crc64(rest, checksum_of(head, places)) != head.checksum) return {};
    Journal journal{.from = head.from, .to = head.to, .file_size = head.file_size, .patches = {}};
    for (const Place& place : places) {
        if (place.size > rest.size()) return {};
        journal.patches.push_back({place.at, rest.first(place.size)});
        rest = rest.subspan(place.size);
    }
    journal.content = std::move(content);  // the patches go on to point into it
    return journal;
}

void apply_journal(const FileDescriptor& file, const Journal& journal) {
    for (const Patch& patch : journal.patches) file.write_at(patch.at, patch.bytes);
    if (file.size() > journal.file_size) file.resize(journal.file_size);
}

void remove_journal(const std::filesystem::path& file) {
    if (::unlink(journal_of(file).c_str()) != 0 && errno != ENOENT) throw_system_error(errno, "unlink");
}

void lay_over(std::span<const Patch> patches, std::uint64_t at, std::span<std::byte> bytes) {
    const std::uint64_t end = at + bytes.size();
    auto patch = std::upper_bound(patches.begin(), patches.end(), at,
                                  [](std::uint64_t place, const Patch& p) { return place < p.at; });
    if (patch != patches.begin()) --patch;
    for (; patch != patches.end() && patch->at < end; ++patch) {
        const std::uint64_t from = std::max(at, patch->at);
        const std::uint64_t to = std::min(end, patch->at + patch->bytes.size());
        if (from < to) std::memcpy(&bytes[from - at], &patch->bytes[from - patch->at], to - from);
    }
}

}  // namespace riffle::inline output
