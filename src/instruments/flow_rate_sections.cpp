// Discharge, depth, momentum and energy at sections: per unit width, in three dimensions of the whole width.

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class FlowRateSections final : public Instrument {
  public:
    FlowRateSections(const Probe& probe, const Case& c)
        : Instrument(probe, c), balance_(c.channel.ends == Ends::open) {
        const std::size_t n = probe.x.size();
        add_axis(fields::flow_rate.x, probe.x);
        add_record(fields::flow_rate.time, {}, true);
        add_record(fields::flow_rate.flow_rate, {n});
        add_record(fields::flow_rate.depth, {n});
        if (balance_) {
            add_record(fields::flow_rate.momentum_flux, {n});
            add_record(fields::flow_rate.pressure_force, {n});
            add_record(fields::flow_rate.energy_flux, {n});
        }
    }

    void sample(const FlowState& state) override {
        std::vector<FluidView::Section> sections(probe().x.size());
        parallel_blocks(sections.size(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                sections[i] = state.fluid->section_at(probe().x[i], balance_ ? state.pressure : nullptr);
            }
        });
        record(0).add(state.time);
        for (const auto& section : sections) {
            record(1).add(section.flow_rate);
            record(2).add(section.depth);
            if (balance_) {
                record(3).add(section.momentum_flux);
                record(4).add(section.pressure_force);
                record(5).add(section.energy_flux);
            }
        }
        end_row();
    }
    [[nodiscard]] bool needs_fields() const override { return balance_; }
    [[nodiscard]] std::size_t points() const override { return probe().x.size(); }

  private:
    bool balance_;  ///< the ends are open: what passes a section enters a balance
};

}  // namespace

std::unique_ptr<Instrument> make_flow_rate_sections(const Probe& probe, const Case& c) {
    return std::make_unique<FlowRateSections>(probe, c);
}

}  // namespace riffle::inline instruments
