#pragma once

#include <filesystem>

#include "output/hdf5_handle.hpp"

namespace riffle {

enum class ResultsAccess {
    read,           ///< from the disk
    copy_to_change  ///< a copy in memory
};

/// Open a results file, sure of its format and version. Throws FileError: missing, unreadable, not HDF5,
/// truncated, not a results file of Riffle, of another format version.
[[nodiscard]] Hdf5Handle open_results(const std::filesystem::path& path, ResultsAccess access);

}  // namespace riffle
