#pragma once

#include "case/case.hpp"

namespace riffle {

/// Friction of side walls by the log law of their own roughness, u/u_* = ln((y + z0)/z0)/kappa with y from
/// the wall (case/bed_friction.hpp), as a drag -beta u|u| in a layer of water beside each wall: the force is
/// that of the friction velocity whose law has, as its mean over the layer, the root of the mean u|u| that
/// the layer has.
class SideWallFriction {
  public:
    /// Of a case with side_walls.drag_form = "log-law".
    explicit SideWallFriction(const Case& c);

    /// beta, 1/m, where the mean of u|u| over the layer is `square`, m2/s2: where viscosity counts it falls
    /// with the speed.
    [[nodiscard]] double coefficient(double square) const;
    /// Its derivative by `square`, s2/m3.
    [[nodiscard]] double slope(double square) const;

  private:
    double kappa_;
    double layer_;              ///< thickness, m
    double viscosity_;          ///< m2/s
    double rough_zero_height_;  ///< z0 of the roughness, m
};

}  // namespace riffle
