#include "analysis/momentum_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// A term of the budget, by sample: what it gives the water, or takes from it (negative).
struct MomentumTerm {
    std::string key;
    std::string label;
    std::vector<double> value;
};

/// The samples of an instrument times a factor; empty where there are none.
std::vector<double> samples(const ScalarProbe* found, double factor) {
    std::vector<double> values = found != nullptr ? found->value : std::vector<double>{};
    for (double& value : values) value *= factor;
    return values;
}

/// What remains of samples less others; empty where there are not as many of both.
std::vector<double> less(std::vector<double> values, const std::vector<double>& others) {
    if (values.size() != others.size()) return {};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= others[i];
    return values;
}

/// What comes in and goes out with the water and by its pressure at the sections of both ends.
std::vector<MomentumTerm> terms_at_ends(const FlowRecord& record) {
    const auto at = [&](const Field& field, int end, double sign) {
        return samples(find_at_end(record, field, end), sign);
    };
    const auto& of = fields::flow_rate;
    return {{"inflow", "momentum that flows in", at(of.momentum_flux, 1, 1.0)},
            {"inflow_pressure", "pressure on the section at the inflow", at(of.pressure_force, 1, 1.0)},
            {"outflow", "momentum that flows out", at(of.momentum_flux, 2, -1.0)},
            {"outflow_pressure", "pressure on the section at the outflow", at(of.pressure_force, 2, -1.0)}};
}

/// The forces on the water between the ends.
std::vector<MomentumTerm> terms_between(const FlowRecord& record, const Case& c) {
    const auto of_force = [&](const std::string& quantity, double sign) {
        return samples(find_scalar(record, quantity, "standard_force"), sign);
    };
    const auto& of = fields::forces;
    std::vector<MomentumTerm> terms = {
        {"weight", "weight down the slope", of_force(of.weight_component.name, 1.0)},
        {"bed_drag", "drag of the bed elements", of_force(of.bed_drag.name, -1.0)},
        {"side_walls", "drag of the side walls", of_force(of.side_wall_drag.name, -1.0)},
        {"vegetation", "drag of the vegetation", of_force(of.vegetation_drag.name, -1.0)},
        {"porous_zones", "resistance of the porous zones", of_force(of.porous_drag.name, -1.0)}};
    std::vector<double> walls = of_force(of.wall_force.name, -1.0);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const std::vector<double> all = of_force(numbered_name(fields::solid_forces.force, k + 1), -1.0);
        const std::vector<double> form = of_force(numbered_name(fields::solid_forces.form_drag, k + 1), -1.0);
        const std::string& name = c.solids[k].name;
        terms.push_back({fmt::format("form_drag_{}", k + 1), fmt::format("form drag of \"{}\"", name), form});
        terms.push_back({fmt::format("solid_friction_{}", k + 1), fmt::format("friction on \"{}\"", name),
                         less(all, form)});
        if (!all.empty()) walls = less(std::move(walls), all);
    }
    // Wall particles continue the pressure of the water above them, so that where the depth changes along the
    // channel they push along the bed, as deep as the kernel reaches into it (docs/theory.md 20). The
    // pressure on the sections has that part already. Beds that drag by a law or not at all have no other
    // force.
    if (is_no_slip(c.bed) || is_duct(c)) {
        terms.push_back({"walls", "force of bed and walls, without the bodies", std::move(walls)});
    }
    return terms;
}

/// How well the residual is known: its interval, as that of the sum of the terms in time, and a thousandth of
/// what presses on a section, which is what the sections know their pressure to (docs/open-ends.md); nothing
/// where the record is too short for an interval.
std::optional<double> uncertainty(const std::vector<MomentumTerm>& at_ends,
                                  const std::vector<MomentumTerm>& between) {
    std::vector<double> sum;
    double pressing = 0.0;
    std::optional<double> squares = 0.0;  // of the intervals of the terms, for terms of other times
    bool at_one_time = true;
    for (const std::vector<MomentumTerm>* const terms : {&at_ends, &between}) {
        for (const MomentumTerm& term : *terms) {
            if (term.value.empty()) continue;
            const MeanEstimate mean = mean_with_confidence(term.value);
            if (terms == &at_ends) pressing = std::max(pressing, std::abs(mean.mean));
            const std::optional<double> half_width = trusted_half_width(mean);
            squares =
                squares && half_width ? std::optional(*squares + *half_width * *half_width) : std::nullopt;
            if (sum.empty()) sum.resize(term.value.size(), 0.0);
            at_one_time = at_one_time && sum.size() == term.value.size();
            for (std::size_t i = 0; at_one_time && i < sum.size(); ++i) sum[i] += term.value[i];
        }
    }
    std::optional<double> half_width;
    if (at_one_time) {
        half_width = trusted_half_width(mean_with_confidence(sum));
    } else if (squares) {
        half_width = std::sqrt(*squares);
    }
    constexpr double known = 1e-3;
    return half_width ? std::optional(std::hypot(*half_width, known * pressing)) : std::nullopt;
}

