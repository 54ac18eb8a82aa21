// The course of a flow that nothing drives steadily: levels, fronts, energy and volume in time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/bodies.hpp"
#include "analysis/chapters.hpp"
#include "analysis/course_parts.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/surface_parts.hpp"
#include "base/not_a_number.hpp"
#include "record/flow_fields.hpp"

namespace riffle::inline analysis {

namespace {

std::vector<double> places_along(const SpaceTime& surface) {
    std::vector<double> x;
    for (std::size_t i = 0; i < surface.columns; ++i) x.push_back(surface.x(i));
    return x;
}

/// Rows at about even times, the first and the last among them.
std::vector<std::size_t> rows_at_times(const std::vector<double>& time, std::size_t wanted) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < wanted; ++i) {
        const double at = time.front() + (time.back() - time.front()) * static_cast<double>(i) /
                                             static_cast<double>(wanted - 1);
        const auto above = std::lower_bound(time.begin(), time.end(), at - 1e-9);
        const auto row = static_cast<std::size_t>(std::min(above, time.end() - 1) - time.begin());
        if (rows.empty() || row > rows.back()) rows.push_back(row);
    }
    return rows;
}

/// Ritter's depth at x and t after the dam is gone; not-a-number outside of the wave.
double ritter_depth(const DamBreak& dam, double gravity, double x, double t) {
    const double celerity = std::sqrt(gravity * dam.depth);
    const double along = (dam.forward ? x - dam.dam : dam.dam - x) / t;
    if (along < -celerity || along > 2.0 * celerity) return not_a_number;
    return std::pow(2.0 * celerity - along, 2) / (9.0 * gravity);
}

/// Ritter's solution holds from when the water is free until the wave comes to an end of the channel, and
/// where the reservoir is long beside its depth.
struct RitterTime {
    double from = 0;
    double to = 0;
};

std::optional<RitterTime> ritter_time(const Case& c, const std::optional<DamBreak>& dam) {
    constexpr double shortest = 2.0;
    if (!dam || dam->length < shortest * dam->depth) return std::nullopt;
    const double celerity = std::sqrt(c.normal_gravity() * dam->depth);
    const double dry = dam->forward ? c.channel.length - dam->dam : dam->dam;
    return RitterTime{dam->opening, dam->opening + std::min(dry / (2.0 * celerity), dam->length / celerity)};
}

void add_level_lines(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = make_figure(
        chapters::course, "level_lines", "Surface along the channel at times",
        "Height of the free surface above the bed level at evenly spaced times; a gap is a dry place.", "",
        make_axis("distance along the channel x", "m"), make_axis("height above the bed level z", "m"));
    figure.x.from = 0.0;
    figure.x.to = c.channel.length;
    figure.y.from = 0.0;
    constexpr std::size_t lines = 6;
    const std::vector<std::size_t> rows = rows_at_times(surface.times, lines);
    for (Curve& body : body_curves(record, surface.times[rows.back()], surface.times[rows.back()])) {
        figure.curves.push_back(std::move(body));
    }
    const std::vector<double> x = places_along(surface);
    const std::optional<DamBreak> dam = dam_break_of(c);
    const std::optional<RitterTime> valid = ritter_time(c, dam);
    int variant = 0;
    Curve exact = make_curve("Ritter at these times", Origin::theory, Mark::line, {}, {});
    for (const std::size_t row : rows) {
        const double time = surface.times[row];
        const auto values = surface.row(row);
        figure.curves.push_back(make_curve(fmt::format("t = {:.3g} s", time), Origin::simulated, Mark::line,
                                           x, {values.begin(), values.end()}, variant));
        if (valid && time > valid->from && time <= valid->to) {
            for (const double at : x) {
                exact.x.push_back(at);
                exact.y.push_back(ritter_depth(*dam, c.normal_gravity(), at, time - valid->from));
            }
            exact.x.push_back(not_a_number);  // the next time begins a line of its own
            exact.y.push_back(not_a_number);
        }
        ++variant;
    }
    if (!exact.x.empty()) {
        figure.curves.push_back(std::move(exact));
        figure.caption +=
            " Theory: a dam that is gone at once before a long reservoir on a bed without friction (Ritter "
            "1892), up to when its waves come to an end of the channel.";
    }
    analysis.figures.push_back(std::move(figure));
}

