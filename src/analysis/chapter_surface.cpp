// The free surface: level, fluctuation, its distribution and space-time map.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/surface_parts.hpp"
#include "base/not_a_number.hpp"
#include "case/flow_kind.hpp"
#include "statistics/p_value.hpp"
#include "statistics/probability_density.hpp"
#include "statistics/stationarity.hpp"

namespace riffle::inline analysis {

namespace {

/// Why a simulated surface is far flatter than the measured one.
std::string flatness_remark(const Case& c) {
    if (resolves_eddies(c)) return "of the eddies, those larger than some spacings are resolved";
    if (c.channel.dimensions == 3 && c.turbulence.closure != ClosureKind::none) {
        return "the closure averages turbulence out and keeps its mean stress only, so that no eddies reach "
               "the surface, which stays almost flat (the thesis: 0.06 to 0.085 mm in 3D)";
    }
    switch (c.turbulence.closure) {
        case ClosureKind::none:
            return "no closure; in two dimensions the eddies that shape a measured surface do not form";
        case ClosureKind::sps:
        case ClosureKind::ramp:
        case ClosureKind::nezu_rodi:
        case ClosureKind::nikuradse:
        case ClosureKind::czernuszenko_rylov:
        case ClosureKind::wale:
        case ClosureKind::vreman:
        case ClosureKind::smagorinsky:
            break;
    }
    return "the mixing-length closure averages turbulence out and keeps its mean stress only, so that no "
           "eddies "
           "reach the surface of the layered 2D flow, which stays almost flat (the thesis: 0.14 mm in 2D)";
}

void add_level(const FlowRecord& record, Analysis& analysis) {
    const MeanEstimate level = mean_level(record.surface());
    const Case& c = *record.flow();
    Finding depth =
        make_finding(chapters::surface, "mean_water_depth", "mean depth of the water above the datum", "m",
                     level.mean - c.datum(), trusted_half_width(level));
    // Between open ends the depth of the case is that of the start.
    analysis.findings.push_back(c.channel.ends == Ends::open
                                    ? std::move(depth)
                                    : against(std::move(depth), c.channel.depth, "case, h_w"));
    const double dry = dry_share(record.surface());
    if (dry > 0.0) {
        analysis.warnings.push_back(fmt::format(
            "{:.2g} % of the points of the surface record are dry and were left out", 100.0 * dry));
    }
}

void add_deviation(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis) {
    const DeviationEstimate deviation = standard_deviation(surface.line);
    Finding finding = make_finding(chapters::surface, "surface_standard_deviation",
                                   "standard deviation of the surface elevation", "m", deviation.value,
                                   deviation.half_width);
    if (record.flow() != nullptr) {
        const Case& c = *record.flow();
        const auto& measured = c.measured.surface_standard_deviation;
        finding = against(std::move(finding), measured, measured_name(c));
        if (measured && record.origin() == Origin::simulated && deviation.value < 0.5 * *measured) {
            finding.remark = flatness_remark(c);
        }
    }
    if (record.flow() != nullptr && record.origin() == Origin::simulated) {
        if (const auto thesis = thesis_surface(*record.flow())) {
            if (!finding.remark.empty()) finding.remark += "; ";
            finding.remark += fmt::format("computed in the thesis ({}D): {:.3g} mm",
                                          record.flow()->channel.dimensions, 1000.0 * thesis->deviation);
        }
    }
    analysis.findings.push_back(std::move(finding));
    if (is_flat(record, surface.line)) {
        analysis.warnings.push_back(
            fmt::format("the surface is flat to {:.2g} of the particle spacing: patterns, celerities and "
                        "spectra of it are "
                        "those of the rows of particles and of rounding, not of waves or turbulence",
                        deviation.value / record.flow()->numerics.spacing));
    }
    if (record.flow() != nullptr) {
        const double depth = water_depth(record);
        analysis.findings.push_back(make_finding(chapters::surface, "surface_relative_deviation",
                                                 "the same over the water depth", "1",
                                                 deviation.value / depth, deviation.half_width / depth));
    }
    if (surface.line.periodic) {
        Finding level = make_finding(chapters::surface, "surface_level_deviation",
                                     "standard deviation of the level as a whole, taken away", "m",
                                     surface.level_deviation);
        level.remark = "of the mean along the periodic line, which the slight compression of the water moves";
        analysis.findings.push_back(std::move(level));
    }
    analysis.findings.push_back(make_finding(chapters::surface, "surface_integral_time",
                                             "integral time scale of the squared elevation", "s",
                                             deviation.integral_time));
}

Figure map_figure() {
    return make_figure(chapters::surface, "surface_map", "Space-time map of the surface",
                       "Departure of the surface from its mean in time at each place; the lines are x = U t "
                       "with the depth-mean "
                       "velocity: patterns that the water carries are parallel to them.",
                       "thesis chapters 4-5, space-time maps", make_axis("distance along the channel x", "m"),
                       make_axis("time t", "s"));
}

/// x = U t through the map, with breaks where it leaves a periodic channel and comes in again.
Curve advection_line(const SpaceTime& line, double velocity, double from, double to) {
    Curve curve =
        make_curve(fmt::format("x = U t, U = {:.3g} m/s", velocity), Origin::reference, Mark::line, {}, {});
    const double low = line.x(0);
    const double high = low + line.length();
    const double passage = (high - low) / velocity;
    for (double start = from; start < to; start += passage) {
        const double end = std::min(to, start + passage);
        curve.x.insert(curve.x.end(), {low, low + velocity * (end - start), not_a_number});
        curve.y.insert(curve.y.end(), {start, end, not_a_number});
    }
    return curve;
}

void add_map(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis) {
    constexpr double crossings = 5.0;
    constexpr std::size_t most_rows = 400;
    constexpr std::size_t most_columns = 400;
    const SpaceTime& line = surface.line;
    Figure figure = map_figure();
    const double velocity = velocity_at_centreline(record);
    const double end = line.times.back();
    const double start = velocity > 0.0
                             ? std::max(line.times.front(), end - crossings * line.length() / velocity)
                             : line.times.front();
    const auto first = static_cast<std::size_t>(
        std::lower_bound(line.times.begin(), line.times.end(), start) - line.times.begin());
    const std::size_t row_stride =
        std::max<std::size_t>(1, (line.rows() - first + most_rows - 1) / most_rows);
    const std::size_t column_stride =
        std::max<std::size_t>(1, (line.columns + most_columns - 1) / most_columns);
    ColourMap map;
    map.label = "elevation eta'";
    map.unit = "m";
    map.diverging = true;
    for (std::size_t i = 0; i < line.columns; i += column_stride) map.x.push_back(line.x(i));
    for (std::size_t j = first; j < line.rows(); j += row_stride) {
        map.y.push_back(line.times[j]);
        for (std::size_t i = 0; i < line.columns; i += column_stride) {
            map.values.push_back(static_cast<float>(line.at(j, i)));
        }
    }
    figure.maps.push_back(std::move(map));
    if (velocity > 0.0) figure.curves.push_back(advection_line(line, velocity, line.times[first], end));
    analysis.figures.push_back(std::move(figure));
}

/// The density of the records of one place each.
void add_density(const std::vector<SurfaceStation>& stations, const FlowRecord& record, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::surface, "surface_probability_density", "Probability density of the surface elevation",
        "Histogram of the elevation about its mean over its standard deviation, with 95 % "
        "intervals, and the Gaussian density.",
        "thesis chapters 3-5, probability density with Gaussian fit", make_axis("elevation eta'/sigma", "1"),
        make_axis("probability density p sigma", "1"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        for (std::size_t i = 0; i < stations.size(); ++i) {
            ProbabilityDensity density = probability_density(stations[i].elevation);
            const double deviation = density.moments.standard_deviation.value;
            for (double& at : density.centre) at /= deviation;
            for (auto* values : {&density.density, &density.half_width, &density.gaussian}) {
                for (double& value : *values) value *= deviation;
            }
            const int variant = static_cast<int>(i);
            Curve bars = make_curve(stations[i].name, record.origin(), Mark::points, density.centre,
                                    density.density, variant);
            bars.y_half_width = density.half_width;
            f.curves.push_back(std::move(bars));
            f.curves.push_back(make_curve("Gaussian, " + stations[i].name, Origin::fit, Mark::line,
                                          density.centre, density.gaussian, variant));
            if (i > 0) continue;
            const Moments& m = density.moments;
            Finding skewness = against(make_finding(chapters::surface, "surface_skewness",
                                                    "skewness of the elevation, " + stations[i].name, "1",
                                                    m.skewness.value, m.skewness.half_width),
                                       0.0, "Gaussian");
            skewness.remark = fmt::format("test against the Gaussian: p {}{} with {:.3g} effective samples",
                                          density.test.p_value >= 0.1 ? ">" : "",
                                          p_value_text(density.test.p_value), density.test.effective_samples);
            analysis.findings.push_back(std::move(skewness));
            analysis.findings.push_back(against(
                make_finding(chapters::surface, "surface_excess_kurtosis", "excess kurtosis of the elevation",
                             "1", m.excess_kurtosis.value, m.excess_kurtosis.half_width),
                0.0, "Gaussian"));
        }
    });
}

/// Moments and spectra of a surface that grows or calms down through the window are of no one state.
void warn_of_change(const SurfaceStation& station, Analysis& analysis) {
    std::vector<double> squares = station.elevation;
    for (double& value : squares) value *= value;
    try {
        const Stationarity test = stationarity(squares);
        constexpr double significance = 0.01;
        if (!(test.p_value < significance)) return;
        const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
        const double first = std::accumulate(squares.begin(), middle, 0.0);
        const double second = std::accumulate(middle, squares.end(), 0.0);
        analysis.warnings.push_back(fmt::format(
            "the fluctuation of the surface is not steady over the window (p {}, {}): its standard "
            "deviation is {:.2g} times as large in the second half as in the first, so that moments and "
            "spectra of it belong to no one state",
            p_value_text(test.p_value), station.name, std::sqrt(second / first)));
    } catch (const InputError&) {
        return;  // too short, or without variance: nothing to tell
    }
}

/// The findings of wave probes without a line between them.
void add_probe_deviations(const std::vector<SurfaceStation>& stations, const FlowRecord& record,
                          Analysis& analysis) {
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const Moments m = moments(stations[i].elevation);
        Finding finding = make_finding(
            chapters::surface,
            i == 0 ? "surface_standard_deviation" : fmt::format("surface_standard_deviation_{}", i + 1),
            "standard deviation of the surface elevation, " + stations[i].name, "m",
            m.standard_deviation.value,
            trusted_half_width(m.standard_deviation.half_width, m.effective_of_variance));
        if (record.flow() != nullptr) {
            finding = against(std::move(finding), record.flow()->measured.surface_standard_deviation,
                              measured_name(*record.flow()));
        }
        analysis.findings.push_back(std::move(finding));
    }
}

}  // namespace