/// Rate of change of the stored momentum over the window, between the means of its first and last tenth:
/// single moments count whole rows of particles that have just come in or gone out.
double rate_of_change(const FlowRecord& record) {
    const std::vector<double> time = within_window(record, fields::time_series.time);
    const std::vector<double> momentum = within_window(record, fields::time_series.momentum_stored);
    if (time.size() < 2 || momentum.size() != time.size() || !(time.back() > time.front())) return 0.0;
    const auto tenth = static_cast<std::ptrdiff_t>((time.size() + 9) / 10);
    const auto change = [&](const std::vector<double>& values) {
        return std::accumulate(values.end() - tenth, values.end(), 0.0) -
               std::accumulate(values.begin(), values.begin() + tenth, 0.0);
    };
    return change(momentum) / change(time);
}

}  // namespace

void add_momentum_budget(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    if (c.channel.ends != Ends::open) return;
    const std::vector<MomentumTerm> at_ends = terms_at_ends(record);
    const std::vector<MomentumTerm> between = terms_between(record, c);
    const auto missing = [](const MomentumTerm& term) { return term.value.empty(); };
    if (std::any_of(at_ends.begin(), at_ends.end(), missing) ||
        std::all_of(between.begin(), between.end(), missing)) {
        return;
    }
    std::vector<Finding> findings;
    const char* const unit = c.channel.dimensions == 3 ? "N" : "N/m";
    const auto add = [&](const MomentumTerm& term) {
        if (term.value.empty()) return 0.0;
        const MeanEstimate mean = mean_with_confidence(term.value);
        if (mean.mean != 0.0) {
            findings.push_back(make_finding(chapters::forces, "momentum_" + term.key,
                                            "momentum budget: " + term.label, unit, mean.mean,
                                            trusted_half_width(mean)));
        }
        return mean.mean;
    };
    const double stored = -rate_of_change(record);
    double ends = 0.0;
    for (const MomentumTerm& term : at_ends) ends += add(term);
    double sum = stored + ends;
    double sizes = std::abs(stored);
    for (const MomentumTerm& term : between) {
        const double mean = add(term);
        sum += mean;
        sizes += std::abs(mean);
    }
    findings.push_back(make_finding(chapters::forces, "momentum_change",
                                    "momentum budget: what the water stored", unit, stored, std::nullopt));
    // The ends give as much as the forces take: half of both is what passes through the budget.
    const double size = 0.5 * (sizes + std::abs(ends));
    const std::optional<double> known = uncertainty(at_ends, between);
    // Grains are pressed on too where the porosity changes, which nothing records.
    const bool grains = !c.porous.empty();
    Finding rest = make_finding(chapters::forces, "momentum_residual",
                                grains ? "momentum budget: pressure on the grains, and what does not close"
                                       : "momentum budget: what does not close",
                                unit, sum, known);
    if (size > 0.0 && !grains) {
        rest.remark = fmt::format("{:.3g} of what passes from the ends to the forces", sum / size);
    }
    findings.push_back(std::move(rest));
    if (size > 0.0 && !grains) {
        findings.push_back(
            against(make_finding(chapters::forces, "momentum_residual_share",
                                 "the same over what passes from the ends to the forces", "1", sum / size,
                                 known ? std::optional(*known / size) : std::nullopt),
                    0.0, "momentum balance"));
    }
    for (Finding& finding : findings) analysis.findings.push_back(std::move(finding));
}

}  // namespace riffle::inline analysis
