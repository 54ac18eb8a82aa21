#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <system_error>

namespace riffle::inline output {

/// Throw std::system_error with the text of `code` (errno) for an operation of this name.
[[noreturn]] void throw_system_error(int code, const char* operation);

/// An open file. All functions throw std::system_error.
class FileDescriptor {
  public:
    FileDescriptor() = default;
    /// `flags`: of open(2); O_CLOEXEC is added. A new file can be read by all whom the umask lets.
    FileDescriptor(const std::filesystem::path& path, int flags);
    ~FileDescriptor();
    FileDescriptor(FileDescriptor&& other) noexcept;
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] int get() const { return descriptor_; }
    [[nodiscard]] std::uint64_t size() const;

    void write(std::span<const std::byte> bytes) const;
    void write_at(std::uint64_t at, std::span<const std::byte> bytes) const;
    /// Bytes read: fewer than asked for at the end of the file only.
    [[nodiscard]] std::size_t read_at(std::uint64_t at, std::span<std::byte> bytes) const;
    void resize(std::uint64_t size) const;
    /// Flush to the disk; where a file system cannot, nothing.
    void sync() const;
    /// Give this file the permissions of the one at a path, where there is one.
    void take_permissions_of(const std::filesystem::path& other) const;
    /// Network file systems report a failed write here.
    void close();

    enum class Lock { shared, exclusive };
    enum class Locked { yes, held_by_another, impossible };
    /// Lock the whole file as HDF5 does (flock), waiting for others for so long. `impossible`: this file
    /// system knows no such locks.
    [[nodiscard]] Locked lock(Lock kind, std::chrono::milliseconds patience) const;
    void unlock() const;

  private:
    int descriptor_ = -1;
};

/// The folder that a file stands in, "." where its path names none.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& path);

/// Flush the names in a folder to the disk.
void sync_folder(const std::filesystem::path& folder);

/// The file that a path leads to through symbolic links, whether it exists or not. Throws std::system_error
/// where links go in circles.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

}  // namespace riffle::inline output
