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

WallParticles<2> wall_particles(const Case& c) {
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

    const auto layer_depth = [&](int layer, double spacing) {
        // Dynamic particles: staggered layers half a spacing apart (thesis; SPHysics).
        return dynamic ? 0.5 * (layer + 1) * spacing : (layer + 0.5) * spacing;
    };
    for (int layer = 0; layer < layers; ++layer) {
        const double behind = layer_depth(layer, lattice.dz);
        const double shift = dynamic && layer % 2 == 1 ? 0.5 : 0.0;
        for (int column = -beyond; column < lattice.columns + beyond; ++column) {
            const double x = (column + 0.5 + shift) * lattice.dx;
            const bool corner = column < 0 || column >= lattice.columns;
            const double wrapped = closed ? x : std::fmod(x, c.channel.length);
            add_particle(wall, wrapped, -behind, volume, corner ? Normal{} : Normal{0.0, 1.0}, behind);
            if (c.channel.top == Top::wall) {
                add_particle(wall, wrapped, depth + behind, volume, corner ? Normal{} : Normal{0.0, -1.0},
                             behind);
            }
        }
    }
    if (closed) {
        // End walls stand half a depth above the still water, for waves; with a lid they end at it.
        const int rows = c.channel.top == Top::wall ? lattice.rows : lattice.rows + lattice.rows / 2;
        for (int layer = 0; layer < layers; ++layer) {
            const double behind = layer_depth(layer, lattice.dx);
            for (int row = 0; row < rows; ++row) {
                const double z = (row + 0.5) * lattice.dz;
                add_particle(wall, -behind, z, volume, Normal{1.0, 0.0}, behind);
                add_particle(wall, c.channel.length + behind, z, volume, Normal{-1.0, 0.0}, behind);
            }
        }
    }
    return wall;
}

}  // namespace riffle
