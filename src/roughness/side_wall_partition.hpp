#pragma once

#include "case/case.hpp"

namespace riffle::inline roughness {

/// How the weight of the water divides between the bed and the side walls (Yang & Lim 1997; thesis 5.11):
/// along lines from the corners, on which the flow areas A_b = W_b H - k H^2 of the bed and A_w = k H^2/2 of
/// each wall meet. In a channel narrower than two depths they cross below the surface, and the bed has the
/// triangle below, A_b = W_b^2/(4 k).
struct SideWallPartition {
    /// u_*bed/u_*wall: k^2 = (A_b/W_b)/(A_w/H) is k^3 + (2 H/W_b) k - 2 = 0, in a narrow channel
    /// k^3 - W_b/(4 H) k^2 - 1/2 = 0.
    double k = 0.0;
    double bed_area = 0.0;     ///< A_b, m2
    double wall_area = 0.0;    ///< A_w of one wall, m2
    double bed_stress = 0.0;   ///< tau_bed/rho = g S0 A_b/W_b, m2/s2
    double wall_stress = 0.0;  ///< tau_wall/rho = g S0 A_w/H, m2/s2
    double bed_share = 0.0;    ///< of the weight component that the bed carries
    /// Force on one wall over the force on the bed of the whole width: H/(k^2 W_b).
    double wall_over_bed = 0.0;
};

/// `depth`: H, `width`: W_b of the whole channel, m; `streamwise_gravity`: g S0, m/s2.
[[nodiscard]] SideWallPartition side_wall_partition(double depth, double width, double streamwise_gravity);

/// The partition of a case with side walls, over its total depth.
[[nodiscard]] SideWallPartition side_wall_partition(const Case& c);

/// Drag coefficient beta, 1/m, of the walls' layers in the printed form (thesis 5.12-5.13), A_w/(k^2 A_b)
/// C_d/(2 dx): it counts k^2 twice and scales as 1/dx.
[[nodiscard]] double printed_side_wall_coefficient(const Case& c);

}  // namespace riffle::inline roughness
