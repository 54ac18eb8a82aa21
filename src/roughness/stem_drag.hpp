#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "case/case.hpp"

namespace riffle::inline roughness {

/// Vegetation-related hydraulic radius of stems, the volume of the water between them over their frontal
/// area: r_v = (1 - phi)/(n d) = pi/4 (1 - phi)/phi d, m (Cheng & Nguyen 2011).
[[nodiscard]] inline double vegetation_radius(double solid_fraction, double diameter) {
    return std::numbers::pi / 4.0 * (1.0 - solid_fraction) / solid_fraction * diameter;
}

/// Drag coefficient of arrays of rigid cylinders by the Reynolds number Re_v = u r_v/nu of the velocity of
/// the water between them: C_D = 50/Re_v^0.43 + 0.7 (1 - exp(-Re_v/15000)), from measurements with Re_v from
/// 52 to 5.6e5 (Cheng & Nguyen 2011).
[[nodiscard]] inline double cheng_nguyen_drag_coefficient(double reynolds) {
    return 50.0 * std::pow(reynolds, -0.43) - 0.7 * std::expm1(-reynolds / 15000.0);
}

/// The drag of stems on the water between them, per mass of water: a deceleration beta(u) u^2 with
/// beta = C_D a/(2 (1 - phi)). The force on the stems in a volume of water and stems, 1/2 rho C_D a u^2,
/// holds back the water in it, a share 1 - phi (docs/theory.md, section 8, vegetation). Flexible stems
/// streamline above a reference velocity: C_D falls with (u/u_ref)^psi (Vogel 1984).
class StemDrag {
  public:
    StemDrag(const Vegetation& stems, double viscosity)
        : constant_(stems.drag_coefficient),
          per_coefficient_(0.5 * stems.frontal_area() / (1.0 - stems.solid_fraction())),
          reynolds_per_speed_(vegetation_radius(stems.solid_fraction(), stems.stem_diameter) / viscosity),
          exponent_(stems.vogel_exponent),
          reference_(stems.reference_velocity.value_or(0.0)) {}

    /// C_D at a speed of the water between the stems, m/s; flexible stems streamlined.
    [[nodiscard]] double drag_coefficient(double speed) const {
        const double rigid =
            constant_ ? *constant_ : cheng_nguyen_drag_coefficient(reynolds_per_speed_ * speed);
        return streamlines(speed) ? rigid * std::pow(speed / reference_, exponent_) : rigid;
    }
    /// beta, 1/m. Finite at rest, where that of Cheng & Nguyen has no limit.
    [[nodiscard]] double coefficient(double speed) const {
        return per_coefficient_ * drag_coefficient(std::max(speed, least_speed));
    }
    /// Deceleration of water that flows at u, m/s2, against it: beta |u| u.
    [[nodiscard]] double deceleration(double u) const { return coefficient(std::abs(u)) * std::abs(u) * u; }
    /// Its derivative by u, 1/s.
    [[nodiscard]] double deceleration_slope(double u) const;
    /// Its integral from 0 to u, m2/s2.
    [[nodiscard]] double deceleration_integral(double u) const;

    /// The speed at which the drag is an acceleration of the water, m/s: that of a uniform flow through
    /// emergent stems, driven by it.
    [[nodiscard]] double speed_at(double acceleration) const;

  private:
    static constexpr double least_speed = 1e-9;  // m/s

    [[nodiscard]] bool streamlines(double speed) const { return exponent_ != 0.0 && speed > reference_; }

    std::optional<double> constant_;
    double per_coefficient_;     ///< beta of C_D = 1, 1/m
    double reynolds_per_speed_;  ///< s/m
    double exponent_;            ///< psi
    double reference_;           ///< m/s
};

}  // namespace riffle::inline roughness
