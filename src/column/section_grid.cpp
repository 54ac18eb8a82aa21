#include "column/section_grid.hpp"

#include "case/bed_friction.hpp"
#include "case/porous_zone.hpp"
#include "column/column_grid.hpp"

namespace riffle::inline column {

SectionGrid make_section_grid(const Case& c, int cells_across, int cells_over_depth) {
    constexpr int fewest = 4;
    constexpr double even = 0.8;  // what varies across the channel varies beside the wall
    SectionGrid grid;
    // The log layer of a plane bed takes more cells than what spheres make of the profile.
    const ColumnGrid column =
        make_column_grid(c, has_wall_law(c) ? 5 * cells_over_depth / 2 : cells_over_depth);
    grid.z_face = column.face;
    grid.z = column.centre;
    std::vector<double> across;
    if (c.side_walls.drag_form != SideDragForm::none) across.push_back(c.side_layer());
    if (c.turbulence.closure == ClosureKind::czernuszenko_rylov) {
        across.push_back(c.turbulence.edge_zone * 0.5 * c.total_depth());
    }
    // The layer of lateral shear beside the wall reaches some depths into the flow.
    const double edge = across.empty() ? 0.0 : across.back();
    for (const double depths : {0.4, 1.2}) across.push_back(edge + depths * c.total_depth());
    for (const Vegetation& stems : c.vegetation) {
        for (const auto& side : {stems.y_from, stems.y_to}) {
            if (side) across.push_back(*side);
        }
    }
    for (const BedPatch& patch : c.bed_patches) {
        for (const auto& side : {patch.y_from, patch.y_to}) {
            if (side) across.push_back(*side);
        }
    }
    for (const Porous& zone : c.porous) {
        const double half = 0.5 * porous_edge(c, zone);
        for (const auto& side : {zone.y_from, zone.y_to}) {
            if (!side) continue;
            for (const double part : {-half, 0.0, half}) across.push_back(*side + part);
        }
    }
    grid.y_face =
        graded_faces(distinct_between(across, 0.0, c.channel.centreline()), cells_across, fewest, even);
    grid.y = midpoints(grid.y_face);
    return grid;
}

}  // namespace riffle::inline column
