#pragma once

#include <vector>

namespace riffle::inline ends {

/// The shape of a profile of the streamwise velocity: u over the depth mean as a function of z/H, straight
/// lines between its points, constant beyond them.
class VelocityShape {
  public:
    /// Heights over the bed level and velocities, the former rising, of water of this depth (m). The
    /// velocities need not have any scale.
    VelocityShape(std::vector<double> height, std::vector<double> velocity, double depth);
    /// One velocity.
    VelocityShape() : place_{0.5}, value_{1.0} {}

    /// u/U at z/H.
    [[nodiscard]] double at(double place) const;
    [[nodiscard]] double largest() const;
    /// Mean of the values at the middles of so many rows: a discharge in rows is exact with the shape over
    /// it.
    [[nodiscard]] double mean_of_rows(int rows) const;

  private:
    std::vector<double> place_;
    std::vector<double> value_;
};

}  // namespace riffle::inline ends
