#include "output/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <sstream>
#include <system_error>

#include "base/error.hpp"
#include "output/file_replace.hpp"

namespace riffle::inline output {
namespace {

std::filesystem::path lock_file(const std::filesystem::path& folder, FolderLock::Work work) {
    return folder / (work == FolderLock::Work::run ? ".run.lock" : ".sweep.lock");
}

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

/// A lock of the whole file that belongs to its open description: it goes over to forked processes, and can
/// be asked for without being taken.
struct flock whole_file() {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

LockHolder read_holder(const FileDescriptor& file) {
    std::array<char, 512> text{};
    const std::size_t size = file.read_at(0, std::as_writable_bytes(std::span(text)));
    std::istringstream words(std::string(text.data(), size));
    LockHolder holder;
    words >> holder.process >> holder.host;
    return holder;
}

std::string refusal(const std::filesystem::path& folder, FolderLock::Work work, const LockHolder& holder) {
    const std::string who = holder.process > 0
                                ? fmt::format("process {}{}", holder.process,
                                              holder.on_this_host() ? "" : " on the computer " + holder.host)
                                : std::string("another process");
    if (work == FolderLock::Work::sweep) {
        return fmt::format(
            "another sweep works in {}, or runs of one are still writing their checkpoints ({}); wait for it "
            "or choose another folder with -o",
            folder.string(), who);
    }
    return fmt::format(
        "{} is at work on the run in {}. Wait for its end, follow it with `riffle watch {}`, stop it with "
        "`kill {}` (it then writes a checkpoint), or choose another folder with -o",
        who, folder.string(), folder.string(),
        holder.process > 0 ? std::to_string(holder.process) : "PROCESS");
}

FileIdentity identity(const struct stat& found) { return {found.st_dev, found.st_ino}; }

/// Which file or folder stands under a name; none where there is none.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 ? std::optional(identity(found)) : std::nullopt;
}

/// Which file is open.
std::optional<FileIdentity> identity_of(const FileDescriptor& file) {
    struct stat found {};
    return ::fstat(file.get(), &found) == 0 ? std::optional(identity(found)) : std::nullopt;
}

}  // namespace

bool LockHolder::on_this_host() const { return host == host_name(); }

FolderLock::FolderLock(const std::filesystem::path& folder, Work work) : path_(lock_file(folder, work)) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw FileError(fmt::format("cannot create the folder {}: {}; choose another with -o",
                                    folder.string(), error.message()));
    }
    try {
        file_ = FileDescriptor(path_, O_RDWR | O_CREAT);
        folder_ = identity_of(folder);
        struct flock lock = whole_file();
        if (::fcntl(file_.get(), F_OFD_SETLK, &lock) != 0) {  // NOLINT(*-vararg)
            if (errno == EAGAIN || errno == EACCES) {
                throw FileError(refusal(folder, work, read_holder(file_)));
            }
            holds_ = false;
        }
        const std::string line = fmt::format("{} {}\n", ::getpid(), host_name());
        file_.resize(0);
        file_.write_at(0, std::as_bytes(std::span(line)));
    } catch (const std::system_error& fault) {
        throw FileError(
            fmt::format("cannot write to the folder {}: {}", folder.string(), explain(fault.code(), path_)));
    }
}

bool FolderLock::in_place() const {
    const std::optional<FileIdentity> there = identity_of(path_);
    // A lock that was tidied away is no other run's.
    return there ? there == identity_of(file_) : identity_of(path_.parent_path()) == folder_;
}

FolderLock::Standing FolderLock::standing(const std::filesystem::path& folder, Work work) {
    try {
        const FileDescriptor file(lock_file(folder, work), O_RDONLY);
        struct flock lock = whole_file();
        if (::fcntl(file.get(), F_OFD_GETLK, &lock) != 0) return {};  // NOLINT(*-vararg)
        if (lock.l_type == F_UNLCK) return {.known = true, .holder = {}};
        return {.known = true, .holder = read_holder(file)};
    } catch (const std::system_error&) {
        return {};  // no lock was ever taken there, or it is not for this user to see
    }
}

}  // namespace riffle::inline output
