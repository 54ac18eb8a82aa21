#include "boundary/mesh_fill.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "boundary/wall_motion.hpp"
#include "case/end_buffers.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline boundary {

namespace {

/// Parts of a cell along each edge, in which the surface is taken for plane.
constexpr int parts_along = 4;
/// Less of a cell than this has no particle of its own.
constexpr double least_share = 1e-3;

/// The solid's part of a cell.
struct Part {
    double volume = 0.0;  ///< m3
    Vec<3> centroid{};
};

class MeshFill {
  public:
    MeshFill(const Case& c, const Lattice& lattice, WallParticles<3>& walls)
        : c_(c),
          lattice_(lattice),
          cell_{lattice.dx, lattice.dy, lattice.dz},
          half_diagonal_(0.5 * std::hypot(cell_[0], cell_[1], cell_[2])),
          meshes_(meshes_of(c)),
          walls_(walls),
          reach_(c.numerics.wall_layers * c.numerics.spacing),
          to_surface_(walls_end_at_surface(c)) {}

    /// Of the solids at rest. A place in several belongs to the first.
    void add_resting(int rows) {
        // Below and beside the water beyond open ends as well: a cross-section goes on there.
        const bool open = c_.channel.ends == Ends::open;
        const int beyond = open ? static_cast<int>(std::ceil(walls_beyond_end(c_) / lattice_.dx)) : 0;
        for (int column = -beyond; column < lattice_.columns + beyond && !meshes_->empty(); ++column) {
            for (int file = 0; file < lattice_.files; ++file) {
                for (int row = 0; row < rows; ++row) add_at(place_of(column, file, row));
            }
        }
    }

    /// All of a solid that moves, wherever it stands.
    void add_moving(std::size_t k) {
        const SolidMesh& mesh = (*meshes_)[k];
        const auto first = [&](std::size_t axis) {
            return static_cast<int>(std::floor(mesh.lower()[axis] / cell_[axis])) - 1;
        };
        const auto last = [&](std::size_t axis) {
            return static_cast<int>(std::ceil(mesh.upper()[axis] / cell_[axis])) + 1;
        };
        for (int column = first(0); column <= last(0); ++column) {
            for (int file = first(1); file <= last(1); ++file) {
                for (int row = first(2); row <= last(2); ++row) {
                    add(k, part_at(k, place_of(column, file, row)));
                }
            }
        }
    }

  private:
    [[nodiscard]] Vec<3> place_of(int column, int file, int row) const {
        return {lattice_.x(column, row), lattice_.y(file, row), lattice_.z(row)};
    }

    void add_at(const Vec<3>& p) {
        double taken = 0.0;
        std::vector<std::size_t> earlier;  // solids that have a part of the cell
        for (std::size_t k = 0; k < meshes_->size() && taken < lattice_.volume(); ++k) {
            if (c_.solids[k].rests()) {
                Part part = earlier.empty() ? part_at(k, p) : part_beside(k, earlier, p);
                part.volume = std::min(part.volume, lattice_.volume() - taken);
                taken += part.volume;
                add(k, part);
                if (part.volume > 0.0) earlier.push_back(k);
            }
        }
    }

    /// What a solid takes of the cell around a place: its part, or on the lattice all or nothing.
    [[nodiscard]] Part part_at(std::size_t solid, const Vec<3>& middle) const {
        const SolidMesh& mesh = (*meshes_)[solid];
        if (to_surface_) return part_in_cell(mesh, middle);
        return mesh.contains(middle) ? Part{lattice_.volume(), middle} : Part{};
    }

