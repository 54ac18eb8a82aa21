#pragma once

#include <cmath>

#include "engine/component.hpp"

namespace riffle::inline components {

/// What the grains of porous zones make of the sums of the pairs, whose records hold the discharge of an area
/// q = n u in place of the velocity and m/(n rho) in place of the volume (docs/theory.md, section 21):
///     D rho/Dt = -rho/n div q,
///     Du/Dt = -grad p/rho + g + div(nu grad q)/n - (linear + quadratic |q|) q.
/// The resistance is implicit, of the velocity at the end of the step: exact where it balances the other
/// forces, and stable however strong it is.
template <int D, class Real>
class PorousForces final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit PorousForces(Flow& flow) { flow.inputs.acceleration = true; }

    void begin_evaluation(Flow& /*flow*/, const Stage& stage) override { kick_ = stage.velocity_step(); }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            task.sums.gradient.density_rate[lane] /= static_cast<Real>(flow.porous_at[i].porosity);
        });
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto& velocity = flow.particles.velocity;
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const PorousMedia::At& at = flow.porous_at[i];
            const double factor = flow.force_factor(i);
            double squared = 0.0;
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                task.sums.force.viscous[k][lane] /= static_cast<Real>(at.porosity);
                squared += velocity[k][i] * velocity[k][i];
            }
            const double size = at.porosity * std::sqrt(squared);
            const double along = implicit(at.along(size));
            const double across = implicit(at.across(size)) - along;
            Vec<D> free{};  // the velocity at the end of the step without the resistance
            double normal = 0.0;
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                const auto pairs = static_cast<double>(task.sums.force.tensor[k][lane]) +
                                   static_cast<double>(task.sums.force.viscous[k][lane]);
                const double others =
                    factor * pairs + flow.particle_data.gravity[k] + task.particles.acceleration[k][lane];
                free[k] = velocity[k][i] + kick_ * others;
                normal += at.normal[axis_in_space(k)] * free[k];
            }
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                const double held = -along * free[k] - across * normal * at.normal[axis_in_space(k)];
                task.porous_acceleration[k][lane] = held;
                task.particles.acceleration[k][lane] += held;
            }
        });
    }

  private:
    /// The rate that, of the velocity without it, gives what a rate takes from the velocity with it.
    [[nodiscard]] double implicit(double rate) const { return rate / (1.0 + kick_ * rate); }
    /// Of an axis, its place in (x, y, z).
    static std::size_t axis_in_space(std::size_t k) { return k == Flow::vertical ? 2 : k; }

    double kick_ = 0.0;  ///< s
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_porous_forces(FlowOf<D, Real>& flow) {
    return flow.porous.empty() ? nullptr : std::make_unique<PorousForces<D, Real>>(flow);
}

}  // namespace riffle::inline components
