// The quadrants of u' and w'.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/figure_tools.hpp"
#include "analysis/subsurface_parts.hpp"
#include "statistics/quadrants.hpp"

namespace riffle::inline analysis {

namespace {

/// A curve without points for each quadrant.
std::array<Curve, 4> curves_of_quadrants(Origin origin) {
    constexpr std::array names = {"outward interactions (Q1)", "ejections (Q2)", "inward interactions (Q3)",
                                  "sweeps (Q4)"};
    std::array<Curve, names.size()> curves;
    for (std::size_t q = 0; q < curves.size(); ++q) {
        curves[q] = make_curve(names[q], origin, Mark::line_and_points, {}, {}, static_cast<int>(q));
    }
    return curves;
}

}  // namespace

void add_quadrants(const FlowRecord& record, const VelocityInstrument& instrument, Analysis& analysis) {
    if (instrument.probe->w.empty()) return;
    Figure figure = make_figure(
        chapters::subsurface, "quadrant_profile", "Quadrants of the Reynolds stress over the depth",
        "Part of <u'w'> that each quadrant of the plane of u' and w' carries, without a hole; bars: 95 % "
        "intervals.",
        "Lu & Willmarth (1973)", make_axis("part of <u'w'>", "m2/s2"),
        make_axis("height above the bed level z", "m"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        std::array<Curve, 4> curves = curves_of_quadrants(record.origin());
        for (const ProbePointStatistics& point : instrument.points) {
            const Quadrants result =
                quadrant_analysis(instrument.probe->point(instrument.probe->u, point.point),
                                  instrument.probe->point(instrument.probe->w, point.point));
            for (std::size_t q = 0; q < curves.size(); ++q) {
                curves[q].x.push_back(result.quadrant[q].stress.value);
                curves[q].x_half_width.push_back(result.quadrant[q].stress.half_width);
                curves[q].y.push_back(point.z);
            }
        }
        for (Curve& curve : curves) f.curves.push_back(std::move(curve));
    });
    const ProbePointStatistics& middle = instrument.points[instrument.points.size() / 2];
    Figure holes = make_figure(
        chapters::subsurface, "quadrant_holes", "Quadrants against the hole size",
        fmt::format("Share of the time in each quadrant with |u'w'| above H u_rms w_rms, at {}.",
                    place(middle)),
        "Lu & Willmarth (1973)", make_axis("hole size H", "1"), make_axis("share of the time", "1"));
    attempt(record, analysis, std::move(holes), [&](Figure& f) {
        std::array<Curve, 4> curves = curves_of_quadrants(record.origin());
        const std::vector<double> u = instrument.probe->point(instrument.probe->u, middle.point);
        const std::vector<double> w = instrument.probe->point(instrument.probe->w, middle.point);
        constexpr int steps = 12;
        for (int i = 0; i <= steps; ++i) {
            const double hole = 0.5 * i;
            const Quadrants result = quadrant_analysis(u, w, hole);
            for (std::size_t q = 0; q < curves.size(); ++q) {
                curves[q].x.push_back(hole);
                curves[q].y.push_back(result.quadrant[q].time.value);
                curves[q].y_half_width.push_back(result.quadrant[q].time.half_width);
            }
            // Shares of a mean that is zero within its interval say nothing.
            if (i > 0 || !(result.mean_product.half_width < std::abs(result.mean_product.value))) continue;
            const auto share = [&](const char* key, const char* label, std::size_t q) {
                if (!std::isfinite(result.quadrant[q].stress_share)) return;
                analysis.findings.push_back(make_finding(chapters::subsurface, key,
                                                         label + (", " + place(middle)), "1",
                                                         result.quadrant[q].stress_share));
            };
            share("ejection_share", "share of ejections in <u'w'>", 1);
            share("sweep_share", "share of sweeps in <u'w'>", 3);
        }
        for (Curve& curve : curves) f.curves.push_back(std::move(curve));
    });
}

}  // namespace riffle::inline analysis
