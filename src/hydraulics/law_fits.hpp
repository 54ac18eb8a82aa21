#pragma once

#include <optional>

#include "hydraulics/channel_laws.hpp"
#include "hydraulics/profile_fit.hpp"
#include "hydraulics/secondary_flow_laws.hpp"
#include "hydraulics/velocity_laws.hpp"

namespace riffle::inline hydraulics {

// Least-squares fits of the other velocity laws. The range must lie between zero plane and surface. A
// friction velocity that is given is taken as exact; where it is not, it is fitted, and the intervals, which
// then are much wider, include that.

/// Fit of Coles' wake over the rough log law (thesis 2.3, 2.5).
struct WakeFit : FitQuality {
    FittedValue wake_strength;         ///< Pi
    FittedValue friction_velocity;     ///< m/s
    FittedValue equivalent_roughness;  ///< k_s, m
};

/// Fit Pi and k_s, and u_* unless given, with the depth over the zero plane. Needs one point more than
/// unknowns.
[[nodiscard]] WakeFit fit_wake_strength(const VelocityPoints& points, double depth,
                                        std::optional<double> friction_velocity = {},
                                        double kappa = log_law_kappa, FitRange range = {});

/// Fit of the power law u = U_max (z/H)^(1/m).
struct PowerLawFit : FitQuality {
    FittedValue m;                 ///< looked for from 0.5 to 50
    FittedValue maximum_velocity;  ///< at z = H, m/s
};

/// Fit m and U_max to the velocities themselves (not to their logarithms, which would weigh the slow points
/// up).
[[nodiscard]] PowerLawFit fit_power_law(const VelocityPoints& points, double depth, FitRange range = {});

/// Fit of a dip-modified law.
struct DipFit : FitQuality {
    FittedValue dip;                   ///< alpha
    FittedValue friction_velocity;     ///< m/s
    FittedValue zero_velocity_height;  ///< z0 over the zero plane, m
    FittedValue height_of_maximum;     ///< h/(1 + alpha) over the zero plane, m; h for alpha <= 0
};

/// Fit alpha and z0, and u_* unless given, of the dip-modified log law (thesis 2.25).
[[nodiscard]] DipFit fit_dip_modified_log_law(const VelocityPoints& points, double depth,
                                              std::optional<double> friction_velocity = {},
                                              double kappa = log_law_kappa, FitRange range = {});

/// Fit alpha and z0, and u_* unless given, of the total dip-modified log-wake law (thesis 2.26) with a given
/// wake strength: alpha and Pi together are hardly ever determined by a profile.
[[nodiscard]] DipFit fit_total_dip_log_wake_law(const VelocityPoints& points, double depth,
                                                std::optional<double> friction_velocity = {},
                                                double wake_strength = wake_strength_of_uniform_flow,
                                                double kappa = log_law_kappa, FitRange range = {});

/// Fit of the log law with secondary flow.
struct SecondaryFlowFit : FitQuality {
    FittedValue phase;                 ///< place in the cell; a law of cells only between -1 and 1
    FittedValue friction_velocity;     ///< between the cells, m/s
    FittedValue zero_velocity_height;  ///< z0 over the zero plane, between the cells, m
};

/// Fit phase and z0, and u_* unless given, of the log law with secondary flow (thesis 2.24) with its printed
/// constants.
[[nodiscard]] SecondaryFlowFit fit_secondary_flow_log_law(const VelocityPoints& points, double depth,
                                                          std::optional<double> friction_velocity = {},
                                                          double kappa = log_law_kappa, FitRange range = {});

/// Equivalent roughness from a profile whose friction velocity is known from the stress.
struct RoughnessFit : FitQuality {
    FittedValue equivalent_roughness;  ///< k_s, m
};

/// Fit k_s of the rough log law (thesis 2.3) with u_* and kappa given: where the profile is short or no log
/// law, a fit of both gives a slope that no stress has. The half-width of the 95 % interval of u_* adds to
/// that of the fit (in quadrature, of the logarithm).
[[nodiscard]] RoughnessFit fit_roughness(const VelocityPoints& points, double friction_velocity,
                                         double friction_velocity_half_width, double kappa = log_law_kappa,
                                         FitRange range = {});

/// Von Karman's constant from a profile whose friction velocity is known from the stress.
struct KappaFit : FitQuality {
    FittedValue kappa;
    FittedValue constant;  ///< of the law, at z = length
};

/// Fit kappa and A of u/u_* = ln(z/length)/kappa + A, as Nezu & Rodi (1986) check kappa: u_* comes from the
/// measured stress or the slope, not from the velocities. `length` is nu/u_* (then A is the smooth B) or k_s
/// (then A is 8.5 of 2.3). The half-width of the 95 % interval of u_* adds to those of both (in quadrature).
[[nodiscard]] KappaFit fit_kappa(const VelocityPoints& points, double friction_velocity,
                                 double friction_velocity_half_width, double length, FitRange range = {});

}  // namespace riffle::inline hydraulics
