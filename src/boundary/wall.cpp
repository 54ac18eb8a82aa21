#include "boundary/wall.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "boundary/mesh_fill.hpp"
#include "boundary/solid_fill.hpp"
#include "boundary/wall_particle.hpp"
#include "case/bed_traits.hpp"
#include "case/end_buffers.hpp"
#include "case/end_levels.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline boundary {

WallAction wall_action(const Case& c) {
    WallAction action{.dynamic = c.numerics.wall == WallKind::dynamic,
                      .no_slip = is_no_slip(c.bed) || c.numerics.wall == WallKind::dynamic,
                      .solid_no_slip = {},
                      .mirror = c.channel.sides == Sides::half};
    for (const Solid& solid : c.solids) {
        action.solid_no_slip.push_back(solid.surface == SolidSurface::no_slip);
    }
    return action;
}

bool starts_beside_dry_walls(const Case& c) { return !c.start.water_x.empty() || !c.solids.empty(); }

namespace {

/// End walls stand half a depth above the still water, for waves, or as high as the case says; with a lid
/// they end at it.
int end_wall_rows(const Case& c, const Lattice& lattice) {
    if (c.channel.top == Top::wall) return lattice.rows;
    const auto rows_up_to = [&](double height) {
        return static_cast<int>(std::ceil(height / lattice.dz - 1e-9));
    };
    if (c.channel.wall_height) return rows_up_to(*c.channel.wall_height);
    const int usual = lattice.rows + lattice.rows / 2;
    // Half as high again as what stands there; tables at open ends may ask for more than the case shows.
    const double highest = has_end_tables(c) ? level_with_room(c) : 1.5 * highest_end_level(c);
    return highest > 1.5 * c.total_depth() ? std::max(usual, rows_up_to(highest)) : usual;
}

/// Columns of wall particles before the channel: the layers of its wall, or what stands below a buffer.
int columns_beyond(const Case& c, const Lattice& lattice) {
    switch (c.channel.ends) {
        case Ends::walls:
            return c.numerics.wall_layers;
        case Ends::open:
            return static_cast<int>(std::ceil(buffer_length(c) / lattice.dx)) + c.numerics.wall_layers;
        case Ends::periodic:
            break;
    }
    return 0;
}

/// The same behind it; none where the bed ends.
int columns_behind(const Case& c, const Lattice& lattice) {
    return bed_ends(c) ? 0 : columns_beyond(c, lattice);
}

}  // namespace

double end_wall_height(const Case& c) {
    const Lattice lattice = lattice_of(c);
    return end_wall_rows(c, lattice) * lattice.dz;
}

