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
    WallParticles<3> wall;
    for (int layer = 0; layer < c.numerics.wall_layers; ++layer) {
        const double behind = (layer + 0.5) * lattice.dz;
        for (int column = 0; column < lattice.columns; ++column) {
            for (int file = 0; file < lattice.files; ++file) {
                wall.position[0].push_back(lattice.x(column, -1 - layer));
                wall.position[1].push_back(lattice.y(file));
                wall.position[2].push_back(-behind);
                wall.volume.push_back(lattice.volume<3>());
                for (std::size_t k = 0; k < 9; ++k) {
                    wall.projector[k].push_back(k == 8 ? 1.0 : 0.0);
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    wall.normal[k].push_back(k == 2 ? 1.0 : 0.0);
                }
                wall.depth.push_back(behind);
            }
        }
    }
    return wall;
}

}  // namespace riffle
