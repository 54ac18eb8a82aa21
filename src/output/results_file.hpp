#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset.hpp"

namespace riffle {

inline constexpr int results_format_version = 1;

/// Path of a snapshot's group: "/snapshots/00012".
[[nodiscard]] std::string snapshot_group(std::size_t index);

/// The one HDF5 file of a run. Every update copies the file (in memory), changes the copy, and renames it
/// over the old one, so that a crash or a full disk at any moment leaves the previous file whole. Large
/// arrays and appended series are compressed. All functions throw FileError (saying what is still intact and
/// how to go on), and std::invalid_argument for content that fits no file: values that do not make the shape,
/// rows of another width or type than those in the file. The HDF5 library serves one thread at a time.
class ResultsFile {
  public:
    /// Create a new results file (replacing nothing: throws FileError if it exists and `overwrite` is false).
    /// Adds the attributes `format` and `format_version` of "/".
    static void create(const std::filesystem::path& path, const Content& content, bool overwrite);

    /// Append rows, replace datasets and attributes, in one atomic step. `rows`: before appending, each named
    /// dataset is cut to that many rows (used on resume, when the file is ahead of the checkpoint); groups
    /// "/snapshots/NNNNN" with an index >= `snapshots` are removed when `snapshots` is set. A dataset with
    /// fewer rows than asked for is a FileError: rows would be missing.
    static void update(const std::filesystem::path& path, const Content& content,
                       const std::map<std::string, std::size_t>& rows = {},
                       std::optional<std::size_t> snapshots = std::nullopt);
};

/// Read access to a results file. Throws FileError when it is missing, damaged, not a Riffle results file,
/// or of another format version (naming both versions and what to do).
class ResultsReader {
  public:
    explicit ResultsReader(const std::filesystem::path& path);
    ~ResultsReader();
    ResultsReader(ResultsReader&&) noexcept;
    ResultsReader& operator=(ResultsReader&&) noexcept;
    ResultsReader(const ResultsReader&) = delete;
    ResultsReader& operator=(const ResultsReader&) = delete;

    [[nodiscard]] bool has(const std::string& path) const;
    [[nodiscard]] std::vector<std::string> children(const std::string& group) const;  ///< sorted names
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

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace riffle