void add_level_map(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis) {
    Figure figure = make_figure(chapters::course, "level_map", "Surface level in space and time",
                                "Height of the free surface above the bed level; white: dry.", "",
                                make_axis("distance along the channel x", "m"), make_axis("time t", "s"));
    constexpr std::size_t most_rows = 400;
    constexpr std::size_t most_columns = 500;
    const std::size_t row_stride = (surface.rows() + most_rows - 1) / most_rows;
    const std::size_t stride = (surface.columns + most_columns - 1) / most_columns;
    ColourMap map;
    map.label = "height of the surface";
    map.unit = "m";
    for (std::size_t i = 0; i < surface.columns; i += stride) map.x.push_back(surface.x(i));
    for (std::size_t j = 0; j < surface.rows(); j += row_stride) {
        map.y.push_back(surface.times[j]);
        for (std::size_t i = 0; i < surface.columns; i += stride) {
            map.values.push_back(static_cast<float>(surface.at(j, i)));
        }
    }
    figure.maps.push_back(std::move(map));
    analysis.figures.push_back(std::move(figure));
    (void)record;
}

void add_levels(const FlowRecord& record, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::course, "level_history", "Level at places in time",
                    "Height of the free surface above the bed level at the wave probes; a gap: dry.", "",
                    make_axis("time t", "s"), make_axis("height of the surface", "m"));
    int variant = 0;
    for (const ElevationProbe& probe : record.elevation_probes()) {
        if (probe.time.size() < 2) continue;
        figure.curves.push_back(make_curve(probe.name, Origin::simulated, Mark::line, thinned(probe.time),
                                           thinned(probe.elevation), variant++));
    }
    if (figure.curves.empty()) {
        add_missing(record, analysis, std::move(figure), "no wave probe recorded anything");
        return;
    }
    analysis.figures.push_back(std::move(figure));
}

/// Speed of the front while Ritter's solution holds, without the first fifth, in which the water sets off.
void add_front_speed(const Case& c, const std::vector<double>& time, const std::vector<double>& front,
                     Analysis& analysis) {
    const std::optional<DamBreak> dam = dam_break_of(c);
    const std::optional<RitterTime> valid = ritter_time(c, dam);
    if (!valid) return;
    std::vector<double> places;
    std::vector<double> times;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < valid->from + 0.2 * (valid->to - valid->from) || time[i] > valid->to) continue;
        times.push_back(time[i]);
        places.push_back(front[i]);
    }
    constexpr std::size_t fewest = 8;
    if (times.size() < fewest) return;
    const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    const TrendEstimate trend = trend_with_confidence(places);
    const double sign = dam->forward ? 1.0 : -1.0;
    analysis.findings.push_back(
        against(make_finding(chapters::course, "front_speed", "speed of the front over the dry bed", "m/s",
                             sign * trend.slope / interval, trend.half_width / interval),
                2.0 * std::sqrt(c.normal_gravity() * dam->depth), "Ritter 1892, 2 sqrt(g h0)",
                fmt::format("from {:.3g} s to {:.3g} s", times.front(), times.back())));
}

