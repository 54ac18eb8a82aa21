#pragma once

#include <vector>

namespace riffle::inline hydraulics {

/// A strip of a cross-section along the channel: the mean depth of its water and the wetted perimeter of its
/// bed, banks and upright faces, over its width.
struct LateralStrip {
    double depth = 0.0;                 ///< m; 0: dry
    double perimeter = 0.0;             ///< over the width of the strip
    double equivalent_roughness = 0.0;  ///< k_s of what the water wets, m; 0: smooth
};

/// Depth-mean velocities of uniform flow over strips of equal width (m) side by side, m/s: the balance of
/// Shiono & Knight (1991), g S h - (f/8) U^2 P + d/dy(lambda h^2 sqrt(f/8) U dU/dy) = 0, with the friction
/// factor of Colebrook and White for a hydraulic radius of the local depth and their lambda = 0.07, without
/// secondary flow. No shear at the outer edges and along dry strips. `gravity_component`: g S, m/s2, greater
/// than 0.
[[nodiscard]] std::vector<double> lateral_profile(const std::vector<LateralStrip>& strips, double width,
                                                  double gravity_component, double kinematic_viscosity);

}  // namespace riffle::inline hydraulics
