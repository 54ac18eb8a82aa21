#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "record/field.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// Quantities of `/mean_field` of a three-dimensional run, in the order of `fields::mean_field`.
enum class FieldQuantity : std::size_t {
    count,
    velocity,
    spanwise_velocity,
    vertical_velocity,
    velocity_variance,
    spanwise_velocity_variance,
    vertical_velocity_variance,
    velocity_covariance,
    velocity_spanwise_covariance,
    spanwise_vertical_covariance,
    shear_stress,
    lateral_shear_stress,
    pressure,
    eddy_viscosity,
    drag,
    spanwise_drag,
    side_wall_drag,
    quantities
};
inline constexpr std::size_t field_quantities = static_cast<std::size_t>(FieldQuantity::quantities);
using FieldValues = std::array<double, field_quantities>;

/// The field of a quantity.
[[nodiscard]] const Field& field_of(FieldQuantity quantity);

/// Sums of a number of cells from which their means follow. Sums of the same cell in other windows, and of
/// other cells, can be added: what then follows is the mean over all the particles and samples of both, and
/// the variances and covariances are those about this mean. Forces are per volume of all cells and samples
/// together, whether or not particles were there.
class FieldSums {
  public:
    FieldSums() = default;
    explicit FieldSums(std::size_t cells) : sums_(cells * width, 0.0) {}

    [[nodiscard]] std::size_t cells() const { return sums_.size() / width; }
    /// Add what a window of so many samples found in a cell; values that are not numbers count as none.
    void add_window(std::size_t cell, const FieldValues& values, double samples);
    /// Add a cell of other sums.
    void add(std::size_t cell, const FieldSums& other, std::size_t other_cell);
    /// Add (sign 1) or take away (-1) sums of the same cells.
    void add(const FieldSums& other, double sign = 1.0);

    /// Mean of a quantity; not-a-number where there was no particle or sample.
    [[nodiscard]] double mean(FieldQuantity quantity, std::size_t cell) const;
    [[nodiscard]] std::vector<double> means(FieldQuantity quantity) const;

  private:
    static constexpr std::size_t width = field_quantities + 1;  ///< the last one: samples of cells
    std::vector<double> sums_;
};

/// Velocities in all cells of the box over a block of windows; not-a-number where no particle was.
struct FieldBlock {
    std::vector<float> u, v, w;
};

/// Time means of a three-dimensional run in cells, over its windows that lie within the averaging window.
struct MeanFlow {
    std::vector<double> x, y, z;      ///< centres of the cells, m
    double interval = 0;              ///< length of a window, s
    std::vector<double> time;         ///< end of each window, s
    FieldSums box;                    ///< all windows: [(iz * y.size() + iy) * x.size() + ix]
    std::vector<FieldSums> sections;  ///< of each window, streamwise: [iz * y.size() + iy]
    /// At most `most_blocks` stretches of successive windows: what intervals come from.
    std::vector<FieldBlock> blocks;
    std::vector<FieldSums> block_sections;

    static constexpr std::size_t most_blocks = 10;

    [[nodiscard]] bool empty() const { return sections.empty(); }
    [[nodiscard]] std::size_t at(std::size_t iz, std::size_t iy) const { return iz * y.size() + iy; }
    [[nodiscard]] std::size_t at(std::size_t iz, std::size_t iy, std::size_t ix) const {
        return (iz * y.size() + iy) * x.size() + ix;
    }
    [[nodiscard]] double cell_height() const { return edge(z); }
    [[nodiscard]] double cell_width() const { return edge(y); }
    [[nodiscard]] double cell_length() const { return edge(x); }
    /// Streamwise means of all windows.
    [[nodiscard]] FieldSums section() const;
    /// Means over the depth: [iy * x.size() + ix]; over the width: [iz * x.size() + ix].
    [[nodiscard]] FieldSums plan() const;
    [[nodiscard]] FieldSums side() const;

  private:
    [[nodiscard]] static double edge(const std::vector<double>& centres) {
        return centres.size() > 1
                   ? (centres.back() - centres.front()) / static_cast<double>(centres.size() - 1)
                   : 0.0;
    }
};

/// Values that follow from streamwise means, with their 95 % half-widths by the jackknife over the blocks of
/// windows; infinite of fewer than two blocks.
struct FieldEstimates {
    std::vector<double> value, half_width;
};
using SectionEstimator = std::function<std::vector<double>(const FieldSums& section)>;
[[nodiscard]] FieldEstimates section_estimates(const MeanFlow& field, const SectionEstimator& estimator);

/// The same of one value.
[[nodiscard]] Estimate section_estimate(const MeanFlow& field,
                                        const std::function<double(const FieldSums& section)>& estimator);

/// The columns of cells across the channel between two places, m; where none has its middle there, the
/// nearest.
[[nodiscard]] std::vector<std::size_t> columns_of_strip(const MeanFlow& field, double from, double to);

/// Sums of the cells of a section between two places across the channel, over the width: one per height.
/// The cells whose centres lie there; the nearest one where none does.
[[nodiscard]] FieldSums strip_of(const MeanFlow& field, const FieldSums& section, double from, double to);

/// Mean of values over the cells across the channel whose centres lie within half a `period` of each; at the
/// walls over those that there are. Not-a-number values are left out.
[[nodiscard]] std::vector<double> period_means(const std::vector<double>& y,
                                               const std::vector<double>& values, double period);

}  // namespace riffle::inline analysis
