#pragma once

#include "methods/stepper.hpp"
#include "particles/particles.hpp"

namespace riffle {

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

}  // namespace riffle
