// The surface's correlation in space and time, and what is left of it along the way of the patterns.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/space_time_correlation.hpp"
#include "analysis/surface_parts.hpp"

namespace riffle::inline analysis {

namespace {

/// xi = velocity tau as far as the map reaches.
Curve ray(std::string name, Origin origin, double velocity, double longest, double furthest) {
    const double lag = std::min(longest, furthest / velocity);
    return make_curve(std::move(name), origin, Mark::line, {0.0, lag}, {0.0, velocity * lag});
}

}  // namespace

void add_surface_space_time(const FlowRecord& record, const SpaceTime& line, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::surface, "surface_space_time_correlation", "Correlation of the surface in space and time",
        "Cross-correlation of the elevation at two places, mean over all pairs at a distance, against the "
        "lag of the one downstream; the lines are the advection with the depth-mean velocity U and with "
        "the celerity found from the extremes.",
        "thesis (4.7), Fig. 5.34", make_axis("time lag tau", "s"), make_axis("distance xi", "m"));
    const double velocity = velocity_at_centreline(record);
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        constexpr std::size_t most = 200;
        CorrelationReach reach;
        const double furthest = line.periodic ? 0.5 * line.length() : line.length();
        reach.step = furthest / static_cast<double>(most);
        if (velocity > 0.0) reach.largest_lag = 2.0 * furthest / velocity;
        const SpaceTimeCorrelation r = space_time_correlation(line, reach);
        const std::size_t stride = (r.lag.size() + most - 1) / most;
        ColourMap map;
        map.label = "correlation R";
        map.unit = "1";
        map.diverging = true;
        for (std::size_t k = 0; k < r.lag.size(); k += stride) map.x.push_back(r.lag[k]);
        map.y = r.distance;
        for (std::size_t d = 0; d < r.distance.size(); ++d) {
            for (std::size_t k = 0; k < r.lag.size(); k += stride) {
                map.values.push_back(static_cast<float>(r.of(d)[k]));
            }
        }
        f.maps.push_back(std::move(map));
        if (velocity > 0.0) {
            f.curves.push_back(ray(fmt::format("xi = U tau, U = {:.3g} m/s", velocity), Origin::reference,
                                   velocity, r.lag.back(), r.distance.back()));
        }
        const Finding* const celerity = find_finding(analysis, "celerity_stations");
        if (celerity != nullptr && celerity->value > 0.0) {
            f.curves.push_back(ray(fmt::format("xi = c tau, c = {:.3g} m/s", celerity->value), Origin::fit,
                                   celerity->value, r.lag.back(), r.distance.back()));
        }
    });
}

void add_surface_extremes(const FlowRecord& record, const StationCelerity& found, Analysis& analysis) {
    const double scale = record.flow() != nullptr ? record.flow()->total_depth() : 1.0;
    Figure figure = make_figure(
        chapters::surface, "surface_extreme_correlation",
        "Correlation of the surface along the way of its patterns",
        "Extreme (maximum or minimum) of the temporal cross-correlation of the elevation at two places "
        "against their distance.",
        "thesis (4.7), Figs 4.19 and 5.35",
        record.flow() != nullptr ? make_axis("distance x_l/H", "1") : make_axis("distance x_l", "m"),
        make_axis("extreme of the correlation R", "1"));
    Curve curve = make_curve(record.origin() == Origin::simulated ? "simulated" : "measured", record.origin(),
                             Mark::line_and_points, {}, {});
    for (const StationCorrelation& station : found.stations) {
        if (!std::isfinite(station.extreme_correlation)) continue;
        curve.x.push_back(station.distance / scale);
        curve.y.push_back(station.extreme_correlation);
    }
    figure.curves.push_back(std::move(curve));
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
