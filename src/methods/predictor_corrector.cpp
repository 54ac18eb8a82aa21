#include "methods/step_start.hpp"

namespace riffle::inline methods {

namespace {

/// SPHysics, thesis (2.50-2.52): q^(n+1/2) = q^n + dt/2 q'^n, again with the rates at n+1/2, then q^(n+1) = 2
/// q^(n+1/2) - q^n, which is q^n plus a full step at the rates of the middle.
template <int D>
class PredictorCorrector final : public MidpointStepper<D> {
    using MidpointStepper<D>::start_;
    using MidpointStepper<D>::step_;

  public:
    void advance(int evaluation, std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) override {
        const double step = evaluation == 0 ? 0.5 * step_ : step_;
        p.density_deviation[i] = start_.density_deviation[i] + step * rates.density;
        for (std::size_t k = 0; k < D; ++k) {
            // dr/dt = u: the velocity of the same stage moves the particle.
            p.position[k][i] = start_.position[k][i] + step * (p.velocity[k][i] + rates.drift[k]);
            p.velocity[k][i] = start_.velocity[k][i] + step * rates.acceleration[k];
        }
    }
};

}  // namespace

template <int D>
std::unique_ptr<Stepper<D>> make_predictor_corrector() {
    return std::make_unique<PredictorCorrector<D>>();
}

template std::unique_ptr<Stepper<2>> make_predictor_corrector<2>();
template std::unique_ptr<Stepper<3>> make_predictor_corrector<3>();

}  // namespace riffle::inline methods
