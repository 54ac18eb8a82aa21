// Discharge and depth at sections: per unit width, in three dimensions of the whole width.

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"

namespace riffle {

namespace {

class FlowRateSections final : public Instrument {
  public:
    FlowRateSections(const Probe& probe, bool space) : Instrument(probe) {
        const std::size_t n = probe.x.size();
        add_axis("x", "distance along the channel", probe.x);
        add_record("time", "s", "simulated time", {}, true);
        add_record("flow_rate", space ? "m3/s" : "m2/s",
                   space ? "discharge through the section" : "discharge per unit width through the section",
                   {n});
        add_record("depth", "m", "depth of the water above the bed level", {n});
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Section> sections(probe().x.size());
        parallel_blocks(sections.size(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                sections[i] = state.fluid->section_at(probe().x[i]);
            }
        });
        record(0).add(state.time);
        for (const auto& section : sections) {
            record(1).add(section.flow_rate);
            record(2).add(section.depth);
        }
        end_row();
    }
    [[nodiscard]] std::size_t points() const override { return probe().x.size(); }
};

}  // namespace

std::unique_ptr<Instrument> make_flow_rate_sections(const Probe& probe, const Case& c) {
    return std::make_unique<FlowRateSections>(probe, c.channel.dimensions == 3);
}

}  // namespace riffle
