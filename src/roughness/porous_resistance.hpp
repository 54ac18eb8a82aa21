#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "case/porous_zone.hpp"

namespace riffle::inline roughness {

/// The resistance of a porous medium to water that passes with the discharge q of an area: a pressure
/// gradient of rho (linear + quadratic |q|) q (Darcy 1856, Forchheimer 1901), linear = nu/K, quadratic =
/// c_F/sqrt(K), or by the grain size after Ergun (1952): A (1 - n)^2 nu/(n^3 d^2) and B (1 - n)/(n^3 d)
/// (docs/theory.md, section 21).
class PorousResistance {
  public:
    PorousResistance(const Porous& medium, double viscosity);

    /// Force on the mass of water that would fill the volume without grains, m/s2; at q >= 0, m/s.
    [[nodiscard]] double of(double q) const { return coefficient(std::abs(q)) * q; }
    /// Its derivative by q, 1/s.
    [[nodiscard]] double slope(double q) const { return linear_ + 2.0 * quadratic_ * std::abs(q); }
    /// Its integral from 0, m2/s3.
    [[nodiscard]] double integral(double q) const {
        return q * q * (linear_ / 2.0 + quadratic_ * std::abs(q) / 3.0);
    }
    /// What multiplies q in it, 1/s.
    [[nodiscard]] double coefficient(double size_of_q) const { return linear_ + quadratic_ * size_of_q; }
    /// The q at which it is `force`, m/s; infinite where nothing resists.
    [[nodiscard]] double discharge_at(double force) const;

    [[nodiscard]] double linear() const { return linear_; }        ///< 1/s
    [[nodiscard]] double quadratic() const { return quadratic_; }  ///< 1/m

  private:
    double linear_;
    double quadratic_;
};

/// Permeability K = nu/linear of a medium, m2; infinite where A is 0.
[[nodiscard]] double permeability_of(const Porous& medium);

/// Diameter of the grains of a medium, m: the given one, or that whose permeability Ergun's law makes of A =
/// 150.
[[nodiscard]] double grain_size_of(const Porous& medium);

/// Largest mixing length in the pores of a medium, m.
[[nodiscard]] double pore_mixing_length(const Porous& medium);

/// The zones of a case with their laws, in the order of the case: what acts at a place.
class PorousMedia {
  public:
    explicit PorousMedia(const Case& c);

    struct Medium {
        PorousResistance resistance;
        double viscosity_ratio;  ///< Porous::viscosity_ratio
        double mixing_length;    ///< m
    };
    /// All that the zones make of a place. In the edge of a zone the resistance is not the same in all
    /// directions: water that passes through it feels one medium after the other, and has the share of the
    /// pressure gradient; water that flows along it feels them side by side, and has the share of the force
    /// on the volume. Each leaves out the error of the first order of the edge's thickness that the other
    /// makes.
    struct At {
        double porosity = 1.0;
        double linear = 0.0;             ///< of the pressure gradient, with the share of the place, 1/s
        double quadratic = 0.0;          ///< 1/m
        double force_linear = 0.0;       ///< the same of n times it, 1/s
        double force_quadratic = 0.0;    ///< 1/m
        double viscosity_ratio = 1.0;    ///< of the shear stress
        std::array<double, 3> normal{};  ///< of the edge; zero where there is none, or not asked for

        /// n times what multiplies q in the pressure gradient of flow across an edge, 1/s.
        [[nodiscard]] double across(double size_of_q) const {
            return porosity * (linear + quadratic * size_of_q);
        }
        /// So of flow along an edge; away from edges the same.
        [[nodiscard]] double along(double size_of_q) const {
            return force_linear + force_quadratic * size_of_q;
        }
    };
    [[nodiscard]] At at(double x, double y, double z) const;
    /// The same with the normal of the edge, in so many dimensions.
    [[nodiscard]] At at_with_normal(int dimensions, double x, double y, double z) const;
    /// The mixing length of the eddies where it would be `length` without grains, m.
    [[nodiscard]] double limited(double length, double x, double y, double z) const;

    [[nodiscard]] bool empty() const { return media_.empty(); }

  private:
    PorosityField field_;
    std::vector<Medium> media_;   ///< of its zones
    double thinnest_edge_ = 0.0;  ///< m
};

}  // namespace riffle::inline roughness
