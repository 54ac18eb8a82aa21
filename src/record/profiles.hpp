#pragma once

#include <vector>

namespace riffle::inline record {

/// Time averages of the layers over a window, with the stresses that follow from them. One value per layer.
struct Profiles {
    double window_start = 0.0;
    double window_end = 0.0;
    double samples = 0.0;
    std::vector<double> bin_lower, bin_upper, z, velocity, velocity_half_width, vertical_velocity,
        velocity_deviation, column_velocity, velocity_gradient, eddy_viscosity, pressure, density,
        viscous_stress, pair_stress, reynolds_stress, total_stress, analytic_stress, velocity_rms,
        vertical_velocity_rms, drag;
    /// Three dimensions only, else empty.
    std::vector<double> spanwise_velocity, spanwise_velocity_rms, side_wall_drag;

    [[nodiscard]] bool empty() const { return z.empty(); }
};

}  // namespace riffle::inline record
