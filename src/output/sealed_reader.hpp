#pragma once

#include <filesystem>

#include "output/byte_store.hpp"
#include "output/sealed_content.hpp"

namespace riffle::inline output {

/// A sealed file for reading. While it is open, a process that changes the file puts a new one in its place
/// (flock), so that the content stays what it was. Throws NotWhole, and std::system_error.
class SealedReader final : public ByteStore {
  public:
    SealedReader(const std::filesystem::path& path, SealKind kind);

    [[nodiscard]] const SealedContent& content() const { return content_; }
    [[nodiscard]] std::uint64_t size() const override { return content_.seal().size; }
    void read(std::uint64_t at, std::span<std::byte> bytes) override { content_.read(at, bytes); }
    void write(std::uint64_t at, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

  private:
    SealedContent content_;
};

/// An HDF5 file without a seal, of an earlier Riffle or of another program, for reading. Throws
/// std::system_error.
class PlainReader final : public ByteStore {
  public:
    explicit PlainReader(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t size() const override { return size_; }
    void read(std::uint64_t at, std::span<std::byte> bytes) override;
    void write(std::uint64_t at, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

  private:
    FileDescriptor file_;
    std::uint64_t size_;
};

/// Open a sealed file, or an HDF5 file that has no seal. Throws NotWhole, and std::system_error.
[[nodiscard]] std::unique_ptr<ByteStore> open_for_reading(const std::filesystem::path& path, SealKind kind);

}  // namespace riffle::inline output
