#include "analysis/flood_passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/passing_sections.hpp"
#include "case/end_levels.hpp"

namespace riffle::inline analysis {

namespace {

/// The largest value of a record, and when.
struct Crest {
    double value = 0.0;
    double time = 0.0;
    bool at_edge = false;  ///< it is the first or the last value: the flood may be larger before or after
};

Crest crest_of(const std::vector<double>& time, const std::vector<double>& values) {
    const auto most = std::max_element(values.begin(), values.end());
    return {*most, time[static_cast<std::size_t>(most - values.begin())],
            most == values.begin() || most + 1 == values.end()};
}

/// When the crest of a section passes, and how it stands to the one that came in.
std::string crest_remark(const Crest& crest, const PassingSection* inflow) {
    std::string text = fmt::format("at t = {:.4g} s", crest.time);
    if (crest.at_edge) {
        return text + ", at the edge of the record: the flood may be larger before or after it";
    }
    if (inflow == nullptr) return text;
    const Crest entered = crest_of(inflow->time, inflow->discharge);
    if (entered.at_edge) return text;
    const double rise = entered.value - *std::min_element(inflow->discharge.begin(), inflow->discharge.end());
    text += fmt::format(", {:.2f} s after that at the inflow", crest.time - entered.time);
    if (rise > 0.0) {
        const double loss = (entered.value - crest.value) / rise;
        text += fmt::format("; {:.1f} % of the rise there {}", 100.0 * std::abs(loss),
                            loss < 0.0 ? "more" : "less");
    }
    return text;
}

/// `stretch`: of the running means, s, which flatten a crest that is not much longer.
void add_crests(const std::vector<PassingSection>& sections, bool space, double stretch, Analysis& analysis) {
    const PassingSection* const inflow = section_at_end(sections, 1);
    for (std::size_t n = 0; n < sections.size(); ++n) {
        const PassingSection& section = sections[n];
        const std::string place = place_of(section, "at the inflow", "at the outflow", "at ");
        const Crest crest = crest_of(section.time, section.discharge);
        Finding finding = make_finding(chapters::along, fmt::format("flood_discharge_{}", n + 1),
                                       fmt::format("largest discharge {}{}, mean over {:.2g} s",
                                                   space ? "" : "per unit width ", place, stretch),
                                       space ? "m3/s" : "m2/s", crest.value);
        finding.remark = crest_remark(crest, section.end != 1 ? inflow : nullptr);
        analysis.findings.push_back(std::move(finding));
        if (section.depth.empty()) continue;
        const Crest deepest = crest_of(section.time, section.depth);
        Finding depth = make_finding(chapters::along, fmt::format("flood_depth_{}", n + 1),
                                     fmt::format("largest depth {}, mean over {:.2g} s", place, stretch), "m",
                                     deepest.value);
        depth.remark = "of the water over what it stands on, " + crest_remark(deepest, nullptr);
        analysis.findings.push_back(std::move(depth));
    }
}

constexpr PassageFigures flood_figures = {
    .discharges_key = "flood_passage",
    .discharges_title = "Passage of the flood",
    .discharges_caption =
        "Discharge through the sections of the instruments: the crest comes later and lower "
        "down the channel.",
    .depths_key = "flood_depths",
    .depths_title = "Depths as the flood passes",
    .loop_key = "rating_loop",
    .loop_title = "Loop of the rating",
    .loop_caption =
        "Depth over discharge as the flood passes, from its begin on: at one depth a rising flood "
        "carries more than a falling one.",
};

/// The highest sample of the surface anywhere in the window.
void add_highest(const FlowRecord& record, Analysis& analysis) {
    const SpaceTime& surface = record.surface();
    std::size_t at = surface.values.size();
    for (std::size_t i = 0; i < surface.values.size(); ++i) {
        if (!std::isfinite(surface.values[i])) continue;
        if (at == surface.values.size() || surface.values[i] > surface.values[at]) at = i;
    }
    if (at == surface.values.size()) return;
    Finding finding = make_finding(chapters::along, "flood_highest_level",
                                   "highest level recorded along the channel", "m", surface.values[at]);
    finding.remark =
        fmt::format("above the bed level, at x = {}, t = {:.4g} s",
                    shown_place(surface.x(at % surface.columns)), surface.times[at / surface.columns]);
    analysis.findings.push_back(std::move(finding));
}

}  // namespace

void add_flood_passage(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || !inflow_changes(*record.flow())) return;
    const bool space = record.flow()->channel.dimensions == 3;
    const std::vector<PassingSection> sections = passing_sections(record);
    add_crests(sections, space, passing_stretch(*record.flow()), analysis);
    add_highest(record, analysis);
    add_passage_figures(record, sections, flood_figures, analysis);
}

}  // namespace riffle::inline analysis
