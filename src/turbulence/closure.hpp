#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline turbulence {

/// Eddy viscosity of a mixing length: nu_t = l_m^2 |S| (m2/s), |S| = sqrt(2 S_ij S_ij) (1/s). Prandtl (1925);
/// with l_m = C_s Delta, Smagorinsky (thesis 4.1).
[[nodiscard]] inline double mixing_length_viscosity(double mixing_length, double strain_rate) {
    return mixing_length * mixing_length * strain_rate;
}

/// A turbulence closure: the eddy viscosity as a function of height and strain rate. The same object serves
/// the particles (batch call) and the column twin (scalar calls). Registered by name, one file per closure.
class Closure {
  public:
    virtual ~Closure() = default;

    /// Mixing length l_m at height z above the bed level (m). For SPS: C_s Delta. For resolved eddies the
    /// length that goes with their measure of the velocity gradient in place of |S| (sph/strain_measure.hpp).
    [[nodiscard]] virtual double mixing_length(double z) const = 0;

    /// The same in water of another depth than the case's, m over the bed level.
    [[nodiscard]] virtual double mixing_length_in(double z, double depth) const = 0;

    /// Eddy viscosity nu_t = l_m^2 |S| (m2/s), |S| = sqrt(2 S_ij S_ij) (1/s).
    [[nodiscard]] double eddy_viscosity(double z, double strain_rate) const {
        return mixing_length_viscosity(mixing_length(z), strain_rate);
    }

    /// Whether side_factor() is anything but 1.
    [[nodiscard]] virtual bool varies_across() const { return false; }
    /// Factor of the mixing length at y across the channel (m), beside side walls.
    [[nodiscard]] virtual double side_factor(double y) const {
        static_cast<void>(y);
        return 1.0;
    }
    /// l_y/l_x: 1 where the mixing length is the same in all directions, as in all closures but that of
    /// Czernuszenko & Rylov.
    [[nodiscard]] virtual double spanwise_ratio() const { return 1.0; }

    /// Mixing length at each height; a loop over the scalar function, vectorisable in each closure.
    virtual void mixing_lengths(std::span<const double> z, std::span<double> result) const = 0;
};

/// The closure that the case names; nullptr for `none` (laminar). Over a bed by a wall law (wall_law.hpp)
/// with the mixing length of the wall.
[[nodiscard]] std::unique_ptr<const Closure> make_closure(const Case& c);

struct WallLaw;

/// The closure that the case names over a bed with another wall law.
[[nodiscard]] std::unique_ptr<const Closure> make_wall_closure(const Case& c, const WallLaw& law);

/// The closure for particles in rows of a height, m: that of make_closure(), in the lowest rows over a bed by
/// a wall law that of their layer (wall_layer.hpp).
[[nodiscard]] std::unique_ptr<const Closure> make_particle_closure(const Case& c, double row_height);

}  // namespace riffle::inline turbulence
