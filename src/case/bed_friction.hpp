#pragma once

#include <algorithm>
#include <cmath>

#include "case/bed_traits.hpp"
#include "case/case.hpp"

namespace riffle::inline case_file {

// The log laws of plane beds, by which beds of a roughness and smooth ones act.

/// Constant of the log law of smooth walls in open channels, u/u_* = ln(z u_*/nu)/kappa + 5.29 (Nezu & Rodi
/// 1986).
inline constexpr double smooth_wall_constant = 5.29;

/// Constant of the rough log law, u/u_* = ln(z/k_s)/kappa + 8.5 (Nikuradse 1933; thesis 2.3).
inline constexpr double rough_wall_constant = 8.5;

/// Height at which the log law of a rough bed has the velocity zero, m: k_s exp(-8.5 kappa), k_s/32.6 with
/// kappa = 0.41 (k_s/30 with 0.40).
[[nodiscard]] inline double zero_height_of_roughness(double equivalent_roughness, double kappa) {
    return equivalent_roughness * std::exp(-rough_wall_constant * kappa);
}

/// The same of a smooth wall: exp(-5.29 kappa) nu/u_*, nearly nu/(9 u_*). `viscous_length` is nu/u_*, m.
[[nodiscard]] inline double zero_height_of_smooth_wall(double viscous_length, double kappa) {
    return viscous_length * std::exp(-smooth_wall_constant * kappa);
}

/// Depth mean over u_* of u/u_* = ln((z + z0)/z0)/kappa from the bed to the depth.
[[nodiscard]] inline double log_law_mean(double depth, double zero_height, double kappa) {
    const double ratio = depth / zero_height;
    return ((1.0 + 1.0 / ratio) * std::log1p(ratio) - 1.0) / kappa;
}

/// U/u_* of Manning's n (s/m^(1/3)) in a wide channel, whose hydraulic radius is its depth: h^(1/6)/(n
/// sqrt(g)) (Chow 1959; Henderson 1966).
[[nodiscard]] inline double velocity_ratio_of_manning(double manning, double depth, double gravity) {
    return std::pow(depth, 1.0 / 6.0) / (manning * std::sqrt(gravity));
}

/// Whether the bed of a case acts by a wall law.
[[nodiscard]] inline bool has_wall_law(const Case& c) { return traits_of(c.bed.kind).wall_law; }

/// Whether the water rests at the bed: a no-slip one, or one by a wall law.
[[nodiscard]] inline bool rests_at_bed(const Case& c) { return is_no_slip(c.bed) || has_wall_law(c); }

/// Whether the velocity over the bed has a log law: over spheres, and over a bed by a wall law.
[[nodiscard]] inline bool has_log_law(const Case& c) { return has_spheres(c.bed) || has_wall_law(c); }

/// Rows of particles of the layer in which the friction of a plane bed acts (turbulence/wall_layer.hpp): with
/// five the depth mean of 12 to 36 rows in their places is that of the law to half a percent
/// (tests/validation/wall_rows.py), with fewer the profile is not resolved.
inline constexpr double rows_of_wall_layer = 5.0;

/// Height up to which the bed holds the water back, above which its flow is that of the twin, m: the crests
/// of spheres, the rows of a wall layer.
[[nodiscard]] inline double top_of_bed_friction(const Case& c) {
    return has_wall_law(c) ? rows_of_wall_layer * c.numerics.spacing : c.crest();
}

/// Thickness of the layer in which the friction of a solid with surface = "log-law" acts, m.
[[nodiscard]] inline double solid_friction_layer(const Case& c) {
    constexpr double rows = 3.0;
    return rows * c.numerics.spacing;
}

/// Friction velocity that the viscous parts of the law of a case are made for, m/s: sqrt(g S0 H); without a
/// slope a twentieth of the velocity of the start, or 0.01 sqrt(g H).
[[nodiscard]] inline double reference_friction_velocity(const Case& c) {
    const double depth = c.total_depth();
    if (c.streamwise_gravity() > 0.0) return std::sqrt(c.streamwise_gravity() * depth);
    constexpr double share_of_velocity = 0.05;
    constexpr double share_of_waves = 0.01;
    return std::max(share_of_velocity * std::abs(c.start.velocity.value_or(0.0)),
                    share_of_waves * std::sqrt(c.fluid.gravity * depth));
}

}  // namespace riffle::inline case_file