template <>
WallParticles<2> wall_particles<2>(const Case& c) {
    WallParticles<2> wall;
    if (c.channel.top == Top::periodic || c.numerics.wall == WallKind::repulsive) return wall;
    const Lattice lattice = lattice_of(c);
    const bool dynamic = c.numerics.wall == WallKind::dynamic;
    const int layers = c.numerics.wall_layers;
    const double volume = lattice.dx * lattice.dz;
    const double depth = c.total_depth();
    const bool closed = c.channel.ends == Ends::walls;
    const int beyond = columns_beyond(c, lattice);
    const int behind_it = columns_behind(c, lattice);

    // Dummy particles stand on the continuation of the lattice; dynamic ones in staggered layers half a
    // spacing apart (thesis; SPHysics).
    const auto layer_depth = [&](int layer, double spacing) {
        return dynamic ? 0.5 * (layer + 1) * spacing : (layer + 0.5) * spacing;
    };
    const auto x_of = [&](int column, int row, int layer) {
        return dynamic ? (column + 0.5 + (layer % 2 == 1 ? 0.5 : 0.0)) * lattice.dx : lattice.x(column, row);
    };
    const auto add = [&](double x, double z, const Vec<2>& normal, double behind,
                         std::int32_t body = resting_body) {
        add_wall_particle(wall, {{x, z}, volume, normal, behind, body});
    };
    for (int layer = 0; layer < layers; ++layer) {
        const double behind = layer_depth(layer, lattice.dz);
        for (int column = -beyond; column < lattice.columns + behind_it; ++column) {
            const bool corner = closed && (column < 0 || column >= lattice.columns);
            const bool periodic = c.channel.ends == Ends::periodic;
            const auto wrapped = [&](double x) { return periodic ? std::fmod(x, c.channel.length) : x; };
            add(wrapped(x_of(column, -1 - layer, layer)), -behind, corner ? Vec<2>{} : Vec<2>{0.0, 1.0},
                behind);
            if (c.channel.top == Top::wall) {
                // The corners belong to the end walls, which stand still.
                add(wrapped(x_of(column, lattice.rows + layer, layer)), depth + behind,
                    corner ? Vec<2>{} : Vec<2>{0.0, -1.0}, behind, corner ? resting_body : lid_body);
            }
        }
    }
    if (closed) {
        const int rows = end_wall_rows(c, lattice);
        const double length = c.channel.length;
        for (int layer = 0; layer < layers; ++layer) {
            for (int row = 0; row < rows; ++row) {
                const double left = dynamic ? -layer_depth(layer, lattice.dx) : lattice.x(-1 - layer, row);
                const double right = dynamic ? length - left : lattice.x(lattice.columns + layer, row);
                add(left, lattice.z(row), {1.0, 0.0}, -left);
                add(right, lattice.z(row), {-1.0, 0.0}, right - length);
            }
        }
    }
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        add_solid(c, c.solids[k], first_solid + static_cast<std::int32_t>(k), wall);
    }
    if (c.solids.empty() && c.channel.lid_velocity == 0.0) wall.body.clear();
    return wall;
}

