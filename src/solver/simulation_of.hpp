#pragma once

#include <functional>

#include "roughness/bed_drag.hpp"
#include "solver/simulation.hpp"
#include "solver/stirring.hpp"
#include "sph/pair_loops.hpp"
#include "turbulence/closure.hpp"

namespace riffle {

/// The simulation with pair arithmetic in `Real`. A step is a few parallel sweeps over the clusters:
/// gradients (then density, pressure, closure and packing of the same clusters), walls, forces (then motion
/// and packing).
template <class Real>
class SimulationOf final : public Simulation {
  public:
    SimulationOf(const Case& c, const ColumnResult* column, Particles<2> particles);

    void step() override;
    [[nodiscard]] int evaluations_per_step() const override;
    [[nodiscard]] double mean_listed_neighbours() const override;
    void restore(Particles<2> particles, const SimulationClock& clock,
                 std::vector<double> wall_deviation) override;

  private:
    // Lists and packing (simulation_lists.cpp).
    void build_lists(bool sort);
    void allocate();
    void repack();
    void pack_gradient(std::size_t particle, std::size_t slot);
    void pack_wall_records();
    void pad_records(std::size_t cluster);
    [[nodiscard]] bool lists_valid(double fraction) const;
    void measure_displacement(std::size_t cluster);

    // Sweeps (simulation_sweeps.cpp).
    void sweep_gradients(double density_step);
    void sweep_walls(double step);
    void wet_wall(std::size_t slot, std::size_t particle, double pressure);
    /// Forces, then `move(first, last)` for the particles of each cluster once their accelerations are known.
    void sweep_forces(const std::function<void(std::size_t, std::size_t)>& move);
    void filter_density();
    void sweep_smoothed_velocity();
    void allocate_filter();
    void evaluate_closure(std::size_t first, std::size_t last, std::size_t slot);
    void pack_force(std::size_t particle, std::size_t slot);
    void measure_stirring();
    void body_forces(std::size_t particle, double& ax, double& az) const;

    // Stepping (simulation_step.cpp).
    void step_semi_implicit_euler(double dt);
    void step_predictor_corrector(double dt);
    [[nodiscard]] double choose_step() const;
    [[nodiscard]] double transport_velocity(std::size_t particle, std::size_t axis) const;
    void wrap_and_pack(std::size_t first, std::size_t last);
    void check_state() const;
    [[nodiscard]] std::pair<std::size_t, std::size_t> particles_of(std::size_t cluster) const;

    Case case_;
    WallLaw wall_law_;
    std::unique_ptr<const Closure> closure_;
    std::unique_ptr<const BedDrag> drag_;
    Stirring2D stirring_;
    double stirring_mean_ = 0.0;  ///< streamwise mean of the stirring over the particles, m/s2
    Domain<2> domain_;
    FixedPoint<2> fixed_point_;
    PairLoops<2, Real> loops_;
    PairData<2, Real> data_;
    double column_width_;  ///< of the columns that clusters are cut from: 8 particles then fill a nearly
                           ///< square box

    Clusters<2> clusters_;
    Clusters<2> wall_clusters_;
    NeighbourList fluid_fluid_;
    NeighbourList fluid_wall_;
    NeighbourList wall_fluid_;
    /// Box of the displacements since the last list build, by cluster.
    std::array<std::vector<double>, 2> displacement_low_;
    std::array<std::vector<double>, 2> displacement_high_;

    std::array<std::vector<double>, 2>
        acceleration_;  ///< pairs and viscosity, with the factor of the pressure form
    std::vector<double> mixing_length_;
    std::vector<double> drag_coefficient_;
    std::vector<double> cluster_largest_;  ///< largest |a|^2 by cluster
    std::vector<double> density_rate_;     ///< ds/dt by particle
    std::vector<std::uint8_t> cluster_fault_;
    Particles<2> saved_;  ///< state at the start of the step (predictor-corrector)
};

}  // namespace riffle
