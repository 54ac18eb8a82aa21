// Pressure at points of walls or in the water, as pressure transducers give it.

#include <algorithm>

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle {

namespace {

class PressureGauges final : public Instrument {
  public:
    PressureGauges(const Probe& probe, const Case& c)
        : Instrument(probe, c),
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
        const auto& of = fields::pressure_gauges;
        add_axis(of.x, x);
        add_axis(of.y, y);
        add_axis(of.z, z);
        add_record(of.time, {}, true);
        add_record(of.pressure, {n});
        add_record(of.wet_share, {n});
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
