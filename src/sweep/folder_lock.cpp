#include "sweep/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/error.hpp"

namespace riffle {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw FileError(fmt::format("cannot create the folder {}: {}; choose another with -o",
                                    folder.string(), error.message()));
    }
    // Not closed in the processes of the runs: their copies of it hold the lock too.
    file_ = ::open((folder / ".sweep.lock").c_str(), O_RDWR | O_CREAT, 0644);  // NOLINT(*-vararg)
    if (file_ < 0) {
        throw FileError(fmt::format("cannot write to the folder {}: {}; choose another with -o",
                                    folder.string(), std::strerror(errno)));
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        const bool held = errno == EWOULDBLOCK;
        const std::string reason = std::strerror(errno);
        ::close(file_);
        if (!held) {
            throw FileError(fmt::format("cannot lock the folder {}: {}", folder.string(), reason));
        }
        throw FileError(
            fmt::format("another sweep works in {}, or runs of one are still writing their checkpoints; wait "
                        "for it or choose another folder with -o",
                        folder.string()));
    }
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace riffle
