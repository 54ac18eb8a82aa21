// The correlation of the vertical velocity between places along the stream, at each height (thesis 4.8).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/space_time_correlation.hpp"
#include "analysis/subsurface_parts.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double thesis_step = 0.005;  // m
/// Size of an extreme that two unrelated records may have by chance: of the largest of some lags of a record
/// with a hundred independent samples.
constexpr double by_chance = 0.25;

/// w' at one height; less its mean along a periodic line where that is asked for.
SpaceTime line_of(const VelocityPlane& plane, std::size_t j, bool without_breathing) {
    SpaceTime line = resample_evenly(plane.line(plane.w, j));
    if (!without_breathing) return line;
    return fluctuation(line, {.remove_trend = false, .remove_line_mean = true});
}

std::vector<StreamwiseCorrelation> correlate(const VelocityPlane& plane, double velocity,
                                             bool without_breathing, std::vector<std::string>& left_out) {
    CorrelationReach reach;
    reach.step = thesis_step;
    // As printed, as far as the channel goes; around a periodic one the last place is the first one's
    // neighbour upstream.
    reach.largest_distance = static_cast<double>(plane.x.size() - 1) * (plane.x[1] - plane.x[0]);
    if (velocity > 0.0) reach.largest_lag = 2.0 * reach.largest_distance / velocity;
    std::vector<StreamwiseCorrelation> heights;
    for (std::size_t j = 0; j < plane.z.size(); ++j) {
        try {
            heights.push_back(streamwise_correlation(plane.z[j], line_of(plane, j, without_breathing), reach,
                                                     velocity, by_chance));
        } catch (const InputError& error) {
            left_out.push_back(fmt::format("z = {:.4g} mm ({})", 1000.0 * plane.z[j], error.what()));
        }
    }
    return heights;
}

ColourMap map_of(const std::vector<StreamwiseCorrelation>& heights, double depth) {
    ColourMap map;
    map.label = "extreme of the correlation of w'";
    map.unit = "1";
    map.diverging = true;
    map.contours = true;
    for (const double distance : heights.front().distance) map.x.push_back(distance / depth);
    for (const StreamwiseCorrelation& height : heights) {
        map.y.push_back(height.z / depth);
        for (const double value : height.extreme) map.values.push_back(static_cast<float>(value));
    }
    return map;
}

void add_influence(const std::vector<StreamwiseCorrelation>& heights, const Case& c, const char* key,
                   const char* label, Figure& figure, Analysis& analysis) {
    const std::optional<double> deepest = deepest_zero(heights);
    if (!deepest) {
        analysis.warnings.push_back(fmt::format(
            "{}: none, the correlation of w' near the surface does not pass through zero within the "
            "distances recorded",
            label));
        return;
    }
    const double relative = *deepest / c.total_depth();
    const bool space = c.channel.dimensions == 3;
    analysis.findings.push_back(against(
        make_finding(chapters::subsurface, key, label, "1", relative), space ? 0.84 : 0.93,
        space ? "thesis, 3D simulations" : "thesis, 2D simulations",
        fmt::format("heights {:.3g} of H apart; changes of sign by less than {} count as chance",
                    heights.size() > 1 ? (heights[1].z - heights[0].z) / c.total_depth() : 0.0, by_chance)));
    figure.curves.push_back(make_curve("influence depth", Origin::reference, Mark::line,
                                       {0.0, heights.front().distance.back() / c.total_depth()},
                                       {relative, relative}));
}

}  // namespace

void add_streamwise_correlation(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr) return;
    const Case& c = *record.flow();
    Figure figure = make_figure(
        chapters::subsurface, "streamwise_correlation", "Correlation of the vertical velocity between places",
        "At each height, the extreme over the lag of the temporal cross-correlation of w' at two places "
        "along the stream, mean over all pairs at a distance. The thesis' influence depth of the surface "
        "lies where, going down from the surface, the correlation last passes through zero.",
        "thesis (4.8), Figs 4.20 and 5.36", make_axis("distance along the channel over H", "1"),
        make_axis("height above the bed level z/H", "1"));
    const std::vector<VelocityPlane>& planes = record.velocity_planes();
    const auto usable = std::find_if(planes.begin(), planes.end(), [](const VelocityPlane& plane) {
        return plane.x.size() > 3 && plane.z.size() > 2 && plane.time.size() >= 32;
    });
    if (usable == planes.end()) {
        add_missing(record, analysis, std::move(figure),
                    "no velocities in a plane were recorded in the window; [[probe]] kind = \"grid\" with "
                    "averaging_time = 0 in the case file records them");
        return;
    }
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        std::vector<std::string> left_out;
        const double velocity = velocity_at_centreline(record);
        const auto printed = correlate(*usable, velocity, false, left_out);
        if (printed.empty()) throw InputError("no height has a whole record: " + left_out.front());
        if (!left_out.empty()) {
            analysis.warnings.push_back(
                fmt::format("correlation of w' between places: {} of {} heights are left out, the first {}",
                            left_out.size(), usable->z.size(), left_out.front()));
        }
        f.maps.push_back(map_of(printed, c.total_depth()));
        add_influence(printed, c, "influence_depth_of_zero",
                      "influence depth of the surface, z/H of the deepest zero (4.8)", f, analysis);
    });
    if (!usable->period) return;
    Figure steady = make_figure(
        chapters::subsurface, "streamwise_correlation_of_waves",
        "The same without the breathing of the water",
        "As above, of w' less its mean along the periodic channel: water that cannot be compressed has no "
        "such mean, and the slight compression of the particles moves all places alike.",
        "after the thesis (4.8)", make_axis("distance along the channel over H", "1"),
        make_axis("height above the bed level z/H", "1"));
    attempt(record, analysis, std::move(steady), [&](Figure& f) {
        std::vector<std::string> left_out;
        const auto heights = correlate(*usable, velocity_at_centreline(record), true, left_out);
        if (heights.empty()) throw InputError("no height has a whole record: " + left_out.front());
        f.maps.push_back(map_of(heights, c.total_depth()));
        add_influence(heights, c, "influence_depth_of_zero_waves",
                      "the same without the breathing of the water", f, analysis);
    });
}

}  // namespace riffle::inline analysis
