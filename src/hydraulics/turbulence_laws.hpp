#pragma once

namespace riffle::inline hydraulics {

// Laws of the turbulence in uniform open-channel flow (thesis chapter 2). SI units. Heights z over the zero
// plane, depth h between zero plane and surface. The mixing lengths (2.20, 2.21, 4.2) are in the room
// `turbulence`.

/// Root mean squares of the three velocity fluctuations, m/s.
struct TurbulenceIntensities {
    double streamwise = 0;  ///< u'
    double vertical = 0;    ///< w', normal to the bed
    double spanwise = 0;    ///< v'
};

/// Universal turbulence intensities (thesis 2.12-2.14; Nezu 1977): (2.30, 1.27, 1.63) u_* exp(-z/h) for u, w
/// and v. Measured for 0.1 or 0.2 < z/h < 0.9, smooth and rough beds.
[[nodiscard]] TurbulenceIntensities nezu_intensities(double z, double depth, double friction_velocity);

/// -u'w'/u_*^2 of uniform flow where the viscous part is small (thesis 2.15): 1 - z/h.
[[nodiscard]] constexpr double linear_reynolds_stress(double z, double depth) { return 1.0 - z / depth; }

/// -u'w'/u_*^2 with a mean vertical velocity W of secondary flow (thesis 2.28): 1 - z/h + U W/u_*^2.
[[nodiscard]] constexpr double reynolds_stress_with_secondary_flow(double z, double depth, double velocity,
                                                                   double vertical_velocity,
                                                                   double friction_velocity) {
    return linear_reynolds_stress(z, depth) +
           velocity * vertical_velocity / (friction_velocity * friction_velocity);
}

/// Bed shear stress at the roughness crest d_h of uniform flow of total depth H (thesis, with 4.6), Pa:
/// tau_b = rho g S0 (H - d_h). `gravity_component` is g S0.
[[nodiscard]] constexpr double crest_stress(double density, double gravity_component, double total_depth,
                                            double roughness_height) {
    return density * gravity_component * (total_depth - roughness_height);
}

/// Total shear stress above the roughness crest over that at the crest (thesis 4.6):
/// tau/tau_b = 1 - (z - d_h)/(H - d_h), z over the bed level.
[[nodiscard]] constexpr double relative_stress_above_crest(double z, double total_depth,
                                                           double roughness_height) {
    return 1.0 - (z - roughness_height) / (total_depth - roughness_height);
}

}  // namespace riffle::inline hydraulics
