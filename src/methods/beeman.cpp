#include "methods/step_start.hpp"
#include "methods/stepper.hpp"

namespace riffle {

namespace {

/// SPHysics (Beeman 1976): predictor by the rates at n and n-1, corrector with those at the predicted n+1.
///
///     x* = x + dt u + dt^2 (4 a^n - a^(n-1))/6      x = x + dt u + dt^2 (a* + 2 a^n)/6
///     u* = u + dt (3 a^n - a^(n-1))/2               u = u + dt (5 a* + 8 a^n - a^(n-1))/12
///
/// and the density like u, for equal steps; here the same polynomials through steps of any length. The first
/// step has no n-1: its predictor is Euler's, its corrector the trapezoidal rule. Particles::previous holds
/// the rates of n-1.
template <int D>
class Beeman final : public Stepper<D> {
  public:
    [[nodiscard]] int evaluations() const override { return 2; }
    [[nodiscard]] double evaluation_time(int evaluation) const override {
        return evaluation == 0 ? 0.0 : 1.0;
    }
    void begin(Particles<D>& particles, const StepSize& step) override {
        start_.save(particles);
        step_ = step.now;
        auto& previous = particles.previous;
        if (previous.empty()) {
            previous.resize(particles.size());
            weights_ = {.predict = 0.0, .predict_path = 0.0, .correct_new = 0.5, .correct_before = 0.0};
        } else {
            const double r = step.before / step.now;
            weights_ = {.predict = -0.5 / r,
                        .predict_path = -1.0 / (6.0 * r),
                        .correct_new = (1.0 / 3.0 + 0.5 * r) / (1.0 + r),
                        .correct_before = -1.0 / (6.0 * r * (1.0 + r))};
        }
        now_.resize(particles.size());
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
        now_.density[i] = rates.density;
        p.density_deviation[i] += step_ * mean(rates.density, p.previous.density[i]);
        for (std::size_t k = 0; k < D; ++k) {
            const double a = rates.acceleration[k];
            const double before = p.previous.motion[k][i];
            const double path = 0.5 * a + weights_.predict_path * (before - a);
            now_.motion[k][i] = a;
            p.position[k][i] += step_ * (p.velocity[k][i] + rates.drift[k] + step_ * path);
            p.velocity[k][i] += step_ * mean(a, before);
        }
    }
    void correct(std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) {
        const auto mean = [&](double next, double now, double before) {
            return now + weights_.correct_new * (next - now) + weights_.correct_before * (before - now);
        };
        double& before = p.previous.density[i];
        p.density_deviation[i] =
            start_.density_deviation[i] + step_ * mean(rates.density, now_.density[i], before);
        before = now_.density[i];
        for (std::size_t k = 0; k < D; ++k) {
            const double a = rates.acceleration[k];
            const double now = now_.motion[k][i];
            double& last = p.previous.motion[k][i];
            p.position[k][i] = start_.position[k][i] + step_ * (start_.velocity[k][i] + rates.drift[k] +
                                                                step_ * (a + 2.0 * now) / 6.0);
            p.velocity[k][i] = start_.velocity[k][i] + step_ * mean(a, now, last);
            last = now;
        }
    }

    StepStart<D> start_;
    double step_ = 0.0;
    Weights weights_;
    PreviousStep<D> now_;  ///< rates at n
};

}  // namespace

template <int D>
std::unique_ptr<Stepper<D>> make_beeman() {
    return std::make_unique<Beeman<D>>();
}

template std::unique_ptr<Stepper<2>> make_beeman<2>();
template std::unique_ptr<Stepper<3>> make_beeman<3>();

}  // namespace riffle
