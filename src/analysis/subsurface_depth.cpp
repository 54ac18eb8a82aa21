// The correlation of the vertical velocity over the depth.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_tools.hpp"
#include "analysis/subsurface_parts.hpp"
#include "statistics/power_spectrum.hpp"

namespace riffle::inline analysis {

namespace {

/// The depth down to which w' goes with that of the highest point, at height `top`.
void add_influence_depth(const std::vector<HeightCorrelation>& found, double top, const Case& c,
                         Analysis& analysis) {
    const double depth = c.total_depth();
    if (found.size() < 3) return;
    // The highest point correlates with itself: a fall between it and the next tells their distance only.
    constexpr double threshold = 0.5;
    if (!(found[found.size() - 2].correlation.value > threshold)) {
        analysis.warnings.push_back(
            fmt::format("influence depth of the surface: not resolved, the correlation falls below 0.5 "
                        "within {:.3g} mm, between the two highest points",
                        1000.0 * (found.back().z - found[found.size() - 2].z)));
        return;
    }
    const auto influence = influence_depth(found, top, threshold);
    if (!influence) {
        analysis.warnings.push_back(
            fmt::format("influence depth of the surface: none, the correlation stays above 0.5 down to the "
                        "lowest point at z/H = {:.3g}",
                        found.front().z / depth));
        return;
    }
    Finding finding =
        make_finding(chapters::subsurface, "influence_depth",
                     "influence depth of the surface, z/H where w' correlates to 0.5 with the highest point",
                     "1", influence->z / depth);
    finding.remark = "a quarter of the variance explained; the thesis' own is influence_depth_of_zero";
    const double half_width = 0.5 * (influence->upper - influence->lower) / depth;
    if (std::isfinite(half_width)) finding.half_width = std::abs(half_width);
    analysis.findings.push_back(std::move(finding));
}

}  // namespace

void add_depth_correlation(const FlowRecord& record, const VelocityInstrument& instrument,
                           Analysis& analysis) {
    if (instrument.probe->w.empty() || instrument.points.size() < 3) return;
    Figure figure = make_figure(
        chapters::subsurface, "depth_correlation", "Correlation of the vertical velocity over the depth",
        fmt::format("Correlation of w' at each height with w' at {}, at the same time and at the lag of its "
                    "extreme; bars: 95 % intervals.",
                    place(instrument.points.back())),
        "thesis (4.8)", make_axis("correlation", "1"), make_axis("height above the bed level z", "m"));
    Figure lags =
        make_figure(chapters::subsurface, "depth_cross_correlation", "Correlation of w' over depth and lag",
                    "Temporal cross-correlation of w' at three heights with w' at the highest point; a "
                    "positive lag: the height follows.",
                    "thesis (4.8)", make_axis("time lag", "s"), make_axis("correlation", "1"));
    figure.x.from = -1.0;
    figure.x.to = 1.0;
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<HeightRecord> records =
            height_records(*instrument.probe, instrument.probe->w, instrument.points);
        const double duration = static_cast<double>(records.front().values.size()) * instrument.interval;
        // A few periods of what w' does most.
        const double peak =
            peak_frequency(smoothed_power_spectrum(records.back().values, instrument.interval).fine);
        constexpr double periods = 8.0;
        double largest = std::min(2.0, 0.25 * duration);
        if (peak > 0.0) largest = std::min(largest, std::max(periods / peak, 8.0 * instrument.interval));
        const std::vector<HeightCorrelation> found =
            depth_correlation(records, records.back().values, instrument.interval, largest);
        Curve same = make_curve("at the same time", record.origin(), Mark::line_and_points, {}, {});
        Curve extreme = make_curve("extreme over the lag", record.origin(), Mark::points, {}, {}, 1);
        for (const HeightCorrelation& height : found) {
            same.x.push_back(height.correlation.value);
            same.x_half_width.push_back(height.correlation.half_width);
            same.y.push_back(height.z);
            if (!height.extreme) continue;
            extreme.x.push_back(height.extreme->correlation);
            extreme.y.push_back(height.z);
        }
        for (const std::size_t part : {1U, 3U, 5U}) {
            if (found.empty()) break;
            const HeightCorrelation& height = found[found.size() * part / 6];
            lags.curves.push_back(make_curve(fmt::format("z = {:.4g} mm", 1000.0 * height.z), record.origin(),
                                             Mark::line, thinned(height.lagged.lag, 2000),
                                             thinned(height.lagged.correlation, 2000),
                                             static_cast<int>(part / 2)));
        }
        f.curves.push_back(std::move(same));
        f.curves.push_back(std::move(extreme));
        if (record.flow() != nullptr) {
            add_influence_depth(found, instrument.points.back().z, *record.flow(), analysis);
        }
    });
    if (!lags.curves.empty()) analysis.figures.push_back(std::move(lags));
}

}  // namespace riffle::inline analysis
