#pragma once

#include <string>
#include "methods/stepper.hpp"

#include "particles/particles.hpp"

namespace riffle::inline methods {

/// State at the start of a step, for the methods that advance from there more than once.
template <int D>
struct StepStart {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity;
    std::vector<double> density_deviation;

    void save(const Particles<D>& particles) {
        position = particles.position;
        velocity = particles.velocity;
        density_deviation = particles.density_deviation;
    }
};

/// What a method keeps of the step before, as further fields of the particles: one for each axis and one for
/// the density.
template <int D>
class PreviousStep {
  public:
    /// `motion`: of the first axis, whose letter ends name and meaning.
    void declare(Particles<D>& particles, const FieldInfo& motion, const FieldInfo& density) {
        for (std::size_t k = 0; k < D; ++k) {
            const std::string axis = axis_names<D>[k];
            motion_[k] = particles.add_field({motion.name + axis, motion.unit, motion.long_name + axis});
        }
        density_ = particles.add_field(density);
    }
    [[nodiscard]] bool empty(const Particles<D>& particles) const { return density(particles).empty(); }
    [[nodiscard]] auto& motion(auto& particles, std::size_t k) const {
        return particles.further[motion_[k]].values;
    }
    [[nodiscard]] auto& density(auto& particles) const { return particles.further[density_].values; }

  private:
    std::array<std::size_t, static_cast<std::size_t>(D)> motion_{};
    std::size_t density_ = 0;
};

/// A method whose second evaluation is at the middle of the step.
template <int D>
class MidpointStepper : public Stepper<D> {
  public:
    [[nodiscard]] int evaluations() const final { return 2; }
    [[nodiscard]] double evaluation_time(int evaluation) const final { return evaluation == 0 ? 0.0 : 0.5; }
    void begin(Particles<D>& particles, const StepSize& step) final {
        start_.save(particles);
        step_ = step.now;
    }

  protected:
    StepStart<D> start_;
    double step_ = 0.0;  ///< s
};

}  // namespace riffle::inline methods
