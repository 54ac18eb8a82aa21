#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "methods/method.hpp"
#include "methods/stepper.hpp"

namespace riffle::inline methods {

/// The methods that take the rates of density, velocity and position together (Stepper). The drags are
/// explicit.
template <int D, class Real>
class SteppingByRates final : public Method<D, Real> {
  public:
    using typename Method<D, Real>::Flow;
    using typename Method<D, Real>::Task;

    SteppingByRates(std::unique_ptr<Stepper<D>> stepper, Flow& flow)
        : stepper_(std::move(stepper)), stages_(static_cast<std::size_t>(stepper_->evaluations())) {
        stepper_->declare(flow.particles);
    }

    [[nodiscard]] int evaluations() const override { return stepper_->evaluations(); }
    [[nodiscard]] bool sums_motion() const override { return false; }

    std::span<const Stage> begin(Flow& flow, double dt) override {
        stepper_->begin(flow.particles, {.now = dt,
                                         .before = flow.clock.time_step,
                                         .steps = flow.clock.steps,
                                         .restart = flow.density_filtered});
        const int evaluations = stepper_->evaluations();
        for (int n = 0; n < evaluations; ++n) {
            stages_[static_cast<std::size_t>(n)] = {.wall = dt / evaluations,
                                                    .motion = dt,
                                                    .time = stepper_->evaluation_time(n) * dt,
                                                    .number = n};
        }
        density_rate_.resize(flow.particles.size());
        return stages_;
    }

    void keep_rates(Flow& flow, const Task& task, std::size_t begin, std::size_t end) override {
        flow.for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t lane) {
            std::copy_n(&task.particles.density_rate[lane], last - first, &density_rate_[first]);
        });
    }

    AdvanceResult<D> move(Flow& flow, Task& task, const Stage& stage, std::size_t begin,
                          std::size_t end) override {
        const auto block_first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        Particles<D>& particles = flow.particles;
        AdvanceResult<D> result;
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const bool dragged =
                flow.inputs.drag && (task.particles.drag_clusters >> lane / cluster_size & 1U) != 0;
            const double factor = flow.force_factor(i);
            double squared = 0.0;
            Vec<D> drags{};
            add_drags(flow, task, lane, i, dragged ? task.particles.drag[i - block_first] : 0.0, drags);
            ParticleRates<D> rates{.density = density_rate_[i]};
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                double a = factor * (static_cast<double>(task.sums.force.tensor[k][lane]) +
                                     static_cast<double>(task.sums.force.viscous[k][lane])) +
                           flow.particle_data.gravity[k];
                a += flow.inputs.acceleration ? task.particles.acceleration[k][lane] : 0.0;
                squared += a * a;
                rates.acceleration[k] = a + drags[k];
                rates.drift[k] = flow.inputs.transport ? task.particles.transport[k][lane] : 0.0;
            }
            result.largest = std::max(result.largest, squared);
            stepper_->advance(stage.number, i, rates, particles);
            result.fault = result.fault || !std::isfinite(particles.density_deviation[i]);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                double& x = particles.position[k][i];
                if (flow.domain.periodic[k]) {
                    x += x < flow.domain.lower[k] ? flow.domain.extent(static_cast<int>(k)) : 0.0;
                    x -= x >= flow.domain.upper[k] ? flow.domain.extent(static_cast<int>(k)) : 0.0;
                }
                result.fault = result.fault || !std::isfinite(particles.velocity[k][i]);
            }
            result.fault = result.fault || !flow.stays(i);
        });
        return result;
    }

    [[nodiscard]] std::size_t bytes() const override { return density_rate_.capacity() * sizeof(double); }

  private:
    /// Explicit drags on a particle, added to `a`; `bed` is the coefficient of the bed's.
    static void add_drags(const Flow& flow, Task& task, std::size_t lane, std::size_t particle, double bed,
                          Vec<D>& a) {
        const auto drag = [&](double beta, std::size_t k) {
            const double u = flow.particles.velocity[k][particle];
            const double acceleration = -beta * u * std::abs(u);
            a[k] += acceleration;
            return acceleration;
        };
        task.particles.drag_force[lane] = drag(bed, 0);
        if constexpr (D == 3) {
            task.particles.drag_force_across[lane] = drag(bed, 1);
            const double y = flow.particles.position[1][particle];
            const double side = flow.particle_data.in_side_layer(flow.particles.position[0][particle], y)
                                    ? flow.inputs.side_drag
                                    : 0.0;
            task.particles.side_force[lane] = drag(side, 0);
            task.particles.side_force_vertical[lane] = drag(side, 2);
        }
    }

    std::unique_ptr<Stepper<D>> stepper_;
    std::vector<Stage> stages_;
    std::vector<double> density_rate_;  ///< ds/dt by particle
};

}  // namespace riffle::inline methods
