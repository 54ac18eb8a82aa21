// Velocity at points and profiles, as an acoustic Doppler velocimeter gives it.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"

namespace riffle {

namespace {

/// One of x, or as many as there are of z: the value of the point.
double of_point(const std::vector<double>& values, std::size_t point) {
    return values.size() == 1 ? values.front() : values[point];
}

class VelocityPoints final : public Instrument {
  public:
    VelocityPoints(const Probe& probe, const Case& c) : Instrument(probe) {
        const std::size_t n = std::max(probe.x.size(), probe.z.size());
        for (std::size_t i = 0; i < n; ++i) {
            x_.push_back(of_point(probe.x, i));
            z_.push_back(of_point(probe.z, i));
        }
        // A measuring volume is the mean of points up to half a spacing of the particles apart.
        parts_ = std::max(1, static_cast<int>(std::ceil(2.0 * probe.sampling_length / c.numerics.spacing)));
        add_axis("x", "distance along the channel", x_);
        add_axis("z", "height above the bed level", z_);
        add_record("time", "s", "simulated time", {}, true);
        add_record("velocity", "m/s", "streamwise velocity", {n});
        add_record("vertical_velocity", "m/s", "vertical velocity", {n});
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Velocity> velocity(x_.size());
        parallel_blocks(x_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                velocity[i] = over_volume(*state.fluid, x_[i], z_[i]);
            }
        });
        record(0).add(state.time);
        for (const auto& v : velocity) {
            record(1).add(v.u);
            record(2).add(v.w);
        }
        end_row();
    }
    [[nodiscard]] std::size_t points() const override { return x_.size(); }

  private:
    /// Mean over the height of the measuring volume; NaN when a part of it is dry, as there is no echo then.
    [[nodiscard]] FluidView::Velocity over_volume(const FluidView& fluid, double x, double z) const {
        FluidView::Velocity sum{0.0, 0.0};
        for (int part = 0; part < parts_; ++part) {
            const double offset = ((part + 0.5) / parts_ - 0.5) * probe().sampling_length;
            const auto v = fluid.velocity_at(x, z + offset);
            sum.u += v.u / parts_;
            sum.w += v.w / parts_;
        }
        return sum;
    }

    std::vector<double> x_;
    std::vector<double> z_;
    int parts_ = 1;
};

}  // namespace

std::unique_ptr<Instrument> make_velocity_points(const Probe& probe, const Case& c) {
    return std::make_unique<VelocityPoints>(probe, c);
}

}  // namespace riffle