template <>
WallParticles<3> wall_particles<3>(const Case& c) {
    WallParticles<3> wall;
    if (c.channel.top == Top::periodic || c.numerics.wall == WallKind::repulsive) return wall;
    const Lattice lattice = lattice_of(c);
    const int layers = c.numerics.wall_layers;
    // Rows of the body-centred lattice stand closer than the spacing.
    const int layers_below =
        lattice.arrangement == StartLattice::body_centred
            ? static_cast<int>(std::ceil(layers * c.numerics.spacing / lattice.dz - 1e-9))
            : layers;
    const bool sides = c.channel.sides != Sides::periodic;
    const bool ends = c.channel.ends == Ends::walls;
    const double width = c.channel.simulated_width();
    const double length = c.channel.length;
    const double depth = c.total_depth();
    const bool dynamic = c.numerics.wall == WallKind::dynamic;
    const bool lid = c.channel.top == Top::wall;
    // A place beyond the bed, the lid, a side or an end; beyond two or three of them it is an edge or a
    // corner. There all motion counts but that along the edge; it belongs to the walls at rest. Behind a
    // plane of symmetry walls at which the water rests go on.
    const bool walls_go_on = c.channel.sides == Sides::half && is_no_slip(c.bed);
    const auto add = [&](const Vec<3>& x, const std::array<int, 3>& faces, double behind) {
        const bool image = walls_go_on && faces[1] < 0 && (faces[0] != 0 || faces[2] != 0);
        const std::array<int, 3> holding{faces[0], image ? 0 : faces[1], faces[2]};
        const int walls = std::abs(holding[0]) + std::abs(holding[1]) + std::abs(holding[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            wall.position[k].push_back(x[k]);
            wall.normal[k].push_back(walls == 1 ? holding[k] : 0.0);
            for (std::size_t l = 0; l < 3; ++l) {
                wall.projector[3 * k + l].push_back(k == l && faces[k] != 0 ? 1.0 : 0.0);
            }
        }
        wall.volume.push_back(lattice.volume());
        wall.depth.push_back(behind);
        wall.body.push_back(walls == 1 && faces[2] < 0 ? lid_body : resting_body);
    };
    const int beside = sides ? layers : 0;
    const int beyond = columns_beyond(c, lattice);
    const int behind_it = columns_behind(c, lattice);
    const int top = end_wall_rows(c, lattice);
    // Layers of dynamic particles stand half a spacing apart, every other one shifted by half a spacing along
    // both of its directions (thesis; SPHysics); dummy particles on the continuation of the lattice. Between
    // two walls a shifted layer has one place less than the others, and is its own mirror image.
    const auto along = [](int i, int places, double spacing, double extent, bool walled,
                          bool shifted) -> std::optional<double> {
        if (walled && shifted && i == places - 1) return std::nullopt;
        const double at = (i + (shifted ? 1.0 : 0.5)) * spacing;
        return walled ? at : std::fmod(at, extent);
    };
    // A layer below the bed or above the lid.
    const auto add_level = [&](int column, int file, int layer, const std::array<int, 3>& faces) {
        const bool below = faces[2] > 0;
        const int row = below ? -1 - layer : lattice.rows + layer;
        if (!dynamic) {
            add({lattice.x(column, row), lattice.y(file, row), lattice.z(row)}, faces,
                (layer + 0.5) * lattice.dz);
            return;
        }
        const bool shifted = layer % 2 == 1;
        const auto x = along(column, lattice.columns + behind_it, lattice.dx, length, ends, shifted);
        const auto y = along(file, lattice.files + beside, lattice.dy, width, sides, shifted);
        const double behind = 0.5 * (layer + 1) * lattice.dz;
        if (x && y) {
            add({*x, *y, below ? -behind : depth + behind}, faces, behind);
        }
    };
    // A layer behind an end or a side, or where both meet.
    const auto add_beside = [&](int column, int file, int row, const std::array<int, 3>& faces) {
        if (!dynamic) {
            const double x = lattice.x(column, row);
            const double y = lattice.y(file, row);
            const double behind_end = faces[0] == 0 ? 0.0 : faces[0] > 0 ? -x : x - length;
            const double behind_side = faces[1] == 0 ? 0.0 : faces[1] > 0 ? -y : y - width;
            add({x, y, lattice.z(row)}, faces, std::max(behind_end, behind_side));
            return;
        }
        const auto layer_behind = [](int i, int places) { return i < 0 ? -1 - i : i - places; };
        const int end_layer = faces[0] == 0 ? 0 : layer_behind(column, lattice.columns);
        const int side_layer = faces[1] == 0 ? 0 : layer_behind(file, lattice.files);
        const bool shifted = std::max(end_layer, side_layer) % 2 == 1;
        const double behind_end = faces[0] == 0 ? 0.0 : 0.5 * (end_layer + 1) * lattice.dx;
        const double behind_side = faces[1] == 0 ? 0.0 : 0.5 * (side_layer + 1) * lattice.dy;
        const auto x = faces[0] == 0 ? along(column, lattice.columns, lattice.dx, length, ends, shifted)
                                     : std::optional(faces[0] > 0 ? -behind_end : length + behind_end);
        const auto y = faces[1] == 0 ? along(file, lattice.files, lattice.dy, width, sides, shifted)
                                     : std::optional(faces[1] > 0 ? -behind_side : width + behind_side);
        if (x && y) {
            add({*x, *y, lattice.z(row) + (shifted ? 0.5 * lattice.dz : 0.0)}, faces,
                std::max(behind_end, behind_side));
        }
    };
    for (int column = -beyond; column < lattice.columns + behind_it; ++column) {
        const int end = !ends ? 0 : column < 0 ? 1 : column >= lattice.columns ? -1 : 0;
        for (int file = -beside; file < lattice.files + beside; ++file) {
            const int side = file < 0 ? 1 : file >= lattice.files ? -1 : 0;
            for (int layer = 0; layer < layers_below; ++layer) {
                add_level(column, file, layer, {end, side, 1});
                if (lid) {
                    add_level(column, file, layer, {end, side, -1});
                }
            }
            for (int row = 0; row < top && (end != 0 || side != 0); ++row) {
                add_beside(column, file, row, {end, side, 0});
            }
        }
    }
    add_meshes(c, lattice, top, wall);
    if (c.solids.empty() && c.channel.lid_velocity == 0.0) wall.body.clear();
    return wall;
}

}  // namespace riffle::inline boundary
