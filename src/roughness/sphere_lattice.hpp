#pragma once

#include <array>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline roughness {

/// The upper layer of the bed's spheres at their real positions (thesis 5.8). Hexagonal: rows along x,
/// spheres D apart in a row, rows sqrt(3)/2 D apart and shifted by D/2 against each other; square: D apart
/// both ways. One row stands under the centreline. On periodic axes the lattice is stretched, by less than
/// `largest_stretch` (case/sphere_tiling.hpp), to fit a whole number of periods.
class SphereLattice {
  public:
    explicit SphereLattice(const Case& c);

    /// phi at a point: 1 inside a sphere, 0 outside, linear over the ramp around its surface; the sum over
    /// the spheres, which is 1 where two of them touch.
    [[nodiscard]] double shape_factor(double x, double y, double z) const;

    /// Centres (x, y, z) of the spheres that stand in a stretch of the bed, 0 <= x < length, or reach into it
    /// from beside it, 0 <= y <= width, m.
    [[nodiscard]] std::vector<std::array<double, 3>> centres(double length, double width) const;

    /// Mean of phi over a horizontal plane, closed form.
    [[nodiscard]] double plan_mean(double z) const;

    /// Height above which phi is zero, m.
    [[nodiscard]] double top() const { return centre_z_ + radius_ + 0.5 * ramp_; }
    /// Height of the spheres' centres over the bed level, d_h - R, m (may be negative).
    [[nodiscard]] double centre_height() const { return centre_z_; }
    [[nodiscard]] double spheres_per_area() const {
        return 2.0 / (period_x_ * period_y_) * (hexagonal_ ? 1.0 : 0.5);
    }
    /// Periods of the lattice along and across the channel, m.
    [[nodiscard]] double period_x() const { return period_x_; }
    [[nodiscard]] double period_y() const { return period_y_; }

  private:
    bool hexagonal_;
    double radius_, ramp_, centre_z_;
    double period_x_, period_y_;  ///< hexagonal: D and sqrt(3) D
    double origin_y_;             ///< of a row
};

}  // namespace riffle::inline roughness
