#include "output/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/markup.hpp"
#include "output/atomic_file.hpp"
#include "output/results_file.hpp"

namespace riffle::inline output {
namespace {

const char* element_type(ElementType type) {
    switch (type) {
        case ElementType::float32:
            return R"(NumberType="Float" Precision="4")";
        case ElementType::float64:
            return R"(NumberType="Float" Precision="8")";
        case ElementType::int32:
            return R"(NumberType="Int" Precision="4")";
        case ElementType::int64:
            return R"(NumberType="Int" Precision="8")";
        case ElementType::uint8:
            return R"(NumberType="UChar" Precision="1")";
    }
    throw std::invalid_argument("XDMF: unknown element type");
}

std::string data_item(const std::string& file, const SnapshotEntry& snapshot, const SnapshotField& field) {
    const std::string columns = field.components == 1 ? "" : fmt::format(" {}", field.components);
    return fmt::format(R"(<DataItem Format="HDF" {} Dimensions="{}{}">{}:{}/{}</DataItem>)",
                       element_type(field.type), snapshot.particles, columns, escape_markup(file),
                       snapshot_group(snapshot.index), escape_markup(field.name));
}

/// Which points are drawn: all of them. XDMF 2 readers draw all points without being told, XDMF 3 readers
/// none. The list is a dataset of the results file, or is written out once for each number of particles, and
/// included afterwards.
class Topologies {
  public:
    explicit Topologies(std::string file) : file_(std::move(file)) {}

    /// `grid_number`: of the grid that this topology is for, counted from 1.
    std::string of(std::size_t grid_number, const SnapshotEntry& snapshot) {
        const std::size_t particles = snapshot.particles;
        if (snapshot.points_in) {
            const SnapshotEntry list{.index = *snapshot.points_in, .particles = particles};
            return fmt::format(
                R"(<Topology TopologyType="Polyvertex" NumberOfElements="{}" NodesPerElement="1">
          {}
        </Topology>)",
                particles,
                data_item(file_, list, {.name = "point", .components = 1, .type = ElementType::int32}));
        }
        const auto [place, first] = grid_with_.try_emplace(particles, grid_number);
        if (!first) {
            return fmt::format(
                R"xml(<xi:include xpointer="xpointer(/Xdmf/Domain/Grid/Grid[{}]/Topology)"/>)xml",
                place->second);
        }
        std::string text = fmt::format(
            R"(<Topology TopologyType="Polyvertex" NumberOfElements="{0}" NodesPerElement="1">
          <DataItem Format="XML" NumberType="Int" Precision="4" Dimensions="{0}">)",
            particles);
        for (std::size_t point = 0; point < particles; ++point) {
            fmt::format_to(std::back_inserter(text), "{}{}", point % 16 == 0 ? '\n' : ' ', point);
        }
        return text + "\n          </DataItem>\n        </Topology>";
    }

  private:
    std::string file_;
    std::map<std::size_t, std::size_t> grid_with_;  ///< by number of particles
};

std::string grid(const std::string& file, const SnapshotEntry& snapshot, const std::string& topology,
                 const SnapshotField& position, const std::vector<SnapshotField>& fields) {
    std::string text = fmt::format(
        R"(      <Grid Name="{:05}" GridType="Uniform">
        <Time Value="{:.17g}"/>
        {}
        <Geometry GeometryType="XYZ">
          {}
        </Geometry>
)",
        snapshot.index, snapshot.time, topology, data_item(file, snapshot, position));
    for (const SnapshotField& field : fields) {
        if (field.name == position.name) continue;
        text += fmt::format(
            R"(        <Attribute Name="{}" AttributeType="{}" Center="Node">
          {}
        </Attribute>
)",
            escape_markup(field.name), field.components == 1 ? "Scalar" : "Vector",
            data_item(file, snapshot, field));
    }
    return text + "      </Grid>\n";
}

}  // namespace

void write_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                const std::vector<SnapshotEntry>& snapshots, const std::vector<SnapshotField>& fields) {
    const auto position = std::find_if(fields.begin(), fields.end(),
                                       [](const SnapshotField& field) { return field.name == "position"; });
    if (position == fields.end() || position->components != 3) {
        throw std::invalid_argument("XDMF: the snapshots need a field \"position\" of three components");
    }
    for (const SnapshotField& field : fields) {
        if (field.components != 1 && field.components != 3) {
            throw std::invalid_argument("XDMF: " + field.name + " is neither a scalar nor a vector");
        }
    }
    std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0" xmlns:xi="http://www.w3.org/2001/XInclude">
  <Domain>
    <Grid Name="particles" GridType="Collection" CollectionType="Temporal">
)";
    Topologies topologies(results_file_name);
    std::size_t grids = 0;
    for (const SnapshotEntry& snapshot : snapshots) {
        if (snapshot.particles == 0) continue;  // readers refuse a cloud without points
        const std::string topology = topologies.of(++grids, snapshot);
        text += grid(results_file_name, snapshot, topology, *position, fields);
    }
    text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
    write_text_atomically(path, text);
}

}  // namespace riffle::inline output
