#include "analysis/flood_passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/running_means.hpp"
#include "case/end_levels.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline analysis {

namespace {

/// Waves of the surface pass a section in less than this many times sqrt(H/g).
constexpr double smoothing_depths = 5.0;

/// What a section of an instrument recorded, in running means.
struct Section {
    double x = 0.0;
    int end = 0;  ///< 1: at the inflow, 2: at the outflow
    std::vector<double> time, discharge;
    std::vector<double> depth;  ///< above the bed level; empty where it was not recorded
};

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

double stretch(const Case& c) { return smoothing_depths * std::sqrt(c.total_depth() / c.normal_gravity()); }

std::vector<Section> sections_of(const FlowRecord& record) {
    const std::string discharge = fields::flow_rate.flow_rate.name;
    const double smoothing = stretch(*record.flow());
    const double spacing = record.flow()->numerics.spacing;
    // The sections of half a channel measure that half.
    const double of_whole = record.flow()->channel.sides == Sides::half ? 2.0 : 1.0;
    const auto end_of = [&](const ScalarProbe& probe) {
        return &probe == find_at_end(record, fields::flow_rate.flow_rate, 1)   ? 1
               : &probe == find_at_end(record, fields::flow_rate.flow_rate, 2) ? 2
                                                                               : 0;
    };
    std::vector<Section> sections;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.kind != "flow_rate" || !probe.x || probe.value.size() < 2 ||
            probe.quantity.rfind(discharge, 0) != 0) {
            continue;
        }
        Section section{
            .x = *probe.x, .end = end_of(probe), .time = probe.time, .discharge = {}, .depth = {}};
        section.discharge = running_means(probe.time, probe.value, smoothing);
        for (double& value : section.discharge) value *= of_whole;
        const ScalarProbe* const depth = find_scalar(
            record, fields::flow_rate.depth.name + probe.quantity.substr(discharge.size()), probe.name);
        if (depth != nullptr && depth->value.size() == probe.value.size()) {
            section.depth = running_means(depth->time, depth->value, smoothing);
        }
        sections.push_back(std::move(section));
    }
    std::stable_sort(sections.begin(), sections.end(),
                     [](const Section& a, const Section& b) { return a.x < b.x; });
    // The standard sections may stand where the case has its own.
    std::vector<Section> each;
    for (Section& section : sections) {
        if (each.empty() || std::abs(each.back().x - section.x) >= 0.1 * spacing) {
            each.push_back(std::move(section));
        } else if (section.end != 0 ||
                   (each.back().end == 0 && section.time.size() > each.back().time.size())) {
            each.back() = std::move(section);
        }
    }
    return each;
}

/// The name of a section's place.
std::string place_of(const Section& section, const char* inflow, const char* outflow, const char* along) {
    return section.end == 1   ? inflow
           : section.end == 2 ? outflow
                              : fmt::format("{}x = {:.4g} mm", along, 1e3 * section.x);
}

/// When the crest of a section passes, and how it stands to the one that came in.
std::string crest_remark(const Crest& crest, const Section* inflow) {
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

void add_crests(const std::vector<Section>& sections, bool space, Analysis& analysis) {
    const auto inflow =
        std::find_if(sections.begin(), sections.end(), [](const Section& s) { return s.end == 1; });
    for (std::size_t n = 0; n < sections.size(); ++n) {
        const Section& section = sections[n];
        const std::string place = place_of(section, "at the inflow", "at the outflow", "at ");
        const Crest crest = crest_of(section.time, section.discharge);
        Finding finding =
            make_finding(chapters::along, fmt::format("flood_discharge_{}", n + 1),
                         fmt::format("largest discharge {}{}", space ? "" : "per unit width ", place),
                         space ? "m3/s" : "m2/s", crest.value);
        finding.remark =
            crest_remark(crest, inflow != sections.end() && section.end != 1 ? &*inflow : nullptr);
        analysis.findings.push_back(std::move(finding));
        if (section.depth.empty()) continue;
        const Crest deepest = crest_of(section.time, section.depth);
        Finding depth = make_finding(chapters::along, fmt::format("flood_depth_{}", n + 1),
                                     fmt::format("largest depth {}", place), "m", deepest.value);
        depth.remark = "of the water above the bed level, " + crest_remark(deepest, nullptr);
        analysis.findings.push_back(std::move(depth));
    }
}

void add_figures(const FlowRecord& record, const std::vector<Section>& sections, bool space,
                 Analysis& analysis) {
    const std::string smoothing =
        fmt::format(" Running means over {:.2g} s, five times the time in which a long wave passes a depth.",
                    stretch(*record.flow()));
    const auto axis = [&] {
        return space ? make_axis("discharge Q", "m3/s") : make_axis("discharge per unit width q", "m2/s");
    };
    Figure passage =
        make_figure(chapters::along, "flood_passage", "Passage of the flood",
                    "Discharge through the sections of the instruments: the crest comes later and lower "
                    "down the channel." +
                        smoothing,
                    "", make_axis("time t", "s"), axis());
    Figure stages = make_figure(chapters::along, "flood_depths", "Depths as the flood passes",
                                "Depth of the water, without the gaps in it, above the bed level at the "
                                "sections of the instruments." +
                                    smoothing,
                                "", make_axis("time t", "s"), make_axis("depth", "m"));
    Figure loop = make_figure(chapters::along, "rating_loop", "Loop of the rating",
                              "Depth over discharge as the flood passes, from its begin on: at one depth a "
                              "rising flood carries more than a falling one." +
                                  smoothing,
                              "", axis(), make_axis("depth", "m"));
    int variant = 0;
    for (const Section& section : sections) {
        const std::string name = place_of(section, "inflow", "outflow", "");
        const std::vector<double> time = thinned(section.time);
        const std::vector<double> discharge = thinned(section.discharge);
        passage.curves.push_back(make_curve(name, Origin::simulated, Mark::line, time, discharge, variant));
        if (!section.depth.empty()) {
            const std::vector<double> depth = thinned(section.depth);
            stages.curves.push_back(make_curve(name, Origin::simulated, Mark::line, time, depth, variant));
            loop.curves.push_back(make_curve(name, Origin::simulated, Mark::line, discharge, depth, variant));
        }
        ++variant;
    }
    for (Figure* const figure : {&passage, &stages, &loop}) {
        if (!figure->curves.empty()) analysis.figures.push_back(std::move(*figure));
    }
}

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
    finding.remark = fmt::format("above the bed level, at x = {:.4g} mm, t = {:.4g} s",
                                 1e3 * surface.x(at % surface.columns), surface.times[at / surface.columns]);
    analysis.findings.push_back(std::move(finding));
}

}  // namespace

void add_flood_passage(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || !inflow_changes(*record.flow())) return;
    const bool space = record.flow()->channel.dimensions == 3;
    const std::vector<Section> sections = sections_of(record);
    add_crests(sections, space, analysis);
    add_highest(record, analysis);
    add_figures(record, sections, space, analysis);
}

}  // namespace riffle::inline analysis
