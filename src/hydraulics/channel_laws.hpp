#pragma once

namespace riffle::inline hydraulics {

// Laws of uniform open-channel flow (thesis chapter 2). SI units.

/// Von Karman's constant of the log-law fits of measured and computed profiles (thesis 2.1, 2.3).
inline constexpr double log_law_kappa = 0.41;

/// Constant of the rough log law (thesis 2.3).
inline constexpr double rough_log_law_constant = 8.5;

/// Friction factor of Darcy and Weisbach (thesis 2.6): f = 8 g R S0/U^2. `gravity_component` is g S0.
[[nodiscard]] double friction_factor(double gravity_component, double hydraulic_radius, double velocity);

/// Manning's n (thesis 2.7): R^(2/3) S0^(1/2)/U, s/m^(1/3).
[[nodiscard]] double manning_coefficient(double slope, double hydraulic_radius, double velocity);

/// Chezy's C (thesis 2.8): U/sqrt(R S0), m^(1/2)/s.
[[nodiscard]] double chezy_coefficient(double slope, double hydraulic_radius, double velocity);

/// Reynolds number U l/nu.
[[nodiscard]] double reynolds_number(double velocity, double length, double kinematic_viscosity);

/// Froude number U/sqrt(g h).
[[nodiscard]] double froude_number(double velocity, double gravity, double depth);

/// Hydraulic radius of a rectangular section, b h/(b + 2 h), m.
[[nodiscard]] double hydraulic_radius(double depth, double width);

/// Friction velocity of uniform flow, sqrt(g S0 R), m/s. `gravity_component` is g S0.
[[nodiscard]] double friction_velocity_from_slope(double gravity_component, double depth);

/// Constants of the equation of Colebrook and White for channels (thesis 2.9).
struct ColebrookWhiteConstants {
    const char* source;
    double c1;
    double c2;
    double c3;
};

/// Rows of Yen's (2002) table of constants; Henderson's are those of the wide channel. The others stand in
/// the thesis without a check against their sources.
inline constexpr ColebrookWhiteConstants henderson_wide_channel{"Henderson, wide channel", 2.0, 12.0, 2.5};
inline constexpr ColebrookWhiteConstants full_pipe{"full pipe", 2.0, 14.83, 2.52};
inline constexpr ColebrookWhiteConstants keulegan_channel{"Keulegan", 2.03, 11.09, 3.41};
inline constexpr ColebrookWhiteConstants rouse_channel{"Rouse", 2.03, 10.95, 1.70};

/// Friction factor of Colebrook and White for channels (thesis 2.9):
/// 1/sqrt(f) = -c1 log10(k_s/(c2 R) + c3/(Re sqrt(f))), Re = 4 R U/nu. Throws InputError unless k_s >= 0,
/// R > 0, Re > 0 and the equation has a root with f > 0, which it lacks for k_s/R beyond about c2.
[[nodiscard]] double colebrook_white_friction_factor(
    double equivalent_roughness, double hydraulic_radius, double reynolds,
    const ColebrookWhiteConstants& constants = henderson_wide_channel);

/// Velocity of uniform flow by the same equation, m/s: with Re sqrt(f) = 4 sqrt(8) R u_*/nu it is explicit in
/// the friction velocity sqrt(g S0 R). Not above 0 where k_s/R is beyond about c2.
[[nodiscard]] double colebrook_white_velocity(
    double gravity_component, double equivalent_roughness, double hydraulic_radius,
    double kinematic_viscosity, const ColebrookWhiteConstants& constants = henderson_wide_channel);

/// Velocity of uniform flow from a friction factor, U = sqrt(8 g S0 R/f) (thesis 2.6), m/s.
[[nodiscard]] double velocity_from_friction_factor(double gravity_component, double hydraulic_radius,
                                                   double friction_factor);

/// U/u_* = sqrt(8/f) (thesis 2.6-2.8: the same as C/sqrt(g) and R^(1/6)/(n sqrt(g))).
[[nodiscard]] double velocity_ratio(double friction_factor);

enum class RoughnessClass { smooth, transitional, rough };

/// Roughness Reynolds number k+ = k_s u_*/nu.
[[nodiscard]] double roughness_reynolds_number(double equivalent_roughness, double friction_velocity,
                                               double kinematic_viscosity);

/// Class of the bed (thesis chapter 2): k+ < 5 smooth, 5-70 transitional, > 70 rough.
[[nodiscard]] RoughnessClass roughness_class(double roughness_reynolds);

/// Rough log law (thesis 2.3): u = u_* (ln(z/k_s)/kappa + 8.5); z over the zero plane, > 0.
[[nodiscard]] double rough_log_law(double z, double friction_velocity, double equivalent_roughness,
                                   double kappa = log_law_kappa);

/// Mean of the rough log law over 0 < z < depth: u_* ((ln(depth/k_s) - 1)/kappa + 8.5).
[[nodiscard]] double rough_log_law_depth_mean(double depth, double friction_velocity,
                                              double equivalent_roughness, double kappa = log_law_kappa);

/// k_s of the rough log law with friction velocity u_* whose depth mean over 0 < z < depth is `velocity`.
[[nodiscard]] double equivalent_roughness_from_mean(double depth, double friction_velocity, double velocity,
                                                    double kappa = log_law_kappa);

}  // namespace riffle::inline hydraulics
