#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "case/options.hpp"
#include "sph/kernel_table.hpp"
#include "sph/neighbour_list.hpp"
#include "sph/pair_form.hpp"
#include "sph/pair_terms.hpp"

namespace riffle::inline sph {

// The sums over neighbours. Each particle is packed into small records, the loops go over the clusters of the
// i side with all 8 particles in lanes, and the results of a block of clusters leave in arrays by lane.

/// Most clusters that one call of a loop takes: about 10 microseconds of work.
inline constexpr std::size_t block_clusters = 16;
inline constexpr std::size_t block_lanes = block_clusters * static_cast<std::size_t>(cluster_size);

/// Position, velocity and density of a fluid particle at the start of a step.
template <int D, class Real>
struct alignas(16) MotionRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D)> u;
    Real s;
    Real volume;
};
using PlaneMotion = MotionRecord<2, float>;
using SpaceMotion = MotionRecord<3, float>;
static_assert(offsetof(PlaneMotion, u) == 8 && offsetof(SpaceMotion, s) == 24,
              "the words of a record are taken apart in this order (record_lanes.hpp)");

/// Stress of a fluid particle as a tensor: what the force pass needs of it beside its motion.
template <int D, class Real>
struct alignas(16) StressRecord {
    std::array<Real, static_cast<std::size_t>(D* D)> stress;  ///< Q = (p B - tau)/rho0
    Real viscosity_root;                                      ///< of pair_terms.hpp
    Real weight;                                              ///< V_j, or m_j/rho0 in the symmetric form
    Real pressure;                                            ///< p/rho0, for the pairs with walls
};

/// The same where the stress is the pressure alone.
template <class Real>
struct alignas(16) PressureRecord {
    std::array<Real, 1> stress;
    Real viscosity_root;
    Real weight;
    Real pressure;
};

/// How far a wall particle continues the fluid, 0 to 1: its pairs are then corrected like the fluid's. By
/// rows of B, the components of the force, each of which is consistent for itself (docs/theory.md): in three
/// dimensions along the channel first, where what stands along it (a side wall, a bank) must not, or the
/// correction would be a force along it; then across it. In a plane all rows are alike.
template <int D, class Real>
using Continuation = std::array<Real, static_cast<std::size_t>(D - 1)>;

/// What the gradient pass needs of a wall particle.
template <int D, class Real>
struct alignas(16) WallGradientRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D* D)> projector;
    Real volume;
    riffle::Continuation<D, Real> continuation;
};

/// What the force pass needs of a wall particle.
template <int D, class Real>
struct alignas(16) WallForceRecord {
    std::array<std::int32_t, static_cast<std::size_t>(D)> x;
    std::array<Real, static_cast<std::size_t>(D)> u;
    Real pressure;
    Real viscosity_root;
    Real weight;                                 ///< of the pressure
    Real viscous_weight;                         ///< of the friction
    riffle::Continuation<D, Real> continuation;  ///< as in WallGradientRecord
};

/// Velocity of a wall particle through its projector, m/s.
template <int D, class Real>
using WallDrift = std::array<Real, static_cast<std::size_t>(D)>;

/// Constants of the pair sums.
template <int D, class Real>
struct PairConstants {
    std::array<Real, static_cast<std::size_t>(D)> unit;  ///< smoothing lengths per integer unit
    Real h;                                              ///< smoothing length, m
    Real gradient_scale;                                 ///< h^-(D+2)
    Real diffusion;                                      ///< delta h c0; 0: no density diffusion
    Real hydrostatic_gradient;                           ///< g_z/c0^2, 1/m
    /// How long ago a pair was where PairLoops::gradient_midway takes its continuity sum, over h, s/m.
    Real half_way = Real(0);
    bool correct_pressure;  ///< B = M^-1 near full support, else the identity
    bool correct_gradient;
    DirectionalViscosity<Real> directional;  ///< where LoopOptions ask for it
    PairForm<Real> form;                     ///< where LoopOptions need one (needs_pair_form)
    const KernelTable<Real>* table;          ///< of a kernel without loops of its own
};

/// By lane of the block.
template <class Real>
using LaneArray = std::array<Real, block_lanes>;

/// Results of the gradient pass.
template <int D, class Real>
struct GradientResult {
    LaneArray<Real> density_rate;  ///< (D rho/Dt)/rho of the pairs, 1/s
    LaneArray<Real> diffusion;     ///< ds/dt of the density diffusion
    std::array<LaneArray<Real>, static_cast<std::size_t>(D* D)>
        velocity_gradient;                                                   ///< d u_k/d x_l at k D + l
    std::array<LaneArray<Real>, static_cast<std::size_t>(D* D)> correction;  ///< B
    LaneArray<Real> viscosity_factor;  ///< D/tr(M) near full support, else 1
    LaneArray<Real> regularity;        ///< smallest eigenvalue of M: about 1 inside, 1/2 at a free surface
};

/// Results of the force pass: accelerations, m/s2, before the factor of the pressure form.
template <int D, class Real>
struct ForceResult {
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> tensor;   ///< pressure and stress divergence
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> viscous;  ///< two-point viscosity
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> wall;     ///< part of both that comes from walls
};

/// Sums of the wall extrapolation (Adami et al. 2012), and of the continuity of dynamic walls.
template <int D, class Real>
struct WallResult {
    LaneArray<Real> weight;                                             ///< sum W (in units of h^-D)
    LaneArray<Real> pressure;                                           ///< sum p_j W
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> offset;    ///< sum r_wj W, m
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> velocity;  ///< sum u_j W
    LaneArray<Real> density_rate;                                       ///< sum V_j (0 - u_j).grad W, 1/s
};

