#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/dataset.hpp"
#include "solver/simulation.hpp"

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
    drag_force,
    spanwise_drag_force,
    side_wall_force,
    quantities
};
inline constexpr std::size_t cell_quantities = static_cast<std::size_t>(CellQuantity::quantities);

/// Time means of a three-dimensional flow in cells, window by window: `/mean_field` of the results. Each
/// particle counts in one cell, those above the highest or below the lowest cell in that one, so that none is
/// lost.
class MeanField {
  public:
    explicit MeanField(const Case& c);

    /// Whether the case asks for it.
    [[nodiscard]] bool on() const { return interval_ > 0.0; }

    /// Add the particles of one instant to the present window; finishes it when its end has passed.
    void sample(const SimulationIn<3>& simulation);

    /// Centres of the cells, m.
    [[nodiscard]] std::vector<double> centres(std::size_t axis) const;
    /// Edges of the cells, m.
    [[nodiscard]] std::vector<double> edges(std::size_t axis) const;
    [[nodiscard]] std::size_t cells() const { return count_[0] * count_[1] * count_[2]; }
    /// Sums of the present window; cells along x first, then y, then z, then quantities.
    [[nodiscard]] const std::vector<double>& sums() const { return sums_; }
    [[nodiscard]] double samples() const { return samples_; }
    /// Ends of the windows finished so far, s.
    [[nodiscard]] const std::vector<double>& window_ends() const { return ends_; }

    /// Bytes of a window's rows, and of those not yet taken.
    [[nodiscard]] std::size_t row_bytes() const;
    [[nodiscard]] std::size_t pending_bytes() const;
    /// The windows finished since the last call, as rows for the results file.
    [[nodiscard]] Content take_new_rows();
    /// Number of rows of each appended dataset at the last take_new_rows(), for the checkpoint.
    void add_rows(std::map<std::string, std::size_t>& rows) const;

    void save(Content& checkpoint) const;
    void restore(const Content& checkpoint);

    /// Names of the fields of a window, in the order of the file.
    [[nodiscard]] static std::vector<std::string> field_names();

  private:
    void finish_window();
    [[nodiscard]] double window_after(double time) const;

    double interval_ = 0.0;
    std::array<std::size_t, 3> count_{};  ///< cells along each axis
    std::array<double, 3> edge_{};        ///< of a cell, m
    std::vector<double> sums_;
    double samples_ = 0.0;
    double window_end_ = 0.0;
    std::vector<double> ends_;
    std::size_t taken_ = 0;
    std::vector<double> new_samples_;
    std::vector<std::vector<float>> new_fields_;  ///< by field: rows not yet taken
    // Of one sample, kept for the next.
    std::vector<std::uint32_t> cell_;
    std::vector<std::uint32_t> order_;
};

}  // namespace riffle
