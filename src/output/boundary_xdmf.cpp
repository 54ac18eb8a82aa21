#include <fmt/format.h>

#include <iterator>

#include "base/markup.hpp"
#include "output/atomic_file.hpp"
#include "output/results_file.hpp"
#include "output/xdmf.hpp"

namespace riffle::inline output {

namespace {

/// Writes the grids of one instant; the arrays that move lie in the group of a snapshot.
class BoundaryGrids {
  public:
    BoundaryGrids(const std::string& file, const BoundaryIndex& boundaries)
        : file_(escape_markup(file)), boundaries_(boundaries) {}

    /// `snapshot`: null where nothing moves.
    [[nodiscard]] std::string at(const SnapshotEntry* snapshot) const {
        std::string text =
            "    <Grid Name=\"boundaries\" GridType=\"Collection\" CollectionType=\"Spatial\">\n";
        if (snapshot != nullptr) text += fmt::format("      <Time Value=\"{:.17g}\"/>\n", snapshot->time);
        const std::string moved = snapshot != nullptr ? snapshot_group(snapshot->index) : "";
        if (boundaries_.walls > 0) {
            text += grid("walls", points("/boundaries/walls/point", boundaries_.walls), boundaries_.walls,
                         moved.empty() ? "/boundaries/walls/position" : moved + "/wall_position",
                         attribute("body", "/boundaries/walls/body", boundaries_.walls));
        }
        if (boundaries_.vertices > 0) {
            text += grid("solids", surface(), boundaries_.vertices,
                         moved.empty() ? "/boundaries/solids/vertices" : moved + "/solid_vertices",
                         attribute("body", "/boundaries/solids/body", boundaries_.vertices));
        }
        if (boundaries_.spheres > 0) {
            text += grid("spheres", points("/boundaries/spheres/point", boundaries_.spheres),
                         boundaries_.spheres, "/boundaries/spheres/centre", "");
        }
        return text + "    </Grid>\n";
    }

  private:
    [[nodiscard]] std::string grid(const char* name, const std::string& topology, std::size_t count,
                                   const std::string& position, const std::string& more) const {
        return fmt::format(R"(      <Grid Name="{}" GridType="Uniform">
{}        <Geometry GeometryType="XYZ">
          <DataItem Format="HDF" NumberType="Float" Precision="4" Dimensions="{} 3">{}:{}</DataItem>
        </Geometry>
{}      </Grid>
)",
                           name, topology, count, file_, position, more);
    }

    [[nodiscard]] std::string points(const char* list, std::size_t count) const {
        return fmt::format(
            R"(        <Topology TopologyType="Polyvertex" NumberOfElements="{0}" NodesPerElement="1">
          <DataItem Format="HDF" NumberType="Int" Precision="4" Dimensions="{0}">{1}:{2}</DataItem>
        </Topology>
)",
            count, file_, list);
    }

    [[nodiscard]] std::string attribute(const char* name, const char* path, std::size_t count) const {
        return fmt::format(R"(        <Attribute Name="{}" AttributeType="Scalar" Center="Node">
          <DataItem Format="HDF" NumberType="Int" Precision="4" Dimensions="{}">{}:{}</DataItem>
        </Attribute>
)",
                           name, count, file_, path);
    }

    /// Triangles, or in two dimensions the closed outlines as polylines.
    [[nodiscard]] std::string surface() const {
        if (boundaries_.triangles > 0) {
            return fmt::format(R"(        <Topology TopologyType="Triangle" NumberOfElements="{0}">
          <DataItem Format="HDF" NumberType="Int" Precision="4" Dimensions="{0} 3">{1}:/boundaries/solids/triangles</DataItem>
        </Topology>
)",
                               boundaries_.triangles, file_);
        }
        constexpr int polyline = 2;  // of XDMF's mixed topologies
        std::string numbers;
        std::size_t entries = 0;
        std::size_t first = 0;
        for (const std::size_t corners : boundaries_.corners) {
            fmt::format_to(std::back_inserter(numbers), "{} {}", polyline, corners + 1);
            for (std::size_t i = 0; i <= corners; ++i) {
                fmt::format_to(std::back_inserter(numbers), " {}", first + i % corners);
            }
            numbers += '\n';
            entries += corners + 3;
            first += corners;
        }
        return fmt::format(R"(        <Topology TopologyType="Mixed" NumberOfElements="{}">
          <DataItem Format="XML" NumberType="Int" Precision="4" Dimensions="{}">
{}          </DataItem>
        </Topology>
)",
                           boundaries_.corners.size(), entries, numbers);
    }

    std::string file_;
    const BoundaryIndex& boundaries_;
};

}  // namespace

void write_boundary_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                         const BoundaryIndex& boundaries) {
    if (boundaries.walls + boundaries.vertices + boundaries.spheres == 0) return;
    const BoundaryGrids grids(results_file_name, boundaries);
    std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
  <Domain>
)";
    if (boundaries.moved.empty()) {
        text += grids.at(nullptr);
    } else {
        text += "  <Grid Name=\"boundaries in time\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
        for (const SnapshotEntry& snapshot : boundaries.moved) text += grids.at(&snapshot);
        text += "  </Grid>\n";
    }
    text += "  </Domain>\n</Xdmf>\n";
    write_text_atomically(path, text);
}

}  // namespace riffle::inline output
