#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "particles/clusters.hpp"
#include "sph/equation_of_state.hpp"
#include "sph/hydrostatic_reference.hpp"
#include "sph/pair_loops.hpp"
#include "sph/strain_measure.hpp"

namespace riffle::inline sph {

// What happens to each particle between the sums: density, stress and packing after the gradient pass, motion
// after the force pass. Compiled per instruction set like the sums, 8 particles in lanes.

/// The state of the particles, by particle, and constants of the scheme. SI.
template <int D>
struct ParticleData {
    std::array<double*, static_cast<std::size_t>(D)> position{};
    std::array<double*, static_cast<std::size_t>(D)> velocity{};
    double* density_deviation = nullptr;
    const double* mass = nullptr;  ///< not read where uniform_mass is set
    double uniform_mass = 0.0;     ///< of every particle, kg (per m in a plane); 0: `mass` holds them

    Domain<D> domain;
    FixedPoint<D> fixed_point;
    Vec<D> stay_from{};  ///< a particle stays within [stay_from, stay_to): the domain without its edge
    Vec<D> stay_to{};
    StateEquation state;
    double density = 0.0;         ///< rho0
    double viscosity = 0.0;       ///< nu0
    double bulk_viscosity = 0.0;  ///< against sound, m2/s
    double sound_rate = 0.0;      ///< c0/h, 1/s: how fast spray loses its pressure
    std::array<double, static_cast<std::size_t>(D)> gravity{};
    HydrostaticReference reference_pressure;
    bool corrected = true;  ///< pressure form: Q = p B with weight V_j, else p/rho^2 with m_j/rho0
    bool closure = false;   ///< an eddy viscosity is wanted
    bool two_point = true;  ///< it acts through the two-point viscosity, else in the tensor
    StrainMeasure strain_measure = StrainMeasure::strain_rate;
    bool shear_only = false;  ///< |S| = |du/dz|, and tau_xz alone
    /// Weights of the eddy stresses in the tensor with one axis across the channel, and with both.
    double shear_weight_across = 1.0;
    double normal_weight_across = 1.0;
    /// Three dimensions: the drag of the side walls acts where y is below or above.
    double layer_below = -std::numeric_limits<double>::infinity();
    double layer_above = std::numeric_limits<double>::infinity();
    /// And x lies in the channel: between open ends what stands beyond them has no walls beside it.
    double layer_from = -std::numeric_limits<double>::infinity();
    double layer_to = std::numeric_limits<double>::infinity();
    const Clusters<D>* clusters = nullptr;

    /// Whether a place, scalars or lanes, lies in the layer of a side wall.
    template <class T>
    [[nodiscard]] RIFFLE_INLINE auto in_side_layer(const T& x, const T& y) const {
        return (y < layer_below || y > layer_above) && x >= layer_from && x < layer_to;
    }
};

/// Arrays of a block, beside the sums: the first two by particle, from the block's first one on, so that they
/// are found for all at once; the others by lane.
template <int D, class Real>
struct ParticleWork {
    LaneArray<double> mixing_length;  ///< in: l_m at the particles, m
    LaneArray<double> drag;           ///< in: beta of the bed drag, 1/m, in the clusters of drag_clusters
    std::uint32_t drag_clusters = 0;  ///< in: bit c: the drag acts in cluster c of the block
    LaneArray<double> density_rate;   ///< out: ds/dt
    LaneArray<Real> pressure;         ///< out: p/rho0
    LaneArray<Real> eddy_viscosity;   ///< out: nu_t
    LaneArray<double> drag_force;     ///< out: acceleration by the drag
    // Three dimensions; out: the same across the channel, and by the drag of the side walls.
    LaneArray<double> drag_force_across;
    LaneArray<double> side_force;
    LaneArray<double> side_force_vertical;
    /// in, where used: further accelerations (stirring) and a velocity added to the transport (XSPH).
    std::array<LaneArray<double>, static_cast<std::size_t>(D)> acceleration;
    std::array<LaneArray<double>, static_cast<std::size_t>(D)> transport;
};

/// Box of the displacements of each cluster's particles since the last build of the lists, in integer units.
template <int D>
struct Displacement {
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> low;
    std::array<std::vector<std::int32_t>, static_cast<std::size_t>(D)> high;

    /// Lanes read whole groups of 8 clusters.
    void resize(std::size_t clusters) {
        for (std::size_t k = 0; k < D; ++k) {
            low[k].assign(clusters + cluster_size, 0);
            high[k].assign(clusters + cluster_size, 0);
        }
    }
};

/// Which of the inputs of advance() are set.
struct AdvanceOptions {
    double step = 0.0;   ///< dt of the positions, s
    double kick = -1.0;  ///< dt of the velocities, s; below zero: the same
    bool drag = false;
    bool acceleration = false;
    bool transport = false;
    double side_drag = 0.0;     ///< beta of the side walls' layers, 1/m
    bool sum_of_drags = false;  ///< the sums of AdvanceResult over the drags are wanted
};

/// Largest |a|^2 before the drag, the range of the velocities that moved the particles, and whether a
/// particle's state is not finite or out of range.
template <int D>
struct AdvanceResult {
    double largest = 0.0;
    Vec<D> slowest{};
    Vec<D> fastest{};
    bool fault = false;
    double bed_drag = 0.0;    ///< sum of m beta u|u| of the bed, N
    double side_layer = 0.0;  ///< sum of m u|u| in the side walls' layers, kg m2/s2
};

/// The loops, for clusters [begin, end), at most block_clusters at a time.
template <int D, class Real>
struct ParticleLoops {
    /// ds/dt from the sums of the gradient pass; s += step ds/dt; pressure, eddy viscosity, stress records.
    void (*stress)(const ParticleData<D>&, PairData<D, Real>&, const BlockWork<D, Real>&,
                   ParticleWork<D, Real>&, double step, std::size_t begin, std::size_t end);
    /// Semi-implicit Euler: velocity and position from the sums of the force pass; the drags implicit: that
    /// of the bed along x and in three dimensions along y, that of the side walls along x and z.
    AdvanceResult<D> (*advance)(const ParticleData<D>&, const BlockWork<D, Real>&, ParticleWork<D, Real>&,
                                const AdvanceOptions&, std::size_t begin, std::size_t end);
    /// Motion records of the moved particles, and their displacements unless null.
    void (*pack)(const ParticleData<D>&, PairData<D, Real>&, Displacement<D>*, std::size_t begin,
                 std::size_t end);
    /// Bit c: whether any particle of cluster begin + c stands at `height` or below.
    std::uint32_t (*standing_below)(const ParticleData<D>&, double height, std::size_t begin,
                                    std::size_t end);
    /// Largest squared relative displacement (m2) of clusters in the lists of [begin, end), and of those with
    /// walls near them against the walls.
    double (*displaced)(const PairData<D, Real>&, const FixedPoint<D>&, const Displacement<D>&,
                        std::size_t begin, std::size_t end);
};

/// The loops of the instruction set in use, or of a given one, which the processor must offer.
template <int D, class Real>
[[nodiscard]] ParticleLoops<D, Real> particle_loops();
template <int D, class Real>
[[nodiscard]] ParticleLoops<D, Real> particle_loops(InstructionSet set);

}  // namespace riffle::inline sph
