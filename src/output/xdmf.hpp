#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace riffle {

/// Type of the elements of a snapshot's dataset.
enum class ElementType { float32, float64, int32, int64, uint8 };

/// One dataset of each snapshot.
struct SnapshotField {
    std::string name;            ///< of the dataset in "/snapshots/NNNNN"
    std::size_t components = 1;  ///< 1: scalar, shape (N); 3: vector, shape (N, 3)
    ElementType type = ElementType::float32;
};

/// One snapshot in the results file.
struct SnapshotEntry {
    std::size_t index = 0;      ///< NNNNN of "/snapshots/NNNNN"
    double time = 0;            ///< s
    std::size_t particles = 0;  ///< N
};

/// Write the XDMF 3 index of the snapshots that ParaView and VTK open: a temporal collection of point clouds
/// whose arrays lie in the results file. `results_file_name`: as seen from the folder of `path`. `fields`:
/// the one named "position" (three components) gives the points, the others are arrays on them. Atomic like
/// write_text_atomically. Throws FileError, and std::invalid_argument without a "position" or with components
/// other than 1 or 3.
void write_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                const std::vector<SnapshotEntry>& snapshots, const std::vector<SnapshotField>& fields);

}  // namespace riffle
