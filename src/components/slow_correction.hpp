#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/component.hpp"
#include "particles/field.hpp"
#include "sph/correction.hpp"

namespace riffle::inline components {

/// The correction of the pressure form in its mean over a time. What the arrangement of the particles makes
/// of the correction at each moment is no gradient of an energy: it drives the particles, which make another
/// arrangement, for ever (docs/theory.md, section 5). The stress of the mean flow needs the mean alone.
template <int D, class Real>
class SlowCorrection final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit SlowCorrection(Flow& flow) : time_(flow.c.numerics.pressure_correction_time) {
        for (std::size_t k = 0; k < elements; ++k) {
            const std::string axes =
                std::string(axis_names<D>[k / Flow::axes]) + axis_names<D>[k % Flow::axes];
            departure_[k] = flow.particles.add_field(
                {"correction_" + axes, "1",
                 "mean departure of the pressure correction from the identity, " + axes});
        }
    }

    void begin_step(Flow& flow, double dt) override {
        share_ = -std::expm1(-dt / time_);
        for (const std::size_t field : departure_) {
            // A particle that has just come starts without correction.
            flow.particles.further[field].values.resize(flow.particles.size(), 0.0);
        }
    }

    void begin_evaluation(Flow& /*flow*/, const Stage& stage) override { first_ = stage.number == 0; }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        GradientResult<D, Real>& sums = task.sums.gradient;
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            // Where nothing is corrected now, in spray and at its surface, nothing is.
            const auto inside = smoothstep<double>(0.3, 0.6, static_cast<double>(sums.regularity[lane]));
            for (std::size_t k = 0; k < elements; ++k) {
                double& mean = flow.particles.further[departure_[k]].values[i];
                const double identity = k % (Flow::axes + 1) == 0 ? 1.0 : 0.0;
                // The predictor's and the corrector's evaluations are of one step.
                if (first_) {
                    mean += share_ * (static_cast<double>(sums.correction[k][lane]) - identity - mean);
                }
                sums.correction[k][lane] = static_cast<Real>(identity + inside * mean);
            }
        });
    }

  private:
    static constexpr auto elements = static_cast<std::size_t>(D * D);

    double time_;
    double share_ = 0.0;
    bool first_ = true;
    std::array<std::size_t, elements> departure_{};  ///< fields of the particles
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_slow_correction(FlowOf<D, Real>& flow) {
    const Numerics& n = flow.c.numerics;
    return n.pressure_form == PressureForm::corrected && n.pressure_correction_time > 0.0
               ? std::make_unique<SlowCorrection<D, Real>>(flow)
               : nullptr;
}

}  // namespace riffle::inline components
