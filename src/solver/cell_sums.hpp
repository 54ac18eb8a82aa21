#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace riffle {

/// Sums over the particles of a cell that the mean field is made of.
enum class CellQuantity : std::size_t {
    count,
    u,
    v,
    w,
    uu,
    vv,
    ww,
    uw,
    uv,
    vw,
    shear_stress,
    lateral_shear_stress,
    pressure,
    eddy_viscosity,
    // Forces: zero but near the bed and the side walls.
    drag_force,
    spanwise_drag_force,
    side_wall_force,
    quantities
};
inline constexpr std::size_t cell_quantities = static_cast<std::size_t>(CellQuantity::quantities);

/// A cell by its place along x, y and z.
using CellPlace = std::array<std::size_t, 3>;

/// The sums of all cells of a grid. Those of the forces take memory where there are any: those of the bed by
/// rows across the channel, those of the side walls by columns. Slices across the channel (one place along x)
/// may be added to by several threads, each slice by one.
class CellSums {
  public:
    /// Quantities that each cell has.
    static constexpr std::size_t dense_quantities = static_cast<std::size_t>(CellQuantity::drag_force);

    CellSums() = default;
    explicit CellSums(const CellPlace& count);

    /// Add the terms of one particle, in the order of CellQuantity.
    void add(const CellPlace& cell, const std::array<double, cell_quantities>& terms);
    [[nodiscard]] double get(const CellPlace& cell, CellQuantity quantity) const;
    /// Let all sums be zero.
    void clear();

    /// By cell (x outermost, then y, z) and dense quantity; for the checkpoint.
    [[nodiscard]] const std::vector<double>& dense() const { return dense_; }
    void set_dense(std::vector<double> values) { dense_ = std::move(values); }
    /// The forces by cell, three each; the reverse of it for all cells at once.
    [[nodiscard]] double force(std::size_t number) const;
    void set_forces(const std::vector<double>& values);

    [[nodiscard]] std::size_t bytes() const;

  private:
    using Row = std::unique_ptr<double[]>;  // NOLINT(*-avoid-c-arrays)
    static constexpr std::size_t forces = cell_quantities - dense_quantities;

    [[nodiscard]] std::size_t index(const CellPlace& cell) const {
        return (cell[0] * count_[1] + cell[1]) * count_[2] + cell[2];
    }
    [[nodiscard]] CellPlace place(std::size_t index) const {
        return {index / (count_[1] * count_[2]), index / count_[2] % count_[1], index % count_[2]};
    }
    void clear_forces();
    void add_forces(const CellPlace& cell, double drag, double across, double side);

    CellPlace count_{};
    std::vector<double> dense_;
    std::vector<Row> bed_;    ///< by x and z: for each y the drag along x and y
    std::vector<Row> sides_;  ///< by x and y: for each z the force
};

}  // namespace riffle
