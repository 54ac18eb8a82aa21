#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "hydraulics/section_shape.hpp"

namespace riffle::inline hydraulics {

/// What one discharge does in a channel at one depth.
struct SectionState {
    double friction_slope =
        0.0;  ///< S_f = tau_0/(rho g H): sine of the angle at which this depth is uniform flow's
    double mean_velocity = 0.0;         ///< U over the datum, m/s
    double momentum_coefficient = 1.0;  ///< beta, mean of u^2 over the square of the mean
    double energy_coefficient = 1.0;    ///< alpha, mean of u^3 over the cube of the mean
};

/// A channel of one slope that carries one discharge, per unit of width: a wide one, or one of a
/// cross-section, whose discharge and area are those over its width. Depths h are over the datum of the bed
/// (of a section its lowest point) and normal to it; below the datum the water may go on for
/// `depth_below_datum` (among the spheres of a rough bed), which carries discharge and pressure like the
/// rest: H = h + depth_below_datum.
struct SteadyChannel {
    double slope = 0.0;              ///< S0, tangent of the angle of the bed; 0: horizontal, below 0: adverse
    double gravity = 9.81;           ///< m/s2
    double unit_discharge = 0.0;     ///< q, m2/s
    double depth_below_datum = 0.0;  ///< m
    double least_depth = 0.0;        ///< h from which on the state is known, m
    std::function<SectionState(double depth)> state;
    std::shared_ptr<const SectionShape> section = {};  ///< null: the same depth all over the width

    /// H, m.
    [[nodiscard]] double total_depth(double depth) const { return depth + depth_below_datum; }
    /// A, the area of the water over the width of the channel, m: H where there is no section.
    [[nodiscard]] double area(double depth) const;
    /// sin(theta) and cos(theta) of the bed.
    [[nodiscard]] double sine() const;
    [[nodiscard]] double cosine() const;
    /// g cos(theta), m/s2.
    [[nodiscard]] double normal_gravity() const { return gravity * cosine(); }
    /// beta; below the least depth that of the least depth.
    [[nodiscard]] double momentum_coefficient(double depth) const;
    /// Momentum function (specific force) beta q^2/A + g cos(theta) H^2/2, of a section with the integral of
    /// A over the depth in place of H^2/2, m3/s2.
    [[nodiscard]] double momentum(double depth) const;
    /// Its derivative by the depth, m2/s2: zero at the critical depth.
    [[nodiscard]] double momentum_gradient(double depth) const;
    /// Froude number by which the momentum balance is singular at 1: 1 - (dM/dh)/(g cos(theta) A) is its
    /// square, q^2 B/(g cos(theta) A^3) where beta = 1, with the share B of the width that the surface takes.
    [[nodiscard]] double froude_number(double depth) const;
    /// Height of the energy grade line over the datum of the bed, h cos(theta) + alpha (q/A)^2/(2 g), m.
    [[nodiscard]] double energy_head(double depth) const;
    /// Driving minus friction: sin(theta) - S_f.
    [[nodiscard]] double surplus_slope(double depth) const;
    /// Manning's n of the state at a depth, with the hydraulic radius of a wide channel or of the section,
    /// s/m^(1/3).
    [[nodiscard]] double manning(double depth) const;
};

/// Depth of the least momentum function, m; 0 where the water below the datum alone is deep enough for
/// subcritical flow.
[[nodiscard]] double critical_depth(const SteadyChannel& channel);

/// Depth of uniform flow, m; none on horizontal and adverse beds. Throws InputError where it is below the
/// least depth.
[[nodiscard]] std::optional<double> normal_depth(const SteadyChannel& channel);

/// The other depth of the same momentum function, m: behind a hydraulic jump for a supercritical depth,
/// before it for a subcritical one; none where that would be below the least depth.
[[nodiscard]] std::optional<double> sequent_depth(const SteadyChannel& channel, double depth,
                                                  double critical_depth);

/// A channel with Manning's n (s/m^(1/3)): S_f = n^2 U^2/R^(4/3), a wide one (R = h) or one of a section.
[[nodiscard]] SteadyChannel manning_channel(double slope, double gravity, double unit_discharge, double n,
                                            const std::shared_ptr<const SectionShape>& section = {});

/// A wide channel with an equivalent roughness k_s (m): the rough log law's mean over the depth (2.3) gives
/// u_*, and S_f = u_*^2/(g h). Known from h = k_s on.
[[nodiscard]] SteadyChannel rough_channel(double slope, double gravity, double unit_discharge,
                                          double equivalent_roughness);

/// A channel of a section with an equivalent roughness (m) of all its perimeter: S_f = f U^2/(8 g R) with the
/// friction factor of Colebrook and White and the constants of a pipe. Known from where R is k_s.
[[nodiscard]] SteadyChannel colebrook_channel(double slope, double gravity, double unit_discharge,
                                              double equivalent_roughness, double kinematic_viscosity,
                                              const std::shared_ptr<const SectionShape>& section);

/// Unit discharge of uniform flow with Manning's n, h^(5/3) sin(theta)^(1/2)/n, m2/s, of a section A R^(2/3)
/// in place of h^(5/3).
[[nodiscard]] double manning_unit_discharge(double slope, double depth, double n,
                                            const SectionShape* section = nullptr);

/// Unit discharge of uniform flow over an equivalent roughness, by the rough log law, m2/s.
[[nodiscard]] double rough_unit_discharge(double slope, double gravity, double depth,
                                          double equivalent_roughness);

}  // namespace riffle::inline hydraulics
