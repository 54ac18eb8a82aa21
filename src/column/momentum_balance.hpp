#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "column/column_grid.hpp"
#include "roughness/porous_resistance.hpp"
#include "roughness/stem_drag.hpp"

namespace riffle::inline column {

/// Symmetric tridiagonal matrix: `diagonal` of n, `off` of n - 1 entries.
struct Tridiagonal {
    std::vector<double> diagonal;
    std::vector<double> off;

    /// Solution of A x = b by elimination without pivoting; A must be positive definite.
    [[nodiscard]] std::vector<double> solve(std::vector<double> b) const;
};

/// The steady momentum balance of the column in finite volumes,
///     g S0 + d/dz[(nu0 + l_m^2 |u'|) u'] - beta(z) u |u| - beta_v(u) u |u| = 0,
/// with the closure, the bed drag and the drag of stems below their tops that the case names (the same
/// objects as the particles'). No flux at z = 0 for sphere and slip beds, u(0) = 0 for no-slip beds and those
/// by a wall law; no flux at the surface, u(H) = 0 under a top wall over a no-slip bed. Forces are per plan
/// area and density, m2/s2. In porous layers the balance is that of the discharge of an area q = n u,
///     n g S0 + d/dz[r (nu0 + l_m^2 |q'|) q'] - beta(z)/n q |q| - n (linear + quadratic |q|) q = 0
/// (docs/theory.md, section 21); u stands for q in all functions of this class then.
class MomentumBalance {
  public:
    MomentumBalance(const Case& c, const ColumnGrid& grid);

    /// Velocity with the friction that balances the weight: a start close enough for Newton's method.
    [[nodiscard]] std::vector<double> first_guess() const;

    /// Force on each cell: weight + stress difference - drag.
    [[nodiscard]] std::vector<double> residual(const std::vector<double>& u) const;

    /// Minus the derivative of the residual, positive definite.
    [[nodiscard]] Tridiagonal jacobian(const std::vector<double>& u) const;

    /// Convex functional whose gradient is minus the residual: the steady flow is its minimum.
    [[nodiscard]] double functional(const std::vector<double>& u) const;

    /// Kinematic stress (nu0 + l_m^2 |u'|) u' at each of the n + 1 faces, m2/s2.
    [[nodiscard]] std::vector<double> face_stress(const std::vector<double>& u) const;

    /// Drag of the whole bed.
    [[nodiscard]] double drag(const std::vector<double>& u) const;
    /// Drag of the vegetation.
    [[nodiscard]] double vegetation_drag(const std::vector<double>& u) const;
    /// Resistance of the porous layers.
    [[nodiscard]] double porous_drag(const std::vector<double>& u) const;
    /// Weight of the water along the bed.
    [[nodiscard]] double weight() const;
    /// Porosity of a cell, 1 in open water.
    [[nodiscard]] double porosity(std::size_t cell) const {
        return media_.empty() ? 1.0 : media_[cell].porosity;
    }

    /// Gradient u' that carries the kinematic stress with mixing length l: the root of (nu0 + l^2 |u'|) u'.
    [[nodiscard]] double gradient_from_stress(double stress, double mixing_length) const;
    /// The same in a cell.
    [[nodiscard]] double gradient_in_cell(double stress, std::size_t cell) const;

    [[nodiscard]] const std::vector<double>& cell_mixing_length() const { return cell_length_; }
    [[nodiscard]] const std::vector<double>& thickness() const { return thickness_; }

  private:
    /// Velocity gradient at face i from the cells on its sides; walls and no-flux ends included.
    [[nodiscard]] double face_gradient(const std::vector<double>& u, std::size_t i) const;

    double weight_ = 0.0;     ///< g S0, m/s2
    double viscosity_ = 0.0;  ///< nu0, m2/s
    bool wall_below_ = false;
    bool wall_above_ = false;
    std::vector<double> thickness_;         ///< of the cells, m
    std::vector<double> distance_;          ///< between the points on the two sides of a face, m
    std::vector<double> length_squared_;    ///< l_m^2 at the faces, m2
    std::vector<double> cell_length_;       ///< l_m at the centres, m
    std::vector<double> drag_coefficient_;  ///< beta of the cells, 1/m
    std::optional<StemDrag> stems_;
    std::vector<double> stem_share_;      ///< of the cells that stands below the tops of the stems
    std::vector<PorousMedia::At> media_;  ///< of the cells; empty without porous layers
    std::vector<double> face_ratio_;      ///< r at the faces: Porous::viscosity_ratio; empty without
    double depth_ = 0.0;

    /// r at a face.
    [[nodiscard]] double ratio(std::size_t face) const {
        return face_ratio_.empty() ? 1.0 : face_ratio_[face];
    }
};

}  // namespace riffle::inline column
