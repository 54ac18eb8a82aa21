#include "analysis/tailwater_passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/passing_sections.hpp"
#include "base/interpolation.hpp"
#include "case/end_levels.hpp"
#include "statistics/cross_correlation.hpp"

namespace riffle::inline analysis {

namespace {

/// The least and the most of a record.
struct Extremes {
    std::size_t least = 0;  ///< where in the record
    std::size_t most = 0;
    double range = 0.0;
};

Extremes extremes_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {static_cast<std::size_t>(least - values.begin()), static_cast<std::size_t>(most - values.begin()),
            *most - *least};
}

/// How a section's depth follows the one at the outflow: the lag of the largest correlation, s, the first of
/// those that are as good, as a tide that repeats has them; nothing where the depths have less in common. (A
/// test of significance takes the few periods of a tide for few samples.) What lies before it by less than
/// `stretch` (s), over which the records are smoothed, goes with it. The sections may have been recorded at
/// times of their own.
std::optional<CorrelationExtreme> following(const PassingSection& outflow, const PassingSection& section,
                                            double stretch) {
    constexpr std::size_t most = 1000;
    constexpr double least_correlation = 0.5;
    const double begin = std::max(outflow.time.front(), section.time.front());
    const double end = std::min(outflow.time.back(), section.time.back());
    const std::size_t count = std::min({most, outflow.time.size(), section.time.size()});
    const double interval = (end - begin) / static_cast<double>(count - 1);
    if (!(interval > 0.0)) return std::nullopt;
    std::vector<double> cause;
    std::vector<double> effect;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = begin + static_cast<double>(i) * interval;
        cause.push_back(place_in(outflow.time, time).in(outflow.depth));
        effect.push_back(place_in(section.time, time).in(section.depth));
    }
    if (extremes_of(cause).range <= 0.0 || extremes_of(effect).range <= 0.0) return std::nullopt;
    const std::vector<CorrelationExtreme> extremes =
        correlation_extremes(cross_correlation(cause, effect, interval, count / 2, LagDivisor::biased));
    std::optional<CorrelationExtreme> best;
    for (const CorrelationExtreme& e : extremes) {
        if (!e.maximum || e.correlation < least_correlation || e.lag < -stretch) continue;
        if (!best || e.correlation * as_good_correlation > best->correlation) best = e;
    }
    if (best && best->lag < 0.5 * interval) best->lag = 0.0;  // nearer than two samples
    return best;
}

/// "at t = 3.2 s", and whether the record may have cut an extreme off.
std::string when(const PassingSection& section, std::size_t at) {
    const bool edge = at == 0 || at + 1 == section.time.size();
    return fmt::format("at t = {:.4g} s{}", section.time[at], edge ? ", at the edge of the record" : "");
}

/// The range of the depth beside that at the outflow.
std::string range_remark(const PassingSection& section, const PassingSection* outflow, double stretch) {
    if (outflow == nullptr || outflow == &section || outflow->depth.empty()) return "";
    const double range = extremes_of(outflow->depth).range;
    if (range <= 0.0) return "the depth at the outflow has not changed";
    std::string text =
        fmt::format("{:.3g} % of that at the outflow", 100.0 * extremes_of(section.depth).range / range);
    if (const auto follows = following(*outflow, section, stretch)) {
        text += follows->lag < 0.005
                    ? fmt::format(", with which it goes (correlation {:.2f})", follows->correlation)
                    : fmt::format(", which it follows by {:.2f} s (correlation {:.2f})", follows->lag,
                                  follows->correlation);
    } else {
        text += ", which it does not follow";
    }
    return text;
}

/// How long water goes up the channel there.
std::string turning_remark(const PassingSection& section) {
    const auto turns =
        std::find_if(section.discharge.begin(), section.discharge.end(), [](double q) { return q < 0.0; });
    if (turns == section.discharge.end()) return "";
    const auto upstream = std::count_if(turns, section.discharge.end(), [](double q) { return q < 0.0; });
    return fmt::format("; up the channel for {:.3g} % of the time, first at t = {:.4g} s",
                       100.0 * static_cast<double>(upstream) / static_cast<double>(section.discharge.size()),
                       section.time[static_cast<std::size_t>(turns - section.discharge.begin())]);
}

void add_section(const PassingSection& section, const PassingSection* outflow, std::size_t number,
                 const Case& c, Analysis& analysis) {
    const bool space = c.channel.dimensions == 3;
    const std::string place = place_of(section, "at the inflow", "at the outflow", "at ");
    const auto add = [&](const char* key, const std::string& label, const char* unit, double value,
                         std::string remark) {
        Finding finding = make_finding(chapters::along, fmt::format("tailwater_{}_{}", key, number),
                                       fmt::format("{} {}", label, place), unit, value);
        finding.remark = std::move(remark);
        analysis.findings.push_back(std::move(finding));
    };
    if (!section.depth.empty()) {
        const Extremes depth = extremes_of(section.depth);
        add("high", "highest water", "m", section.depth[depth.most],
            "of the water over what it stands on, " + when(section, depth.most));
        add("low", "lowest water", "m", section.depth[depth.least],
            "of the water over what it stands on, " + when(section, depth.least));
        add("range", "range of the depth", "m", depth.range,
            range_remark(section, outflow, passing_stretch(c)));
    }
    const Extremes discharge = extremes_of(section.discharge);
    const char* const unit = space ? "m3/s" : "m2/s";
    const std::string of = space ? "discharge" : "discharge per unit width";
    add("largest_discharge", "largest " + of, unit, section.discharge[discharge.most],
        when(section, discharge.most));
    add("smallest_discharge", "smallest " + of, unit, section.discharge[discharge.least],
        when(section, discharge.least) + turning_remark(section));
}

constexpr PassageFigures tailwater_figures = {
    .discharges_key = "tailwater_discharges",
    .discharges_title = "Discharges as the tailwater changes",
    .discharges_caption =
        "Discharge through the sections of the instruments; less than zero: up the channel.",
    .depths_key = "tailwater_depths",
    .depths_title = "Depths as the tailwater changes",
    .loop_key = "tailwater_loop",
    .loop_title = "Depth over discharge as the tailwater changes",
    .loop_caption =
        "One line for each section of the instruments: at one depth a rising tailwater holds back "
        "water that a falling one lets out.",
};

}  // namespace

void add_tailwater_passage(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || !tailwater_changes(*record.flow())) return;
    const std::vector<PassingSection> sections = passing_sections(record);
    const PassingSection* const outflow = section_at_end(sections, 2);
    for (std::size_t n = 0; n < sections.size(); ++n) {
        add_section(sections[n], outflow, n + 1, *record.flow(), analysis);
    }
    // A flood that comes with it has these figures.
    if (!inflow_changes(*record.flow())) add_passage_figures(record, sections, tailwater_figures, analysis);
}

}  // namespace riffle::inline analysis
