#pragma once

#include <array>
#include <vector>

#include "engine/component.hpp"

namespace riffle::inline components {

/// XSPH (Monaghan 1989): particles move with a velocity that is smoothed over their neighbours.
template <int D, class Real>
class Xsph final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit Xsph(Flow& flow) { flow.inputs.transport = true; }

    void before_step(Flow& flow) override {
        for (auto& component : velocity_) component.resize(flow.particles.size());
        flow.for_moments([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                velocity_[k][particle] = flow.c.numerics.xsph * static_cast<double>(sums.velocity[k][lane]);
            }
        });
    }
    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            flow.for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t lane) {
                std::fill_n(&task.particles.transport[k][lane], cluster_size, 0.0);
                std::copy_n(&velocity_[k][first], last - first, &task.particles.transport[k][lane]);
            });
        }
    }
    [[nodiscard]] std::size_t bytes() const override {
        return velocity_.size() * velocity_[0].capacity() * sizeof(double);
    }

  private:
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity_;  ///< added, by particle
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_xsph(FlowOf<D, Real>& flow) {
    return flow.c.numerics.xsph != 0.0 ? std::make_unique<Xsph<D, Real>>(flow) : nullptr;
}

}  // namespace riffle::inline components
