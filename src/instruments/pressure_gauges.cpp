// Pressure at points of walls or in the water, as pressure transducers give it.

#include <algorithm>

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"

namespace riffle {

namespace {

class PressureGauges final : public Instrument {
  public:
    PressureGauges(const Probe& probe, const Case& c)
        : Instrument(probe),
          weight_(c.channel.top == Top::free_surface ? c.fluid.density * c.normal_gravity() : 0.0) {
        const std::size_t n = std::max(probe.x.size(), probe.z.size());
        const std::vector<double> y = across(probe, c, n);
        std::vector<double> x;
        std::vector<double> z;
        for (std::size_t i = 0; i < n; ++i) {
            x.push_back(of_point(probe.x, i));
            z.push_back(of_point(probe.z, i));
            points_.push_back({x[i], y[i], z[i]});
        }
        add_axis("x", "distance along the channel", x);
        if (c.channel.dimensions == 3) {
            add_axis("y", "distance across the channel", y);
        }
        add_axis("z", "height above the bed level", z);
        add_record("time", "s", "simulated time", {}, true);
        add_record("pressure", "Pa", "pressure over that of the air; 0 at a dry point", {n});
        add_record("wet_share", "1", "share of the kernel's support that is water", {n});
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Pressure> pressure(points_.size());
        parallel_blocks(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                pressure[i] = state.fluid->pressure_at(points_[i], *state.pressure, weight_);
            }
        });
        record(0).add(state.time);
        for (const FluidView::Pressure& at : pressure) {
            record(1).add(at.pressure);
            record(2).add(at.wet_share);
        }
        end_row();
    }
    [[nodiscard]] bool needs_fields() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return points_.size(); }

  private:
    double weight_;  ///< rho g cos(theta), Pa/m
    std::vector<Vec<3>> points_;
};

}  // namespace

std::unique_ptr<Instrument> make_pressure_gauges(const Probe& probe, const Case& c) {
    return std::make_unique<PressureGauges>(probe, c);
}

}  // namespace riffle
