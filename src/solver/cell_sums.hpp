#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace riffle::inline solver {

/// What the mean field is made of, by cell: the number of samples, means, mean products of fluctuations, and
/// sums of forces.
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

/// A sample of a cell: one particle at one instant. Forces times mass, N.
struct CellSample {
    std::array<double, 3> velocity{};
    double shear_stress = 0.0;
    double lateral_shear_stress = 0.0;
    double pressure = 0.0;
    double eddy_viscosity = 0.0;
    double drag_force = 0.0;
    double spanwise_drag_force = 0.0;
    double side_wall_force = 0.0;
};

/// The statistics of all cells of a grid. Means and products of fluctuations are kept up to date sample by
/// sample (Welford 1962; Chan, Golub & LeVeque 1983), so that single precision suffices for them: half of the
/// memory of sums, and no difference of large numbers. Those of the forces take memory where there are any:
/// those of the bed by rows across the channel, those of the side walls by columns. Slices across the channel
/// (one place along x) may be added to by several threads, each slice by one.
class CellSums {
  public:
    /// Quantities that each cell has.
    static constexpr std::size_t dense_quantities = static_cast<std::size_t>(CellQuantity::drag_force);

    CellSums() = default;
    explicit CellSums(const CellPlace& count);

    void add(const CellPlace& cell, const CellSample& sample);
    /// The count, a mean, a mean product of two fluctuations, or a sum of forces; 0 in a cell without
    /// samples.
    [[nodiscard]] double get(const CellPlace& cell, CellQuantity quantity) const;
    /// Forget all samples.
    void clear();

    /// By cell (x outermost, then y, z) and dense quantity, products of fluctuations as sums; for the
    /// checkpoint.
    [[nodiscard]] const std::vector<float>& dense() const { return dense_; }
    void set_dense(const std::vector<double>& values) { dense_.assign(values.begin(), values.end()); }
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
    std::vector<float> dense_;
    std::vector<Row> bed_;    ///< by x and z: for each y the drag along x and y
    std::vector<Row> sides_;  ///< by x and y: for each z the force
};

}  // namespace riffle::inline solver
