#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "components/components.hpp"
#include "engine/pass_order.hpp"
#include "methods/method.hpp"
#include "solver/simulation.hpp"
#include "walls/walls.hpp"

namespace riffle::inline solver {

/// The simulation in D dimensions with pair arithmetic in `Real`: a flow, its walls, the components of its
/// model, the method that steps it, and the passes over blocks of clusters that an evaluation is made of.
template <int D, class Real>
class SimulationOf final : public SimulationIn<D> {
  public:
    SimulationOf(const Case& c, const ColumnResult* column, Particles<D> particles);

    void step(double fields_due) override;
    [[nodiscard]] int evaluations_per_step() const override { return method_->evaluations(); }
    [[nodiscard]] Stepping stepping() const override { return flow_.c.numerics.stepping; }
    [[nodiscard]] double mean_listed_neighbours() const override;
    [[nodiscard]] double count_neighbours() const override;
    [[nodiscard]] std::size_t bytes() const override;
    void drop_fields(bool with_viscosity) override { flow_.fields.release(with_viscosity); }
    void measure_profile(bool on) override;
    [[nodiscard]] StepProfile profile() const override;
    void listed_positions(std::size_t axis, std::size_t first, std::span<double> values) const override;
    [[nodiscard]] bool lists_out_of_date() const override { return unlisted_; }
    void restore(Particles<D> particles, const SimulationClock& clock,
                 std::vector<double> wall_deviation) override;

  protected:
    [[nodiscard]] const FlowIn<D>& flow() const override { return flow_; }

  private:
    using Flow = FlowOf<D, Real>;
    using Task = BlockTask<D, Real>;
    static constexpr std::size_t axes = Flow::axes;
    static constexpr std::size_t vertical = Flow::vertical;

    /// A pass and what it does with a block of clusters [begin, end).
    struct Pass {
        PassDeclaration declaration;
        std::function<void(Task&, const Stage&, std::size_t begin, std::size_t end)> run;
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
    void order_passes_anew();
    void allocate();
    [[nodiscard]] bool lists_valid(double fraction);
    /// Most relative displacement that the lists allow, m.
    [[nodiscard]] double displacement_limit() const;
    /// Whether lists_valid() is likely to look at the displacements after this step.
    [[nodiscard]] bool displacements_due() const;
    [[nodiscard]] bool has_loose_particles() const;

    // Particles that leave (simulation_losses.cpp).
    /// Whether all particles of a block have integer positions.
    [[nodiscard]] bool can_be_packed(std::size_t begin, std::size_t end) const;
    /// Error where a particle is no longer finite or beyond all integer positions.
    void check_state() const;
    /// What is wrong with a particle, one of so many.
    [[nodiscard]] std::string fault_text(std::size_t particle, std::size_t faults) const;
    /// Take the particles that stand beyond the domain out of the water and into the ledger.
    void take_out_leaving();

    // Passes (simulation_passes.cpp).
    /// All passes of an evaluation, in their order: the one place where they are declared.
    [[nodiscard]] std::vector<Pass> make_passes();
    /// One evaluation of all rates, the motion that follows from it, and the packing of the moved particles.
    void evaluate(const Stage& stage);
    /// The passes of one wave; `alone`: by this thread, beside others with other strips.
    void evaluate_wave(std::size_t wave, const Stage& stage, bool alone);
    /// Ask for what follows the sums of a block, so that it arrives meanwhile.
    void fetch_for_stress(std::size_t begin, std::size_t end);
    void fetch_for_motion(std::size_t begin, std::size_t end);
    void evaluate_gradients(Task& task, const Stage& stage, std::size_t begin, std::size_t end);
    void evaluate_forces(Task& task, const Stage& stage, std::size_t begin, std::size_t end);
    void pack(std::size_t begin, std::size_t end);
    void gather_motion(double step);
    void keep_stress_fields(const Task& task, std::size_t begin, std::size_t end);
    void keep_force_fields(const Task& task, std::size_t begin, std::size_t end);

    // Stepping (simulation_step.cpp).
    void take_step(double fields_due);
    [[nodiscard]] double choose_step() const;

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

    Flow flow_;
    Walls<D, Real> walls_;
    ComponentList<D, Real> components_;
    std::unique_ptr<Method<D, Real>> method_;
    std::vector<Pass> passes_;
    PassOrder order_;
    bool asks_ahead_ = true;           ///< for memory: the particles do not fit into the second-level cache
    bool finds_displacements_ = true;  ///< with the packing of the evaluation in progress
    double last_motion_ = 0.0;         ///< what the last step added to the bound of the displacements, m
    bool leaving_ = false;             ///< particles stand beyond the domain
    bool unlisted_ = false;            ///< particles have been taken out since the lists were built
    bool loose_ = false;               ///< drops beyond the reach of the water, which no list knows

    bool profiling_ = false;
    StepProfile profile_;
    double clock_seconds_ = 0.0;               ///< of a measurement of nothing, all in all, s
    double clock_seconds_inside_ = 0.0;        ///< what it measures, s
    std::vector<BlockSeconds> block_seconds_;  ///< by block
    std::vector<double> wall_seconds_;         ///< by block of walls
};

}  // namespace riffle::inline solver
