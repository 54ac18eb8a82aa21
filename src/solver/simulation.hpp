#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "boundary/wall.hpp"
#include "case/case.hpp"
#include "column/column.hpp"
#include "instruments/instrument.hpp"
#include "particles/particles.hpp"
#include "particles/sparse_values.hpp"
#include "particles/working_values.hpp"
#include "solver/scheme.hpp"

namespace riffle {

/// Quantities of the particles at the last evaluation of the forces, for sampling and output. By particle,
/// SI.
struct ParticleFields {
    WorkingValues pressure;                      ///< p, Pa
    WorkingValues eddy_viscosity;                ///< nu_t
    WorkingValues shear;                         ///< du/dz
    WorkingValues regularity;                    ///< smallest eigenvalue of M; in two dimensions only
    std::vector<double> pair_acceleration_x;     ///< of the pressure pairs
    std::vector<double> viscous_acceleration_x;  ///< of viscosity and closure
    SparseValues wall_acceleration_x;            ///< part of both from walls
    SparseValues wall_acceleration_z;            ///< the same, normal to the bed
    SparseValues drag_acceleration_x;            ///< of the bed drag (negative for u > 0)
    std::vector<double> shear_stress;            ///< tau_xz of viscosity and closure, Pa
    // Three dimensions only, else empty.
    SparseValues drag_acceleration_y;       ///< of the bed drag
    SparseValues side_wall_acceleration_x;  ///< of the drag in the side walls' layers
    SparseValues side_wall_acceleration_z;
    std::vector<double> lateral_shear_stress;  ///< tau_xy, Pa

    /// Take n particles, all values zero. `Real`: of the pair arithmetic; `density`: of the water, kg/m3.
    template <class Real>
    void reset(std::size_t n, int dimensions, double density) {
        pressure.reset<Real>(n, density);
        eddy_viscosity.reset<Real>(n);
        shear.reset<Real>(n);
        regularity.reset<Real>(dimensions == 2 ? n : 0);
        pair_acceleration_x.assign(n, 0.0);
        viscous_acceleration_x.assign(n, 0.0);
        shear_stress.assign(n, 0.0);
        lateral_shear_stress.assign(dimensions == 3 ? n : 0, 0.0);
        for (SparseValues ParticleFields::*const force : near_walls(dimensions)) {
            (this->*force).reset(n);
        }
    }
    /// Keep those of these particles alone, in this order, which is that of their numbers.
    void keep(const std::vector<std::int32_t>& particles);
    /// Free all but the eddy viscosity, which snapshots show, or that too.
    void release(bool with_viscosity);
    [[nodiscard]] std::size_t bytes() const;

  private:
    [[nodiscard]] static std::span<SparseValues ParticleFields::*const> near_walls(int dimensions);
};

/// The simulation cannot go on because of one particle.
class ParticleFault : public RunError {
  public:
    /// `particle`: its index in the arrays.
    ParticleFault(std::size_t particle, const std::string& message)
        : RunError(message), particle_(particle) {}
    [[nodiscard]] std::size_t particle() const { return particle_; }

  private:
    std::size_t particle_;
};

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
};

/// Where the time of a step goes, s: summed over the steps since the last reset. The parts inside the sweeps
/// are summed over the threads and divided by their number.
struct StepProfile {
    double lists = 0.0;      ///< sorting, clusters, neighbour lists; and the test whether they still hold
    double gradients = 0.0;  ///< pair sums of the gradient pass
    double forces = 0.0;     ///< pair sums of the force pass
    double walls = 0.0;      ///< extrapolation to the walls
    double particles = 0.0;  ///< density, closure, motion and packing, and the rest of the sweeps
    double total = 0.0;      ///< wall time
};

/// A simulation: the particles of a case and the method that advances them.
template <int D>
class SimulationIn {
  public:
    virtual ~SimulationIn() = default;

    /// One time step. Throws ParticleFault naming particle, place and time when the state is no longer
    /// finite; the step is then not completed. Particles that have left the domain are taken out at its end,
    /// into particles().lost. fields() are brought up to date by steps that end at or after `fields_due`, s.
    virtual void step(double fields_due) = 0;
    void step() { step(0.0); }

    /// Force evaluations per step (1 or 2).
    [[nodiscard]] virtual int evaluations_per_step() const = 0;

    [[nodiscard]] virtual Stepping stepping() const = 0;

    /// Mean number of neighbours in the lists of a cluster, for the benchmark.
    [[nodiscard]] virtual double mean_listed_neighbours() const = 0;

    /// Mean number of particles, fluid and wall, within the kernel's support of a fluid particle (without
    /// itself), counted now.
    [[nodiscard]] virtual double count_neighbours() const = 0;

    /// Bytes that the simulation's arrays hold, those of fields() included.
    [[nodiscard]] virtual std::size_t bytes() const = 0;

    /// Free the arrays of fields() until a step fills them again, but for the eddy viscosity or all.
    void drop_fields(bool with_viscosity = true) { fields_.release(with_viscosity); }

    /// Measure the parts of the steps from now on (a few per cent slower), or stop to.
    virtual void measure_profile(bool on) = 0;
    [[nodiscard]] virtual StepProfile profile() const = 0;

    [[nodiscard]] const Particles<D>& particles() const { return particles_; }
    [[nodiscard]] const ParticleFields& fields() const { return fields_; }
    /// Forces of the water on the solids at the last evaluation of the forces, at the same times as fields();
    /// empty without solids.
    [[nodiscard]] const std::vector<ForceOnSolid>& solid_forces() const { return solid_forces_; }
    [[nodiscard]] const SimulationClock& clock() const { return clock_; }
    [[nodiscard]] const Scheme& scheme() const { return scheme_; }
    [[nodiscard]] const std::vector<double>& wall_density_deviation() const { return wall_deviation_; }
    [[nodiscard]] const WallParticles<D>& walls() const { return walls_; }

    /// Coordinates of the particles from `first` on at the last build of the neighbour lists, m: part of the
    /// state that a checkpoint holds, unless the lists are out of date.
    virtual void listed_positions(std::size_t axis, std::size_t first, std::span<double> values) const = 0;
    [[nodiscard]] virtual bool lists_out_of_date() const = 0;

    /// Put back the particles of a checkpoint, with their listed positions and in their saved order, and its
    /// clock.
    virtual void restore(Particles<D> particles, const SimulationClock& clock,
                         std::vector<double> wall_deviation) = 0;

  protected:
    Particles<D> particles_;
    ParticleFields fields_;
    std::vector<ForceOnSolid> solid_forces_;
    SimulationClock clock_;
    Scheme scheme_;
    WallParticles<D> walls_;
    std::vector<double> wall_deviation_;  ///< by wall particle
};

using Simulation = SimulationIn<2>;

/// Build the simulation of a case from its initial particles. `column` as in make_scheme, also the default
/// celerity of the stirring.
template <int D>
[[nodiscard]] std::unique_ptr<SimulationIn<D>> make_simulation(const Case& c, const ColumnResult* column,
                                                               Particles<D> particles);

}  // namespace riffle
