#include "particles/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace riffle {

Lattice lattice_of(const Case& c) {
    Lattice lattice;
    lattice.hexagonal = c.start.lattice == StartLattice::hexagonal;
    // Ratio of the spacing along x to sqrt(area per particle), and of the same root to the distance of rows.
    const double ratio = lattice.hexagonal ? std::sqrt(2.0 / std::sqrt(3.0)) : 1.0;
    const double spacing = c.numerics.spacing;
    lattice.columns = std::max(1, static_cast<int>(std::lround(c.channel.length / (ratio * spacing))));
    lattice.rows = std::max(1, static_cast<int>(std::lround(c.total_depth() * ratio / spacing)));
    lattice.dx = c.channel.length / lattice.columns;
    lattice.dz = c.total_depth() / lattice.rows;
    return lattice;
}

Domain<2> domain_of(const Case& c) {
    const double depth = c.total_depth();
    const double wall = (c.numerics.wall_layers + 1) * c.numerics.spacing;
    // Room for waves and splashes: a particle beyond it has left the simulated water.
    const double margin = wall + depth;
    Domain<2> domain;
    domain.periodic = {c.channel.ends == Ends::periodic, c.channel.top == Top::periodic};
    domain.lower = {domain.periodic[0] ? 0.0 : -margin, domain.periodic[1] ? 0.0 : -margin};
    domain.upper = {c.channel.length + (domain.periodic[0] ? 0.0 : margin),
                    depth + (domain.periodic[1] ? 0.0 : margin)};
    return domain;
}

Particles<2> lattice_particles(const Case& c) {
    const Lattice lattice = lattice_of(c);
    Particles<2> particles;
    particles.resize(static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows));
    std::mt19937_64 generator(static_cast<std::uint64_t>(c.start.seed));
    const auto displacement = [&](double spacing) {
        // 53 random bits give the same number on every machine, unlike std::uniform_real_distribution.
        const double unit = static_cast<double>(generator() >> 11U) * 0x1.0p-53;
        return c.start.jitter * spacing * (2.0 * unit - 1.0);
    };
    std::size_t i = 0;
    for (int column = 0; column < lattice.columns; ++column) {
        for (int row = 0; row < lattice.rows; ++row, ++i) {
            double x = lattice.x(column, row);
            double z = lattice.z(row);
            if (c.start.jitter > 0.0) {
                x += displacement(lattice.dx);
                z += displacement(lattice.dz);
            }
            particles.position[0][i] = x;
            particles.position[1][i] = z;
            particles.id[i] = static_cast<std::int64_t>(i);
        }
    }
    return particles;
}

}  // namespace riffle
