#pragma once

#include <filesystem>
#include <memory>

#include "output/content_reader_impl.hpp"

namespace riffle::inline output {

/// A results file, open for reading, sure of its format and version. Throws FileError: missing, unreadable,
/// not HDF5, truncated, not a results file of Riffle, of another format version.
[[nodiscard]] std::unique_ptr<ContentReader::Impl> open_results(const std::filesystem::path& path);

/// Throw FileError unless an HDF5 file is one of results in the format that this Riffle reads.
void require_results_format(const Hdf5Handle& file, const std::filesystem::path& path);

/// Throw the FileError of a file that is missing or cannot be read at all.
void require_readable(const std::filesystem::path& path);

/// What to do about a damaged results file: where something of it could not be read, and where what is lost
/// of it has been said, or cannot be known.
inline constexpr const char* after_damage =
    "Restore it from a copy, or run the case again; `riffle verify` lists what of it is lost.";
inline constexpr const char* after_loss = "Restore it from a copy, or run the case again.";

}  // namespace riffle::inline output
