#pragma once

#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace riffle::test {

/// A folder of its own for a test, removed with all in it at the end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        // In memory where there is such a place: the tests flush to the disk hundreds of times.
        const std::filesystem::path memory = "/dev/shm";
        const bool in_memory = ::access(memory.c_str(), W_OK) == 0;
        const std::filesystem::path parent = in_memory ? memory : std::filesystem::temp_directory_path();
        std::string pattern = (parent / "riffle-test-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make " + pattern);
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A folder that lasts as long as the process. Tests run side by side, each in a process of its own: a name
/// that two of them share in one folder is read by one while the other writes it.
inline const std::filesystem::path& folder_of_this_process() {
    static const TemporaryFolder folder;
    return folder.path();
}

/// A disk in memory of the given size, mounted on a folder.
class SmallDisk {
  public:
    explicit SmallDisk(const std::string& size) {
        if (::mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, ("size=" + size).c_str()) != 0) {
            error_ = errno;
        }
    }
    ~SmallDisk() {
        if (mounted()) ::umount2(folder_.path().c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    /// False where this user may not mount.
    bool mounted() const { return error_ == 0; }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    const std::filesystem::path& path() const { return folder_.path(); }

    /// Leave only so many bytes free.
    void fill_up_to(std::size_t left) const {
        const std::uintmax_t free = std::filesystem::space(path()).available;
        if (free <= left) return;
        std::ofstream(path() / "filler", std::ios::binary) << std::string(free - left, 'x') << std::flush;
    }

  private:
    TemporaryFolder folder_;
    int error_ = 0;
};

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << bytes;
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

inline std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.insert(entry.path().filename());
    }
    return names;
}

}  // namespace riffle::test
