#pragma once

#include <algorithm>
#include <chrono>
#include <span>
#include <type_traits>

#include "base/parallel.hpp"
#include "boundary/mesh_contact.hpp"
#include "boundary/plane_contact.hpp"
#include "boundary/repulsive_wall.hpp"
#include "boundary/solid_contact.hpp"
#include "boundary/wall_motion.hpp"
#include "roughness/bed_drag.hpp"
#include "solver/ghost_nodes.hpp"
#include "solver/simulation.hpp"
#include "solver/stepper.hpp"
#include "solver/stirring.hpp"
#include "solver/sweep_order.hpp"
#include "sph/pair_loops.hpp"
#include "sph/pair_sweep.hpp"
#include "sph/particle_loops.hpp"
#include "turbulence/closure.hpp"

namespace riffle {

/// The simulation in D dimensions with pair arithmetic in `Real`. A step is a few parallel sweeps over blocks
/// of clusters: gradients (then density, pressure and closure of the same particles), walls, forces (then
/// their motion), and the packing of the moved particles.
template <int D, class Real>
class SimulationOf final : public SimulationIn<D> {
  public:
    SimulationOf(const Case& c, const ColumnResult* column, Particles<D> particles);

    void step(double fields_due) override;
    [[nodiscard]] int evaluations_per_step() const override;
    [[nodiscard]] Stepping stepping() const override { return case_.numerics.stepping; }
    [[nodiscard]] double mean_listed_neighbours() const override;
    [[nodiscard]] double count_neighbours() const override;
    [[nodiscard]] std::size_t bytes() const override;
    void measure_profile(bool on) override;
    [[nodiscard]] StepProfile profile() const override;
    void listed_positions(std::size_t axis, std::size_t first, std::span<double> values) const override;
    [[nodiscard]] bool lists_out_of_date() const override { return unlisted_; }
    void restore(Particles<D> particles, const SimulationClock& clock,
                 std::vector<double> wall_deviation) override;

  private:
    using SimulationIn<D>::particles_;
    using SimulationIn<D>::fields_;
    using SimulationIn<D>::solid_forces_;
    using SimulationIn<D>::clock_;
    using SimulationIn<D>::scheme_;
    using SimulationIn<D>::walls_;
    using SimulationIn<D>::wall_deviation_;
    static constexpr auto axes = static_cast<std::size_t>(D);
    static constexpr std::size_t vertical = axes - 1;

    /// Results, inputs and buffers of one task.
    struct Task {
        BlockWork<D, Real> sums;
        BlockWork<D, Real> solid;  ///< the force pass of one solid alone
        ParticleWork<D, Real> particles;
        std::array<LaneArray<double>, static_cast<std::size_t>(D)> repulsion;  ///< of the walls, m/s2
    };
    /// What an evaluation advances by how much, s.
    struct StageSteps {
        double density = 0.0;
        double wall = 0.0;  ///< density of dynamic walls
        double motion = 0.0;
        double kick = -1.0;   ///< of the velocities, where it is another than that of the motion
        bool midway = false;  ///< the continuity sum is that of PairLoops::gradient_midway
    };
    /// Time of the pair sums of a block, s, and how often both were measured.
    struct BlockSeconds {
        double gradients = 0.0;
        double forces = 0.0;
        std::int64_t measurements = 0;
    };

    // Lists and packing (simulation_lists.cpp).
    /// Lists of the particles where they are, sorted, or of their listed positions as they stand.
    void build_lists(bool sort);
    void allocate();
    void refer_to_particles();
    void repack();
    void fill_last_records();
    [[nodiscard]] bool lists_valid(double fraction);
    /// Most relative displacement that the lists allow, m.
    [[nodiscard]] double displacement_limit() const;
    /// Whether lists_valid() is likely to look at the displacements after this step.
    [[nodiscard]] bool displacements_due() const;
    [[nodiscard]] bool has_loose_particles() const;

