// Forces between the water and its bed and walls: per unit width, in three dimensions over the whole width.

#include "case/end_buffers.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class BedForce final : public Instrument {
  public:
    BedForce(const Probe& probe, const Case& c)
        : Instrument(probe, c),
          parameters_(c),
          open_(c.channel.ends == Ends::open),
          space_(c.channel.dimensions == 3),
          vegetation_(!c.vegetation.empty()),
          porous_(!c.porous.empty()),
          solids_(c.solids.size()) {
        for (const Field& field : fields_of(fields::forces)) {
            const bool left_out = (field == fields::forces.vegetation_drag && !vegetation_) ||
                                  (field == fields::forces.porous_drag && !porous_);
            if (!left_out) add_record(field, {}, true);
        }
        for (std::size_t k = 0; k < solids_; ++k) {
            for (const Field& field : fields_of(fields::solid_forces)) {
                add_record_of_solid(field, k + 1, c.solids[k].name);
            }
        }
        for (const FreeBody& body : free_bodies(c)) {
            for (const Field& field : fields_of(fields::body_motion)) {
                add_record_of_solid(field, body.solid() + 1, c.solids[body.solid()].name);
            }
            centres_.push_back(body.centre_of_mass());
        }
    }

    void sample(const FlowState& state) override {
        const std::span<const double> mass = state.mass;
        double total = 0.0;
        double drag = 0.0;
        double wall = 0.0;
        double normal = 0.0;
        double sides = 0.0;
        double stems = 0.0;
        double grains = 0.0;
        for (std::size_t i = 0; i < mass.size(); ++i) {
            if (open_ && !in_channel(parameters_, state.x[i])) {
                continue;  // water beyond the ends, which moves as it is told
            }
            total += mass[i];
            drag -= mass[i] * (*state.drag_x)[i];
            wall -= mass[i] * (*state.wall_x)[i];
            normal += mass[i] * (*state.wall_z)[i];  // what pushes the water up presses on the bed
            if (space_) sides -= mass[i] * (*state.side_wall_x)[i];
            if (vegetation_) stems -= mass[i] * (*state.vegetation_x)[i];
            if (porous_) grains -= mass[i] * (*state.porous_x)[i];
        }
        std::vector<double> row = {state.time, drag, wall, normal, total * state.streamwise_gravity};
        if (space_) row.push_back(sides);
        if (vegetation_) row.push_back(stems);
        if (porous_) row.push_back(grains);
        for (std::size_t k = 0; k < solids_; ++k) {
            const ForceOnSolid force = k < state.solids.size() ? state.solids[k] : ForceOnSolid{};
            row.push_back(force.pressure[0] + force.friction[0]);
            row.push_back(force.pressure[0]);
            row.push_back(force.pressure[2] + force.friction[2]);
            if (space_) row.push_back(force.pressure[1] + force.friction[1]);
            for (const std::size_t axis : {1U, 0U, 2U}) {
                if (axis != 1 && !space_) continue;
                row.push_back(force.pressure_moment[axis] + force.friction_moment[axis]);
                row.push_back(force.pressure_moment[axis]);
            }
        }
        for (std::size_t n = 0; n < centres_.size(); ++n) {
            const FreeBodyState body = n < state.free_bodies.size() ? state.free_bodies[n] : FreeBodyState{};
            const auto add_place = [&](std::size_t axis) {
                row.push_back(centres_[n][axis] + body.displacement[axis]);
            };
            add_place(0);
            add_place(2);
            row.push_back(body.velocity[0]);
            row.push_back(body.velocity[2]);
            row.push_back(body.angle[1]);
            row.push_back(body.angular_velocity[1]);
            if (!space_) continue;
            add_place(1);
            row.push_back(body.velocity[1]);
            for (const std::size_t axis : {0U, 2U}) {
                row.push_back(body.angle[axis]);
                row.push_back(body.angular_velocity[axis]);
            }
        }
        for (std::size_t k = 0; k < records().size(); ++k) record(k).add(row[k]);
        end_row();
    }
    [[nodiscard]] bool looks_at_fluid() const override { return false; }
    [[nodiscard]] bool needs_fields() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return 1; }

  private:
    Case parameters_;
    bool open_;   ///< ends
    bool space_;  ///< three dimensions
    bool vegetation_;
    bool porous_;
    std::size_t solids_;
    std::vector<Point3> centres_;  ///< of mass, of the free bodies at t = 0
};

}  // namespace

std::unique_ptr<Instrument> make_bed_force(const Probe& probe, const Case& c) {
    return std::make_unique<BedForce>(probe, c);
}

}  // namespace riffle::inline instruments
