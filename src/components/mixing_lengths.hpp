#pragma once

#include <utility>

#include "engine/component.hpp"
#include "particles/lattice.hpp"
#include "turbulence/closure.hpp"

namespace riffle {

/// Mixing lengths of the closure at the particles.
template <int D, class Real>
class MixingLengths final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit MixingLengths(std::unique_ptr<const Closure> closure) : closure_(std::move(closure)) {}

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto& position = flow.particles.position;
        const auto first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        const auto count = static_cast<std::size_t>(flow.clusters.begin[end]) - first;
        double* const lengths = task.particles.mixing_length.data();
        closure_->mixing_lengths({&position[Flow::vertical][first], count}, {lengths, count});
        if constexpr (D == 3) {
            for (std::size_t i = 0; closure_->varies_across() && i < count; ++i) {
                lengths[i] *= closure_->side_factor(position[1][first + i]);
            }
        }
    }

  private:
    std::unique_ptr<const Closure> closure_;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_mixing_lengths(FlowOf<D, Real>& flow) {
    auto closure = make_particle_closure(flow.c, lattice_of(flow.c).dz);
    return closure ? std::make_unique<MixingLengths<D, Real>>(std::move(closure)) : nullptr;
}

}  // namespace riffle
