#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace riffle::inline output {

// A sealed file is an HDF5 file by which each change that Riffle has not made is seen. Its first 512 bytes
// (HDF5's user block, which every HDF5 program skips) are a line of text, the seal; behind the HDF5 file
// stands a table with the checksum of each of its pages. The seal holds the table's checksum, and its own.

/// Bytes of the seal.
inline constexpr std::size_t seal_bytes = 512;
using SealBlock = std::array<std::byte, seal_bytes>;

/// Bytes that share a checksum.
inline constexpr std::uint64_t page_bytes = std::uint64_t{1} << 16U;

/// What kinds of files are sealed, with the version of each format.
struct SealKind {
    const char* word;  ///< first in the line
    int version;
};
inline constexpr SealKind results_seal = {"riffle-results", 1};
inline constexpr SealKind checkpoint_seal = {"riffle-checkpoint", 2};

/// The content of a seal.
struct Seal {
    std::uint64_t size = 0;      ///< bytes of the HDF5 file with its user block; the table follows
    std::uint64_t table = 0;     ///< checksum of the table
    std::uint64_t identity = 0;  ///< checksum of the line: as good as one of the whole file

    [[nodiscard]] std::uint64_t pages() const { return (size + page_bytes - 1) / page_bytes; }
    /// Bytes of the file with its table.
    [[nodiscard]] std::uint64_t file_size() const { return size + pages() * sizeof(std::uint64_t); }
};

/// Checksums of the pages of a file, in order.
using PageTable = std::vector<std::uint64_t>;

/// The seal of a file of so many bytes with this table, and the block that holds it.
[[nodiscard]] Seal make_seal(SealKind kind, std::uint64_t size, const PageTable& table);
[[nodiscard]] SealBlock seal_block(SealKind kind, const Seal& seal);

/// Why a sealed file is not whole, as the end of a sentence that begins with its name: "is truncated: ...".
class NotWhole : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file that does not begin as a sealed file of the wanted kind.
class NotSealed : public NotWhole {
  public:
    using NotWhole::NotWhole;
};

/// A page of a sealed file that does not fit its checksum.
class DamagedPage : public NotWhole {
  public:
    explicit DamagedPage(std::uint64_t page)
        : NotWhole("has been altered or damaged: its checksums do not fit its content"), page_(page) {}
    [[nodiscard]] std::uint64_t page() const { return page_; }

  private:
    std::uint64_t page_;
};

/// Whether these first bytes of a file are those of an HDF5 file without a seal.
[[nodiscard]] bool starts_like_hdf5(std::span<const std::byte> start);

/// The seal in the first bytes of a file; fewer than seal_bytes at its end only. Throws NotWhole: truncated,
/// not of this kind, of another version, altered.
[[nodiscard]] Seal read_seal(SealKind kind, std::span<const std::byte> start);

/// Where the bytes of a page that count for its checksum begin: the seal does not.
[[nodiscard]] constexpr std::uint64_t page_begin(std::uint64_t page) {
    return page == 0 ? seal_bytes : page * page_bytes;
}
/// Where a page ends in a file of so many bytes.
[[nodiscard]] constexpr std::uint64_t page_end(std::uint64_t page, std::uint64_t size) {
    return (page + 1) * page_bytes < size ? (page + 1) * page_bytes : size;
}

}  // namespace riffle::inline output
