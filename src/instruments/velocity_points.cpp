// Velocity at points and profiles, as an acoustic Doppler velocimeter gives it.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"

namespace riffle {

namespace {

class VelocityPoints final : public Instrument {
  public:
    VelocityPoints(const Probe& probe, const Case& c) : Instrument(probe) {
        const std::size_t n = std::max(probe.x.size(), probe.z.size());
        const bool space = c.channel.dimensions == 3;
        const std::vector<double> y = across(probe, c, n);
        std::vector<double> x;
        std::vector<double> z;
        for (std::size_t i = 0; i < n; ++i) {
            x.push_back(of_point(probe.x, i));
            z.push_back(of_point(probe.z, i));
            points_.push_back({x[i], y[i], z[i]});
        }
        // A measuring volume is the mean of points up to half a spacing of the particles apart.
        parts_ = std::max(1, static_cast<int>(std::ceil(2.0 * probe.sampling_length / c.numerics.spacing)));
        add_axis("x", "distance along the channel", x);
        if (space) {
            add_axis("y", "distance across the channel", y);
        }
        add_axis("z", "height above the bed level", z);
        add_record("time", "s", "simulated time", {}, true);
        add_record("velocity", "m/s", "streamwise velocity", {n});
        add_record("vertical_velocity", "m/s", "vertical velocity", {n});
        if (space) {
            add_record("spanwise_velocity", "m/s", "spanwise velocity", {n});
        }
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Velocity> velocity(points_.size());
        parallel_blocks(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                velocity[i] = over_volume(*state.fluid, points_[i]);
            }
        });
        record(0).add(state.time);
        for (const auto& v : velocity) {
            record(1).add(v.u);
            record(2).add(v.w);
            if (records().size() > 3) {
                record(3).add(v.v);
            }
        }
        end_row();
    }
    [[nodiscard]] std::size_t points() const override { return points_.size(); }

  private:
    /// Mean over the height of the measuring volume; NaN when a part of it is dry, as there is no echo then.
    [[nodiscard]] FluidView::Velocity over_volume(const FluidView& fluid, const Vec<3>& point) const {
        FluidView::Velocity sum{0.0, 0.0, 0.0};
        for (int part = 0; part < parts_; ++part) {
            const double offset = ((part + 0.5) / parts_ - 0.5) * probe().sampling_length;
            const auto v = fluid.velocity_at({point[0], point[1], point[2] + offset});
            sum.u += v.u / parts_;
            sum.v += v.v / parts_;
            sum.w += v.w / parts_;
        }
        return sum;
    }

    std::vector<Vec<3>> points_;
    int parts_ = 1;
};

}  // namespace

std::unique_ptr<Instrument> make_velocity_points(const Probe& probe, const Case& c) {
    return std::make_unique<VelocityPoints>(probe, c);
}

}  // namespace riffle
