// What comes up to the surface, against the ejections below it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/figure_tools.hpp"
#include "analysis/subsurface_parts.hpp"
#include "statistics/cross_correlation.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

/// -u'w' at the moments at which slow water goes up (u' < 0, w' > 0), else 0.
std::vector<double> ejections(const std::vector<double>& u, const std::vector<double>& w) {
    const double mean_u = mean_of(u);
    const double mean_w = mean_of(w);
    std::vector<double> result(u.size(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (u[i] < mean_u && w[i] > mean_w) result[i] = (mean_u - u[i]) * (w[i] - mean_w);
    }
    return result;
}

/// The points whose ejections are looked at: above the crests, up to three, the lowest first.
std::vector<std::size_t> looked_at(const std::vector<ProbePointStatistics>& points, double crests) {
    std::vector<std::size_t> above;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (points[i].z > crests) above.push_back(i);
    }
    if (above.size() <= 3) return above;
    return {above.front(), above[above.size() / 2], above.back()};
}

}  // namespace

void add_ejections_and_upwellings(const FlowRecord& record, const VelocityInstrument& instrument,
                                  Analysis& analysis) {
    if (instrument.probe->w.empty() || instrument.points.size() < 3) return;
    const ProbePointStatistics& top = instrument.points.back();
    Figure figure = make_figure(
        chapters::subsurface, "ejection_upwelling_correlation", "Upwellings after ejections",
        fmt::format(
            "Correlation in time of w' at the highest point, {}, with the ejections at points below it (-u'w' "
            "where u' < 0 and w' > 0, else 0): at a positive lag the upwelling follows the ejection.",
            place(top)),
        "", make_axis("time lag", "s"), make_axis("correlation", "1"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<HeightRecord> u =
            height_records(*instrument.probe, instrument.probe->u, instrument.points);
        const std::vector<HeightRecord> w =
            height_records(*instrument.probe, instrument.probe->w, instrument.points);
        const std::vector<double>& surface = w.back().values;
        constexpr double longest = 1.0;  // s
        const auto lags = static_cast<std::size_t>(
            std::min(longest / instrument.interval, 0.25 * static_cast<double>(surface.size())));
        const double crests = record.flow() != nullptr ? record.flow()->crest() : 0.0;
        int variant = 0;
        for (const std::size_t point : looked_at(instrument.points, crests)) {
            const CrossCorrelation found =
                cross_correlation(ejections(u[point].values, w[point].values), surface, instrument.interval,
                                  std::max<std::size_t>(lags, 1));
            f.curves.push_back(make_curve("ejections at " + place(instrument.points[point]), record.origin(),
                                          Mark::line, thinned(found.lag, 2000),
                                          thinned(found.correlation, 2000), variant++));
            if (f.curves.size() > 1) continue;
            f.curves.push_back(make_curve("by chance, one lag in twenty", Origin::reference, Mark::line,
                                          thinned(found.lag, 2000), thinned(found.significance, 2000)));
            const auto most = static_cast<std::size_t>(
                std::max_element(found.correlation.begin(), found.correlation.end()) -
                found.correlation.begin());
            Finding finding = make_finding(chapters::subsurface, "ejection_upwelling_correlation",
                                           fmt::format("largest correlation of w', {}, with ejections, {}",
                                                       place(top), place(instrument.points[point])),
                                           "1", found.correlation[most]);
            finding.remark = fmt::format("at a lag of {:.3g} s; by chance up to {:.2g} at one lag",
                                         found.lag[most], found.significance[most]);
            analysis.findings.push_back(std::move(finding));
        }
    });
}

}  // namespace riffle::inline analysis
