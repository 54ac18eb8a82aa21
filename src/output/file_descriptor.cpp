#include "output/file_descriptor.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <thread>
#include <utility>

namespace riffle::inline output {

void throw_system_error(int code, const char* operation) {
    throw std::system_error(code, std::generic_category(), operation);
}

FileDescriptor::FileDescriptor(const std::filesystem::path& path, int flags)
    : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {  // NOLINT(*-vararg)
    if (descriptor_ < 0) throw_system_error(errno, "open");
}

FileDescriptor::~FileDescriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

std::uint64_t FileDescriptor::size() const {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0) throw_system_error(errno, "fstat");
    if (S_ISDIR(status.st_mode)) throw_system_error(EISDIR, "read");
    return static_cast<std::uint64_t>(status.st_size);
}

void FileDescriptor::write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw_system_error(errno, "write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void FileDescriptor::write_at(std::uint64_t at, std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw_system_error(errno, "write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        at += static_cast<std::uint64_t>(written);
    }
}

std::size_t FileDescriptor::read_at(std::uint64_t at, std::span<std::byte> bytes) const {
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::pread(descriptor_, bytes.data() + filled, bytes.size() - filled,
                                      static_cast<off_t>(at + filled));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_error(errno, "read");
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
    }
    return filled;
}

void FileDescriptor::resize(std::uint64_t size) const {
    while (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) {
        if (errno != EINTR) throw_system_error(errno, "ftruncate");
    }
}

void FileDescriptor::sync() const {
    // EINVAL: a file system that cannot flush this kind of file; there is nothing more to be had from it.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) throw_system_error(errno, "fsync");
}

void FileDescriptor::take_permissions_of(const std::filesystem::path& other) const {
    struct stat status = {};
    if (::stat(other.c_str(), &status) == 0) (void)::fchmod(descriptor_, status.st_mode & 07777U);
}

void FileDescriptor::close() {
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) throw_system_error(errno, "close");
}

FileDescriptor::Locked FileDescriptor::lock(Lock kind, std::chrono::milliseconds patience) const {
    constexpr std::chrono::milliseconds between = std::chrono::milliseconds(5);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (::flock(descriptor_, (kind == Lock::shared ? LOCK_SH : LOCK_EX) | LOCK_NB) != 0) {
        if (errno == EINTR) continue;
        if (errno != EWOULDBLOCK) return Locked::impossible;
        if (std::chrono::steady_clock::now() >= deadline) return Locked::held_by_another;
        std::this_thread::sleep_for(between);
    }
    return Locked::yes;
}

void FileDescriptor::unlock() const { (void)::flock(descriptor_, LOCK_UN); }

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

void sync_folder(const std::filesystem::path& folder) {
    const FileDescriptor open(folder, O_RDONLY | O_DIRECTORY);
    open.sync();
}

std::filesystem::path behind_links(std::filesystem::path path) {
    constexpr int most = 40;  // as the system itself follows
    for (int link = 0; link < most; ++link) {
        std::error_code error;
        const std::filesystem::path target = std::filesystem::read_symlink(path, error);
        if (error) return path;
        path = target.is_absolute() ? target : folder_of(path) / target;
    }
    throw_system_error(ELOOP, "open");
}

}  // namespace riffle::inline output
