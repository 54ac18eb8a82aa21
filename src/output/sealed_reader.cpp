#include "output/sealed_reader.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace riffle::inline output {
namespace {

/// How long a reader waits for a change of the file, which takes milliseconds.
constexpr std::chrono::seconds patience = std::chrono::seconds(2);

/// Open a file and keep others from changing it under the reader.
FileDescriptor open_and_lock(const std::filesystem::path& path) {
    FileDescriptor file(path, O_RDONLY);
    (void)file.size();  // not of a folder
    // Where the file system knows no locks, those who change the file replace it as a whole
    // (file_update.hpp).
    (void)file.lock(FileDescriptor::Lock::shared, patience);
    return file;
}

[[noreturn]] void refuse_to_write() {
    throw std::logic_error("a file that was opened for reading is written to");
}

}  // namespace

SealedReader::SealedReader(const std::filesystem::path& path, SealKind kind)
    : content_(open_and_lock(path), behind_links(path), kind) {}

void SealedReader::write(std::uint64_t /*at*/, std::span<const std::byte> /*bytes*/) { refuse_to_write(); }
void SealedReader::resize(std::uint64_t /*size*/) { refuse_to_write(); }

PlainReader::PlainReader(const std::filesystem::path& path) : file_(path, O_RDONLY), size_(file_.size()) {}

void PlainReader::read(std::uint64_t at, std::span<std::byte> bytes) {
    const std::size_t there = file_.read_at(at, bytes);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(there), bytes.end(), std::byte{0});
}
void PlainReader::write(std::uint64_t /*at*/, std::span<const std::byte> /*bytes*/) { refuse_to_write(); }
void PlainReader::resize(std::uint64_t /*size*/) { refuse_to_write(); }

std::unique_ptr<ByteStore> open_for_reading(const std::filesystem::path& path, SealKind kind) {
    std::array<std::byte, 8> start = {};
    const std::size_t there = FileDescriptor(path, O_RDONLY).read_at(0, start);
    if (starts_like_hdf5(std::span(start).first(there))) return std::make_unique<PlainReader>(path);
    return std::make_unique<SealedReader>(path, kind);
}

}  // namespace riffle::inline output
