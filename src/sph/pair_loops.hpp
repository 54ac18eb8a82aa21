#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "particles/neighbour_list.hpp"

namespace riffle {

// The sums over neighbours. Each particle is packed into one record per pass, the loops go over the clusters
// of the i side with all 8 particles in lanes, and the results leave in arrays by slot.

/// What the gradient pass needs of a fluid particle.
template <int D, class Real>
struct alignas(16) GradientRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D)> u;
    Real s;
    Real volume;
};

/// What the gradient pass needs of a wall particle.
template <int D, class Real>
struct alignas(16) WallGradientRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D* D)> projector;
    Real volume;
    Real continuation;  ///< 1: the wall continues the fluid, its pairs are corrected like the fluid's; else 0
};

/// What the force pass needs of a particle, fluid or wall.
template <int D, class Real>
struct alignas(16) ForceRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D)> u;
    std::array<Real, static_cast<std::size_t>(D* D)> stress;  ///< Q = (p B - tau)/rho0
    Real viscosity_root;                                      ///< sqrt(mu/rho0), mu/rho0 = (1 + s) nu
    Real volume;                                              ///< weight of the viscous term
    Real weight;                                              ///< weight of the tensor term
    Real continuation;                                        ///< walls: as in WallGradientRecord
};

/// Constants of the pair sums.
template <int D, class Real>
struct PairConstants {
    std::array<Real, static_cast<std::size_t>(D)> unit;  ///< m per integer unit
    Real inverse_h;
    Real gradient_scale;        ///< h^-(D+2)
    Real diffusion;             ///< delta h c0; 0: no density diffusion
    Real hydrostatic_gradient;  ///< g_z/c0^2, 1/m
    bool correct_pressure;      ///< B = M^-1 near full support, else the identity
    bool correct_gradient;
};

/// Results of the gradient pass, one array per component by slot.
template <int D, class Real>
struct GradientResult {
    std::vector<Real> density_rate;  ///< (D rho/Dt)/rho of the pairs, 1/s
    std::vector<Real> diffusion;     ///< ds/dt of the density diffusion
    std::array<std::vector<Real>, static_cast<std::size_t>(D* D)>
        velocity_gradient;                                                     ///< d u_k/d x_l at k D + l
    std::array<std::vector<Real>, static_cast<std::size_t>(D* D)> correction;  ///< B
    std::vector<Real> viscosity_factor;  ///< D/tr(M) near full support, else 1
    std::vector<Real> regularity;        ///< smallest eigenvalue of M: about 1 inside, 1/2 at a free surface
};

/// Results of the force pass: accelerations by slot, m/s2, before the factor of the pressure form.
template <int D, class Real>
struct ForceResult {
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> tensor;   ///< pressure and stress divergence
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> viscous;  ///< two-point viscosity
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> wall;  ///< part of both that comes from walls
};

/// Sums of the wall extrapolation (Adami et al. 2012), by wall slot, and of the continuity of dynamic walls.
template <int D, class Real>
struct WallResult {
    std::vector<Real> weight;                                             ///< sum W (in units of h^-D)
    std::vector<Real> pressure;                                           ///< sum p_j W
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> offset;    ///< sum r_wj W, m
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> velocity;  ///< sum u_j W
    std::vector<Real> density_rate;                                       ///< sum V_j (0 - u_j).grad W, 1/s
};

/// Moments for the density filters and XSPH, by slot: sums over j of V_j W (1, r, r r) and m_j/rho0 W (1, r),
/// W in m^-D; velocity differences weighted by V_j W.
template <int D, class Real>
struct FilterResult {
    std::vector<Real> zeroth;
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> first;
    std::array<std::vector<Real>, static_cast<std::size_t>(D*(D + 1) / 2)> second;
    std::vector<Real> mass;
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> mass_first;
    std::array<std::vector<Real>, static_cast<std::size_t>(D)> velocity;  ///< sum V_j W (u_j - u_i)
};

/// Everything the loops read. Fluid records by fluid slot, wall records by wall slot.
template <int D, class Real>
struct PairData {
    PairConstants<D, Real> constants;
    const NeighbourList* fluid_fluid = nullptr;
    const NeighbourList* fluid_wall = nullptr;  ///< i fluid, j wall
    const NeighbourList* wall_fluid = nullptr;  ///< i wall, j fluid
    std::vector<GradientRecord<D, Real>> fluid_gradient;
    std::vector<WallGradientRecord<D, Real>> wall_gradient;
    std::vector<ForceRecord<D, Real>> fluid_force;
    std::vector<ForceRecord<D, Real>> wall_force;
    std::vector<Real> fluid_pressure;  ///< p/rho0 by fluid slot
    GradientResult<D, Real> gradient;
    ForceResult<D, Real> force;
    WallResult<D, Real> wall;
    FilterResult<D, Real> filter;
};

/// The loops, for clusters [begin, end) of the i side. One table per kernel, viscosity and instruction set.
template <int D, class Real>
struct PairLoops {
    using Loop = void (*)(PairData<D, Real>&, std::size_t begin, std::size_t end);
    Loop gradient;  ///< fluid: continuity, diffusion, velocity gradient, M -> B
    Loop force;     ///< fluid: pressure and stress divergence, viscosity; of fluid and walls
    Loop wall;      ///< walls: extrapolated pressure and velocity, continuity
    Loop filter;    ///< fluid: moments for density filters and XSPH
};

/// Instruction sets with their own objects in this binary.
enum class InstructionSet { baseline, avx2, avx512 };

/// Word of an instruction set: "baseline", "avx2", "avx512".
[[nodiscard]] std::string instruction_set_name(InstructionSet set);

/// The set in use: the best the processor offers, or the one that the environment variable
/// RIFFLE_INSTRUCTION_SET names (InputError for an unknown word or a set the processor lacks).
[[nodiscard]] InstructionSet active_instruction_set();

/// The loops for the options of a case.
template <int D, class Real>
[[nodiscard]] PairLoops<D, Real> pair_loops(KernelKind kernel, ViscosityForm viscosity);

}  // namespace riffle
