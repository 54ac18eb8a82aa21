#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "output/file_descriptor.hpp"
#include "output/journal.hpp"
#include "output/seal.hpp"

namespace riffle::inline output {

/// The content of a sealed file on the disk: each page is checked before the first of its bytes is given
/// away. A change that was interrupted is seen as complete where its journal is there, else as not begun;
/// nothing is written. The functions throw NotWhole where the file is not, and std::system_error.
class SealedContent {
  public:
    SealedContent() = default;
    /// `path`: of the file, to find its journal.
    SealedContent(FileDescriptor file, const std::filesystem::path& path, SealKind kind);

    [[nodiscard]] const FileDescriptor& file() const { return file_; }
    [[nodiscard]] const Seal& seal() const { return seal_; }
    [[nodiscard]] const PageTable& table() const { return table_; }
    /// The change that is seen as complete, if there was one.
    [[nodiscard]] const std::optional<Journal>& journal() const { return journal_; }

    /// Read bytes of the HDF5 file and of the seal; those behind its end are zero.
    void read(std::uint64_t at, std::span<std::byte> bytes);

    /// Numbers of all pages that do not fit their checksums.
    [[nodiscard]] std::vector<std::uint64_t> damaged_pages() const;

    /// Bytes behind the end of the content, of which no checksum knows: a change that ended in its midst
    /// leaves such, or something that is not Riffle.
    [[nodiscard]] std::uint64_t bytes_behind() const { return file_size() - seal_.file_size(); }
    /// Whether the file ends where it should.
    [[nodiscard]] bool ends_with_table() const { return bytes_behind() == 0; }

  private:
    [[nodiscard]] std::uint64_t file_size() const;
    /// Bytes as they stand in the file, the journal laid over; how many there are.
    std::size_t read_unchecked(std::uint64_t at, std::span<std::byte> bytes) const;
    /// Read a page and compare it with its checksum.
    [[nodiscard]] bool load(std::uint64_t page, std::span<std::byte> buffer) const;
    void find_journal(const std::filesystem::path& path, SealKind kind);

    FileDescriptor file_;
    std::optional<Journal> journal_;
    Seal seal_;
    PageTable table_;
    std::vector<bool> checked_;
    std::vector<std::byte> page_;  ///< the page that was checked last
    std::optional<std::uint64_t> page_number_;
};

}  // namespace riffle::inline output