    // Particles that leave (simulation_losses.cpp).
    [[nodiscard]] bool stays(std::size_t particle) const;
    /// Whether all particles of a block have integer positions.
    [[nodiscard]] bool can_be_packed(std::size_t begin, std::size_t end) const;
    /// Error where a particle is no longer finite or beyond all integer positions.
    void check_state() const;
    /// What is wrong with a particle, one of so many.
    [[nodiscard]] std::string fault_text(std::size_t particle, std::size_t faults) const;
    /// Take the particles that stand beyond the domain out of the water and into the ledger.
    void take_out_leaving();

    // Walls (simulation_walls.cpp).
    void make_walls();
    /// Sort the walls in space and cut them into clusters; the order that they had before.
    std::vector<std::int32_t> sort_walls();
    /// Put the walls where they stand at a time, sort and pack them.
    void place_walls(double time);
    /// Coordinate of a wall particle that is displaced with its body; axis 0: x, 1: z.
    [[nodiscard]] double displaced(double x, const BodyState& body, std::size_t axis) const;
    /// Where the walls stand now, and how they move, into their records.
    void move_walls();
    /// Widen the range of velocities by those of the solids in the step that begins now.
    void add_wall_motion(double step, Vec<D>& slowest, Vec<D>& fastest) const;
    /// Put moved particles of a block that are behind a wall or in a solid back onto its face.
    void keep_out_of_walls(std::size_t begin, std::size_t end, double step);
    /// Error where water stands more than a spacing deep in a solid.
    void check_solids() const;
    // Forces on the solids (simulation_solids.cpp).
    /// Lists of the walls of each solid alone, and room for the sums; once for each build of the lists.
    void list_solids();
    /// The forces of the pairs of a block with each solid, in an evaluation that keeps the fields.
    void sum_solid_forces(Task& task, std::size_t begin, std::size_t end);
    /// The sums over the blocks, in their order.
    void gather_solid_forces();

    /// wet_wall() of all wall particles, by their density deviation.
    void wet_walls();
    void wet_wall(std::size_t slot, std::size_t particle, double pressure);
    /// What a wall particle of a density deviation brings to the pressure sum of its pairs, m2/s2: p/rho0, in
    /// the symmetric form over (1 + s)^2, as water at its place would.
    [[nodiscard]] double pair_pressure(double deviation) const;
    void update_wall(std::size_t slot, std::size_t particle, const WallResult<D, Real>& sums,
                     std::size_t lane, double step);

    // Sweeps (simulation_sweeps.cpp).
    /// One evaluation of all rates, the motion that follows from it, and the packing of the moved particles.
    void evaluate(const StageSteps& steps);
    /// Ask for what follows the sums of a block, so that it arrives meanwhile.
    void fetch_for_stress(std::size_t begin, std::size_t end);
    void fetch_for_motion(std::size_t begin, std::size_t end);
    /// Mixing lengths at the particles of a block.
    void find_mixing_lengths(Task& task, std::size_t begin, std::size_t end) const;
    /// The sweeps of one wave; `alone`: by this thread, beside others with other sections.
    void evaluate_wave(std::size_t wave, const StageSteps& steps, Displacement<D>* moved, bool alone);
    void evaluate_gradients(Task& task, std::size_t begin, std::size_t end, const StageSteps& steps);
    void evaluate_walls(Task& task, std::size_t begin, std::size_t end, double step);
    /// The same from the particles' ghost nodes (ghost_walls.cpp).
    void update_walls_by_ghosts(std::size_t begin, std::size_t end);
    void evaluate_forces(Task& task, std::size_t begin, std::size_t end, const StageSteps& steps);
    void gather_motion(double step);
    /// An evaluation of the stepper: the particles of a block by their rates.
    void advance_by_rates(Task& task, std::size_t begin, std::size_t end);
    void keep_stress_fields(const Task& task, std::size_t begin, std::size_t end);
    void keep_force_fields(const Task& task, std::size_t begin, std::size_t end);

