#include "particles/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "base/notice.hpp"
#include "base/unit_fraction.hpp"
#include "case/end_buffers.hpp"
#include "case/end_levels.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"
#include "case/solid_volume.hpp"

namespace riffle::inline particles {

Lattice lattice_of(const Case& c) {
    Lattice lattice;
    lattice.arrangement = c.start.lattice;
    const bool cubic = lattice.arrangement == StartLattice::body_centred;
    // Ratio of the spacing along x and y to sqrt(area per particle), or to cbrt(volume), and of the same root
    // to the distance of rows.
    const double ratio = lattice.arrangement == StartLattice::hexagonal ? std::sqrt(2.0 / std::sqrt(3.0))
                         : cubic                                        ? std::cbrt(2.0)
                                                                        : 1.0;
    const double per_row = cubic ? 2.0 / ratio : ratio;
    const double spacing = c.numerics.spacing;
    lattice.columns = std::max(1, static_cast<int>(std::lround(c.channel.length / (ratio * spacing))));
    lattice.rows = std::max(1, static_cast<int>(std::lround(c.total_depth() * per_row / spacing)));
    lattice.dx = c.channel.length / lattice.columns;
    lattice.dz = c.total_depth() / lattice.rows;
    const double width = c.channel.flow_width();
    if (c.channel.dimensions == 3) {
        lattice.files =
            std::max(1, static_cast<int>(std::lround(width / (cubic ? ratio * spacing : spacing))));
    }
    lattice.dy = width / lattice.files;
    return lattice;
}

RowsBelow rows_below(const Lattice& lattice, double surface) {
    const int rows = std::max(1, static_cast<int>(std::lround(surface / lattice.dz)));
    return {rows, surface / rows};
}

namespace {

/// The place in an outline of the water that the water of a place has: beyond an open end it is that of the
/// end.
double place_in_outline(const Case& c, double x) {
    return c.channel.ends == Ends::open ? within_ends(x, c.channel.length) : x;
}

}  // namespace

double still_surface(const Case& c, double x, double z) {
    return c.start.water_x.empty()
               ? c.total_depth()
               : ceiling_above({c.start.water_x, c.start.water_z}, place_in_outline(c, x), z);
}

namespace {

/// How high above all that a case names a splash may rise and still fall back: where the start or a solid can
/// drive a jet. It gathers the energy of much water in little: spray of a breaking dam rises to several times
/// the height of the dam. Elsewhere one depth, or what a table at an open end may ask for.
double headroom(const Case& c) {
    const bool violent = !c.start.water_x.empty() || std::any_of(c.solids.begin(), c.solids.end(),
                                                                 [](const Solid& s) { return !s.rests(); });
    const auto highest = std::max_element(c.start.water_z.begin(), c.start.water_z.end());
    const double head =
        highest != c.start.water_z.end() ? std::max(*highest, c.total_depth()) : c.total_depth();
    constexpr double heads = 5.0;
    if (violent) return heads * head;
    return has_end_tables(c) ? level_with_room(c) : std::max(c.total_depth(), highest_end_level(c));
}

/// Top of all that a case names: the water at its depth, the outline of the water, walls and solids.
double highest_part(const Case& c) {
    double top = std::max({c.total_depth(), c.channel.wall_height.value_or(0.0), highest_end_level(c)});
    for (const double z : c.start.water_z) top = std::max(top, z);
    const auto meshes = c.channel.dimensions == 3 ? meshes_of(c) : nullptr;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Solid& solid = c.solids[k];
        // With where it moves to, but not beyond as much again: a gate leaves the water for good.
        double reach = solid.motion == SolidMotion::oscillating ? std::abs(solid.amplitude_z) : 0.0;
        for (const double shift : solid.shifts_z) reach = std::max(reach, shift);
        if (turns(c, solid)) {
            const Point3 point = rotation_point(c, solid);
            top = std::max(top, point[2] + reach_from(c, solid, point) + reach);
        }
        for (const double z : solid.z) top = std::max(top, z + reach);
        // Of one at rest no more than the walls' height has wall particles.
        if (meshes && !solid.rests()) top = std::max(top, (*meshes)[k].upper()[2] + reach);
    }
    return top;
}

/// Where the water starts: in its outline and out of the solids.
class WetPlaces {
  public:
    explicit WetPlaces(const Case& c) : case_(c), water_{c.start.water_x, c.start.water_z} {
        if (c.channel.dimensions == 3) {
            meshes_ = meshes_of(c);
            return;
        }
        for (const Solid& solid : c.solids) {
            solids_.push_back({solid.x, solid.z});
        }
    }

    [[nodiscard]] bool contain(const Point3& p) const {
        const bool to_surface = walls_end_at_surface(case_);
        return contain(p[0], p[2]) && std::none_of(meshes_->begin(), meshes_->end(), [&](const auto& mesh) {
                   return mesh.contains(p) || (to_surface && mesh.nearest(p, clearance()));
               });
    }

