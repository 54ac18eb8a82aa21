#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "output/file_descriptor.hpp"

namespace riffle::inline output {

/// The process that works in a folder, as it wrote itself into the lock.
struct LockHolder {
    int process = 0;
    std::string host;
    [[nodiscard]] bool on_this_host() const;
};

/// What a file or a folder is, whatever its name.
struct FileIdentity {
    std::uint64_t device = 0;
    std::uint64_t number = 0;
    bool operator==(const FileIdentity&) const = default;
};

/// Keeps two processes from working in one folder. Processes that are forked while it is held share it: it
/// holds until the last of them has ended, however that happens.
class FolderLock {
  public:
    enum class Work { run, sweep };

    /// Make the folder and lock it. Throws FileError where it cannot be made or another process holds the
    /// lock, saying which.
    FolderLock(const std::filesystem::path& folder, Work work);

    /// Whether this file system has locks at all; else nothing keeps other processes out.
    [[nodiscard]] bool holds() const { return holds_; }

    /// Whether the lock still stands in its folder: not where the folder was removed, or is now another's.
    [[nodiscard]] bool in_place() const;

    /// How the lock of a folder stands.
    struct Standing {
        bool known = false;                ///< whether there is a lock that can be looked at
        std::optional<LockHolder> holder;  ///< the process that holds it
    };
    [[nodiscard]] static Standing standing(const std::filesystem::path& folder, Work work);

  private:
    std::filesystem::path path_;
    std::optional<FileIdentity> folder_;
    FileDescriptor file_;
    bool holds_ = true;
};

}  // namespace riffle::inline output
