#pragma once

#include <vector>

#include "case/case.hpp"

namespace riffle::inline turbulence {

/// How particles meet a bed by a wall law, which they cannot resolve: in a layer of the height of some rows
/// the velocity joins the profile of the law with value, slope and curvature, has no slope at the
/// bed and carries the same discharge; a drag -beta(z) u|u| in its lower part takes the stress of the bed,
/// and the mixing length there is that with which this is the steady flow. Above the layer nothing differs
/// from the law, and no length of it is finer than the rows (theory 8).
class WallLayer {
  public:
    /// For rows of a height, m. The case must have a wall law.
    WallLayer(const Case& c, double row_height);

    [[nodiscard]] double height() const { return height_; }
    /// beta at z, 1/m, at the reference friction velocity of the case: falling linearly from the bed to zero.
    [[nodiscard]] double drag_coefficient(double z) const;
    /// Height above which the drag is zero, m.
    [[nodiscard]] double drag_top() const { return drag_top_; }
    /// Mixing length at z below height(), m.
    [[nodiscard]] double mixing_length(double z) const;
    /// u at z up to height() of the uniform flow at the reference friction velocity, m/s.
    [[nodiscard]] double velocity(double z) const;
    /// Factor of beta for water that runs at a speed at z, m/s: 1 where the bed is rough; where viscosity
    /// counts, the law of the wall at the friction velocity that goes with the speed.
    [[nodiscard]] double speed_factor(double z, double speed) const;

  private:
    double height_;
    double drag_top_;
    double friction_velocity_;
    double drag_coefficient_ = 0.0;  ///< at the bed, 1/m
    double top_ = 0.0;               ///< of u/u_* = top - integral of slope (1 - t)(1 + 2 t + bend t^2)
    double slope_ = 0.0;
    double bend_ = 0.0;
    std::vector<double> z_, mixing_length_;
    std::vector<double> log_speed_, log_factor_;  ///< over those of the reference
};

}  // namespace riffle::inline turbulence