    /// Whether a cell around a place lies beyond the box around a solid.
    [[nodiscard]] bool is_beyond(const SolidMesh& mesh, const Vec<3>& middle) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (middle[k] < mesh.lower()[k] - cell_[k] || middle[k] > mesh.upper()[k] + cell_[k]) return true;
        }
        return false;
    }

    /// The part of a solid in the cell around a place. Where the surface passes it that is the sum of the
    /// parts in smaller cells.
    [[nodiscard]] Part part_in_cell(const SolidMesh& mesh, const Vec<3>& middle) const {
        if (is_beyond(mesh, middle)) {
            return {};
        }
        if (!mesh.nearest(middle, half_diagonal_)) {
            return mesh.contains(middle) ? Part{lattice_.volume(), middle} : Part{};
        }
        return sum_of_small(middle, [&](const Vec<3>& place, const Vec<3>& size) {
            return part_in_small(mesh, place, size);
        });
    }

    /// The part of a solid in a cell beside those of earlier ones, which it may overlap.
    [[nodiscard]] Part part_beside(std::size_t solid, const std::vector<std::size_t>& earlier,
                                   const Vec<3>& middle) const {
        const SolidMesh& mesh = (*meshes_)[solid];
        if (is_beyond(mesh, middle)) {
            return {};
        }
        return sum_of_small(middle, [&](const Vec<3>& place, const Vec<3>& size) {
            Part part = part_in_small(mesh, place, size);
            for (const std::size_t other : earlier) {
                if (part.volume <= 0.0) break;
                const double share = part_in_small((*meshes_)[other], place, size).volume;
                // Two faces through the small cell: on each other where one part lies in the other solid,
                // else side by side.
                const bool covered = (*meshes_)[other].contains(part.centroid);
                part.volume = std::clamp(part.volume - (covered ? share : 0.0), 0.0, 1.0 - share);
            }
            return part;
        });
    }

    /// The sum over the 4^3 smaller cells of a cell of f(place, size), parts as shares of a smaller one.
    template <class F>
    [[nodiscard]] Part sum_of_small(const Vec<3>& middle, const F& f) const {
        const Vec<3> small{cell_[0] / parts_along, cell_[1] / parts_along, cell_[2] / parts_along};
        Part part;
        for (int number = 0; number < parts_along * parts_along * parts_along; ++number) {
            const std::array<int, 3> index{number % parts_along, number / parts_along % parts_along,
                                           number / (parts_along * parts_along)};
            Vec<3> place{};
            for (std::size_t k = 0; k < 3; ++k) {
                place[k] = middle[k] + (index[k] + 0.5 - 0.5 * parts_along) * small[k];
            }
            const Part inside = f(place, small);
            part.volume += inside.volume;
            for (std::size_t k = 0; k < 3; ++k) {
                part.centroid[k] += inside.volume * (inside.centroid[k] - middle[k]);
            }
        }
        if (part.volume < least_share * parts_along * parts_along * parts_along) {
            return {};
        }
        for (std::size_t k = 0; k < 3; ++k) part.centroid[k] = middle[k] + part.centroid[k] / part.volume;
        part.volume = part.volume * small[0] * small[1] * small[2];
        return part;
    }

    /// The part of a solid in a small box around a place, its volume over that of the box.
    [[nodiscard]] Part part_in_small(const SolidMesh& mesh, const Vec<3>& place, const Vec<3>& size) const {
        const bool inside = mesh.contains(place);
        const auto foot = mesh.nearest(place, half_diagonal_);
        if (!foot) {
            return {inside ? 1.0 : 0.0, place};
        }
        const double side = inside ? 1.0 : -1.0;
        Vec<3> outward{};
        double thickness = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            outward[k] = side * foot->direction[k];
            thickness += std::abs(outward[k]) * size[k];
        }
        Part part{share_below_plane(size, outward, side * foot->distance), place};
        // Of a layer across the box; a corner's centroid differs little.
        for (std::size_t k = 0; k < 3; ++k) {
            part.centroid[k] -= 0.5 * (1.0 - part.volume) * thickness * outward[k];
        }
        return part;
    }

    /// A wall particle in a part, where it is not deeper than the layers.
    void add(std::size_t solid, const Part& part) {
        if (part.volume <= 0.0) return;
        const SolidMesh& mesh = (*meshes_)[solid];
        const Vec<3>& p = part.centroid;
        const auto foot = mesh.nearest(p, reach_);
        if (!foot) return;
        // The centroid of the part at an edge that the solid surrounds may stand before the surface.
        const bool before = to_surface_ && foot->distance < half_diagonal_ && !mesh.contains(p);
        for (std::size_t k = 0; k < 3; ++k) {
            walls_.position[k].push_back(p[k]);
            walls_.normal[k].push_back(before ? -foot->direction[k] : foot->direction[k]);
            for (std::size_t l = 0; l < 3; ++l) walls_.projector[3 * k + l].push_back(k == l ? 1.0 : 0.0);
        }
        walls_.volume.push_back(part.volume);
        walls_.depth.push_back(before ? 0.0 : foot->distance);
        walls_.body.push_back(first_solid + static_cast<std::int32_t>(solid));
    }

    const Case& c_;
    const Lattice& lattice_;
    Vec<3> cell_;
    double half_diagonal_;
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
    WallParticles<3>& walls_;
    double reach_;
    bool to_surface_;
};

}  // namespace

double share_below_plane(const Vec<3>& size, const Vec<3>& n, double d) {
    // Reflected and scaled: the unit cube, the plane m . x = a with m >= 0 of sum 1.
    Vec<3> m{};
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        m[k] = std::abs(n[k]) * size[k];
        sum += m[k];
    }
    // An edge along the plane: so little of it across that the differences below keep their digits.
    constexpr double least = 1e-4;
    double total = 0.0;
    for (double& component : m) {
        component = std::max(component / sum, least);
        total += component;
    }
    for (double& component : m) component /= total;
    const double a = d / sum + 0.5;
    if (a <= 0.0 || a >= 1.0) return a <= 0.0 ? 0.0 : 1.0;
    const auto cube = [](double x) { return x > 0.0 ? x * x * x : 0.0; };
    // By symmetry of the smaller side.
    const double b = std::min(a, 1.0 - a);
    double share = cube(b);
    for (std::size_t k = 0; k < 3; ++k) share += cube(b - m[k] - m[(k + 1) % 3]) - cube(b - m[k]);
    share = std::clamp(share / (6.0 * m[0] * m[1] * m[2]), 0.0, 1.0);
    return a == b ? share : 1.0 - share;
}

void add_meshes(const Case& c, const Lattice& lattice, int rows, WallParticles<3>& walls) {
    MeshFill fill(c, lattice, walls);
    fill.add_resting(rows);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        if (!c.solids[k].rests()) fill.add_moving(k);
    }
}

}  // namespace riffle::inline boundary
