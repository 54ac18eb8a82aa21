#include "report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/drowned_inflow.hpp"
#include "case/bed_traits.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "column/column.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline report {

namespace {

/// A difference in words: "0.31 % above", "equal to (within 0.05 %)".
std::string against(double value, double reference) {
    const double share = 100 * (value / reference - 1);
    if (std::abs(share) < 0.05) return "within 0.05 % of";
    return fmt::format("{:.{}f} % {}", std::abs(share), std::abs(share) < 10 ? 1 : 0,
                       share > 0 ? "above" : "below");
}

/// `where`: of which part of the water, `twin`: "column" or "section"; `layered`: the particles slide in
/// layers, whose order changes more slowly than any run lasts.
std::string velocity_sentence(const SummaryRow& mean, const char* where, const char* twin, bool layered) {
    // Starts of other noise, and one run taken on to 100 s: docs/theory.md, section 14.
    constexpr double known = 0.002;
    const SummaryValue& simulated = *mean.simulated;
    std::string text = fmt::format("The depth-mean velocity {} is {:.4g}", where, simulated.value);
    if (simulated.half_width) text += fmt::format(" ± {:.2g}", *simulated.half_width);
    text += " m/s";
    if (simulated.half_width) {
        text +=
            layered && *simulated.half_width < known * simulated.value
                ? " (95 % interval of what the window holds; as the particles change their order slowly, such a mean is "
                  "known to 0.2 %)"
                : " (95 % interval)";
    }
    std::string joint = ": ";
    if (mean.measured && mean.measured->value != 0) {
        text += fmt::format("{}{} the measured {:.3g} m/s", joint,
                            against(simulated.value, mean.measured->value), mean.measured->value);
        joint = ", ";
    }
    if (mean.column && mean.column->value != 0) {
        text += fmt::format("{}{} the {} twin's {:.4g} m/s", joint,
                            against(simulated.value, mean.column->value), twin, mean.column->value);
    }
    return text + ".";
}

/// `resolved`: a profile of eddies that the particles carry is short and wavy, so that the law has the
/// friction velocity of the stress.
void add_friction(std::vector<std::string>& sentences, const std::vector<SummaryRow>& quantities,
                  bool resolved) {
    const SummaryRow* const friction = find_quantity(quantities, "friction_velocity");
    if (friction == nullptr || !friction->simulated) return;
    std::string text = fmt::format("The friction velocity is {:.3g} m/s", friction->simulated->value);
    if (friction->measured) {
        text += fmt::format(", {} the measured {:.3g} m/s",
                            against(friction->simulated->value, friction->measured->value),
                            friction->measured->value);
    }
    const SummaryRow* const roughness =
        find_quantity(quantities, resolved ? "stress_equivalent_roughness" : "equivalent_roughness");
    if (roughness != nullptr && roughness->simulated) {
        text += fmt::format("; the bed acts with an equivalent roughness of {:.1f} mm",
                            1000 * roughness->simulated->value);
        if (roughness->measured) {
            text += fmt::format(" (measured {:.0f} mm)", 1000 * roughness->measured->value);
        }
    }
    sentences.push_back(text + ".");
}

std::string health_sentence(const std::vector<Diagnostic>& diagnostics, Health worst) {
    const auto checks = std::count_if(diagnostics.begin(), diagnostics.end(),
                                      [](const Diagnostic& d) { return d.mark != Health::none; });
    if (worst == Health::good) return fmt::format("All health checks ({}) are in their ranges.", checks);
    std::string list;
    for (const Diagnostic& row : diagnostics) {
        if (row.mark != Health::caution && row.mark != Health::bad) continue;
        std::string label = row.label;
        std::transform(label.begin(), label.begin() + 1, label.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        list +=
            fmt::format("{}{} ({}; healthy: {})", list.empty() ? "" : "; ", label, row.value, row.healthy);
    }
    return "Outside the healthy range: " + list + ".";
}

std::string steady_headline(bool converged, Health worst) {
    const std::string state = converged ? "The run has converged" : "The run has not converged";
    switch (worst) {
        case Health::none:
            return state + "; it was not checked for health.";
        case Health::good:
            return state + (converged ? " and is healthy." : ", but is healthy so far.");
        case Health::caution:
            return state + "; something should be watched.";
        case Health::bad:
            break;
    }
    return state + (converged ? ", but it is not healthy." : " and is not healthy.");
}

}  // namespace

namespace {

Health worst_of(const std::vector<Diagnostic>& diagnostics) {
    Health worst = Health::none;
    for (const Diagnostic& row : diagnostics) {
        if (row.mark == Health::none) continue;
        worst = worst == Health::none ? row.mark : std::max(worst, row.mark);
    }
    return worst;
}

/// Headline of a run that is to reach its end, not to converge.
std::string ended_headline(bool complete, Health worst) {
    const std::string state = complete ? "The run is complete" : "The run has not ended";
    switch (worst) {
        case Health::none:
            return state + "; it was not checked for health.";
        case Health::good:
            return state + (complete ? " and is healthy." : ", and is healthy so far.");
        case Health::caution:
            return state + "; something should be watched.";
        case Health::bad:
            break;
    }
    return state + ", but it is not healthy.";
}

/// "q = 0.012 ± 0.001 m2/s", of a row of the summary.
std::optional<std::string> quantity_text(const std::vector<SummaryRow>& quantities, const char* key,
                                         const char* name) {
    const SummaryRow* const found = find_quantity(quantities, key);
    if (found == nullptr || !found->simulated) return std::nullopt;
    const SummaryValue& value = *found->simulated;
    std::string text = fmt::format("{} {:.4g}", name, found->factor * value.value);
    if (value.half_width) text += fmt::format(" ± {:.2g}", found->factor * *value.half_width);
    if (found->unit != "1") text += " " + found->unit;
    return text;
}

void add_why_no_twin(const Case& c, Verdict& verdict) {
    if (auto reason = why_no_column(c)) {
        std::erase(*reason, '`');  // names of commands; the page has no marks for them
        verdict.sentences.push_back("There is no twin to compare with: " + *reason + ".");
    }
}

void judge_uniform(const ReportData& data, const std::vector<SummaryRow>& quantities, Verdict& verdict) {
    const Case& c = data.flow;
    const bool layered = has_spheres(c.bed) && has_mixing_length(c) && c.channel.dimensions == 2;
    // Between side walls the measured velocity is that of the centreline.
    const SummaryRow* const centre = find_quantity(quantities, "centreline_velocity");
    if (centre != nullptr && centre->simulated) {
        verdict.sentences.push_back(
            velocity_sentence(*centre, "above the datum around the centreline", "section", layered));
    }
    const char* const twin = data.flow.has_side_walls() ? "section" : "column";
    const char* const where =
        data.flow.has_side_walls() ? "above the datum over the whole width" : "above the datum";
    const SummaryRow& mean = *find_quantity(quantities, "depth_mean_velocity");
    verdict.sentences.push_back(velocity_sentence(mean, where, twin, layered));
    add_friction(verdict.sentences, quantities, resolves_eddies(data.flow));
    // A section may have a twin where a column has none.
    if (!mean.column) add_why_no_twin(data.flow, verdict);
}

/// What came in and went out of a flood; nothing of a flow without a hydrograph.
void judge_flood(const std::vector<SummaryRow>& quantities, Verdict& verdict) {
    std::vector<const SummaryRow*> crests;
    for (const SummaryRow& row : quantities) {
        if (row.key.rfind("flood_discharge_", 0) == 0 && row.simulated) crests.push_back(&row);
    }
    if (crests.empty()) return;
    if (crests.size() > 2) crests.erase(crests.begin() + 1, crests.end() - 1);
    std::string text = "A flood passes:";
    const char* joint = " ";
    for (const SummaryRow* const row : crests) {
        std::string name = row->label;
        name.front() = 'l';
        text += fmt::format("{}{} {:.4g} {}", joint, name, row->factor * row->simulated->value, row->unit);
        joint = ", ";
    }
    if (const auto level =
            quantity_text(quantities, "flood_highest_level", "highest level recorded along the channel")) {
        text += joint + *level;
    }
    verdict.sentences.push_back(text + ".");
}

/// How the water went up and down at the ends under a tailwater that changes; nothing of a steady one.
void judge_tailwater(const std::vector<SummaryRow>& quantities, Verdict& verdict) {
    // The rows of each section, in their order downstream.
    const auto rows = [&](const char* key) {
        std::vector<const SummaryRow*> found;
        for (const SummaryRow& row : quantities) {
            if (row.key.rfind(key, 0) == 0 && row.simulated) found.push_back(&row);
        }
        return found;
    };
    const auto number = [](const SummaryRow& row) { return row.factor * row.simulated->value; };
    const auto low = rows("tailwater_low_");
    const auto high = rows("tailwater_high_");
    const auto range = rows("tailwater_range_");
    const auto smallest = rows("tailwater_smallest_discharge_");
    const auto largest = rows("tailwater_largest_discharge_");
    if (low.empty() || smallest.empty()) return;
    std::string text = fmt::format(
        "The tailwater changes: at the section furthest downstream the depth goes from {:.4g} to {:.4g} {} "
        "and the discharge from {:.3g} to {:.3g} {}",
        number(*low.back()), number(*high.back()), low.back()->unit, number(*smallest.back()),
        number(*largest.back()), smallest.back()->unit);
    if (smallest.back()->simulated->value < 0.0) text += ", less than zero where the flow turns";
    if (range.size() > 1 && range.back()->simulated->value > 0.0) {
        text += fmt::format("; {:.3g} % of that range of the depth arrive at the section furthest upstream",
                            100.0 * range.front()->simulated->value / range.back()->simulated->value);
    }
    verdict.sentences.push_back(text + ".");
}

void judge_bodies(const ReportData& data, const std::vector<SummaryRow>& quantities, Verdict& verdict) {
    const bool bodies_stand = !data.flow.solids.empty();
    std::string text = changes_at_ends(data.flow) ? "Means over the window:"
                       : bodies_stand             ? "Mean flow around the bodies:"
                                                  : "Mean flow along the channel:";
    const char* joint = " ";
    for (const auto& [key, name] :
         {std::pair{"unit_discharge", "discharge per unit width"},
          std::pair{"depth_mean_velocity", "depth-mean velocity"},
          std::pair{"highest_level", "highest mean level"}, std::pair{"lowest_level", "lowest"},
          std::pair{"largest_froude", "largest Froude number"}}) {
        if (const auto part = quantity_text(quantities, key, name)) {
            text += joint + *part;
            joint = ", ";
        }
    }
    verdict.sentences.push_back(text + ".");
    judge_flood(quantities, verdict);
    judge_tailwater(quantities, verdict);
    const SummaryRow* const drowned = find_quantity(quantities, "drowned_inflow_depth");
    if (drowned != nullptr && drowned->simulated) {
        verdict.sentences.push_back(fmt::format("The depth at the inflow is {:.4g} {}, {}.",
                                                drowned->factor * drowned->simulated->value, drowned->unit,
                                                drowned_inflow_text(data.flow)));
    }
    const SummaryRow* const bodies = find_quantity(quantities, "solid_force_share");
    if (bodies != nullptr && bodies->simulated) {
        verdict.sentences.push_back(fmt::format("The bodies take {:.1f} % of the water's weight component.",
                                                100.0 * bodies->simulated->value));
    }
    if (data.flow.channel.ends == Ends::open && !bodies_stand) {
        const SummaryRow* const curve = find_quantity(quantities, "backwater_departure");
        if (curve != nullptr && curve->simulated) {
            verdict.sentences.emplace_back(fmt::format(
                "What the ends give rules the flow; the mean level departs by at most {:.3g} % of the depth from "
                "the steady varied flow between them, which stands beside the long profile.",
                100.0 * std::abs(curve->simulated->value)));
        }
    } else {
        add_why_no_twin(data.flow, verdict);
    }
}

void judge_course(const ReportData& data, const std::vector<SummaryRow>& quantities, Verdict& verdict) {
    std::string text;
    for (const SummaryRow& row : quantities) {
        if (!row.theory || !row.simulated || row.theory->value == 0.0) continue;
        text += fmt::format("{}{} {:.4g} {}, {} theory's {:.4g}", text.empty() ? "" : "; ", row.label,
                            row.factor * row.simulated->value, row.unit,
                            against(row.simulated->value, row.theory->value), row.factor * row.theory->value);
    }
    if (!text.empty()) verdict.sentences.push_back(text + ".");
    const double time = recorded_time(data);
    verdict.sentences.push_back(
        fmt::format("A {}, {:.4g} s of it; nothing drives a steady mean flow, so none is judged.",
                    flow_kind_name(flow_kind(data.flow)), time));
}

/// What else a run was found to be, it has failed: what is shown is of the time before.
void tell_failure(const ReportData& data, Verdict& verdict) {
    verdict.mark = Health::bad;
    verdict.headline = fmt::format("The run failed after {:.4g} s.", recorded_time(data));
    const std::string cause = data.failure.substr(0, data.failure.find('\n'));
    verdict.sentences.insert(verdict.sentences.begin(),
                             {cause + (cause.ends_with('.') ? "" : "."),
                              "What is shown below is of the time before the failure; the log of the run "
                              "(run.log) says what to look at and how to go on."});
}

Verdict judge_flow(const ReportData& data, const std::vector<SummaryRow>& quantities,
                   const std::vector<Diagnostic>& diagnostics) {
    Verdict verdict;
    const FlowKind kind = flow_kind(data.flow);
    const SummaryRow* const mean = find_quantity(quantities, "depth_mean_velocity");
    const bool averaged = mean != nullptr && mean->simulated.has_value();
    const double time = recorded_time(data);
    if (is_channel(kind) ? !averaged : time <= 0.0) {
        verdict.headline =
            data.complete ? "The run ended without time averages." : "The run has no time averages yet.";
        if (time > 0) {
            verdict.sentences.push_back(fmt::format("It has reached {:.2f} s of simulated time.", time));
        }
        verdict.sentences.emplace_back("What the results file holds so far is shown below.");
        return verdict;
    }

    const Health worst = worst_of(diagnostics);
    verdict.mark = worst;
    // Flows with a column twin are tested for convergence, and those between open ends that are to converge.
    if (has_column(data.flow) || converges_between_ends(data.flow)) {
        const bool converged = find_value(data.summary, fields::summary.converged).value_or(0.0) != 0.0;
        if (!converged && verdict.mark == Health::good) verdict.mark = Health::caution;
        verdict.headline = steady_headline(converged, worst);
    } else {
        if (!data.complete && verdict.mark == Health::good) verdict.mark = Health::caution;
        verdict.headline = ended_headline(data.complete, worst);
    }
    switch (kind) {
        case FlowKind::uniform_channel:
            judge_uniform(data, quantities, verdict);
            break;
        case FlowKind::channel_with_bodies:
        case FlowKind::open_channel:
            judge_bodies(data, quantities, verdict);
            break;
        case FlowKind::tank:
        case FlowKind::standing_wave:
        case FlowKind::periodic_box:
            judge_course(data, quantities, verdict);
            break;
    }
    if (worst != Health::none) verdict.sentences.push_back(health_sentence(diagnostics, worst));
    if (!data.flow.measured.uniform) {
        verdict.sentences.emplace_back(
            "The measured flow was not uniform, so the comparison with it is only an indication.");
    }
    if (!data.complete && data.failure.empty()) {
        verdict.sentences.push_back(
            fmt::format("The run had not ended when this report was made ({:.2f} s so far).", time));
    }
    return verdict;
}

}  // namespace

Verdict judge(const ReportData& data, const std::vector<SummaryRow>& quantities,
              const std::vector<Diagnostic>& diagnostics) {
    Verdict verdict = judge_flow(data, quantities, diagnostics);
    if (!data.failure.empty()) tell_failure(data, verdict);
    return verdict;
}

}  // namespace riffle::inline report
