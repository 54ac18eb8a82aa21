#include "methods/step_start.hpp"

namespace riffle::inline methods {

namespace {

/// SPHysics, DualSPHysics (Leimkuhler, Reich & Skeel 1996): positions, density and velocity to the middle of
/// the step with the rates at its start; then the rates of the middle give u^(n+1) = u^n + dt a^(n+1/2), and
/// the mean of old and new velocity moves the particle. The density over the step as rho^(n+1) = rho^n (2 -
/// e)/(2 + e), e = -dt (D rho/Dt)/rho at the middle (Parshikov et al. 2000).
template <int D>
class Symplectic final : public MidpointStepper<D> {
    using MidpointStepper<D>::start_;
    using MidpointStepper<D>::step_;

  public:
    void advance(int evaluation, std::size_t i, const ParticleRates<D>& rates, Particles<D>& p) override {
        double& s = p.density_deviation[i];
        if (evaluation == 0) {
            const double half = 0.5 * step_;
            s = start_.density_deviation[i] + half * rates.density;
            for (std::size_t k = 0; k < D; ++k) {
                p.position[k][i] = start_.position[k][i] + half * (start_.velocity[k][i] + rates.drift[k]);
                p.velocity[k][i] = start_.velocity[k][i] + half * rates.acceleration[k];
            }
            return;
        }
        const double e = -step_ * rates.density / (1.0 + s);
        // As a change of s: no rounding against rho0.
        s = start_.density_deviation[i] - (1.0 + start_.density_deviation[i]) * 2.0 * e / (2.0 + e);
        for (std::size_t k = 0; k < D; ++k) {
            const double u = start_.velocity[k][i] + step_ * rates.acceleration[k];
            p.position[k][i] =
                start_.position[k][i] + step_ * (0.5 * (start_.velocity[k][i] + u) + rates.drift[k]);
            p.velocity[k][i] = u;
        }
    }
};

}  // namespace

template <int D>
std::unique_ptr<Stepper<D>> make_symplectic() {
    return std::make_unique<Symplectic<D>>();
}

template std::unique_ptr<Stepper<2>> make_symplectic<2>();
template std::unique_ptr<Stepper<3>> make_symplectic<3>();

}  // namespace riffle::inline methods
