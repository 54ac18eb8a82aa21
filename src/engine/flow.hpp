#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "ends/open_ends_state.hpp"
#include "engine/particle_fields.hpp"
#include "engine/scheme.hpp"
#include "particles/clusters.hpp"
#include "particles/energy_rates.hpp"
#include "particles/force_on_solid.hpp"
#include "particles/particles.hpp"
#include "roughness/porous_resistance.hpp"
#include "sph/pair_loops.hpp"
#include "sph/particle_loops.hpp"

namespace riffle::inline engine {

/// The sets of particles that passes run over, as PassDeclaration numbers them.
inline constexpr std::size_t fluid_set = 0;
inline constexpr std::size_t wall_set = 1;

/// State that a run needs beside the particles to go on with the same bits.
struct SimulationClock {
    double time = 0.0;
    std::int64_t steps = 0;
    std::int64_t list_builds = 0;
    double time_step = 0.0;                   ///< last step
    double largest_acceleration = 0.0;        ///< of the last evaluation
    double displacement_bound = 0.0;          ///< bound of the relative motion since the last list build, m
    double side_wall_drag_coefficient = 0.0;  ///< beta of the side walls' layers in the next step, 1/m
    double listed_time = 0.0;                 ///< of the last list build, where solids move, s
    std::vector<FreeBodyState> free_bodies;   ///< in the order of the case
    std::vector<FreeBodyState> listed_free_bodies;  ///< at the last list build
    /// Tangential springs of the contacts of free bodies (boundary/body_contact.hpp), m.
    std::vector<Point3> contact_springs;
    OpenEndsState open_ends;
};

/// A simulated flow, whatever the arithmetic of its pairs: its case, the state of water and walls, and what
/// is sampled of them.
template <int D>
struct FlowIn {
    explicit FlowIn(const Case& c_) : c(c_), motion(c_), free(riffle::free_bodies(c_)) {
        clock.free_bodies.resize(free.size());
        clock.listed_free_bodies = clock.free_bodies;
    }

    Case c;
    Scheme scheme;
    SimulationClock clock;
    Particles<D> particles;
    WallParticles<D> walls;
    WallMotion motion;                       ///< of the bodies that walls and solids belong to
    std::vector<FreeBody> free;              ///< those that the water moves
    std::vector<BodyState> bodies;           ///< at the evaluation in progress; empty where no wall moves
    std::vector<BodyState> bodies_after;     ///< at the end of its motion; empty without solids
    bool keep_fields = true;                 ///< in the step in progress
    ParticleFields fields;                   ///< where they are kept
    std::vector<ForceOnSolid> solid_forces;  ///< where they are kept; empty without solids
    EnergyRates energy_rates;                ///< at the same times

    /// Whether the forces on the solids are kept in the step in progress: with the fields, and where a body
    /// moves by them.
    [[nodiscard]] bool keeps_solid_forces() const { return keep_fields || !free.empty(); }
    /// All bodies at the time of the clock.
    [[nodiscard]] std::vector<BodyState> bodies_now() const {
        return motion.at(clock.time, clock.free_bodies);
    }
    /// All bodies where they were when the lists were built.
    [[nodiscard]] std::vector<BodyState> bodies_listed() const {
        return motion.at(clock.listed_time, clock.listed_free_bodies);
    }
};

/// What an evaluation of the rates advances by how much, s.
struct Stage {
    double density = 0.0;
    double wall = 0.0;  ///< density of dynamic walls
    double motion = 0.0;
    double kick = -1.0;   ///< of the velocities, where it is another than that of the motion
    bool midway = false;  ///< the continuity sum is that of PairLoops::gradient_midway
    double time = 0.0;    ///< of the evaluation, after the begin of the step
    int number = 0;       ///< of the evaluation in its step

    /// Step of the velocities, s.
    [[nodiscard]] double velocity_step() const { return kick < 0.0 ? motion : kick; }
};

/// Sums, inputs and buffers of a block of clusters; each thread keeps one from block to block.
template <int D, class Real>
struct BlockTask {
    BlockWork<D, Real> sums;
    ParticleWork<D, Real> particles;
    /// The part of ParticleWork::acceleration that walls push with, m/s2.
    std::array<LaneArray<double>, static_cast<std::size_t>(D)> wall_acceleration;
    /// The part of it, upwards, by which the reference pressure holds the water, m/s2; where there is one.
    LaneArray<double> reference_acceleration;
    /// The part of it that vegetation holds back with, m/s2; where FlowOf::with_vegetation.
    std::array<LaneArray<double>, static_cast<std::size_t>(D)> vegetation_acceleration;
    /// The part of it that the grains of porous zones hold back with, m/s2; where there are such zones.
    std::array<LaneArray<double>, static_cast<std::size_t>(D)> porous_acceleration;
};

/// A flow with the records, lists and loops that its passes work with. Passes, components, wall treatments
/// and methods are handed it; they share nothing else.
template <int D, class Real>
struct FlowOf : FlowIn<D> {
    static constexpr auto axes = static_cast<std::size_t>(D);
    static constexpr std::size_t vertical = axes - 1;
    using Task = BlockTask<D, Real>;

    FlowOf(const Case& c_, const ColumnResult* column, Particles<D> water);

