#include "boundary/wall.hpp"

#include <cmath>

#include "particles/lattice.hpp"

namespace riffle {

namespace {

struct Normal {
    double x = 0.0;
    double z = 0.0;
};

void add_particle(WallParticles<2>& wall, double x, double z, double volume, const Normal& n, double depth) {
    wall.position[0].push_back(x);
    wall.position[1].push_back(z);
    wall.volume.push_back(volume);
    const bool corner = n.x == 0.0 && n.z == 0.0;
    wall.projector[0].push_back(corner ? 1.0 : n.x * n.x);
    wall.projector[1].push_back(n.x * n.z);
    wall.projector[2].push_back(n.x * n.z);
    wall.projector[3].push_back(corner ? 1.0 : n.z * n.z);
    wall.normal[0].push_back(n.x);
    wall.normal[1].push_back(n.z);
    wall.depth.push_back(depth);
}

}  // namespace

WallLaw wall_law(const Case& c) {
    return {.dynamic = c.numerics.wall == WallKind::dynamic,
            .no_slip = c.bed.kind == BedKind::no_slip || c.numerics.wall == WallKind::dynamic};
}

template <>
WallParticles<2> wall_particles<2>(const Case& c) {
    WallParticles<2> wall;
    if (c.channel.top == Top::periodic) {
        return wall;
    }
    const Lattice lattice = lattice_of(c);
    const bool dynamic = c.numerics.wall == WallKind::dynamic;
    const int layers = c.numerics.wall_layers;
    const double volume = lattice.dx * lattice.dz;
    const double depth = c.total_depth();
    const bool closed = c.channel.ends == Ends::walls;
    const int beyond = closed ? layers : 0;

    // Dummy particles stand on the continuation of the lattice; dynamic ones in staggered layers half a
    // spacing apart (thesis; SPHysics).
    const auto layer_depth = [&](int layer, double spacing) {
        return dynamic ? 0.5 * (layer + 1) * spacing : (layer + 0.5) * spacing;
    };
    const auto x_of = [&](int column, int row, int layer) {
        return dynamic ? (column + 0.5 + (layer % 2 == 1 ? 0.5 : 0.0)) * lattice.dx : lattice.x(column, row);
    };
    for (int layer = 0; layer < layers; ++layer) {
        const double behind = layer_depth(layer, lattice.dz);
        for (int column = -beyond; column < lattice.columns + beyond; ++column) {
            const bool corner = column < 0 || column >= lattice.columns;
            const auto wrapped = [&](double x) { return closed ? x : std::fmod(x, c.channel.length); };
            add_particle(wall, wrapped(x_of(column, -1 - layer, layer)), -behind, volume,
                         corner ? Normal{} : Normal{0.0, 1.0}, behind);
            if (c.channel.top == Top::wall) {
                add_particle(wall, wrapped(x_of(column, lattice.rows + layer, layer)), depth + behind, volume,
                             corner ? Normal{} : Normal{0.0, -1.0}, behind);
            }
        }
    }
    if (closed) {
        // End walls stand half a depth above the still water, for waves; with a lid they end at it.
        const int rows = c.channel.top == Top::wall ? lattice.rows : lattice.rows + lattice.rows / 2;
        const double length = c.channel.length;
        for (int layer = 0; layer < layers; ++layer) {
            for (int row = 0; row < rows; ++row) {
                const double left = dynamic ? -layer_depth(layer, lattice.dx) : lattice.x(-1 - layer, row);
                const double right = dynamic ? length - left : lattice.x(lattice.columns + layer, row);
                add_particle(wall, left, lattice.z(row), volume, Normal{1.0, 0.0}, -left);
                add_particle(wall, right, lattice.z(row), volume, Normal{-1.0, 0.0}, right - length);
            }
        }
    }
    return wall;
}

template <>
WallParticles<3> wall_particles<3>(const Case& c) {
    const Lattice lattice = lattice_of(c);
    const int layers = c.numerics.wall_layers;
    const bool closed = c.channel.sides != Sides::periodic;
    const double width = c.channel.simulated_width();
    WallParticles<3> wall;
    const auto add = [&](int column, int file, int row, const Vec<3>& n, double depth) {
        const Vec<3> x{lattice.x(column, row), lattice.y(file), lattice.z(row)};
        const bool corner = n[1] == 0.0 && n[2] == 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            wall.position[k].push_back(x[k]);
            wall.normal[k].push_back(n[k]);
            for (std::size_t l = 0; l < 3; ++l) {
                // In the edge between bed and side wall all motion but that along the channel.
                const double within = k == l && k != 0 ? 1.0 : 0.0;
                wall.projector[3 * k + l].push_back(corner ? within : n[k] * n[l]);
            }
        }
        wall.volume.push_back(lattice.volume<3>());
        wall.depth.push_back(depth);
    };
    const int beyond = closed ? layers : 0;
    // Side walls stand half a depth above the still water, as end walls do.
    const int top = lattice.rows + lattice.rows / 2;
    for (int column = 0; column < lattice.columns; ++column) {
        for (int file = -beyond; file < lattice.files + beyond; ++file) {
            const bool side = file < 0 || file >= lattice.files;
            for (int layer = 0; layer < layers; ++layer) {
                add(column, file, -1 - layer, side ? Vec<3>{} : Vec<3>{0.0, 0.0, 1.0},
                    (layer + 0.5) * lattice.dz);
            }
            if (!side) {
                continue;
            }
            const double y = lattice.y(file);
            for (int row = 0; row < top; ++row) {
                add(column, file, row, {0.0, file < 0 ? 1.0 : -1.0, 0.0}, file < 0 ? -y : y - width);
            }
        }
    }
    return wall;
}

}  // namespace riffle
