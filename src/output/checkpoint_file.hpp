#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/content_reader.hpp"
#include "output/dataset.hpp"

namespace riffle::inline output {

/// A checkpoint: the whole state of a run, as an HDF5 file with checksums (seal.hpp), so that a truncated or
/// altered file is refused and never half read. Give "/" the attribute `time` (double, s): messages about the
/// file tell it. Not compressed: it is to be quick. The HDF5 library serves one thread at a time.
class CheckpointFile {
  public:
    /// Write to a new file, flush it to the disk, keep the old checkpoint as "<stem>-previous<ext>", rename.
    /// A crash at any instant leaves a whole checkpoint under `path` (on file systems without hard links:
    /// under one of the two names). Streamed values are made while they are written. Throws FileError; the
    /// old checkpoint is then untouched.
    static void write(const std::filesystem::path& path, const Content& content);

    /// Read and verify; datasets and attributes come sorted by path. Throws FileError as CheckpointReader.
    [[nodiscard]] static Content read(const std::filesystem::path& path);

    /// Let `path` be a copy of the checkpoint `other`, in one step. Throws FileError; `path` is then
    /// untouched.
    static void adopt(const std::filesystem::path& path, const std::filesystem::path& other);

    /// Path of the checkpoint kept before the newest.
    [[nodiscard]] static std::filesystem::path previous(const std::filesystem::path& path);
};

/// Read access to a checkpoint, of which the whole has been verified. Throws FileError saying what is wrong
/// (truncated, altered, another version, missing) and how to go on (the previous checkpoint, when it is
/// whole).
class CheckpointReader : public ContentReader {
  public:
    explicit CheckpointReader(const std::filesystem::path& path);

    /// A number that is an attribute of a group. Throws FileError where it is missing or no number.
    [[nodiscard]] double number(const std::string& group, const std::string& name) const;
    /// A whole number from 0 to `most`.
    [[nodiscard]] std::size_t count(const std::string& group, const std::string& name,
                                    std::size_t most) const;
    /// A dataset of so many doubles. Throws FileError where it is missing, of another type or another length.
    [[nodiscard]] std::vector<double> doubles(const std::string& path, std::size_t length) const;
};

}  // namespace riffle::inline output
