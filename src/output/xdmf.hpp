#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riffle::inline output {

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
    /// Snapshot whose dataset "point" holds the numbers 0 to N - 1; unset: they are written out in the index.
    std::optional<std::size_t> points_in = {};
};

/// Write the XDMF 3 index of the snapshots that ParaView and VTK open: a temporal collection of point clouds
/// whose arrays lie in the results file. `results_file_name`: as seen from the folder of `path`. `fields`:
/// the one named "position" (three components) gives the points, the others are arrays on them. Atomic like
/// write_text_atomically. Throws FileError, and std::invalid_argument without a "position" or with components
/// other than 1 or 3.
void write_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                const std::vector<SnapshotEntry>& snapshots, const std::vector<SnapshotField>& fields);

/// What bounds the water, in the group "/boundaries" of the results file.
struct BoundaryIndex {
    std::size_t walls = 0;     ///< particles
    std::size_t vertices = 0;  ///< of the solids
    std::vector<std::size_t>
        corners;  ///< of the outline of each solid, in the order of the vertices; two dimensions
    std::size_t triangles = 0;  ///< of the solids, three dimensions
    std::size_t spheres = 0;
    /// Where solids move, the snapshots whose groups hold "wall_position" and "solid_vertices"; else empty.
    std::vector<SnapshotEntry> moved;
};

/// Write the XDMF index of the boundaries: a point cloud of the wall particles, the surfaces of the solids,
/// the centres of the spheres; where solids move, a set of these for each snapshot. Atomic like
/// write_text_atomically. Throws FileError.
void write_boundary_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                         const BoundaryIndex& boundaries);

/// Cell values on a grid of boxes, one set for each of several times.
struct GridSeries {
    std::string group;                         ///< of the datasets in the results file
    std::array<std::vector<double>, 3> edges;  ///< of the cells along x, y and z, m
    std::vector<double> times;                 ///< of the rows of the datasets, s
    std::vector<std::string> fields;           ///< datasets of shape (times, z, y, x), 32-bit floating point
};

/// Write the XDMF index of a series of rectilinear grids with cell-centred values that lie in the results
/// file. For the "XDMF Reader" of ParaView (vtkXdmfReader): the XDMF 3 readers know no part of a dataset.
/// Atomic like write_text_atomically. Throws FileError.
void write_grid_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                     const GridSeries& grid);

}  // namespace riffle::inline output
