#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "particles/clusters.hpp"
#include "particles/domain.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

/// A set of particles for the loops, disordered fluid over a few layers of wall, or fluid alone.
struct PairSample {
    Domain<2> domain;
    FixedPoint<2> fixed_point;
    double h = 0.0;
    struct Particle {
        Vec<2> x{};
        Vec<2> u{};
        double s = 0.0;
        double volume = 0.0;
        double pressure = 0.0;
        double viscosity_root = 0.0;
        std::array<double, 4> stress{};
        std::array<double, 4> projector{};
        double continuation = 0.0;
    };
    std::vector<Particle> fluid;
    std::vector<Particle> wall;
};

/// The lattice (16 x 10 spacings of 1/16, periodic along x) with random displacements of up to `jitter`
/// spacings, velocities, densities and tensors, on `layers` layers of wall; periodic along z too without
/// walls.
[[nodiscard]] PairSample disordered_sample(double jitter, int layers, unsigned seed);

/// One result: the sum and the sum of the magnitudes of its terms, which measures what rounding may do to it.
struct PlainSum {
    double value = 0.0;
    double magnitude = 0.0;
    void add(double term);
};

/// The sums of the loops over all pairs, in double precision and by the plain formulas (model.md section 3,
/// numerics.md), by fluid or wall particle.
struct PlainSums {
    std::vector<PlainSum> density_rate, diffusion;
    std::array<std::vector<PlainSum>, 4> gradient;                      ///< uncorrected, du_k/dx_l
    std::array<std::vector<PlainSum>, 3> m_fluid, m_wall, m_continued;  ///< xx, xz, zz
    std::array<std::vector<PlainSum>, 2> tensor, viscous, wall;
    std::vector<PlainSum> wall_weight, wall_pressure, wall_density_rate;
    std::array<std::vector<PlainSum>, 2> wall_offset, wall_velocity;
    std::vector<PlainSum> zeroth, mass;
    std::array<std::vector<PlainSum>, 2> first, velocity;
    std::array<std::vector<PlainSum>, 3> second;
};
/// `correction`: B by fluid particle, for the wall pairs of the force.
[[nodiscard]] PlainSums plain_sums(const PairSample& sample, KernelKind kernel, ViscosityForm viscosity,
                                   double diffusion, double hydrostatic_gradient,
                                   const std::vector<std::array<double, 4>>& correction);

/// Everything that the loops need, made of a sample.
template <class Real>
struct LoopRun {
    Clusters<2> clusters;
    Clusters<2> wall_clusters;
    NeighbourList fluid_fluid;
    NeighbourList fluid_wall;
    NeighbourList wall_fluid;
    PairData<2, Real> data;
    /// Results by slot.
    struct {
        std::vector<Real> density_rate, diffusion, viscosity_factor, regularity;
        std::array<std::vector<Real>, 4> velocity_gradient, correction;
    } gradient;
    struct {
        std::array<std::vector<Real>, 2> tensor, viscous, wall;
    } force;
    struct {
        std::vector<Real> weight, pressure, density_rate;
        std::array<std::vector<Real>, 2> offset, velocity;
    } wall;
    struct {
        std::vector<Real> zeroth, mass;
        std::array<std::vector<Real>, 2> first, mass_first, velocity;
        std::array<std::vector<Real>, 3> second;
    } filter;

    LoopRun(const PairSample& sample, double diffusion, double hydrostatic_gradient, bool correct);
    LoopRun(const LoopRun&) = delete;
    LoopRun& operator=(const LoopRun&) = delete;
    LoopRun(LoopRun&&) = delete;
    LoopRun& operator=(LoopRun&&) = delete;
    ~LoopRun() = default;

    void run(const PairLoops<2, Real>& loops);
    /// Slot of a fluid or wall particle of the sample.
    [[nodiscard]] std::size_t fluid_slot(std::size_t particle) const;
    [[nodiscard]] std::size_t wall_slot(std::size_t particle) const;

    std::vector<std::int32_t> order;  ///< sample's fluid particles in spatial order
    std::vector<std::int32_t> wall_order;
};

}  // namespace riffle
