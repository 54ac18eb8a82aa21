#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "output/dataset.hpp"

namespace riffle {

inline constexpr int checkpoint_format_version = 1;

/// A checkpoint: the whole state of a run, as an HDF5 file whose user block carries a checksum of all the
/// rest, so that a truncated or altered file is refused and never half read. Give "/" the attribute `time`
/// (double, s): messages about the file tell it. Not compressed: it is to be quick. The HDF5 library serves
/// one thread at a time.
class CheckpointFile {
  public:
    /// Write to a new file, flush it to the disk, keep the old checkpoint as "<stem>-previous<ext>", rename.
    /// A crash at any instant leaves a whole checkpoint under `path` (on file systems without hard links:
    /// under one of the two names). Throws FileError; the old checkpoint is then untouched.
    static void write(const std::filesystem::path& path, const Content& content);

    /// Read and verify; datasets and attributes come sorted by path. Throws FileError saying what is wrong
    /// (truncated, altered, another version, missing) and how to go on (the previous checkpoint, when it is
    /// whole).
    [[nodiscard]] static Content read(const std::filesystem::path& path);

    /// Path of the checkpoint kept before the newest.
    [[nodiscard]] static std::filesystem::path previous(const std::filesystem::path& path);
};

}  // namespace riffle