    Domain<D> domain;
    FixedPoint<D> fixed_point;
    double column_width;  ///< of the columns that clusters are cut from: 8 particles then fill a nearly
                          ///< cubic box
    PairLoops<D, Real> loops;
    ParticleLoops<D, Real> particle_loops;
    PairData<D, Real> data;
    ParticleData<D> particle_data;
    Clusters<D> clusters;  ///< of the listed positions
    Clusters<D> wall_clusters;
    NeighbourList fluid_fluid;
    NeighbourList fluid_wall;
    NeighbourList wall_fluid;

    AdvanceOptions inputs;  ///< what the components add to the motion; the steps are those of a stage
    bool with_solid_friction = false;  ///< of the log law: BlockTask::wall_acceleration holds it
    bool with_side_drag = false;       ///< side walls with drag
    bool with_vegetation = false;
    /// Of a case with porous zones: what they are, and what they make of the place of each particle, found
    /// when its records are packed. Empty without zones.
    PorousMedia porous;
    std::vector<PorousMedia::At> porous_at;
    bool motion_summed = true;                    ///< Method::sums_motion()
    bool density_filtered = false;                ///< at the begin of the step in progress
    std::vector<AdvanceResult<D>> block_advance;  ///< by block
    Displacement<D> moved;
    bool moved_known = false;  ///< `moved` is of the present positions

    /// Tell the loops where the arrays of the particles are: after each change of their order or number.
    void refer_to_particles();
    /// Whether a particle stands in the domain, and not beyond an open bound.
    [[nodiscard]] bool stays(std::size_t particle) const;
    /// What makes the acceleration of a particle of its force sums: rho0/rho where pairs weigh by volume.
    [[nodiscard]] double force_factor(std::size_t particle) const {
        return particle_data.corrected ? 1.0 / (1.0 + this->particles.density_deviation[particle]) : 1.0;
    }
    /// Motion records of the moved particles of a block, and their displacements unless null. Within porous
    /// zones they hold the discharge of an area n u in place of the velocity, and the room that the particle
    /// takes up with the grains around it, m/(n rho).
    void pack(Displacement<D>* displacement, std::size_t begin, std::size_t end);
    /// Make the motion records anew, with the displacements.
    void repack();
    /// Of the stress records of a block within porous zones: the same room, and the viscosity of the medium.
    void put_media_in_stress(std::size_t begin, std::size_t end);
    /// The records behind the last particle, which fill up turns of the loops.
    void fill_last_records();

    /// Call f(first particle, end, lane of the first) for the clusters of a block.
    template <class F>
    void for_clusters(std::size_t begin, std::size_t end, const F& f) const {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            f(static_cast<std::size_t>(clusters.begin[cluster]),
              static_cast<std::size_t>(clusters.begin[cluster + 1]), (cluster - begin) * cluster_size);
        }
    }
    /// Call f(particle, its lane) for the particles of a block.
    template <class F>
    void for_particles(std::size_t begin, std::size_t end, const F& f) const {
        for_clusters(begin, end, [&f](std::size_t first, std::size_t last, std::size_t first_lane) {
            for (std::size_t i = first; i < last; ++i) f(i, first_lane + (i - first));
        });
    }
    /// f(task, begin, end) for blocks of clusters, in parallel or, where a thread is `alone` with its strip,
    /// one after the other; each thread keeps its task from call to call.
    template <class F>
    void for_blocks(std::size_t cluster_count, std::span<const std::uint32_t> blocks, const F& f,
                    bool alone) const {
        const auto one = [&](std::size_t i) {
            const std::size_t begin = block_clusters * blocks[i];
            f(this_task(), begin, std::min(begin + block_clusters, cluster_count));
        };
        if (alone) {
            for (std::size_t i = 0; i < blocks.size(); ++i) one(i);
        } else {
            parallel_blocks(blocks.size(), 1, [&](std::size_t i, std::size_t) { one(i); });
        }
    }
    /// The same for all blocks of the water.
    template <class F>
    void for_blocks(const F& f) const {
        parallel_blocks(clusters.size(), block_clusters,
                        [&](std::size_t begin, std::size_t end) { f(this_task(), begin, end); });
    }
    /// f(sums, particle, lane) for each particle, with its moments over the neighbours.
    template <class F>
    void for_moments(const F& f) {
        for_blocks([&](Task& task, std::size_t begin, std::size_t end) {
            loops.filter(data, begin, end, task.sums);
            for_particles(begin, end, [&](std::size_t i, std::size_t lane) { f(task.sums.filter, i, lane); });
        });
    }

  private:
    [[nodiscard]] Task& this_task() const {
        thread_local Task task;
        const std::size_t needed =
            std::max({fluid_fluid.buffer_size(), fluid_wall.buffer_size(), wall_fluid.buffer_size()});
        if (task.sums.slots.size() < needed) task.sums.slots.resize(needed);
        return task;
    }
};

/// Clusters per task of a loop without sums.
inline constexpr std::size_t light_block = 128;

/// Particles per edge of a cluster of 8 in the columns: columns of this many spacings.
[[nodiscard]] constexpr double cluster_column_spacings(int dimensions) {
    return dimensions == 2 ? 2.67 : 2.0;
}

}  // namespace riffle::inline engine
