#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boundary/wall.hpp"
#include "case/case.hpp"
#include "column/column.hpp"
#include "particles/particles.hpp"
#include "solver/scheme.hpp"

namespace riffle {

/// Quantities of the particles at the last evaluation of the forces, for sampling and output. By particle,
/// SI.
struct ParticleFields {
    std::vector<double> pressure;                ///< p, Pa
    std::vector<double> eddy_viscosity;          ///< nu_t
    std::vector<double> shear;                   ///< du/dz
    std::vector<double> regularity;              ///< smallest eigenvalue of M
    std::vector<double> pair_acceleration_x;     ///< of the pressure pairs
    std::vector<double> viscous_acceleration_x;  ///< of viscosity and closure
    std::vector<double> wall_acceleration_x;     ///< part of both from walls
    std::vector<double> drag_acceleration_x;     ///< of the bed drag (negative for u > 0)

    void resize(std::size_t n);
};

/// State that a run needs beside the particles to go on with the same bits.
struct SimulationClock {
    double time = 0.0;
    std::int64_t steps = 0;
    std::int64_t list_builds = 0;
    double time_step = 0.0;             ///< last step
    double largest_acceleration = 0.0;  ///< of the last evaluation
};

/// A 2D simulation: the particles of a case and the method that advances them.
class Simulation {
  public:
    virtual ~Simulation() = default;

    /// One time step. Throws RunError naming particle, place and time when the state is no longer finite or a
    /// particle has left the domain; the step is then not completed.
    virtual void step() = 0;

    /// Force evaluations per step (1, or 2 with the predictor-corrector).
    [[nodiscard]] virtual int evaluations_per_step() const = 0;

    /// Mean number of neighbours of a particle within the kernel's support and in the lists, for the
    /// benchmark.
    [[nodiscard]] virtual double mean_listed_neighbours() const = 0;

    [[nodiscard]] const Particles<2>& particles() const { return particles_; }
    [[nodiscard]] const ParticleFields& fields() const { return fields_; }
    [[nodiscard]] const SimulationClock& clock() const { return clock_; }
    [[nodiscard]] const Scheme& scheme() const { return scheme_; }
    [[nodiscard]] const std::vector<double>& wall_density_deviation() const { return wall_deviation_; }
    [[nodiscard]] const WallParticles<2>& walls() const { return walls_; }

    /// Put back a saved state (particles in their saved order, listed positions included).
    virtual void restore(Particles<2> particles, const SimulationClock& clock,
                         std::vector<double> wall_deviation) = 0;

  protected:
    Particles<2> particles_;
    ParticleFields fields_;
    SimulationClock clock_;
    Scheme scheme_;
    WallParticles<2> walls_;
    std::vector<double> wall_deviation_;  ///< by wall particle
};

/// Build the simulation of a case from its initial particles. `column` as in make_scheme, also the default
/// celerity of the stirring.
[[nodiscard]] std::unique_ptr<Simulation> make_simulation(const Case& c, const ColumnResult* column,
                                                          Particles<2> particles);

}  // namespace riffle
