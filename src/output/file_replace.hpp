#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "output/file_descriptor.hpp"

namespace riffle::inline output {

/// A new content for a file, put in its place in one step: at each instant, a crash of the machine included,
/// the name holds either the whole old or the whole new content. Written to "<path>.new", which is removed
/// again unless it comes to commit(). A symbolic link stays: the file that it leads to is replaced. All
/// functions throw std::system_error; the old file is then as before (once it has been renamed, only flushing
/// the folder can fail).
class FileReplacement {
  public:
    /// `keep_as`: where the file that is replaced stays; nothing is kept when empty. At each instant at least
    /// one of the two names then holds a whole file, and where the file system knows hard links `path` always
    /// does.
    explicit FileReplacement(const std::filesystem::path& path, std::filesystem::path keep_as = {});
    ~FileReplacement();
    FileReplacement(const FileReplacement&) = delete;
    FileReplacement& operator=(const FileReplacement&) = delete;

    /// The new file, to be written and read.
    [[nodiscard]] const FileDescriptor& file() const { return file_; }

    /// Flush to the disk, keep the old file where asked for, rename, flush the folder.
    void commit();

  private:
    std::filesystem::path target_;
    std::filesystem::path kept_;
    std::filesystem::path fresh_;
    FileDescriptor file_;
};

/// Put `parts`, one behind the other, into the file `path` as a FileReplacement. What is no file but a device
/// or a pipe (/dev/stdout) is not replaced: the parts are written to it.
void replace_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> parts);

/// The whole content of a file. Throws std::system_error.
[[nodiscard]] std::vector<std::byte> read_file_bytes(const std::filesystem::path& path);

/// Text of the system error, with what the user can do about it: "No space left on device. Free at least
/// 1.2 MiB on this disk." `size`: bytes that were to be written, if known.
[[nodiscard]] std::string explain(const std::error_code& code, const std::filesystem::path& path,
                                  std::optional<std::size_t> size = std::nullopt);

}  // namespace riffle::inline output
