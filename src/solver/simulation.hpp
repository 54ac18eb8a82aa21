#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "column/column.hpp"
#include "engine/flow.hpp"
#include "engine/particle_fault.hpp"

namespace riffle::inline solver {

/// Where the time of a step goes, s: summed over the steps since the last reset. The parts inside the passes
/// are summed over the threads and divided by their number.
struct StepProfile {
    double lists = 0.0;      ///< sorting, clusters, neighbour lists; and the test whether they still hold
    double gradients = 0.0;  ///< pair sums of the gradient pass
    double forces = 0.0;     ///< pair sums of the force pass
    double walls = 0.0;      ///< extrapolation to the walls
    double particles = 0.0;  ///< density, closure, motion and packing, and the rest of the passes
    double total = 0.0;      ///< wall time
};

/// A simulation: the particles of a case and the method that advances them.
template <int D>
class SimulationIn {
  public:
    SimulationIn(const SimulationIn&) = delete;
    SimulationIn& operator=(const SimulationIn&) = delete;
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
    virtual void drop_fields(bool with_viscosity) = 0;
    void drop_fields() { drop_fields(true); }

    /// Measure the parts of the steps from now on (a few per cent slower), or stop to.
    virtual void measure_profile(bool on) = 0;
    [[nodiscard]] virtual StepProfile profile() const = 0;

    [[nodiscard]] const Particles<D>& particles() const { return flow().particles; }
    [[nodiscard]] const ParticleFields& fields() const { return flow().fields; }
    /// Forces of the water on the solids at the last evaluation of the forces, at the same times as fields();
    /// empty without solids.
    [[nodiscard]] const std::vector<ForceOnSolid>& solid_forces() const { return flow().solid_forces; }
    /// Where the bodies that walls and solids belong to are after the last step; empty without solids.
    [[nodiscard]] const std::vector<BodyState>& bodies() const { return flow().bodies_after; }
    /// What changed the energy of the water in the last step that kept its fields.
    [[nodiscard]] const EnergyRates& energy_rates() const { return flow().energy_rates; }
    [[nodiscard]] const SimulationClock& clock() const { return flow().clock; }
    [[nodiscard]] const Scheme& scheme() const { return flow().scheme; }
    [[nodiscard]] const std::vector<double>& wall_density_deviation() const {
        return walls().density_deviation;
    }
    [[nodiscard]] const WallParticles<D>& walls() const { return flow().walls; }

    /// Coordinates of the particles from `first` on at the last build of the neighbour lists, m: part of the
    /// state that a checkpoint holds, unless the lists are out of date.
    virtual void listed_positions(std::size_t axis, std::size_t first, std::span<double> values) const = 0;
    [[nodiscard]] virtual bool lists_out_of_date() const = 0;

    /// Put back the particles of a checkpoint, with their listed positions and in their saved order, and its
    /// clock.
    virtual void restore(Particles<D> particles, const SimulationClock& clock,
                         std::vector<double> wall_deviation) = 0;

  protected:
    SimulationIn() = default;
    [[nodiscard]] virtual const FlowIn<D>& flow() const = 0;
};

using Simulation = SimulationIn<2>;

/// Build the simulation of a case from its initial particles. `column` as in make_scheme, also the default
/// celerity of the stirring.
template <int D>
[[nodiscard]] std::unique_ptr<SimulationIn<D>> make_simulation(const Case& c, const ColumnResult* column,
                                                               Particles<D> particles);

}  // namespace riffle::inline solver
