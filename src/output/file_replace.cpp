#include "output/file_replace.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace riffle::inline output {
namespace {

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) { return path += suffix; }

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (::rename(from.c_str(), to.c_str()) != 0) throw_system_error(errno, "rename");
}

/// Let `kept` name the file at `path`, replacing what it named before without a gap.
void keep_file(const std::filesystem::path& path, const std::filesystem::path& kept) {
    const std::filesystem::path link = with_suffix(kept, ".new");
    ::unlink(link.c_str());
    if (::link(path.c_str(), link.c_str()) == 0) {
        const int failed = ::rename(link.c_str(), kept.c_str()) == 0 ? 0 : errno;
        // When both names are already links to one file, as after a crash at the next step, renaming leaves
        // both names.
        ::unlink(link.c_str());
        if (failed != 0) throw_system_error(failed, "rename");
        return;
    }
    if (errno == ENOENT) return;  // nothing to keep: the first file under this name
    rename_file(path, kept);      // a file system without hard links
}

/// Whether something stands at the path that cannot be replaced by a file: a device, a pipe.
bool is_device(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return !error && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

}  // namespace

FileReplacement::FileReplacement(const std::filesystem::path& path, std::filesystem::path keep_as)
    : target_(behind_links(path)), kept_(std::move(keep_as)), fresh_(with_suffix(target_, ".new")) {
    if (is_device(target_)) throw_system_error(ENXIO, "replace");
    if (std::error_code error; std::filesystem::is_directory(target_, error)) {
        throw_system_error(EISDIR, "replace");
    }
    file_ = FileDescriptor(fresh_, O_RDWR | O_CREAT | O_TRUNC);
    file_.take_permissions_of(target_);
}

FileReplacement::~FileReplacement() {
    if (!fresh_.empty()) ::unlink(fresh_.c_str());
}

void FileReplacement::commit() {
    file_.sync();
    file_.close();
    if (!kept_.empty()) keep_file(target_, kept_);
    rename_file(fresh_, target_);
    fresh_.clear();
    sync_folder(folder_of(target_));
}

void replace_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> parts) {
    if (is_device(path)) {
        FileDescriptor device(path, O_WRONLY);
        for (const auto& part : parts) device.write(part);
        device.close();
        return;
    }
    FileReplacement replacement(path);
    for (const auto& part : parts) replacement.file().write(part);
    replacement.commit();
}

std::vector<std::byte> read_file_bytes(const std::filesystem::path& path) {
    const FileDescriptor file(path, O_RDONLY);
    std::vector<std::byte> bytes(file.size());
    bytes.resize(file.read_at(0, bytes));
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
    if (code == std::errc::file_too_large) {
        return fmt::format(
            "{}{} would grow beyond the limit for files here: raise it (ulimit -f), or write "
            "less (snapshots, probes).",
            text, path.filename().string());
    }
    if (code == std::errc::permission_denied || code == std::errc::read_only_file_system ||
        code == std::errc::operation_not_permitted) {
        return fmt::format("{}Check the permissions of {} and of the folder {}.", text,
                           path.filename().string(), folder);
    }
    if (code == std::errc::is_a_directory) return text + "Give the name of a file in that folder.";
    if (code == std::errc::no_such_file_or_directory) {
        return fmt::format("{}Check the path; the folder {} {}.", text, folder,
                           std::filesystem::is_directory(folder_of(path)) ? "exists" : "does not exist");
    }
    return fmt::format("{}Check the disk and the path.", text);
}

}  // namespace riffle::inline output
