#include "methods/step_start.hpp"
#include "methods/stepper.hpp"

namespace riffle::inline methods {

namespace {

/// SPHysics (Beeman 1976): predictor by the rates at n and n-1, corrector with those at the predicted n+1.
///
///     x* = x + dt u + dt^2 (4 a^n - a^(n-1))/6      x = x + dt u + dt^2 (a* + 2 a^n)/6
///     u* = u + dt (3 a^n - a^(n-1))/2               u = u + dt (5 a* + 8 a^n - a^(n-1))/12
///
/// and the density like u, for equal steps; here the same polynomials through steps of any length. The first
/// step has no n-1: its predictor is Euler's, its corrector the trapezoidal rule. The previous step holds
/// the rates of n-1.
template <int D>
class Beeman final : public Stepper<D> {
  public:
    [[nodiscard]] int evaluations() const override { return 2; }
    [[nodiscard]] double evaluation_time(int evaluation) const override {
        return evaluation == 0 ? 0.0 : 1.0;
    }
    void declare(Particles<D>& particles) override {
        previous_.declare(particles, {"previous_motion_", "m/s2", "acceleration of the step before along "},
                          {"previous_density", "1/s", "rate of change of rho/rho0 of the step before"});
    }
    void begin(Particles<D>& particles, const StepSize& step) override {
        start_.save(particles);
        step_ = step.now;
        if (previous_.empty(particles)) {
            for (std::size_t k = 0; k < D; ++k) previous_.motion(particles, k).resize(particles.size());
            previous_.density(particles).resize(particles.size());
            weights_ = {.predict = 0.0, .predict_path = 0.0, .correct_new = 0.5, .correct_before = 0.0};
        } else {
            const double r = step.before / step.now;
            weights_ = {.predict = -0.5 / r,
                        .predict_path = -1.0 / (6.0 * r),
                        .correct_new = (1.0 / 3.0 + 0.5 * r) / (1.0 + r),
                        .correct_before = -1.0 / (6.0 * r * (1.0 + r))};
        }
        for (auto& component : acceleration_) component.resize(particles.size());
        density_rate_.resize(particles.size());
    }
    void advance(int evaluation, std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) override {
        if (evaluation == 0) {
            predict(i, rates, p);
        } else {
            correct(i, rates, p);
        }
    }

  private:
    /// Parts of the rates in the change over a step; what is missing to one is that of the rate at n.
    struct Weights {
        double predict = 0.0;       ///< of n-1 in u*
        double predict_path = 0.0;  ///< of n-1 in x*, whose sum is one half
        double correct_new = 0.0;   ///< of n+1 in u
        double correct_before = 0.0;
    };
    void predict(std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) {
        const auto mean = [&](double now, double before) { return now + weights_.predict * (before - now); };
        density_rate_[i] = rates.density;
        p.density_deviation[i] += step_ * mean(rates.density, previous_.density(p)[i]);
        for (std::size_t k = 0; k < D; ++k) {
            const double a = rates.acceleration[k];
            const double before = previous_.motion(p, k)[i];
            const double path = 0.5 * a + weights_.predict_path * (before - a);
            acceleration_[k][i] = a;
            p.position[k][i] += step_ * (p.velocity[k][i] + rates.drift[k] + step_ * path);
            p.velocity[k][i] += step_ * mean(a, before);
        }
    }
    void correct(std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) {
        const auto mean = [&](double next, double now, double before) {
            return now + weights_.correct_new * (next - now) + weights_.correct_before * (before - now);
        };
        double& before = previous_.density(p)[i];
        p.density_deviation[i] =
            start_.density_deviation[i] + step_ * mean(rates.density, density_rate_[i], before);
        before = density_rate_[i];
        for (std::size_t k = 0; k < D; ++k) {
            const double a = rates.acceleration[k];
            const double now = acceleration_[k][i];
            double& last = previous_.motion(p, k)[i];
            p.position[k][i] = start_.position[k][i] + step_ * (start_.velocity[k][i] + rates.drift[k] +
                                                                step_ * (a + 2.0 * now) / 6.0);
            p.velocity[k][i] = start_.velocity[k][i] + step_ * mean(a, now, last);
            last = now;
        }
    }

    StepStart<D> start_;
    double step_ = 0.0;
    Weights weights_;
    PreviousStep<D> previous_;
    // Rates at n.
    std::array<std::vector<double>, static_cast<std::size_t>(D)> acceleration_;
    std::vector<double> density_rate_;
};

}  // namespace

template <int D>
std::unique_ptr<Stepper<D>> make_beeman() {
    return std::make_unique<Beeman<D>>();
}

template std::unique_ptr<Stepper<2>> make_beeman<2>();
template std::unique_ptr<Stepper<3>> make_beeman<3>();

}  // namespace riffle::inline methods
