// Forces between the water and its bed and walls, per unit width.

#include "instruments/instrument.hpp"

namespace riffle {

namespace {

class BedForce final : public Instrument {
  public:
    explicit BedForce(const Probe& probe) : Instrument(probe) {
        add_record("time", "s", "simulated time", {}, true);
        const auto force = [&](const char* name, const char* long_name) {
            add_record(name, "N/m", long_name, {}, true);
        };
        force("bed_drag", "drag of the water on the bed's roughness, downstream, per unit width");
        force("wall_force", "force of the water on the walls, downstream, per unit width");
        force("wall_normal_force",
              "force of the water on the walls, normal to the bed and downward, per unit "
              "width");
        force("weight_component", "component of the water's weight down the bed, per unit width");
    }

    void sample(const FlowState& state) override {
        const std::vector<double>& mass = state.particles->mass;
        double total = 0.0;
        double drag = 0.0;
        double wall = 0.0;
        double normal = 0.0;
        for (std::size_t i = 0; i < mass.size(); ++i) {
            total += mass[i];
            drag -= mass[i] * state.drag_x[i];
            wall -= mass[i] * state.wall_x[i];
            normal += mass[i] * state.wall_z[i];  // what pushes the water up presses on the bed
        }
        const double row[] = {state.time, drag, wall, normal, total * state.streamwise_gravity};
        for (std::size_t k = 0; k < std::size(row); ++k) {
            record(k).add(row[k]);
        }
        end_row();
    }
    [[nodiscard]] bool looks_at_fluid() const override { return false; }
    [[nodiscard]] bool needs_forces() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return 1; }
};

}  // namespace

std::unique_ptr<Instrument> make_bed_force(const Probe& probe, const Case& /*c*/) {
    return std::make_unique<BedForce>(probe);
}

}  // namespace riffle
