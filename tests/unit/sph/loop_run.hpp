#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pair_sample.hpp"
#include "particles/clusters.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

/// Constants of the loops.
struct RunOptions {
    double diffusion = 0.0;
    double hydrostatic_gradient = 0.0;
    double ago = 0.0;       ///< of the continuity sum midway, s
    bool correct = true;    ///< pressure and velocity gradient
    bool gradients = true;  ///< as in LoopOptions: without them the stress is the pressure alone
    DirectionalViscosity<double> directional = {};
    KernelKind kernel = KernelKind::wendland_c2;  ///< kernel and viscosity as in LoopOptions
    ViscosityForm viscosity = ViscosityForm::morris;
    double impact = 0.0;  ///< as in PairForm
    double impact_bound = 0.0;
    double non_conservative = 0.0;
    double tensile = 0.0;
    bool by_direction = false;
};

/// Everything that the loops need, made of a sample, and their results by slot.
template <int D, class Real>
struct LoopRun {
    using Values = std::vector<Real>;
    using Vectors = std::array<Values, static_cast<std::size_t>(D)>;
    using Matrices = std::array<Values, static_cast<std::size_t>(D* D)>;
    using SymmetricMatrices = std::array<Values, static_cast<std::size_t>(D*(D + 1) / 2)>;

    Clusters<D> clusters;
    Clusters<D> wall_clusters;
    NeighbourList fluid_fluid;
    NeighbourList fluid_wall;
    NeighbourList wall_fluid;
    PairData<D, Real> data;
    struct {
        Values density_rate, midway_density_rate, diffusion, viscosity_factor, regularity;
        Matrices velocity_gradient, correction;
    } gradient;
    struct {
        Vectors tensor, viscous, wall;
    } force;
    struct {
        Values weight, pressure, density_rate;
        Vectors offset, velocity;
    } wall;
    struct {
        Values zeroth, mass;
        Vectors first, mass_first, velocity;
        SymmetricMatrices second;
    } filter;

    LoopRun(const PairSample<D>& sample, const RunOptions& options);
    LoopRun(const LoopRun&) = delete;
    LoopRun& operator=(const LoopRun&) = delete;
    LoopRun(LoopRun&&) = delete;
    LoopRun& operator=(LoopRun&&) = delete;
    ~LoopRun() = default;

    void run(const PairLoops<D, Real>& loops);
    std::vector<std::size_t> fluid_slot;  ///< of each fluid particle of the sample
    std::vector<std::size_t> wall_slot;   ///< of each wall particle of the sample

  private:
    void pack_fluid(const PairSample<D>& sample);
    void pack_walls(const PairSample<D>& sample);
    bool gradients_;
};

}  // namespace riffle
