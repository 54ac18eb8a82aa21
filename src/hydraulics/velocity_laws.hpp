#pragma once

#include "hydraulics/channel_laws.hpp"

namespace riffle::inline hydraulics {

// Laws of the time-mean velocity over the height in uniform open-channel flow (thesis chapter 2). SI units;
// the rough log law (2.3) is in channel_laws.hpp. Heights z over the zero plane of the law, depth h between
// zero plane and surface. None of them checks its arguments: outside of what is said they are not a number.

/// Constant of the smooth log law (thesis 2.1; Coles 1956). Nezu & Rodi 1986 give 5.29 with kappa 0.412,
/// Brederode & Bradshaw 1974 5.2.
inline constexpr double smooth_log_law_constant = 5.0;

/// Coles' wake strength of uniform flow where u_* h/nu > 2000 (Nezu & Rodi 1986, thesis below 2.5).
inline constexpr double wake_strength_of_uniform_flow = 0.2;

/// Smooth log law (thesis 2.1): u = u_* (ln(z u_*/nu)/kappa + B), m/s. Valid from z+ of about 30 upwards.
[[nodiscard]] double smooth_log_law(double z, double friction_velocity, double kinematic_viscosity,
                                    double kappa = log_law_kappa, double constant = smooth_log_law_constant);

/// Coles' wake function (thesis 2.4-2.5) over u_*: (2 Pi/kappa) sin^2(pi z/(2 h)), to be added to a log law.
[[nodiscard]] double coles_wake(double z, double depth, double wake_strength, double kappa = log_law_kappa);

/// Rough log-wake law (thesis 2.3 and 2.5), m/s.
[[nodiscard]] double rough_log_wake_law(double z, double depth, double friction_velocity,
                                        double equivalent_roughness, double wake_strength,
                                        double kappa = log_law_kappa);

/// Power law, the start of the thesis' 3D runs: u = U_max (z/H)^(1/m), m/s.
[[nodiscard]] double power_law(double z, double depth, double maximum_velocity, double m);

/// Dip-modified log law (thesis 2.25; Yang, Tan & Lim 2004), m/s: u = u_* [ln(z/z0) + alpha ln(1 -
/// z/h)]/kappa. Its maximum lies at z/h = 1/(1 + alpha); 0 < z < h.
[[nodiscard]] double dip_modified_log_law(double z, double depth, double friction_velocity,
                                          double zero_velocity_height, double dip,
                                          double kappa = log_law_kappa);

/// Dip parameter at the distance y_w from the side wall (Yang, Tan & Lim 2004, with 2.25): 1.3 exp(-y_w/h).
[[nodiscard]] double dip_parameter_near_wall(double wall_distance, double depth);

/// Dip parameter of a velocity maximum at the height z_dip (with 2.25 and 2.26): h/z_dip - 1.
[[nodiscard]] double dip_parameter_of_maximum(double height_of_maximum, double depth);

/// Total dip-modified log-wake law (thesis 2.26; Kundu & Ghoshal 2012), m/s, with xi = z/h, xi0 = z0/h:
/// u = u_* [ln(xi/xi0) + alpha ln((1 - xi)/(1 - xi0)) + Pi (1 + alpha)(cos(pi xi0) - cos(pi xi))
///          - alpha pi Pi (Si(pi (1 - xi0)) - Si(pi (1 - xi)))]/kappa; 0 < z < h.
[[nodiscard]] double total_dip_log_wake_law(double z, double depth, double friction_velocity,
                                            double zero_velocity_height, double dip, double wake_strength,
                                            double kappa = log_law_kappa);

/// The velocity gradient that the law above is the integral of, 1/s:
/// du/dz = u_*/(kappa h) [1/xi - alpha/(1 - xi)] (1 + pi Pi xi sin(pi xi)).
[[nodiscard]] double total_dip_log_wake_gradient(double z, double depth, double friction_velocity, double dip,
                                                 double wake_strength, double kappa = log_law_kappa);

/// Sine integral Si(x), the integral of sin(t)/t from 0 to x, by its power series: to 1e-12 for |x| <= 10.
/// Throws InputError beyond that.
[[nodiscard]] double sine_integral(double x);

}  // namespace riffle::inline hydraulics