    // Forcing (simulation_forcing.cpp).
    void measure_stirring();
    [[nodiscard]] Vec<D> stirring_at(std::size_t particle) const;
    void add_stirring(Task& task, std::size_t begin, std::size_t end) const;
    /// The push of repulsive walls, added to the accelerations of a block.
    void add_repulsion(Task& task, std::size_t begin, std::size_t end) const;
    /// Whether a block has accelerations beside those of the pairs, gravity and drags.
    [[nodiscard]] bool has_accelerations() const { return stirring_.active() || repulsion_.active(); }
    /// Coefficients of the bed's drag at the particles of a block, and at one.
    void find_drag(Task& task, std::size_t begin, std::size_t end) const;
    [[nodiscard]] double bed_drag_at(std::size_t particle) const;
    /// Explicit drags on a particle (with a stepper), added to `a`; `bed` is the coefficient of the bed's.
    void add_drags(Task& task, std::size_t lane, std::size_t particle, double bed, Vec<D>& a) const;
    /// The coefficient of the side walls' drag from the sums of AdvanceResult, and from the particles.
    void set_side_drag(double bed_drag, double side_layer);
    void measure_side_drag();

    // Filters (simulation_filters.cpp).
    void filter_density();
    void sweep_smoothed_velocity();
    /// f(sums, particle, lane) for each particle.
    template <class F>
    void for_filter_blocks(const F& f);
    /// With dissipation of impacts, each `crowding_interval` steps: raise the density of crowded particles.
    [[nodiscard]] bool dissolves_crowds() const;
    void dissolve_crowds(double dt);

    // Stepping (simulation_step.cpp).
    void take_step(double fields_due);
    void take_step_by_rates(double dt, bool filtered);
    [[nodiscard]] double choose_step() const;

