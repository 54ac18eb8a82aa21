#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "column/section_grid.hpp"
#include "roughness/log_law_friction.hpp"
#include "roughness/porous_resistance.hpp"
#include "roughness/vegetation.hpp"

namespace riffle::inline column {

/// Minus the derivative of a section's momentum balance, matrix + column row^T: the friction coefficient of
/// the side walls depends on the flow of the whole section, which adds a product of two vectors.
struct SectionJacobian {
    Eigen::SparseMatrix<double> matrix;
    Eigen::VectorXd column;
    Eigen::VectorXd row;
};

/// The momentum balance of steady flow along a channel in finite volumes over half a cross-section,
///     g S0 + d/dy[(nu0 + A nu_t) dU/dy] + d/dz[(nu0 + nu_t) dU/dz] - beta U|U| = 0,
/// beta = beta_bed(z) + beta_wall(y) + beta_v(U, y, z) of bed, side walls and vegetation,
/// nu_t = l^2 |S|, l = l_m(z) G(y), |S|^2 = (dU/dy)^2 + (dU/dz)^2, A = 1/2 (1 + q^2), with the closure, the
/// bed drag (its mean over the plan) and the side walls' friction of the case. No flux at bed, surface, wall
/// and plane of symmetry, but for no-slip beds and beds by a wall law U = 0 at z = 0, and beside no-slip beds
/// U = 0 at the side walls too, as at the walls of the particles. Velocities stand at the
/// centres of the cells, in the order of the grid; forces are per length and density, m3/s2. In porous zones
/// U stands for the discharge of an area, as in MomentumBalance.
class SectionBalance {
  public:
    SectionBalance(const Case& c, const SectionGrid& grid);

    /// Force on each cell: weight + differences of the stresses - drag.
    [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& u) const;
    [[nodiscard]] SectionJacobian jacobian(const Eigen::VectorXd& u) const;

    /// Friction coefficient beta_wall of the wall's layer, 1/m. Consistent form: such that the wall carries
    /// H/(k^2 W_b) of what the flow exerts on the bed. By the log law: LogLawFriction.
    [[nodiscard]] double wall_coefficient(const Eigen::VectorXd& u) const;

    /// Force of the flow on the bed and on the wall.
    [[nodiscard]] double bed_force(const Eigen::VectorXd& u) const;
    [[nodiscard]] double wall_force(const Eigen::VectorXd& u) const;

    /// Kinematic stresses at the centres of the cells, m2/s2: xz and xy.
    struct Stresses {
        std::vector<double> vertical;
        std::vector<double> lateral;
    };
    [[nodiscard]] Stresses stresses(const Eigen::VectorXd& u) const;

    [[nodiscard]] const Eigen::VectorXd& area() const { return area_; }  ///< of the cells, m2
    /// Area of the water of the cells, m2.
    [[nodiscard]] Eigen::VectorXd water_area() const;
    [[nodiscard]] double weight() const { return weight_ * (media_.empty() ? area_ : water_area()).sum(); }
    /// Porosity of a cell, 1 in open water.
    [[nodiscard]] double porosity(Eigen::Index cell) const {
        return media_.empty() ? 1.0 : media_[static_cast<std::size_t>(cell)].porosity;
    }
    [[nodiscard]] double mixing_length(std::size_t iy, std::size_t iz) const {
        const double length = cell_length_[patch_of_[iy]][iz] * cell_factor_[iy];
        return media_.empty() ? length : std::min(length, pore_length_[iz * columns_ + iy]);
    }
    /// Force of the flow on the vegetation.
    [[nodiscard]] double vegetation_force(const Eigen::VectorXd& u) const;
    /// Resistance of the porous zones.
    [[nodiscard]] double porous_force(const Eigen::VectorXd& u) const;
    /// Whether anything resists the flow. Without it there is no steady state.
    [[nodiscard]] bool has_friction() const;

