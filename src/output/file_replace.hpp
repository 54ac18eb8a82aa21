#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace riffle {

/// Called with the name of each step that is about to change the folder, so that a test can end the process
/// there.
using StepObserver = std::function<void(std::string_view step)>;

/// What `replace_file` does besides replacing.
struct ReplaceOptions {
    /// Where the file that is replaced stays; nothing is kept when empty.
    std::filesystem::path keep_as = {};
    StepObserver observer = {};
};

/// Put `parts`, one behind the other, into the file `path` so that at each instant, a crash of the machine
/// included, the name holds either the whole old or the whole new content: write "<path>.new", flush it to
/// the disk, rename, flush the folder. With `keep_as` the old file stays under that name; at each instant at
/// least one of the two names holds a whole file, and where the file system knows hard links `path` always
/// does. Throws std::system_error; the new file is then removed, and `path` is as before (once it has been
/// renamed, only flushing the folder can fail).
void replace_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> parts,
                  const ReplaceOptions& options = {});

/// The whole content of a file. Throws std::system_error.
[[nodiscard]] std::vector<std::byte> read_file_bytes(const std::filesystem::path& path);

/// Text of the system error, with what the user can do about it: "No space left on device. Free at least
/// 1.2 MiB on this disk." `size`: bytes that were to be written, if known.
[[nodiscard]] std::string explain(const std::error_code& code, const std::filesystem::path& path,
                                  std::optional<std::size_t> size = std::nullopt);

}  // namespace riffle
