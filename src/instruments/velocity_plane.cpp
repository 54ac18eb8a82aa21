// Velocities at the points of a grid in the x-z plane, sample by sample, as the frames of particle image
// velocimetry give them.

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class VelocityPlane final : public Instrument {
  public:
    VelocityPlane(const Probe& probe, const Case& c, GridAxes axes)
        : Instrument(probe, c), at_(std::move(axes)), y_(across(probe, c, 1).front()) {
        const std::vector<std::size_t> shape = {at_.z.size(), at_.x.size()};
        const auto& of = fields::velocity_plane;
        add_axis(of.x, at_.x);
        add_axis(of.y, {y_});
        add_axis(of.z, at_.z);
        add_record(of.time, {}, true);
        add_record(of.velocity, shape);
        add_record(of.vertical_velocity, shape);
    }

    void sample(const FlowState& state) override {
        const std::size_t width = at_.x.size();
        std::vector<FluidView::Velocity> velocity(points());
        parallel_blocks(velocity.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                velocity[i] = state.fluid->velocity_at({at_.x[i % width], y_, at_.z[i / width]});
            }
        });
        record(0).add(state.time);
        for (const auto& v : velocity) {
            record(1).add(v.u);
            record(2).add(v.w);
        }
        end_row();
    }
    [[nodiscard]] std::size_t points() const override { return at_.x.size() * at_.z.size(); }

  private:
    GridAxes at_;
    double y_;
};

}  // namespace

std::unique_ptr<Instrument> make_velocity_plane(const Probe& probe, const Case& c) {
    return std::make_unique<VelocityPlane>(probe, c, grid_axes(probe, c));
}

}  // namespace riffle::inline instruments
