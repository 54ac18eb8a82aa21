#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset.hpp"

namespace riffle::inline output {

/// Read access to the datasets and attributes of a file of Riffle. What is read is checked first against the
/// checksums of the file. Throws FileError. The HDF5 library serves one thread at a time.
class ContentReader {
  public:
    ~ContentReader();
    ContentReader(ContentReader&&) noexcept;
    ContentReader& operator=(ContentReader&&) noexcept;
    ContentReader(const ContentReader&) = delete;
    ContentReader& operator=(const ContentReader&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const;
    [[nodiscard]] bool has(const std::string& path) const;
    [[nodiscard]] std::vector<std::string> children(const std::string& group) const;  ///< sorted names
    [[nodiscard]] bool is_group(const std::string& path) const;
    [[nodiscard]] Dataset read(const std::string& path) const;
    [[nodiscard]] std::vector<double> read_doubles(const std::string& path) const;  ///< any numeric type
    [[nodiscard]] std::string read_string(const std::string& path) const;

    /// Lengths of the axes of a dataset.
    [[nodiscard]] std::vector<std::size_t> shape(const std::string& path) const;

    /// The rows `first`, `first + stride`, ... along the first axis, `count` of them: a part of what may be
    /// larger than the memory. Rows beyond the last are a FileError.
    [[nodiscard]] std::vector<double> read_rows(const std::string& path, std::size_t first, std::size_t count,
                                                std::size_t stride = 1) const;
    [[nodiscard]] std::optional<AttributeValue> attribute(const std::string& path,
                                                          const std::string& name) const;
    /// Names of the attributes of a group or dataset, sorted.
    [[nodiscard]] std::vector<std::string> attribute_names(const std::string& path) const;

    struct Impl;

  protected:
    explicit ContentReader(std::unique_ptr<Impl> impl);
    [[nodiscard]] const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace riffle::inline output