    [[nodiscard]] bool contain(double x, double z) const {
        if (water_.size() > 0 && !contains(water_, place_in_outline(case_, x), z)) return false;
        const double period = case_.channel.ends == Ends::periodic ? case_.channel.length : 0.0;
        return std::none_of(solids_.begin(), solids_.end(), [&](const Outline& outline) {
            return at_any_image(x, period, [&](double at) {
                return contains(outline, at, z) || distance_from_outline(outline, at, z) < clearance();
            });
        });
    }

  private:
    /// No particle starts nearer to a surface.
    [[nodiscard]] double clearance() const { return 0.25 * case_.numerics.spacing; }

    const Case& case_;
    Outline water_;
    std::vector<Outline> solids_;
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
};

}  // namespace

template <int D>
Domain<D> domain_of(const Case& c) {
    const double depth = c.total_depth();
    const double wall = (c.numerics.wall_layers + 1) * c.numerics.spacing;
    // Room for waves and splashes: a particle beyond it has left the simulated water, and is taken out.
    const double margin = wall + depth;
    Domain<D> domain;
    const auto set = [&](std::size_t axis, bool periodic, double extent) {
        domain.periodic[axis] = periodic;
        domain.lower[axis] = periodic ? 0.0 : -margin;
        domain.upper[axis] = extent + (periodic ? 0.0 : margin);
    };
    set(0, c.channel.ends == Ends::periodic, c.channel.length);
    domain.lower[0] -= buffer_length(c);
    domain.upper[0] += buffer_length(c);
    if constexpr (D == 3) set(1, c.channel.sides == Sides::periodic, c.channel.simulated_width());
    set(D - 1, c.channel.top == Top::periodic, highest_part(c));
    if (!domain.periodic[D - 1]) domain.upper[D - 1] = highest_part(c) + (wall + headroom(c));
    return domain;
}

template <int D>
Particles<D> lattice_particles(const Case& c, const std::function<double(double)>& surface_along) {
    if (c.channel.dimensions != D) throw std::logic_error("particles of other dimensions than the case's");
    const Lattice lattice = lattice_of(c);
    // The rows of an outline stand at the heights of the lattice.
    const std::function<double(double)> surface =
        c.start.water_x.empty() ? surface_along : std::function<double(double)>();
    const int files = lattice.files;
    // An outline of the water may rise above the depth that the spacing is cut from.
    int rows = lattice.rows;
    for (const double z : c.start.water_z) rows = std::max(rows, static_cast<int>(std::ceil(z / lattice.dz)));
    // Water beyond an open end; what enters at the other one is made by the flow.
    const int columns =
        lattice.columns +
        (c.channel.ends == Ends::open && !bed_ends(c) ? static_cast<int>(end_support(c) / lattice.dx) : 0);
    std::vector<RowsBelow> below;  // by column
    for (int column = 0; surface && column < columns; ++column) {
        below.push_back(rows_below(lattice, surface(lattice.x(column, 0))));
        rows = std::max(rows, below.back().rows);
    }
    const auto height = [&](int column, int row) {
        return surface ? (row + 0.5) * below[static_cast<std::size_t>(column)].height : lattice.z(row);
    };
    const bool everywhere = c.start.water_x.empty() && c.solids.empty();
    const WetPlaces wet(c);
    const auto is_wet = [&](int column, int file, int row) {
        if constexpr (D == 2) {
            return wet.contain(lattice.x(column, row), height(column, row));
        } else {
            return wet.contain(Point3{lattice.x(column, row), lattice.y(file, row), height(column, row)});
        }
    };
    constexpr double takes_a_while = 2e6;
    const double places = 1.0 * columns * files * rows;
    if (places > takes_a_while) {
        notice(fmt::format("placing {:.3g} particles", places));
    }
    Particles<D> particles;
    particles.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(files) *
                     static_cast<std::size_t>(rows));
    std::mt19937_64 generator(static_cast<std::uint64_t>(c.start.seed));
    const auto displacement = [&](double spacing) {
        return c.start.jitter * spacing * (2.0 * unit_fraction(generator()) - 1.0);
    };
    std::size_t i = 0;
    for (int column = 0; column < columns; ++column) {
        for (int file = 0; file < files; ++file) {
            const int rows_here = surface ? below[static_cast<std::size_t>(column)].rows : rows;
            for (int row = 0; row < rows_here; ++row) {
                if (!everywhere && !is_wet(column, file, row)) continue;
                particles.position[0][i] = lattice.x(column, row);
                if constexpr (D == 3) particles.position[1][i] = lattice.y(file, row);
                particles.position[D - 1][i] = height(column, row);
                if (c.start.jitter > 0.0) {
                    particles.position[0][i] += displacement(lattice.dx);
                    if constexpr (D == 3) particles.position[1][i] += displacement(lattice.dy);
                    particles.position[D - 1][i] += displacement(lattice.dz);
                }
                particles.id[i] = static_cast<std::int32_t>(i);
                ++i;
            }
        }
    }
    particles.resize(i);
    return particles;
}

template Domain<2> domain_of<2>(const Case&);
template Domain<3> domain_of<3>(const Case&);
template Particles<2> lattice_particles<2>(const Case&, const std::function<double(double)>&);
template Particles<3> lattice_particles<3>(const Case&, const std::function<double(double)>&);

}  // namespace riffle::inline particles
