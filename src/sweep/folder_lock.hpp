#pragma once

#include <filesystem>

namespace riffle {

/// Keeps two sweeps from working in one folder. The runs of a sweep share its lock: it holds until the last
/// of them has ended, also where the sweep itself was killed.
class FolderLock {
  public:
    /// Make the folder and lock it. Throws FileError where it cannot be made or another sweep holds it.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int file_ = -1;
};

}  // namespace riffle