/// Moments for the density filters and XSPH: sums over j of V_j W (1, r, r r) and m_j/rho0 W (1, r), W in
/// m^-D; velocity differences weighted by V_j W.
template <int D, class Real>
struct FilterResult {
    LaneArray<Real> zeroth;
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> first;
    std::array<LaneArray<Real>, static_cast<std::size_t>(D*(D + 1) / 2)> second;
    LaneArray<Real> mass;
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> mass_first;
    std::array<LaneArray<Real>, static_cast<std::size_t>(D)> velocity;  ///< sum V_j W (u_j - u_i)
};

/// Results and buffers of a thread.
template <int D, class Real>
struct BlockWork {
    GradientResult<D, Real> gradient;
    ForceResult<D, Real> force;
    WallResult<D, Real> wall;
    FilterResult<D, Real> filter;
    std::vector<std::int32_t> slots;  ///< neighbours of one cluster; at least NeighbourList::buffer_size()
    /// Lists that the force pass takes in place of those of PairData; null: those.
    const NeighbourList* fluid_fluid = nullptr;
    const NeighbourList* fluid_wall = nullptr;
    bool uncorrected_gradient = false;  ///< the gradient pass gives the velocity gradient without correction
};

/// Everything the loops read. Fluid records by fluid slot, wall records by wall slot; each array ends with
/// one record more, without weight, that fills turns of the loops up.
template <int D, class Real>
struct PairData {
    PairConstants<D, Real> constants;
    const NeighbourList* fluid_fluid = nullptr;
    const NeighbourList* fluid_wall = nullptr;  ///< i fluid, j wall
    const NeighbourList* wall_fluid = nullptr;  ///< i wall, j fluid
    std::vector<MotionRecord<D, Real>> motion;
    std::vector<StressRecord<D, Real>> stress;   ///< either this
    std::vector<PressureRecord<Real>> pressure;  ///< or this, as the loops of the scheme need
    /// By slot, what the pairs carry of the pressure beside a reference pressure; empty without one.
    std::vector<Real> pair_pressure;
    std::vector<WallGradientRecord<D, Real>> wall_gradient;
    std::vector<WallForceRecord<D, Real>> wall_force;
    /// By wall slot, the part P u_w of a wall's velocity that counts in the continuity equation, m/s; empty
    /// while no wall moves against the water.
    std::vector<WallDrift<D, Real>> wall_drift;
    /// B of the clusters beside walls that continue the fluid, cluster after cluster; empty without such
    /// walls.
    std::array<std::vector<Real>, static_cast<std::size_t>(D* D)> correction;
    /// By fluid cluster, the first lane of its B; -1: no such wall near it. Empty as `correction`.
    std::vector<std::int32_t> correction_lane;

    /// First lane of the B of a cluster, or -1.
    [[nodiscard]] std::int32_t correction_of(std::size_t cluster) const {
        return correction_lane.empty() ? -1 : correction_lane[cluster];
    }
};

/// What the loops are made for.
struct LoopOptions {
    KernelKind kernel = KernelKind::wendland_c2;
    ViscosityForm viscosity = ViscosityForm::morris;
    /// The velocity gradient and the correction matrix are wanted. Without them the gradient pass leaves the
    /// rates of density alone, and the stress is the pressure alone.
    bool gradients = true;
    /// Morris' viscosity with a weight of the pair's direction (three dimensions).
    bool directional = false;
    /// Pressures of the pair beside p_i + p_j: of a Riemann problem, or against clumping.
    bool pair_pressure = false;
};

/// Whether the force takes its terms from PairConstants::form.
[[nodiscard]] constexpr bool needs_pair_form(const LoopOptions& options) {
    return !has_own_loops(options.kernel) || options.viscosity != ViscosityForm::morris ||
           options.pair_pressure;
}

/// The loops, for clusters [begin, end) of the i side, at most block_clusters at a time. One table per
/// kernel, viscosity and instruction set.
template <int D, class Real>
struct PairLoops {
    using Loop = void (*)(PairData<D, Real>&, std::size_t begin, std::size_t end, BlockWork<D, Real>& work);
    Loop gradient;         ///< fluid: continuity, diffusion, velocity gradient, M -> B
    Loop gradient_midway;  ///< the same with the continuity sum of PairConstants::half_way ago
    Loop force;            ///< fluid: pressure and stress divergence, viscosity; of fluid and walls
    Loop wall;             ///< walls: extrapolated pressure and velocity, continuity
    Loop filter;           ///< fluid: moments for density filters and XSPH
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
[[nodiscard]] PairLoops<D, Real> pair_loops(const LoopOptions& options);

/// The same of one instruction set, which must be available.
template <int D, class Real>
[[nodiscard]] PairLoops<D, Real> pair_loops(const LoopOptions& options, InstructionSet set);
/// Whether this program holds the loops of a set, and the processor offers it.
[[nodiscard]] bool instruction_set_available(InstructionSet set);

/// The search for neighbours of the set in use, or of a given one, which the processor must offer.
template <int D>
[[nodiscard]] NeighbourSearchFunction<D> neighbour_search();
template <int D>
[[nodiscard]] NeighbourSearchFunction<D> neighbour_search(InstructionSet set);

}  // namespace riffle::inline sph
