#pragma once

#include <array>
#include <vector>

#include "case/case.hpp"
#include "pair_sample.hpp"
#include "sph/pair_terms.hpp"

namespace riffle {

/// One result: the sum and the sum of the magnitudes of its terms, which measures what rounding may do to it.
struct PlainSum {
    double value = 0.0;
    double magnitude = 0.0;
    void add(double term);
};

/// The sums of the loops over all pairs, in double precision and by the plain formulas (model.md section 3,
/// numerics.md), by fluid or wall particle. Symmetric matrices as their upper triangles, row by row.
template <int D>
struct PlainSums {
    using Sums = std::vector<PlainSum>;
    using Vectors = std::array<Sums, static_cast<std::size_t>(D)>;
    using Matrices = std::array<Sums, static_cast<std::size_t>(D* D)>;
    using SymmetricMatrices = std::array<Sums, static_cast<std::size_t>(D*(D + 1) / 2)>;

    Sums density_rate, diffusion;
    Sums midway_density_rate;  ///< with each pair where it was `ago` before
    Matrices gradient;         ///< uncorrected, du_k/dx_l
    SymmetricMatrices m_fluid, m_wall, m_continued;
    SymmetricMatrices m_along;  ///< of m_continued the walls that continue the fluid along the channel too
    Vectors tensor, viscous, wall;
    Sums wall_weight, wall_pressure, wall_density_rate;
    Vectors wall_offset, wall_velocity;
    Sums zeroth, mass;
    Vectors first, mass_first, velocity;
    SymmetricMatrices second;
};

/// Constants of the sums.
struct PlainOptions {
    KernelKind kernel = KernelKind::wendland_c2;
    ViscosityForm viscosity = ViscosityForm::morris;
    double diffusion = 0.0;
    double ago = 0.0;
    double hydrostatic_gradient = 0.0;
    double impact = 0.0;            ///< Riemann problem of the pair
    double impact_bound = 0.0;      ///< of it
    double non_conservative = 0.0;  ///< of the particle's own pressure, taken off
    double tensile = 0.0;           ///< Monaghan's (2000) epsilon
    bool weighted = false;          ///< Morris' viscosity by `directional` (three dimensions)
    DirectionalViscosity<double> directional = {};
};

/// B by fluid particle, row-major.
template <int D>
using Corrections = std::vector<std::array<double, static_cast<std::size_t>(D* D)>>;

/// `correction` is used for the pairs of the force with walls that continue the fluid.
template <int D>
[[nodiscard]] PlainSums<D> plain_sums(const PairSample<D>& sample, const PlainOptions& options,
                                      const Corrections<D>& correction);

}  // namespace riffle
