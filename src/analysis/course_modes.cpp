// The first mode of a surface that swings: amplitude in time, period and decay beside linear theory.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/course_parts.hpp"
#include "analysis/figure_tools.hpp"
#include "case/flow_kind.hpp"
#include "statistics/damped_oscillation.hpp"

namespace riffle::inline analysis {

namespace {

/// Amplitude of cos(k x) in a row; not-a-number where a place is dry.
double amplitude_of(const SpaceTime& surface, std::size_t row, double wavenumber) {
    double sum = 0.0;
    for (std::size_t i = 0; i < surface.columns; ++i) {
        sum += surface.at(row, i) * std::cos(wavenumber * surface.x(i));
    }
    return 2.0 * sum / static_cast<double>(surface.columns);
}

}  // namespace

void add_surface_modes(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis) {
    const Case& c = *record.flow();
    const FlowKind kind = flow_kind(c);
    const bool wave = kind == FlowKind::standing_wave;
    const bool full_tank = kind == FlowKind::tank && c.channel.ends == Ends::walls && c.solids.empty() &&
                           c.start.water_x.empty() && c.channel.dimensions == 2;
    if ((!wave && !full_tank) || c.channel.top != Top::free_surface) return;
    const double wavenumber = (wave ? 2.0 : 1.0) * std::numbers::pi / c.channel.length;
    std::vector<double> amplitude;
    for (std::size_t row = 0; row < surface.rows(); ++row) {
        amplitude.push_back(amplitude_of(surface, row, wavenumber));
    }
    const bool dry =
        std::any_of(amplitude.begin(), amplitude.end(), [](double a) { return !std::isfinite(a); });
    const auto [low, high] = std::minmax_element(amplitude.begin(), amplitude.end());
    // A still surface has no mode to speak of.
    constexpr double smallest = 0.02;
    if (dry || *high - *low < smallest * c.numerics.spacing) return;

    const double frequency =
        std::sqrt(c.normal_gravity() * wavenumber * std::tanh(wavenumber * c.total_depth()));
    const double decay = 2.0 * c.fluid.kinematic_viscosity * wavenumber * wavenumber;
    Figure figure = make_figure(
        chapters::course, "mode_history", "First mode of the surface",
        fmt::format("Amplitude of cos({} x / L) in the surface, with the damped oscillation fitted to it.",
                    wave ? "2 pi" : "pi"),
        "Lamb 1932, arts. 228 and 349", make_axis("time t", "s"),
        make_axis("amplitude of the first mode", "m"));
    constexpr std::size_t most = 2000;
    figure.curves.push_back(make_curve("simulated", Origin::simulated, Mark::line,
                                       thinned(surface.times, most), thinned(amplitude, most)));
    const auto curve_of = [&](const char* name, Origin origin, const auto& value) {
        constexpr int steps = 1000;
        Curve curve = make_curve(name, origin, Mark::line, {}, {});
        for (int i = 0; i <= steps; ++i) {
            const double t =
                surface.times.front() + (surface.times.back() - surface.times.front()) * i / steps;
            curve.x.push_back(t);
            curve.y.push_back(value(t));
        }
        figure.curves.push_back(std::move(curve));
    };
    if (wave && c.start.amplitude > 0.0) {
        curve_of("linear theory", Origin::theory, [&](double t) {
            return c.start.amplitude * std::exp(-decay * t) * std::cos(frequency * t);
        });
    }
    if (const auto fit = fit_damped_oscillation(surface.times, amplitude, frequency, decay)) {
        curve_of("fitted", Origin::fit, [&](double t) { return fit->at(t); });
        const double period = 2.0 * std::numbers::pi / fit->frequency.value;
        analysis.findings.push_back(
            against(make_finding(chapters::course, "mode_period", "period of the first mode of the surface",
                                 "s", period, period * fit->frequency.half_width / fit->frequency.value),
                    2.0 * std::numbers::pi / frequency, "linear theory, omega^2 = g k tanh(k H)"));
        analysis.findings.push_back(against(
            make_finding(chapters::course, "mode_decay_rate", "rate at which its amplitude falls", "1/s",
                         fit->decay.value, fit->decay.half_width),
            decay, "small viscosity, 2 nu k^2",
            "of a free surface and a bed without friction; a viscosity that leaves the surface free of "
            "du/dn alone damps half as much, and the scheme adds its own"));
    }
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
