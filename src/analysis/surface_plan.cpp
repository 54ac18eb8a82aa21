// The free surface of a run in three dimensions, in plan.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/surface_parts.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

Figure plan_figure(const Case& c, const char* key, const char* title, std::string caption) {
    Figure figure = make_figure(chapters::surface, key, title, std::move(caption),
                                "thesis chapter 5, maps of the mean water level",
                                make_axis("distance along the channel x", "m"), across_axis(c));
    figure.y.equal_scale = true;
    return figure;
}

ColourMap plan_map(const SurfaceMaps& maps, const std::vector<double>& values, const char* label,
                   bool diverging) {
    ColourMap map;
    map.x = maps.x;
    map.y = maps.y;
    map.label = label;
    map.unit = "m";
    map.diverging = diverging;
    for (const double value : values) map.values.push_back(static_cast<float>(value));
    return map;
}

/// Mean in time of each point; not-a-number where it was never wet.
std::vector<double> means_of(const SurfaceMaps& maps) {
    const std::size_t points = maps.x.size() * maps.y.size();
    std::vector<double> sum(points, 0.0);
    std::vector<double> count(points, 0.0);
    for (std::size_t i = 0; i < maps.elevation.size(); ++i) {
        if (!std::isfinite(maps.elevation[i])) continue;
        sum[i % points] += maps.elevation[i];
        count[i % points] += 1.0;
    }
    for (std::size_t i = 0; i < points; ++i) {
        sum[i] = count[i] > 0.0 ? sum[i] / count[i] : std::numeric_limits<double>::quiet_NaN();
    }
    return sum;
}

}  // namespace

SpaceTime plan_record(const SurfaceMaps& maps) {
    SpaceTime record;
    record.spacing = 1.0;
    record.columns = maps.x.size() * maps.y.size();
    record.periodic = true;
    record.times = maps.time;
    record.values = maps.elevation;
    return record;
}

void add_surface_plan(const FlowRecord& record, Analysis& analysis) {
    if (!is_three_dimensional(record) || record.flow()->channel.top != Top::free_surface) return;
    const SurfaceMaps& maps = record.surface_maps();
    const Case& c = *record.flow();
    Figure mean = plan_figure(c, "surface_mean_map", "Mean water level in plan", "");
    if (maps.time.empty()) {
        add_missing(record, analysis, std::move(mean),
                    "the results file holds no plan map of the surface in the window "
                    "(output.surface_map_interval)");
        return;
    }
    std::vector<double> level = means_of(maps);
    const double whole = mean_of(level);
    Finding finding =
        make_finding(chapters::surface, "plan_mean_water_depth",
                     "mean depth of the water above the datum over the plan", "m", whole - c.datum());
    // Between open ends the depth of the case is that of the start.
    if (c.channel.ends != Ends::open) finding = against(std::move(finding), c.channel.depth, "case, h_w");
    for (double& value : level) value -= whole;
    finding.remark = fmt::format("from {} maps; the thesis' levels are within 2 %", maps.time.size());
    analysis.findings.push_back(std::move(finding));
    mean.caption = fmt::format(
        "Mean level of {} maps about its mean over the plan, {:.4g} mm above the bed level: what the bed and "
        "the secondary flow imprint on it, and what the averaging has left of the waves.",
        maps.time.size(), 1000.0 * whole);
    mean.maps.push_back(plan_map(maps, level, "mean level about its mean", true));
    analysis.figures.push_back(std::move(mean));
    analysis.findings.push_back(make_finding(chapters::surface, "plan_mean_level_deviation",
                                             "standard deviation of the mean level over the plan", "m", [&] {
                                                 double squares = 0.0;
                                                 double count = 0.0;
                                                 for (const double value : level) {
                                                     if (!std::isfinite(value)) continue;
                                                     squares += value * value;
                                                     count += 1.0;
                                                 }
                                                 return std::sqrt(squares / std::max(1.0, count));
                                             }()));

    if (record.origin() == Origin::simulated) add_surface_families(record, analysis);
    Figure deviation = plan_figure(
        c, "surface_deviation_map", "Fluctuation of the surface in plan",
        "Standard deviation in time of the elevation at each point, less the level of the whole plan at each "
        "instant.");
    attempt(record, analysis, std::move(deviation), [&](Figure& f) {
        const SurfaceFluctuation surface = surface_fluctuation(plan_record(maps));
        const SpaceTime& line = surface.line;
        std::vector<double> values(line.columns);
        for (std::size_t i = 0; i < line.columns; ++i) {
            double squares = 0.0;
            for (std::size_t row = 0; row < line.rows(); ++row) squares += std::pow(line.at(row, i), 2);
            values[i] = std::sqrt(squares / static_cast<double>(line.rows()));
        }
        f.maps.push_back(plan_map(maps, values, "standard deviation of eta'", false));
        const DeviationEstimate whole_plan = standard_deviation(line);
        analysis.findings.push_back(
            against(make_finding(chapters::surface, "plan_standard_deviation",
                                 "standard deviation of the surface elevation over the plan", "m",
                                 whole_plan.value, whole_plan.half_width),
                    c.measured.surface_standard_deviation, measured_name(c)));
    });
}

}  // namespace riffle::inline analysis
