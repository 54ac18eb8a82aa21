#pragma once

#include "components/stirring_modes.hpp"
#include "engine/component.hpp"

namespace riffle::inline components {

/// The stirring body force, less its mean over the particles, so that it adds no momentum along or across the
/// channel even where the particles' spacing correlates with its pattern.
template <int D, class Real>
class StirringForce final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    StirringForce(Flow& flow, const StirringIn<D>& modes) : modes_(modes) { flow.inputs.acceleration = true; }

    void begin_evaluation(Flow& flow, const Stage& /*stage*/) override {
        using Sums = std::array<double, Flow::axes>;  // of the horizontal components, then of the mass
        const std::vector<double>& mass = flow.particles.mass;
        const Sums sums = reduce_blocks(
            flow.particles.size(), std::size_t{1024}, Sums{},
            [&](std::size_t begin, std::size_t end) {
                Sums part{};
                for (std::size_t i = begin; i < end; ++i) {
                    const Vec<D> a = at(flow, i);
                    for (std::size_t k = 0; k < Flow::vertical; ++k) part[k] += mass[i] * a[k];
                    part[Flow::vertical] += mass[i];
                }
                return part;
            },
            [](const Sums& a, const Sums& b) {
                Sums sum{};
                for (std::size_t k = 0; k < Flow::axes; ++k) sum[k] = a[k] + b[k];
                return sum;
            });
        for (std::size_t k = 0; k < Flow::vertical; ++k) mean_[k] = sums[k] / sums[Flow::vertical];
    }
    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const Vec<D> a = at(flow, i);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                task.particles.acceleration[k][lane] += a[k] - mean_[k];
            }
        });
    }

  private:
    [[nodiscard]] Vec<D> at(const Flow& flow, std::size_t particle) const {
        Vec<D> a{};
        modes_.add(vector_of(flow.particles.position, particle), flow.clock.time, a);
        return a;
    }

    StirringIn<D> modes_;
    Vec<D> mean_{};  ///< of the horizontal components over the particles, m/s2
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_stirring(FlowOf<D, Real>& flow, double celerity) {
    const StirringIn<D> modes(flow.c, flow.c.stirring.celerity.value_or(celerity));
    return modes.active() ? std::make_unique<StirringForce<D, Real>>(flow, modes) : nullptr;
}

}  // namespace riffle::inline components
