#pragma once

#include <cstdint>
#include <memory>

#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle::inline methods {

/// Rates of change of one particle at an evaluation. SI.
template <int D>
struct ParticleRates {
    double density = 0.0;   ///< ds/dt, 1/s
    Vec<D> acceleration{};  ///< du/dt with the drags, m/s2
    Vec<D> drift{};         ///< velocity of transport less u (XSPH), m/s
};

/// The step that begins.
struct StepSize {
    double now = 0.0;     ///< s
    double before = 0.0;  ///< of the last step, s
    std::int64_t steps = 0;
    bool restart = false;  ///< the density has been filtered: its value of the step before is of no use
};

/// A method of time stepping that takes the rates of density, velocity and position together, each particle
/// for itself. SteppingByRates calls begin(), then for each evaluation finds the rates of all particles in
/// their present state and calls advance() for each of them, in any order and from any thread.
///
/// What a method needs of the step before it adds to the particles as further fields (PreviousStep), which
/// are sorted with them and saved with them.
template <int D>
class Stepper {
  public:
    Stepper() = default;
    Stepper(const Stepper&) = delete;
    Stepper& operator=(const Stepper&) = delete;
    virtual ~Stepper() = default;

    /// Add the fields that it needs to the particles, once before the first step.
    virtual void declare(Particles<D>& /*particles*/) {}
    /// Evaluations of the rates per step.
    [[nodiscard]] virtual int evaluations() const = 0;
    /// Time of an evaluation, counted from 0, within the step, in units of it.
    [[nodiscard]] virtual double evaluation_time(int evaluation) const = 0;
    virtual void begin(Particles<D>& particles, const StepSize& step) = 0;
    /// Positions may be left outside a periodic domain by less than its extent.
    virtual void advance(int evaluation, std::size_t particle, const ParticleRates<D>& rates,
                         Particles<D>& particles) = 0;
};

/// The stepper of a method; none for those whose motion is fused with the passes (fused.hpp).
template <int D>
[[nodiscard]] std::unique_ptr<Stepper<D>> make_stepper(Stepping stepping);

// The methods, one file each; equations and sources in docs/theory.md, section 10.
template <int D>
[[nodiscard]] std::unique_ptr<Stepper<D>> make_predictor_corrector();
template <int D>
[[nodiscard]] std::unique_ptr<Stepper<D>> make_verlet();
template <int D>
[[nodiscard]] std::unique_ptr<Stepper<D>> make_symplectic();
template <int D>
[[nodiscard]] std::unique_ptr<Stepper<D>> make_beeman();

}  // namespace riffle::inline methods