void add_fronts(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[fields::time_series.time];
    // Files of earlier versions know the particles alone.
    const bool fronts =
        series.has(fields::time_series.front_upstream) && series.has(fields::time_series.front_downstream);
    const std::vector<double>& lower =
        series[fronts ? fields::time_series.front_upstream : fields::time_series.first_particle];
    const std::vector<double>& upper =
        series[fronts ? fields::time_series.front_downstream : fields::time_series.last_particle];
    if (c.channel.ends != Ends::walls || lower.empty() || upper.empty() || time.size() < 2) return;
    const auto moves = [&](const std::vector<double>& ends) {
        const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
        return *high - *low > 3.0 * c.numerics.spacing;
    };
    Figure figure =
        make_figure(chapters::course, "front_history", "Ends of the water in time",
                    fronts ? "Places along the channel of the third particle from each end of the "
                             "water: two drops that fly ahead do not count."
                           : "Places along the channel of the first and the last particle, "
                             "spray and all.",
                    "", make_axis("time t", "s"), make_axis("distance along the channel x", "m"));
    const auto add = [&](const char* name, const std::vector<double>& ends, int variant) {
        if (!moves(ends)) return;
        figure.curves.push_back(
            make_curve(name, Origin::simulated, Mark::line, thinned(time), thinned(ends), variant));
    };
    add("downstream end", upper, 0);
    add("upstream end", lower, 1);
    if (figure.curves.empty()) return;
    const std::optional<DamBreak> dam = dam_break_of(c);
    if (const auto valid = ritter_time(c, dam)) {
        const double run = 2.0 * std::sqrt(c.normal_gravity() * dam->depth) * (valid->to - valid->from);
        figure.curves.push_back(make_curve("Ritter: 2 sqrt(g h0) t", Origin::theory, Mark::line,
                                           {valid->from, valid->to},
                                           {dam->dam, dam->dam + (dam->forward ? run : -run)}));
        add_front_speed(c, time, dam->forward ? upper : lower, analysis);
    }
    analysis.figures.push_back(std::move(figure));
}

/// Profiles of u at the first velocity probe at times: how the flow over the depth develops.
void add_velocity_lines(const FlowRecord& record, Analysis& analysis) {
    for (const VelocityProbe& probe : record.velocity_probes()) {
        const auto one_place = [](const std::vector<double>& places) {
            return std::all_of(places.begin(), places.end(), [&](double at) { return at == places.front(); });
        };
        const bool upright = probe.z.size() > 2 && one_place(probe.x) && one_place(probe.y);
        if (!upright || probe.time.size() < 2) continue;
        Figure figure = make_figure(
            chapters::course, "velocity_lines", "Velocity over the depth at times",
            fmt::format("Streamwise velocity at the points of {}, x = {}, at evenly spaced times.",
                        probe.name, shown_place(probe.x.front())),
            "", make_axis("streamwise velocity u", "m/s"), make_axis("height above the bed level z", "m"));
        constexpr std::size_t lines = 6;
        int variant = 0;
        for (const std::size_t row : rows_at_times(probe.time, lines)) {
            std::vector<double> u(probe.u.begin() + static_cast<std::ptrdiff_t>(row * probe.z.size()),
                                  probe.u.begin() + static_cast<std::ptrdiff_t>((row + 1) * probe.z.size()));
            // Of a place that is mostly dry there is no profile to show.
            const auto wet =
                std::count_if(u.begin(), u.end(), [](double value) { return std::isfinite(value); });
            if (2 * static_cast<std::size_t>(wet) < u.size()) continue;
            figure.curves.push_back(make_curve(fmt::format("t = {:.3g} s", probe.time[row]),
                                               Origin::simulated, Mark::line, std::move(u), probe.z,
                                               variant++));
        }
        if (figure.curves.size() > 2) analysis.figures.push_back(std::move(figure));
        return;
    }
}

/// Whether the surface goes up and down again and again, so that its spectrum tells something.
bool swings(const Case& c) {
    const bool paddle = std::any_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) {
        return solid.motion == SolidMotion::oscillating;
    });
    const bool full_tank = c.channel.ends == Ends::walls && c.solids.empty() && c.start.water_x.empty();
    return flow_kind(c) == FlowKind::standing_wave || paddle || full_tank;
}

}  // namespace

void analyse_course(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const SpaceTime& surface = record.surface();
    if (surface.rows() > 1) {
        add_level_lines(record, surface, analysis);
        add_levels(record, analysis);
        add_level_map(record, surface, analysis);
        add_surface_modes(record, surface, analysis);
        if (swings(*record.flow())) {
            const std::vector<SurfaceStation> stations = stations_of_probes(record, analysis.warnings);
            if (!stations.empty()) add_station_spectra(record, stations, analysis);
        }
    }
    add_fronts(record, analysis);
    add_velocity_lines(record, analysis);
    add_energies(record, analysis);
    add_volumes(record, surface, analysis);
}

}  // namespace riffle::inline analysis
