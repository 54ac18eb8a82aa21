#include "analysis/passing_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/running_means.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline analysis {

double passing_stretch(const Case& c) {
    constexpr double depths = 5.0;  // waves of the surface pass a section in less than this many sqrt(H/g)
    return depths * std::sqrt(c.total_depth() / c.normal_gravity());
}

std::vector<PassingSection> passing_sections(const FlowRecord& record) {
    const std::string discharge = fields::flow_rate.flow_rate.name;
    const double smoothing = passing_stretch(*record.flow());
    const double spacing = record.flow()->numerics.spacing;
    // The sections of half a channel measure that half.
    const double of_whole = record.flow()->channel.whole_over_simulated();
    const auto end_of = [&](const ScalarProbe& probe) {
        return &probe == find_at_end(record, fields::flow_rate.flow_rate, 1)   ? 1
               : &probe == find_at_end(record, fields::flow_rate.flow_rate, 2) ? 2
                                                                               : 0;
    };
    std::vector<PassingSection> sections;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.kind != "flow_rate" || !probe.x || probe.value.size() < 2 ||
            probe.quantity.rfind(discharge, 0) != 0) {
            continue;
        }
        PassingSection section{
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
                     [](const PassingSection& a, const PassingSection& b) { return a.x < b.x; });
    // The standard sections may stand where the case has its own.
    std::vector<PassingSection> each;
    for (PassingSection& section : sections) {
        if (each.empty() || std::abs(each.back().x - section.x) >= 0.1 * spacing) {
            each.push_back(std::move(section));
        } else if (section.end != 0 ||
                   (each.back().end == 0 && section.time.size() > each.back().time.size())) {
            each.back() = std::move(section);
        }
    }
    return each;
}

const PassingSection* section_at_end(const std::vector<PassingSection>& sections, int end) {
    const auto found =
        std::find_if(sections.begin(), sections.end(), [&](const PassingSection& s) { return s.end == end; });
    return found == sections.end() ? nullptr : &*found;
}

std::string place_of(const PassingSection& section, const char* inflow, const char* outflow,
                     const char* along) {
    return section.end == 1   ? inflow
           : section.end == 2 ? outflow
                              : fmt::format("{}x = {}", along, shown_place(section.x));
}

void add_passage_figures(const FlowRecord& record, const std::vector<PassingSection>& sections,
                         const PassageFigures& words, Analysis& analysis) {
    const std::string smoothing =
        fmt::format(" Running means over {:.2g} s, five times the time in which a long wave passes a depth.",
                    passing_stretch(*record.flow()));
    const bool space = record.flow()->channel.dimensions == 3;
    const auto axis = [&] {
        return space ? make_axis("discharge Q", "m3/s") : make_axis("discharge per unit width q", "m2/s");
    };
    Figure discharges =
        make_figure(chapters::along, words.discharges_key, words.discharges_title,
                    words.discharges_caption + smoothing, "", make_axis("time t", "s"), axis());
    Figure depths = make_figure(chapters::along, words.depths_key, words.depths_title,
                                "Depth of the water, without the gaps in it, over what it stands on at the "
                                "sections of the instruments." +
                                    smoothing,
                                "", make_axis("time t", "s"), make_axis("depth", "m"));
    Figure loop = make_figure(chapters::along, words.loop_key, words.loop_title,
                              words.loop_caption + smoothing, "", axis(), make_axis("depth", "m"));
    int variant = 0;
    for (const PassingSection& section : sections) {
        const std::string name = place_of(section, "inflow", "outflow", "");
        const std::vector<double> time = thinned(section.time);
        const std::vector<double> discharge = thinned(section.discharge);
        discharges.curves.push_back(
            make_curve(name, Origin::simulated, Mark::line, time, discharge, variant));
        if (!section.depth.empty()) {
            const std::vector<double> depth = thinned(section.depth);
            depths.curves.push_back(make_curve(name, Origin::simulated, Mark::line, time, depth, variant));
            loop.curves.push_back(make_curve(name, Origin::simulated, Mark::line, discharge, depth, variant));
        }
        ++variant;
    }
    for (Figure* const figure : {&discharges, &depths, &loop}) {
        if (!figure->curves.empty()) analysis.figures.push_back(std::move(*figure));
    }
}

}  // namespace riffle::inline analysis
