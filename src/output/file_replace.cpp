#include "output/file_replace.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace riffle {
namespace {

[[noreturn]] void throw_system_error(int code, const char* operation) {
    throw std::system_error(code, std::generic_category(), operation);
}

class FileDescriptor {
  public:
    FileDescriptor(const std::filesystem::path& path, int flags)
        : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0) throw_system_error(errno, "open");
    }
    ~FileDescriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    FileDescriptor(FileDescriptor&&) = delete;
    FileDescriptor& operator=(FileDescriptor&&) = delete;

    [[nodiscard]] int get() const { return descriptor_; }

    void write(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) throw_system_error(errno, "write");
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    void sync() const {
        // EINVAL: a file system that cannot flush this kind of file; there is nothing more to be had from it.
        if (::fsync(descriptor_) != 0 && errno != EINVAL) throw_system_error(errno, "fsync");
    }

    /// Network file systems report a failed write here.
    void close() {
        if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR)
            throw_system_error(errno, "close");
    }

  private:
    int descriptor_;
};

/// Removes a file again unless it has been moved to its place.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {}
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    TemporaryFile(TemporaryFile&&) = delete;
    TemporaryFile& operator=(TemporaryFile&&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void release() { path_.clear(); }

  private:
    std::filesystem::path path_;
};

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) { return path += suffix; }

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (::rename(from.c_str(), to.c_str()) != 0) throw_system_error(errno, "rename");
}

/// Let `kept` name the file at `path`, replacing what it named before without a gap.
void keep_file(const std::filesystem::path& path, const std::filesystem::path& kept,
               const StepObserver& observer) {
    const TemporaryFile link(with_suffix(kept, ".new"));
    ::unlink(link.path().c_str());
    observer("link the old file");
    if (::link(path.c_str(), link.path().c_str()) == 0) {
        observer("rename the link");
        // When both names are already links to one file, as after a crash at the next step, this leaves both
        // names; `link` is removed in any case.
        rename_file(link.path(), kept);
        observer("remove the link");
        return;
    }
    if (errno == ENOENT) return;      // nothing to keep: the first file under this name
    observer("rename the old file");  // a file system without hard links
    rename_file(path, kept);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> parts,
                  const ReplaceOptions& options) {
    const StepObserver observer = options.observer ? options.observer : [](std::string_view) {};
    observer("open");
    TemporaryFile fresh(with_suffix(path, ".new"));
    FileDescriptor file(fresh.path(), O_WRONLY | O_CREAT | O_TRUNC);
    for (const auto& part : parts) {
        observer("write");
        file.write(part);
    }
    observer("flush");
    file.sync();
    file.close();
    if (!options.keep_as.empty()) keep_file(path, options.keep_as, observer);
    observer("rename");
    rename_file(fresh.path(), path);
    fresh.release();
    observer("flush the folder");
    const FileDescriptor folder(folder_of(path), O_RDONLY | O_DIRECTORY);
    folder.sync();
    observer("done");
}

std::vector<std::byte> read_file_bytes(const std::filesystem::path& path) {
    const FileDescriptor file(path, O_RDONLY);
    struct stat status = {};
    if (::fstat(file.get(), &status) != 0) throw_system_error(errno, "fstat");
    if (S_ISDIR(status.st_mode)) throw_system_error(EISDIR, "read");
    std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_error(errno, "read");
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
    }
    bytes.resize(filled);
    return bytes;
}

std::string explain(const std::error_code& code, const std::filesystem::path& path,
                    std::optional<std::size_t> size) {
    const std::string folder = folder_of(path).string();
    const std::string text = code.message() + ". ";
    if (code == std::errc::no_space_on_device || code.value() == EDQUOT) {
        const char* which = code.value() == EDQUOT ? "Your quota on the disk" : "The disk";
        const std::string need =
            size ? fmt::format("at least {:.1f} MiB", static_cast<double>(*size) / (1024.0 * 1024.0))
                 : "space";
        return fmt::format("{}{} that holds {} is full: free {} there.", text, which, folder, need);
    }
    if (code == std::errc::permission_denied || code == std::errc::read_only_file_system ||
        code == std::errc::operation_not_permitted) {
        return fmt::format("{}Check the permissions of {} and of the folder {}.", text,
                           path.filename().string(), folder);
    }
    if (code == std::errc::no_such_file_or_directory) {
        return fmt::format("{}Check the path; the folder {} {}.", text, folder,
                           std::filesystem::is_directory(folder_of(path)) ? "exists" : "does not exist");
    }
    return fmt::format("{}Check the disk and the path.", text);
}

}  // namespace riffle
