// The XDMF index of cell values on a grid.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/markup.hpp"
#include "output/atomic_file.hpp"
#include "output/xdmf.hpp"

namespace riffle::inline output {
namespace {

std::string geometry(const GridSeries& grid) {
    std::string text = R"(<Geometry GeometryType="VXVYVZ">)";
    for (const std::vector<double>& edges : grid.edges) {
        text += fmt::format(
            R"(
          <DataItem Format="XML" NumberType="Float" Precision="8" Dimensions="{}">{:.9g}</DataItem>)",
            edges.size(), fmt::join(edges, " "));
    }
    return text + "\n        </Geometry>";
}

}  // namespace

void write_grid_xdmf(const std::filesystem::path& path, const std::string& results_file_name,
                     const GridSeries& grid) {
    const auto& [x, y, z] = grid.edges;
    const std::string cells = fmt::format("{} {} {}", z.size() - 1, y.size() - 1, x.size() - 1);
    const std::string geometry_text = geometry(grid);
    std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
  <Domain>
    <Grid Name="mean field" GridType="Collection" CollectionType="Temporal">
)";
    for (std::size_t row = 0; row < grid.times.size(); ++row) {
        text += fmt::format(
            R"(      <Grid Name="{}" GridType="Uniform">
        <Time Value="{:.17g}"/>
        <Topology TopologyType="3DRectMesh" Dimensions="{} {} {}"/>
        {}
)",
            row, grid.times[row], z.size(), y.size(), x.size(), geometry_text);
        for (const std::string& field : grid.fields) {
            text += fmt::format(
                R"(        <Attribute Name="{0}" AttributeType="Scalar" Center="Cell">
          <DataItem ItemType="HyperSlab" NumberType="Float" Precision="4" Dimensions="{1}">
            <DataItem Format="XML" NumberType="Int" Dimensions="3 4">{2} 0 0 0 1 1 1 1 1 {1}</DataItem>
            <DataItem Format="HDF" NumberType="Float" Precision="4" Dimensions="{3} {1}">{4}:{5}/{0}</DataItem>
          </DataItem>
        </Attribute>
)",
                escape_markup(field), cells, row, grid.times.size(), escape_markup(results_file_name),
                escape_markup(grid.group));
        }
        text += "      </Grid>\n";
    }
    text += "    </Grid>\n  </Domain>\n</Xdmf>\n";
    write_text_atomically(path, text);
}

}  // namespace riffle::inline output