void analyse_surface(const FlowRecord& record, Analysis& analysis) {
    add_surface_plan(record, analysis);
    const std::vector<SurfaceStation> probes = stations_of_probes(record, analysis.warnings);
    const SpaceTime& surface = record.surface();
    if (surface.rows() < 2 && probes.empty()) {
        const bool wall = record.flow() != nullptr && record.flow()->channel.top != Top::free_surface;
        add_missing(record, analysis, map_figure(),
                    wall ? "the case has no free surface"
                         : "the results file holds no record of the surface in the window");
        return;
    }
    std::vector<SurfaceStation> stations;
    if (surface.rows() >= 2) {
        add_level(record, analysis);
        try {
            const SurfaceFluctuation fluctuation = surface_fluctuation(surface);
            add_deviation(record, fluctuation, analysis);
            add_map(record, fluctuation, analysis);
            stations = stations_of_line(fluctuation.line, record.elevation_probes());
            add_surface_spectra(record, fluctuation, analysis);
            add_surface_patterns(record, fluctuation, analysis);
        } catch (const InputError& error) {
            analysis.warnings.push_back(std::string("surface: ") + error.what());
            add_missing(record, analysis, map_figure(), error.what());
        }
    } else {
        stations = probes;
        add_probe_deviations(stations, record, analysis);
        add_place_patterns(record, stations, analysis);
    }
    if (stations.empty()) return;
    warn_of_change(stations.front(), analysis);
    add_density(stations, record, analysis);
    add_station_spectra(record, stations, analysis);
    add_station_correlations(record, stations, analysis);
}

}  // namespace riffle::inline analysis
