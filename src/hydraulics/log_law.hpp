#pragma once

#include <span>

namespace riffle {

/// Fit of the rough log law u/u_* = ln((z - z_0)/k_s)/kappa + 8.5 (thesis 2.3).
struct LogLawFit {
    double friction_velocity = 0;             ///< u_*, m/s
    double equivalent_roughness = 0;          ///< k_s, m
    double zero_plane = 0;                    ///< z_0 above the bed level, m
    double friction_velocity_half_width = 0;  ///< of the 95 % interval
    double equivalent_roughness_half_width = 0;
    double zero_plane_half_width = 0;
    double residual_rms = 0;  ///< m/s
    double from = 0;          ///< fitted range of z, m
    double to = 0;
    bool valid = false;
};

/// Fit u_* and k_s with the zero plane given (linear least squares in ln(z - zero_plane)).
[[nodiscard]] LogLawFit fit_log_law(std::span<const double> z, std::span<const double> velocity, double kappa,
                                    double zero_plane, double from, double to);

/// Fit u_*, k_s and the zero plane together (the plane searched below `from`).
[[nodiscard]] LogLawFit fit_log_law_with_zero_plane(std::span<const double> z,
                                                    std::span<const double> velocity, double kappa,
                                                    double from, double to);

}  // namespace riffle
