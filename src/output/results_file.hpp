#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "output/content_reader.hpp"
#include "output/dataset.hpp"

namespace riffle::inline output {

inline constexpr int results_format_version = 1;

/// Path of a snapshot's group: "/snapshots/00012".
[[nodiscard]] std::string snapshot_group(std::size_t index);

/// The one HDF5 file of a run. Every update is one step (file_update.hpp): a crash or a full disk at any
/// moment leaves the content before it or after it. Large arrays and appended series are compressed. All
/// functions throw FileError (saying what is still intact and how to go on), and std::invalid_argument for
/// content that fits no file: values that do not make the shape, rows of another width or type than those in
/// the file. The HDF5 library serves one thread at a time.
class ResultsFile {
  public:
    /// Create a new results file (replacing nothing: throws FileError if it exists and `overwrite` is false).
    /// Adds the attributes `format` and `format_version` of "/".
    static void create(const std::filesystem::path& path, const Content& content, bool overwrite);

    /// Append rows, replace datasets and attributes, in one atomic step. `rows`: before appending, each named
    /// dataset is cut to that many rows (used on resume, when the file is ahead of the checkpoint); groups
    /// "/snapshots/NNNNN" with an index >= `snapshots` are removed when `snapshots` is set. A dataset with
    /// fewer rows than asked for is a FileError: rows would be missing. `removed`: objects to be removed,
    /// where they are there.
    static void update(const std::filesystem::path& path, const Content& content,
                       const std::map<std::string, std::size_t>& rows = {},
                       std::optional<std::size_t> snapshots = std::nullopt,
                       const std::vector<std::string>& removed = {});

    /// Make checksums for a file that has been changed on purpose by another program, or has none: its
    /// content is copied as HDF5 reads it.
    static void accept(const std::filesystem::path& path);
};

/// Read access to a results file: what it held when it was opened, also while a run goes on to write. Throws
/// FileError when it is missing, damaged, not a Riffle results file, or of another format version (naming
/// both versions and what to do).
class ResultsReader : public ContentReader {
  public:
    explicit ResultsReader(const std::filesystem::path& path);

    /// Compare the whole file with its checksums. Throws FileError, naming what is lost. Files without
    /// checksums, which other programs and the first Riffle write, pass. Returns how many bytes stand behind
    /// the end of what is whole: a change in place that did not come to its end leaves some.
    std::uint64_t verify() const;
    [[nodiscard]] bool has_checksums() const;
};

}  // namespace riffle::inline output
