#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "output/byte_store.hpp"
#include "output/file_replace.hpp"
#include "output/sealed_content.hpp"

namespace riffle::inline output {

/// Size from which a file is changed in place rather than written anew, bytes. A new file costs little below
/// it, and whoever copies or reads the old one meanwhile, with locks or without, keeps a whole one.
inline constexpr std::uint64_t change_in_place_from = std::uint64_t{64} << 20U;

/// The same, or what the environment variable RIFFLE_CHANGE_IN_PLACE_FROM says: for tests.
[[nodiscard]] std::uint64_t chosen_change_in_place_from();

/// A change of a sealed file, or the making of one, in one step: at each instant, a crash of the machine
/// included, the file is whole for Riffle, old or new. What is added behind the end of the file goes to the
/// disk at once; of what is there already, the pages that change are kept in memory, so that time and memory
/// follow the change and not the file. commit() then puts the pages into their places:
///
/// - in place, from `change_in_place_from` on: a journal first, then the pages under an exclusive lock
/// (flock),
///   which lasts some milliseconds. Those who read the file hold a shared lock, as HDF5 does by itself.
/// - else, and where somebody holds a lock, the file system knows none, or the file has several names: a new
///   file beside the old one, which is renamed over it.
///
/// There must be one process that changes the file at a time. The functions throw std::system_error and
/// NotWhole; without commit() the file stays as it was.
class FileUpdate final : public ByteStore {
  public:
    /// Make a new file, which replaces one of this name; `keep_as` as in FileReplacement.
    static std::unique_ptr<FileUpdate> create(const std::filesystem::path& path, SealKind kind,
                                              const std::filesystem::path& keep_as = {});
    /// Change a file. `in_place_from`: as change_in_place_from.
    static std::unique_ptr<FileUpdate> change(const std::filesystem::path& path, SealKind kind,
                                              std::uint64_t in_place_from = change_in_place_from);
    ~FileUpdate() override;

    [[nodiscard]] std::uint64_t size() const override { return size_; }
    void read(std::uint64_t at, std::span<std::byte> bytes) override;
    void write(std::uint64_t at, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override { size_ = size; }

    /// Bytes that the disk must have room for.
    [[nodiscard]] std::uint64_t bytes_to_write() const;

    /// Seal the content and put it in place. The HDF5 file must be closed.
    void commit();

  private:
    /// A page of the old content that changes.
    struct Page {
        std::vector<std::byte> bytes;
        std::uint32_t changed = 0;  ///< a bit for each block of it
    };

    FileUpdate(std::filesystem::path path, SealKind kind) : path_(std::move(path)), kind_(kind) {}
    Page& page_to_change(std::uint64_t number);
    /// write() that leaves the size of the content as it is.
    void put(std::uint64_t at, std::span<const std::byte> bytes);
    void clear_old_table();
    /// Read bytes of the old content.
    void read_old(std::uint64_t at, std::span<std::byte> bytes);
    [[nodiscard]] const FileDescriptor& tail() const;
    [[nodiscard]] PageTable new_table();
    [[nodiscard]] std::vector<Patch> patches() const;
    [[nodiscard]] bool changes_in_place(std::uint64_t in_place_from) const;
    void commit_in_place(std::uint64_t identity);
    /// Copy the new content up to a place.
    void copy(const FileDescriptor& to, std::uint64_t end);

    std::filesystem::path path_;
    SealKind kind_;
    std::optional<SealedContent> old_;
    std::uint64_t old_size_ = 0;  ///< with its table; what lies behind is the tail
    std::uint64_t size_ = 0;
    std::uint64_t file_size_ = 0;  ///< with the new table
    std::map<std::uint64_t, Page> pages_;
    std::unique_ptr<FileReplacement> fresh_;  ///< none: in place
    bool committed_ = false;
};

}  // namespace riffle::inline output
