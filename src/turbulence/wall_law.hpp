#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "case/bed_friction.hpp"
#include "case/case.hpp"

namespace riffle::inline turbulence {

/// The friction of a plane bed as its mixing length: that of the closure grows from a height below the bed
/// and is damped where viscosity carries the stress,
///     l = l_c(z) (z + shift)/z (1 - exp(-(z + shift)/damping)),
/// so that u(0) = 0 and far from the bed u/u_* = ln((z + z0)/z0)/kappa. Damping after van Driest (1956),
/// shift after Rotta (1962); both follow from the log laws of smooth and rough walls (theory 8).
struct WallLaw {
    double kappa = 0.41;          ///< slope of the closure's mixing length at the bed
    double zero_height = 0.0;     ///< z0, m
    double shift = 0.0;           ///< m
    double damping = 0.0;         ///< A+ nu/u_*, m; 0: none
    double viscous_length = 0.0;  ///< nu/u_*, m

    /// Mixing length at height z, m, from that of the closure there.
    [[nodiscard]] double mixing_length(double z, double of_closure) const {
        constexpr double most = 40.0;  // beyond it the damping is below a rounding error
        const double grown = z > 0.0 ? of_closure * (1.0 + shift / z) : kappa * shift;
        const double from_zero = std::max(z, 0.0) + shift;
        return damping > 0.0 && from_zero < most * damping ? -grown * std::expm1(-from_zero / damping)
                                                           : grown;
    }
};

/// The law for a roughness whose log law begins at `rough_zero_height` (0: smooth) and a viscous length, both
/// m: z0 is the sum of the two (Colebrook 1939), so that beds between smooth and rough have theirs.
[[nodiscard]] WallLaw make_wall_law(double kappa, double rough_zero_height, double viscous_length);

/// k_s of a bed by roughness, m; 0 of a smooth one. From Manning's n: that with which the uniform flow of the
/// case, with its closure, has the depth-mean velocity U/u_* = h^(1/6)/(n sqrt(g)) of n at its depth (the
/// hydraulic radius of a wide channel; Chow 1959, Henderson 1966). Throws InputError where no k_s has it.
[[nodiscard]] double equivalent_roughness(const Case& c);

/// A case whose bed keeps its k_s at other depths, where Manning's n gave it.
[[nodiscard]] Case with_fixed_roughness(Case c);

/// The law of a case's bed; nothing where its bed has none. The second: for another friction velocity, m/s.
[[nodiscard]] std::optional<WallLaw> bed_wall_law(const Case& c);
[[nodiscard]] std::optional<WallLaw> bed_wall_law(const Case& c, double friction_velocity);

/// Velocity of a uniform flow of depth H over its height, over u_*, from u(0) = 0: the stress falls linearly
/// and is carried by viscosity and mixing length.
class UniformProfile {
  public:
    UniformProfile(const std::function<double(double)>& mixing_length, const WallLaw& law, double depth);

    [[nodiscard]] double velocity(double z) const { return at(velocity_, z); }
    /// Mean from the bed to z.
    [[nodiscard]] double mean(double z) const { return at(flow_, z) / z; }
    /// du/dz over u_*, 1/m.
    [[nodiscard]] double gradient(double z) const { return at(gradient_, z); }

  private:
    [[nodiscard]] double at(const std::vector<double>& values, double z) const;

    std::vector<double> z_, velocity_, flow_, gradient_;
};

}  // namespace riffle::inline turbulence