  private:
    /// A face between two cells: the gradient along its normal is that between the two, the gradient along
    /// it the mean of those of the two cells from their neighbours.
    struct Face {
        std::array<Eigen::Index, 6> cells;  ///< minus and plus each with its neighbours along the face
        std::array<double, 6> weights;      ///< of the gradient along the face, 1/m
        double inverse_distance;
        double length_squared;
        double stress_weight;
        double viscosity_ratio;  ///< Porous::viscosity_ratio
        double extent;
        [[nodiscard]] Eigen::Index minus() const { return cells[1]; }
        [[nodiscard]] Eigen::Index plus() const { return cells[4]; }
    };
    struct FaceFlow {
        double stress;         ///< kinematic, m2/s2
        double normal_slope;   ///< its derivative by the gradient along the normal
        double tangent_slope;  ///< and by the gradient along the face
    };
    [[nodiscard]] FaceFlow flow(const Face& face, const Eigen::VectorXd& u) const;
    /// Of a bed at which the water rests under the cell iy.
    [[nodiscard]] FaceFlow bed_flow(std::size_t iy, const Eigen::VectorXd& u) const;
    /// Kinematic stress over U at a wall at which the water rests, in the cells beside it, m/s; 0: the walls
    /// are frictionless planes. The mixing length vanishes at them.
    [[nodiscard]] double wall_slope(std::size_t iz) const;
    [[nodiscard]] double layer_sum(const Eigen::VectorXd& u) const;

    void add_vegetation(const Case& c, const SectionGrid& grid);
    /// The stems in a cell that has some.
    [[nodiscard]] const StemDrag& stems_in(Eigen::Index cell) const;
    /// After add_vegetation().
    void add_bed_patches(const Case& c, const SectionGrid& grid);
    void add_faces(const Case& c, const SectionGrid& grid);
    /// What porous zones make of cells and faces; after add_faces().
    void add_porous(const Case& c, const SectionGrid& grid);

    std::size_t columns_;
    std::size_t rows_;
    double weight_;
    double viscosity_;
    std::vector<bool> rests_below_;  ///< at the bed, by column
    bool rests_beside_;              ///< at the side walls
    SideDragForm wall_form_;
    std::optional<LogLawFriction> wall_friction_;  ///< by the log law
    double wall_over_bed_ = 0.0;              ///< force on the wall over that on the bed of the half section
    double fixed_coefficient_ = 0.0;          ///< of the wall, printed form
    double bed_distance_ = 0.0;               ///< of the lowest centres from the bed
    double wall_distance_ = 0.0;              ///< of the centres beside the wall from it
    std::vector<double> bed_length_squared_;  ///< l_m^2 at the bed, by column
    std::vector<double> bed_extent_;          ///< widths of the cells
    std::vector<double> wall_extent_;         ///< heights of the cells
    std::vector<VegetationPatch> patches_;
    /// Of each column: 0 over the bed of the channel, n in the vegetation patches_[n - 1], and then the
    /// patches of the bed.
    std::vector<std::size_t> patch_of_;
    std::vector<std::vector<double>>
        cell_length_;                   ///< l_m at the heights of the centres, so for each of these
    std::vector<double> cell_factor_;   ///< G at the centres
    std::vector<Face> vertical_faces_;  ///< between rows, row by row
    std::vector<Face> lateral_faces_;   ///< between columns, row by row
    Eigen::VectorXd area_;
    Eigen::VectorXd bed_drag_;            ///< area times beta_bed
    Eigen::VectorXd stem_area_;           ///< area below the tops of stems
    Eigen::VectorXd layer_area_;          ///< area in the wall's layer, else 0
    double layer_extent_ = 0.0;           ///< of the wall's layer, m2
    std::vector<PorousMedia::At> media_;  ///< of the cells; empty without porous zones
    std::vector<double> pore_length_;     ///< l_m of the cells with them, m
};

}  // namespace riffle::inline column
