#include "methods/step_start.hpp"

namespace riffle::inline methods {

namespace {

/// Steps from one Euler step to the next (DualSPHysics: about 40; SPHysics: 50): it ties the two interleaved
/// solutions of the leapfrog together.
constexpr std::int64_t euler_interval = 40;

/// SPHysics (Verlet 1967): u^(n+1) = u^(n-1) + 2 dt a^n, the same for the density, x^(n+1) = x^n + dt u^n +
/// dt^2/2 a^n. With steps that change, 2 dt is the time from n-1 to n+1. The previous step holds u and s of
/// n-1.
template <int D>
class Verlet final : public Stepper<D> {
  public:
    [[nodiscard]] int evaluations() const override { return 1; }
    [[nodiscard]] double evaluation_time(int) const override { return 0.0; }
    void declare(Particles<D>& particles) override {
        previous_.declare(particles, {"previous_motion_", "m/s", "velocity before the last step along "},
                          {"previous_density", "1", "rho/rho0 - 1 before the last step"});
    }
    void begin(Particles<D>& particles, const StepSize& step) override {
        step_ = step.now;
        leap_ = step.now + step.before;
        if (previous_.empty(particles) || step.restart || step.steps % euler_interval == 0) {
            // From n with the step of n: Euler's.
            for (std::size_t k = 0; k < D; ++k) previous_.motion(particles, k) = particles.velocity[k];
            previous_.density(particles) = particles.density_deviation;
            leap_ = step.now;
        }
    }
    void advance(int, std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) override {
        const double s = p.density_deviation[i];
        double& s_before = previous_.density(p)[i];
        p.density_deviation[i] = s_before + leap_ * rates.density;
        s_before = s;
        for (std::size_t k = 0; k < D; ++k) {
            const double u = p.velocity[k][i];
            double& u_before = previous_.motion(p, k)[i];
            p.position[k][i] += step_ * (u + rates.drift[k] + 0.5 * step_ * rates.acceleration[k]);
            p.velocity[k][i] = u_before + leap_ * rates.acceleration[k];
            u_before = u;
        }
    }

  private:
    PreviousStep<D> previous_;
    double step_ = 0.0;
    double leap_ = 0.0;
};

}  // namespace

template <int D>
std::unique_ptr<Stepper<D>> make_verlet() {
    return std::make_unique<Verlet<D>>();
}

template std::unique_ptr<Stepper<2>> make_verlet<2>();
template std::unique_ptr<Stepper<3>> make_verlet<3>();

}  // namespace riffle::inline methods
