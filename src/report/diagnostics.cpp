#include "report/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_tools.hpp"
#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "report/diagnostic_rows.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline report {

Health mark_of(double size, double bar) {
    if (!std::isfinite(size)) return Health::bad;
    if (size <= bar) return Health::good;
    return size <= 2 * bar ? Health::caution : Health::bad;
}

Health mark_of(double size, double bar, double half_width) {
    const Health mark = mark_of(size, bar);
    return mark == Health::bad && size - half_width <= bar ? Health::caution : mark;
}

std::string percent(double share, int digits) {
    std::string text = fmt::format("{:.{}f} %", 100 * share, digits);
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

std::string signed_percent(double share) { return (share < 0 ? "" : "+") + percent(share, 3); }

const Finding* DiagnosticRows::finding(const std::string& key) const { return find_finding(analysis_, key); }

std::span<const double> DiagnosticRows::in_window(const Field& field) const {
    const auto& time = data_.series[fields::time_series.time];
    const auto& values = data_.series[field];
    if (data_.window_end <= data_.window_start || is_undriven(flow_kind(data_.flow))) return values;
    const auto first = std::lower_bound(time.begin(), time.end(), data_.window_start);
    const auto last = std::upper_bound(first, time.end(), data_.window_end);
    return std::span(values).subspan(static_cast<std::size_t>(first - time.begin()),
                                     static_cast<std::size_t>(last - first));
}

double DiagnosticRows::impact_compression() const {
    const auto sound = value(fields::summary.sound_speed);
    if (!sound || *sound <= 0.0 || !data_.series.has(fields::time_series.maximum_velocity)) return 0.0;
    const auto& speeds = data_.series[fields::time_series.maximum_velocity];
    const double fastest = speeds.empty() ? 0.0 : *std::max_element(speeds.begin(), speeds.end());
    return fastest / *sound;
}

void DiagnosticRows::density() {
    if (!data_.series.has(fields::time_series.density_deviation_minimum) ||
        !data_.series.has(fields::time_series.density_deviation_maximum)) {
        return;
    }
    const auto low = in_window(fields::time_series.density_deviation_minimum);
    const auto high = in_window(fields::time_series.density_deviation_maximum);
    if (low.empty() || high.empty()) return;
    const double least = *std::min_element(low.begin(), low.end());
    const double most = *std::max_element(high.begin(), high.end());
    // Water that strikes a wall or itself is compressed for a moment by more than its own weight does.
    const bool impacts =
        flow_kind(data_.flow) == FlowKind::tank || data_.flow.numerics.impact_dissipation > 0.0;
    const double bar = impacts ? std::max(0.03, impact_compression()) : 0.015;
    add({"density_range", "Range of the density", signed_percent(least) + " to " + signed_percent(most),
         "within ± " + percent(bar, 1),
         impacts
             ? "The water is treated as slightly compressible: its own weight alone may compress it by "
               "up to 1 % at the bed, and for a moment an impact of water of speed u by u over the speed "
               "of sound (water hammer), u the fastest of the run. Beyond that, and beyond 3 %, the speed of "
               "sound of the case is too low."
             : "The water is treated as slightly compressible: its own weight alone may compress it by "
               "up to 1 % at the bed. More tells of pressure noise.",
         mark_of(std::max(std::abs(least), std::abs(most)), bar)});
}

void DiagnosticRows::order() {
    if (!data_.series.has(fields::time_series.particle_order)) return;
    const auto values = in_window(fields::time_series.particle_order);
    if (values.empty()) return;
    add({"particle_order", "Order of the particles",
         fmt::format("{:.2f} (mean over the window)", mean_with_confidence(values).mean),
         "1: perfect layers, 0: none",
         "A flow without resolved turbulence lets the particles slide in layers. Loss of order is not "
         "wrong in itself; it tells how hard the test of the pressure form is.",
         Health::none});
}

void DiagnosticRows::fluctuation() {
    if (!data_.series.has(fields::time_series.velocity_fluctuation)) return;
    const auto values = in_window(fields::time_series.velocity_fluctuation);
    const auto friction = value(fields::summary.friction_velocity);
    if (values.empty()) return;
    const double mean = mean_with_confidence(values).mean;
    std::string text = fmt::format("{:.2g} mm/s", 1000 * mean);
    if (friction && *friction > 0) {
        text += fmt::format(" ({:.2g} % of the friction velocity)", 100 * mean / *friction);
    }
    const bool resolved = resolves_eddies(data_.flow);
    add({"velocity_fluctuation", "Velocity fluctuation of the particles", text,
         data_.flow.stirring.acceleration > 0 ? "set by the stirring force"
         : resolved                           ? "eddies and noise"
                                              : "small where the closure carries the turbulence",
         resolved ? "Rms departure from the mean of the layer: of the eddies, those larger than some "
                    "spacings, and the noise of particles that pass each other in the shear."
                  : "Rms departure from the mean of the layer. The closure stands for the turbulence, so the "
                    "particles themselves need not fluctuate as the water in a flume does.",
         Health::none});
}

void DiagnosticRows::particles_lost() {
    const auto lost = value(fields::summary.lost_particles);
    const auto share = value(fields::summary.lost_share);
    if (!lost || !share) return;
    constexpr double bar = 1e-3;
    add({"lost_water", "Water that left the domain",
         *lost > 0 ? fmt::format("{:.0f} particles, {} of the water", *lost, percent(*share, 3)) : "none",
         "none, or at most 0.1 % of the water",
         "Particles that fly over a wall or out of the simulated space are taken out of the run.",
         mark_of(*share, bar)});
}

std::vector<Diagnostic> diagnose(const ReportData& data, const Analysis& analysis) {
    return is_channel(flow_kind(data.flow)) ? diagnose_channel(data, analysis)
                                            : diagnose_course(data, analysis);
}

}  // namespace riffle::inline report
