// Energy and volume of a flow that nothing drives steadily.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/course_parts.hpp"
#include "analysis/figure_tools.hpp"
#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"

namespace riffle::inline analysis {

namespace {

const std::vector<double>* column_of(const FlowRecord& record, const Field& field) {
    const std::vector<double>& values = record.series()[field];
    return values.size() < 2 ? nullptr : &values;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// Rate at which the energy of Taylor-Green vortices falls, 2 nu (kx^2 + kz^2), 1/s.
double vortex_decay(const Case& c) {
    const double kx = 2.0 * std::numbers::pi / c.channel.length;
    const double kz = 2.0 * std::numbers::pi / c.total_depth();
    return 2.0 * c.fluid.kinematic_viscosity * (kx * kx + kz * kz);
}

/// Slope of the straight line through the logarithms, with its 95 % half-width, per second.
std::optional<TrendEstimate> logarithmic_slope(const std::vector<double>& time,
                                               const std::vector<double>& values) {
    std::vector<double> logarithms;
    for (const double value : values) {
        if (!(value > 0.0)) return std::nullopt;
        logarithms.push_back(std::log(value));
    }
    TrendEstimate trend = trend_with_confidence(logarithms);
    const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    trend.slope /= interval;
    trend.half_width /= interval;
    return trend;
}

void add_decay(const Case& c, const std::vector<double>& time, const std::vector<double>& kinetic,
               Figure& figure, Analysis& analysis) {
    if (c.start.kind != StartKind::taylor_green || c.channel.dimensions == 3) return;
    const double rate = vortex_decay(c);
    Curve exact = make_curve("exact, exp(-2 nu (kx^2 + kz^2) t)", Origin::theory, Mark::line, {}, {});
    // The kinetic energy at t = 0: u0^2/4 per mass for a square box.
    const double start = kinetic.front() * std::exp(rate * time.front());
    constexpr int steps = 100;
    for (int i = 0; i <= steps; ++i) {
        const double t = time.back() * i / steps;
        exact.x.push_back(t);
        exact.y.push_back(start * std::exp(-rate * t));
    }
    figure.curves.push_back(std::move(exact));
    if (const auto trend = logarithmic_slope(time, kinetic)) {
        analysis.findings.push_back(
            against(make_finding(chapters::course, "velocity_decay_rate", "rate at which the velocities fall",
                                 "1/s", -0.5 * trend->slope, 0.5 * trend->half_width),
                    0.5 * rate, "exact, nu (kx^2 + kz^2)",
                    "from the logarithm of the kinetic energy over the whole record"));
    }
}

}  // namespace

void add_energies(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    const bool space = c.channel.dimensions == 3;
    Figure figure = make_figure(chapters::course, "energy_history", "Energy of the water in time",
                                "Kinetic energy", "", make_axis("time t", "s"),
                                space ? make_axis("energy", "J") : make_axis("energy per unit width", "J/m"));
    const auto* const time = column_of(record, fields::time_series.time);
    const auto* const kinetic = column_of(record, fields::time_series.kinetic_energy);
    if (time == nullptr || kinetic == nullptr) {
        add_missing(record, analysis, std::move(figure), "the results file holds no time series yet");
        return;
    }
    const auto add = [&](const char* name, const std::vector<double>& values, int variant) {
        figure.curves.push_back(
            make_curve(name, Origin::simulated, Mark::line, thinned(*time), thinned(values), variant));
    };
    add("kinetic", *kinetic, 0);
    const double most = largest(*kinetic);
    analysis.findings.push_back(make_finding(chapters::course, "kinetic_energy_largest",
                                             "largest kinetic energy", figure.y.unit, most));
    const auto* const potential = column_of(record, fields::time_series.potential_energy);
    const auto* const elastic = column_of(record, fields::time_series.elastic_energy);
    const bool whole = potential != nullptr && elastic != nullptr && c.normal_gravity() > 0.0 &&
                       c.channel.top == Top::free_surface;
    if (whole) {
        std::vector<double> height = *potential;
        std::vector<double> total = *kinetic;
        for (std::size_t i = 0; i < total.size(); ++i) {
            height[i] -= potential->front();
            total[i] += (*potential)[i] + (*elastic)[i];
        }
        const double start = total.front();
        for (double& value : total) value -= start;
        add("potential, less that of the start", height, 1);
        add("change of kinetic, potential and elastic together", total, 2);
        figure.caption +=
            ", potential energy less that of the start, and what all energy, that of the compression too, "
            "has changed by. Friction takes energy away; without moving bodies nothing adds any.";
        if (most > 0.0) {
            analysis.findings.push_back(make_finding(chapters::course, "energy_change",
                                                     "change of all energy over the largest kinetic energy",
                                                     "1", total.back() / most));
            analysis.findings.push_back(make_finding(
                chapters::course, "energy_gain", "largest gain of all energy over the largest kinetic energy",
                "1", std::max(0.0, largest(total)) / most));
        }
    } else {
        figure.caption += " of all water.";
    }
    add_decay(c, *time, *kinetic, figure, analysis);
    analysis.figures.push_back(std::move(figure));
}

void add_volumes(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::course, "volume_history", "Volume of the water in time",
        "Relative change since the start of the water's volume, mass over density of its particles.", "",
        make_axis("time t", "s"), make_axis("relative change of the volume", "1"));
    const auto* const time = column_of(record, fields::time_series.time);
    const auto* const volume = column_of(record, fields::time_series.water_volume);
    if (time == nullptr || volume == nullptr) {
        add_missing(record, analysis, std::move(figure),
                    "the time series of this file hold no volume of the water");
        return;
    }
    std::vector<double> change;
    double most = 0.0;
    for (const double value : *volume) {
        change.push_back(value / volume->front() - 1.0);
        if (std::abs(change.back()) > std::abs(most)) most = change.back();
    }
    figure.curves.push_back(make_curve("by the density of the particles", Origin::simulated, Mark::line,
                                       thinned(*time), thinned(change)));
    analysis.findings.push_back(make_finding(chapters::course, "volume_change_largest",
                                             "largest relative change of the water's volume", "1", most));
    // Bodies take room below the surface, and in space the line is not the whole surface.
    const Case& c = *record.flow();
    if (c.solids.empty() && c.channel.dimensions == 2 && surface.rows() > 1) {
        std::vector<double> area;
        for (std::size_t row = 0; row < surface.rows(); ++row) {
            double sum = 0.0;
            for (const double level : surface.row(row)) sum += std::isfinite(level) ? level : 0.0;
            area.push_back(sum);
        }
        const double start = area.front();
        for (double& value : area) value = value / start - 1.0;
        figure.curves.push_back(make_curve("under the highest surface at each place", Origin::simulated,
                                           Mark::line, thinned(surface.times), thinned(area), 1));
        figure.caption += " The volume under the surface counts air that the water encloses or leaps over.";
    }
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
