// Elevation of the surface: wave probes and the scan line.

#include <algorithm>
#include <cmath>

#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

class SurfacePoints final : public Instrument {
  public:
    SurfacePoints(const Probe& probe, const Case& c, const std::vector<double>& x) : Instrument(probe, c) {
        const std::vector<double> y = across(probe, c, x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            places_.push_back({x[i], y[i]});
        }
        const auto& of = fields::elevations;
        add_axis(of.x, x);
        add_axis(of.y, y);
        add_record(of.time, {}, true);
        add_record(of.elevation, {x.size()});
    }

    void sample(const FlowState& state) override {
        record(0).add(state.time);
        for (const double elevation : state.fluid->surface_at(places_)) record(1).add(elevation);
        end_row();
    }
    [[nodiscard]] std::size_t points() const override { return places_.size(); }

  private:
    std::vector<Vec<2>> places_;
};

}  // namespace

std::unique_ptr<Instrument> make_wave_probes(const Probe& probe, const Case& c) {
    return std::make_unique<SurfacePoints>(probe, c, probe.x);
}

std::unique_ptr<Instrument> make_surface_line(const Probe& probe, const Case& c) {
    // Whole intervals over the channel, so that the line of a periodic one is evenly spaced across its ends.
    const double wanted = probe.spacing.value_or(c.numerics.spacing);
    const auto n = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(c.channel.length / wanted)));
    const double spacing = c.channel.length / static_cast<double>(n);
    std::vector<double> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back((static_cast<double>(i) + 0.5) * spacing);
    return std::make_unique<SurfacePoints>(probe, c, x);
}

}  // namespace riffle::inline instruments
