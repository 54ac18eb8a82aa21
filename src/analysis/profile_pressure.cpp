// The vertical profile of the pressure and its departure from hydrostatic.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "record/flow_fields.hpp"

namespace riffle::inline analysis {

double mean_level_of(const FlowRecord& record, const Profiles& p) {
    const std::vector<double>& time = record.series()[fields::time_series.time];
    const std::vector<double>& level = record.series()[fields::time_series.mean_level];
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < std::min(time.size(), level.size()); ++i) {
        if (time[i] < p.window_start || time[i] > p.window_end || !std::isfinite(level[i])) continue;
        sum += level[i];
        count += 1.0;
    }
    return count > 0.0 ? sum / count : record.flow()->total_depth();
}

bool stands_level(const FlowRecord& record, const Profiles& p) {
    const SpaceTime& surface = record.surface();
    const double depth = record.flow()->total_depth();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < surface.columns; ++i) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t row = 0; row < surface.rows(); ++row) {
            if (surface.times[row] < p.window_start || surface.times[row] > p.window_end) continue;
            sum += surface.at(row, i);
            count += 1.0;
        }
        if (!(count > 0.0) || !std::isfinite(sum)) return false;
        low = std::min(low, sum / count);
        high = std::max(high, sum / count);
    }
    constexpr double tolerance = 0.02;
    return high - low < tolerance * depth;
}

void add_pressure(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = profile_figure("pressure_profile", "Pressure",
                                   "Time-mean pressure of the particles against the hydrostatic pressure "
                                   "below the mean surface level.",
                                   "thesis chapter 4, pressure", make_axis("pressure p", "Pa"));
    if (p.pressure.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no pressure");
        return;
    }
    const double level = mean_level_of(record, p);
    // Under a lid gravity across the flow only adds a pressure, which is left out.
    const double weight = c.channel.top == Top::free_surface ? c.fluid.density * c.normal_gravity() : 0.0;
    std::vector<double> hydrostatic;
    double squares = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < p.z.size(); ++i) {
        hydrostatic.push_back(weight * std::max(0.0, level - p.z[i]));
        const double departure = p.pressure[i] - hydrostatic.back();
        squares += departure * departure;
        most = std::max(most, std::abs(departure));
    }
    figure.curves.push_back(
        profile_curve("simulated", Origin::simulated, p.pressure, p.z, Mark::line_and_points));
    if (weight > 0.0) figure.curves.push_back(profile_curve("hydrostatic", Origin::theory, hydrostatic, p.z));
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
    if (!(weight * level > 0.0)) return;
    Figure departure =
        profile_figure("pressure_departure_profile", "Departure of the pressure from hydrostatic",
                       "Time-mean pressure of the particles less the hydrostatic pressure below the mean "
                       "surface level, over that at the bed level.",
                       "", make_axis("pressure departure over bottom pressure", "1"));
    std::vector<double> share;
    for (std::size_t i = 0; i < p.z.size(); ++i) {
        share.push_back((p.pressure[i] - hydrostatic[i]) / (weight * level));
    }
    departure.curves.push_back(
        profile_curve("simulated", Origin::simulated, share, p.z, Mark::line_and_points));
    departure.curves.push_back(
        make_curve("hydrostatic", Origin::theory, Mark::line, {0.0, 0.0}, {0.0, level}));
    mark_levels(record, departure);
    analysis.figures.push_back(std::move(departure));
    const double rms = std::sqrt(squares / static_cast<double>(p.z.size())) / (weight * level);
    Finding finding =
        make_finding(chapters::profiles, "pressure_departure_rms",
                     "rms departure of the pressure from hydrostatic over the bottom pressure", "1", rms);
    finding.remark = fmt::format("largest departure {:.3g}", most / (weight * level));
    analysis.findings.push_back(std::move(finding));
}

}  // namespace riffle::inline analysis
