// Pressure at points of walls or in the water, and over the faces of gauges on walls and solids, as pressure
// transducers give it.

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "base/parallel.hpp"
#include "case/gauge_face.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class PressureGauges final : public Instrument {
  public:
    PressureGauges(const Probe& probe, const Case& c)
        : Instrument(probe, c),
          weight_(c.channel.top == Top::free_surface ? c.fluid.density * c.normal_gravity() : 0.0),
          solid_(solid_named(c, probe.solid)) {
        std::vector<double> x;
        std::vector<double> y;
        std::vector<double> z;
        for (const Point3& point : probe_points(c, probe)) {
            const auto face = gauge_face(c, probe, point);
            if (!face) {  // probe_refusals() says so before
                throw std::invalid_argument("gauge \"" + probe.name + "\" sits on no surface");
            }
            x.push_back(face->middle[0]);
            y.push_back(face->middle[1]);
            z.push_back(face->middle[2]);
            points_.insert(points_.end(), face->points.begin(), face->points.end());
            ends_.push_back(points_.size());
        }
        const std::size_t n = ends_.size();
        const auto& of = fields::pressure_gauges;
        add_axis(of.x, x);
        add_axis(of.y, y);
        add_axis(of.z, z);
        add_record(of.time, {}, true);
        add_record(of.pressure, {n});
        add_record(of.wet_share, {n});
    }

    void sample(const FlowState& state) override {
        const BodyState body = body_of(state);
        std::vector<FluidView::Pressure> pressure(points_.size());
        parallel_blocks(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Vec<3> place = body.placed(points_[i]);
                pressure[i] = solid_ ? state.fluid->pressure_on_solid(place, *state.pressure, weight_)
                                     : state.fluid->pressure_at(place, *state.pressure, weight_);
            }
        });
        record(0).add(state.time);
        std::size_t point = 0;
        for (const std::size_t end : ends_) {
            const auto count = static_cast<double>(end - point);
            FluidView::Pressure mean{0.0, 0.0};
            for (; point < end; ++point) {
                mean.pressure += pressure[point].pressure / count;
                mean.wet_share += pressure[point].wet_share / count;
            }
            record(1).add(mean.pressure);
            record(2).add(mean.wet_share);
        }
        end_row();
    }
    [[nodiscard]] bool needs_fields() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return points_.size(); }

  private:
    /// The solid that the gauges sit on, where it is now.
    [[nodiscard]] BodyState body_of(const FlowState& state) const {
        const std::size_t body = first_solid + solid_.value_or(0);
        return solid_ && body < state.bodies.size() ? state.bodies[body] : BodyState{};
    }

    double weight_;                     ///< rho g cos(theta), Pa/m
    std::optional<std::size_t> solid_;  ///< that the gauges sit on
    std::vector<Vec<3>> points_;        ///< of all faces, at the start
    std::vector<std::size_t> ends_;     ///< of each gauge, behind its last point
};

}  // namespace

std::unique_ptr<Instrument> make_pressure_gauges(const Probe& probe, const Case& c) {
    return std::make_unique<PressureGauges>(probe, c);
}

}  // namespace riffle::inline instruments