    /// Call f(first particle, end, lane of the first) for the clusters of a block.
    template <class F>
    void for_clusters(std::size_t begin, std::size_t end, const F& f) const {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            f(static_cast<std::size_t>(clusters_.begin[cluster]),
              static_cast<std::size_t>(clusters_.begin[cluster + 1]), (cluster - begin) * cluster_size);
        }
    }
    /// f(task, begin, end) for blocks of clusters, in parallel or, where a thread is `alone` with its
    /// section, one after the other; each thread keeps its task from call to call.
    template <class F>
    void for_blocks(std::size_t clusters, std::span<const std::uint32_t> blocks, const F& f,
                    bool alone) const {
        const auto one = [&](std::size_t i) {
            const std::size_t begin = block_clusters * blocks[i];
            f(this_task(), begin, std::min(begin + block_clusters, clusters));
        };
        if (alone) {
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                one(i);
            }
        } else {
            parallel_blocks(blocks.size(), 1, [&](std::size_t i, std::size_t) { one(i); });
        }
    }
    /// The same for all blocks.
    template <class F>
    void for_blocks(std::size_t clusters, const F& f) const {
        parallel_blocks(clusters, block_clusters,
                        [&](std::size_t begin, std::size_t end) { f(this_task(), begin, end); });
    }
    [[nodiscard]] Task& this_task() const {
        thread_local Task task;
        const std::size_t needed =
            std::max({fluid_fluid_.buffer_size(), fluid_wall_.buffer_size(), wall_fluid_.buffer_size()});
        if (task.sums.slots.size() < needed) {
            task.sums.slots.resize(needed);
        }
        return task;
    }
    /// Run f; while the parts of a step are measured, add its duration to `seconds`.
    template <class F>
    void timed(double& seconds, const F& f) const {
        if (!profiling_) {
            f();
            return;
        }
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        f();
        seconds += std::chrono::duration<double>(Clock::now() - start).count();
    }

    Case case_;
    WallLaw wall_law_;
    WallMotion motion_;
    std::conditional_t<D == 2, SolidContact, MeshContact> contact_;
    PlaneContact<D> planes_;
    std::vector<BodyState> bodies_after_;  ///< at the end of the step; empty without solids
    std::vector<double> contact_depth_;    ///< by block, the largest of the step, m
    std::vector<BodyState> bodies_;        ///< at the begin of the step; empty where no wall moves
    std::unique_ptr<const Closure> closure_;
    std::unique_ptr<const BedDrag> drag_;
    bool side_drag_ = false;      ///< side walls with drag
    double wall_over_bed_ = 0.0;  ///< force on each side wall over that on the bed; 0: a fixed coefficient
    StirringIn<D> stirring_;
    RepulsiveWalls<D> repulsion_;
    Vec<D> stirring_mean_{};  ///< of the horizontal components over the particles, m/s2
    Domain<D> domain_;
    FixedPoint<D> fixed_point_;
    PairLoops<D, Real> loops_;
    ParticleLoops<D, Real> particle_loops_;
    PairData<D, Real> data_;
    ParticleData<D> particle_data_;
    double column_width_;  ///< of the columns that clusters are cut from: 8 particles then fill a nearly
                           ///< cubic box

    Clusters<D> clusters_;  ///< of the listed positions
    Clusters<D> wall_clusters_;
    WallParticles<D> reference_walls_;      ///< at t = 0 in their first order; only where walls change place
    std::vector<std::int32_t> wall_order_;  ///< of walls_: number in reference_walls_
    NeighbourList fluid_fluid_;
    NeighbourList fluid_wall_;
    NeighbourList wall_fluid_;
    std::vector<NeighbourList> solid_lists_;        ///< of fluid_wall_, the pairs with each solid
    NeighbourList no_list_;                         ///< without any neighbour, for as many clusters
    std::int64_t solids_listed_ = -1;               ///< SimulationClock::list_builds of these lists
    std::vector<ForceOnSolid> block_solid_forces_;  ///< by block and solid
    std::vector<std::unique_ptr<PairSweep<D, Real>>> sweeps_;  ///< options beside the pair loops
    std::unique_ptr<GhostNodes<D>> ghosts_;  ///< of walls that look into the water at their mirror images
    SweepOrder order_;
    bool asks_ahead_ = true;  ///< for memory: the particles do not fit into the second-level cache
    Displacement<D> moved_;
    bool moved_known_ = false;  ///< `moved_` is of the present positions
    double last_motion_ = 0.0;  ///< what the last step added to the bound of the displacements, m

    bool keep_fields_ = true;                      ///< in this step
    std::vector<AdvanceResult<D>> block_advance_;  ///< by block
    bool leaving_ = false;                         ///< particles stand beyond the domain
    bool unlisted_ = false;  ///< particles have been taken out since the lists were built
    bool loose_ = false;     ///< drops beyond the reach of the water, which no list knows
    std::array<std::vector<double>, static_cast<std::size_t>(D)> smoothed_velocity_;  ///< XSPH, by particle
    std::unique_ptr<Stepper<D>> stepper_;  ///< none: the semi-implicit Euler method
    int evaluation_ = 0;                   ///< of the stepper, in progress
    std::vector<double> density_rate_;     ///< ds/dt by particle, for the stepper

    bool profiling_ = false;
    StepProfile profile_;
    double clock_seconds_ = 0.0;               ///< of a measurement of nothing, all in all, s
    double clock_seconds_inside_ = 0.0;        ///< what it measures, s
    std::vector<BlockSeconds> block_seconds_;  ///< by block
    std::vector<double> wall_seconds_;         ///< by block of walls
};

/// Particles per edge of a cluster of 8 in the columns: columns of this many spacings.
[[nodiscard]] constexpr double cluster_column_spacings(int dimensions) {
    return dimensions == 2 ? 2.67 : 2.0;
}

}  // namespace riffle
