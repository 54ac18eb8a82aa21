// Velocity at points and profiles, as an acoustic Doppler velocimeter gives it.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "case/gauge_face.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class VelocityPoints final : public Instrument {
  public:
    VelocityPoints(const Probe& probe, const Case& c) : Instrument(probe, c) {
        points_ = probe_points(c, probe);
        const std::size_t n = points_.size();
        std::vector<double> x;
        std::vector<double> y;
        std::vector<double> z;
        for (const Point3& point : points_) {
            x.push_back(point[0]);
            y.push_back(point[1]);
            z.push_back(point[2]);
        }
        // A measuring volume is the mean of points up to half a spacing of the particles apart.
        parts_ = std::max(1, static_cast<int>(std::ceil(2.0 * probe.sampling_length / c.numerics.spacing)));
        const auto& of = fields::velocity_points;
        add_axis(of.x, x);
        add_axis(of.y, y);
        add_axis(of.z, z);
        add_record(of.time, {}, true);
        add_record(of.velocity, {n});
        add_record(of.vertical_velocity, {n});
        add_record(of.spanwise_velocity, {n});
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Velocity> velocity(points_.size());
        parallel_blocks(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) velocity[i] = over_volume(*state.fluid, points_[i]);
        });
        record(0).add(state.time);
        for (const auto& v : velocity) {
            record(1).add(v.u);
            record(2).add(v.w);
            if (records().size() > 3) record(3).add(v.v);
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

}  // namespace riffle::inline instruments
