#pragma once

#include "case/case.hpp"

namespace riffle::inline roughness {

/// Friction of walls that are known by their roughness, where the particles do not resolve the flow beside
/// them: by the log law u/u_* = ln((d + z0)/z0)/kappa, d from the wall (case/bed_friction.hpp), as a drag
/// -beta u|u| in a layer of water beside the wall. The force is that of the friction velocity whose law has,
/// as its mean over the layer, the root of the mean u|u| that the layer has.
class LogLawFriction {
  public:
    /// `layer`: its thickness, m; `roughness`: k_s of the wall, m, 0 of a smooth one.
    LogLawFriction(const Case& c, double layer, double roughness);

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

/// Of the side walls of a case with side_walls.drag_form = "log-law".
[[nodiscard]] LogLawFriction side_wall_friction(const Case& c);

/// Of a solid with surface = "log-law": its layer is three spacings thick.
[[nodiscard]] LogLawFriction solid_friction(const Case& c, const Solid& solid);
/// Of a patch on such a solid.
[[nodiscard]] LogLawFriction solid_friction(const Case& c, const SurfacePatch& patch);

}  // namespace riffle::inline roughness
