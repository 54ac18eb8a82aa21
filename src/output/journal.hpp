#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "output/file_descriptor.hpp"

namespace riffle::inline output {

/// Bytes to be put into a file at a place; they are kept elsewhere.
struct Patch {
    std::uint64_t at = 0;
    std::span<const std::byte> bytes;
};

/// What changes a file from one whole content to the next, in one file of its own beside it: written and
/// flushed before the first byte of the file is changed, and removed when the last one has reached the disk.
/// So whoever finds a whole journal can complete the change, and whoever finds a torn one knows that nothing
/// has been changed yet.
struct Journal {
    std::uint64_t from = 0;  ///< seal of the file before, and after the change
    std::uint64_t to = 0;
    std::uint64_t file_size = 0;          ///< after the change
    std::vector<Patch> patches;           ///< sorted by place, without overlaps
    std::vector<std::byte> content = {};  ///< of a journal that was read: the bytes of its patches
};

/// Where the journal of a file is kept.
[[nodiscard]] std::filesystem::path journal_of(const std::filesystem::path& file);

/// Write a journal and flush it to the disk. Throws std::system_error.
void write_journal(const std::filesystem::path& file, const Journal& journal);

/// The journal of a file; nothing where there is none or it is torn. Throws std::system_error where it cannot
/// be read.
[[nodiscard]] std::optional<Journal> read_journal(const std::filesystem::path& file);

/// Put the patches into the file, which may hold some of them already. Throws std::system_error.
void apply_journal(const FileDescriptor& file, const Journal& journal);

/// Remove the journal of a file, if there is one.
void remove_journal(const std::filesystem::path& file);

/// Overwrite the part of `bytes`, which stand at `at` in the file, that patches hold.
void lay_over(std::span<const Patch> patches, std::uint64_t at, std::span<std::byte> bytes);

}  // namespace riffle::inline output
