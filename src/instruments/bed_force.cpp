// Forces between the water and its bed and walls: per unit width, in three dimensions over the whole width.

#include "instruments/instrument.hpp"

namespace riffle {

namespace {

class BedForce final : public Instrument {
  public:
    BedForce(const Probe& probe, bool space) : Instrument(probe), space_(space) {
        add_record("time", "s", "simulated time", {}, true);
        const auto force = [&](const char* name, const std::string& long_name) {
            add_record(name, space ? "N" : "N/m", long_name + (space ? "" : ", per unit width"), {}, true);
        };
        force("bed_drag", "drag of the water on the bed's roughness, downstream");
        force("wall_force", "force of the water on the walls, downstream");
        force("wall_normal_force", "force of the water on the walls, normal to the bed and downward");
        force("weight_component", "component of the water's weight down the bed");
        if (space) {
            force("side_wall_drag", "drag of the water on the side walls' layers, downstream");
        }
    }

    void sample(const FlowState& state) override {
        const std::span<const double> mass = state.mass;
        double total = 0.0;
        double drag = 0.0;
        double wall = 0.0;
        double normal = 0.0;
        double sides = 0.0;
        for (std::size_t i = 0; i < mass.size(); ++i) {
            total += mass[i];
            drag -= mass[i] * (*state.drag_x)[i];
            wall -= mass[i] * (*state.wall_x)[i];
            normal += mass[i] * (*state.wall_z)[i];  // what pushes the water up presses on the bed
        }
        for (std::size_t i = 0; space_ && i < mass.size(); ++i) {
            sides -= mass[i] * (*state.side_wall_x)[i];
        }
        const double row[] = {state.time, drag, wall, normal, total * state.streamwise_gravity, sides};
        for (std::size_t k = 0; k < records().size(); ++k) {
            record(k).add(row[k]);
        }
        end_row();
    }
    [[nodiscard]] bool looks_at_fluid() const override { return false; }
    [[nodiscard]] bool needs_forces() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return 1; }

  private:
    bool space_;  ///< three dimensions
};

}  // namespace

std::unique_ptr<Instrument> make_bed_force(const Probe& probe, const Case& c) {
    return std::make_unique<BedForce>(probe, c.channel.dimensions == 3);
}

}  // namespace riffle
