#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ends/entering_flow.hpp"

namespace riffle::inline ends {

/// The water of a periodic channel at some moments, on a grid of cells: what a recorded flow is made of.
struct RecordedWater {
    double length = 0.0;         ///< of the channel, which repeats itself, m
    double width = 0.0;          ///< simulated, m; 0 in two dimensions
    bool repeats_across = true;  ///< so across the channel
    std::array<std::size_t, 3> cells{1, 1, 1};
    std::vector<double> time;  ///< of the moments, rising, s
    /// By moment: (u, v, w) in the middle of each cell at [3 * ((iz * ny + iy) * nx + ix)], m/s.
    std::vector<std::vector<float>> velocity;
};

/// The water of a periodic channel as it enters another one: from one recorded moment to the next the eddies
/// of both are carried along by the mean flow at their height (Taylor's hypothesis) and go over into each
/// other, with the mean square of what was recorded between; behind the last moment comes the first one.
class RecordedFlow final : public EnteringFlow {
  public:
    /// Of at least one moment.
    explicit RecordedFlow(RecordedWater water);

    [[nodiscard]] double mean_at(double y, double place) const override;
    [[nodiscard]] Vec<3> at(double time, double y, double place) const override;
    [[nodiscard]] double largest() const override { return largest_; }
    [[nodiscard]] double fastest() const override { return fastest_; }
    [[nodiscard]] std::size_t bytes() const override;

    [[nodiscard]] double bulk_velocity() const { return bulk_velocity_; }  ///< of the record, m/s
    /// Time in which the record repeats itself, s.
    [[nodiscard]] double period() const { return period_; }

  private:
    /// Two neighbouring cells and the share of the second one.
    struct Between {
        std::size_t low, high;
        double share;
    };
    [[nodiscard]] static Between between(double place, std::size_t cells, bool repeats);
    [[nodiscard]] Between across(double y) const;
    [[nodiscard]] Vec<3> mean(double y, double place) const;
    /// What the velocity at a moment departs from the mean.
    [[nodiscard]] Vec<3> departure(std::size_t moment, double x, double y, double place) const;
    void take_off_mean();
    void find_correlations();

    RecordedWater water_;
    std::vector<double> mean_;  ///< (u, v, w) by iy within iz; where it repeats across one iy
    std::size_t mean_columns_ = 1;
    double bulk_velocity_ = 0.0;
    double largest_ = 0.0;
    double fastest_ = 0.0;
    double period_ = 0.0;
    /// From each moment to the next, by component: mean squares of both and mean product.
    struct Pair {
        double first = 0.0;
        double second = 0.0;
        double product = 0.0;
    };
    std::vector<std::array<Pair, 3>> pairs_;
};

}  // namespace riffle::inline ends
