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
#include "case/end_buffers.hpp"
#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

/// Samples of what the water is given, or loses (negative), at their times.
struct Samples {
    std::vector<double> time, value;
};

/// A term of the budget, by sample.
struct MomentumTerm {
    std::string key;
    std::string label;
    Samples samples;
};

/// The samples of an instrument times a factor; empty where there are none.
Samples samples(const ScalarProbe* found, double factor) {
    if (found == nullptr) return {};
    Samples of{found->time, found->value};
    for (double& value : of.value) value *= factor;
    return of;
}

/// What remains of samples less others; empty where there are not as many of both.
Samples less(Samples samples, const Samples& others) {
    if (samples.value.size() != others.value.size()) return {};
    for (std::size_t i = 0; i < samples.value.size(); ++i) samples.value[i] -= others.value[i];
    return samples;
}

/// The sections that the budget is drawn up between.
struct Sections {
    std::string instrument;
    Field momentum;      ///< series of that between them
    double share = 1.0;  ///< of the channel's length
};

/// Those in the free water beside the ends; in records of before, the ends themselves, where half of what a
/// section sums moves as prescribed, and the momentum of the buffers with that between them.
Sections sections(const FlowRecord& record, const Case& c) {
    const auto& of = fields::time_series;
    if (find_scalar(record, std::string(fields::flow_rate.momentum_flux.name) + "_1",
                    momentum_sections_name) == nullptr ||
        within_window(record, of.momentum_between_sections).empty()) {
        return {"standard_end_sections", of.momentum_stored};
    }
    const auto [first, last] = momentum_sections(c);
    return {momentum_sections_name, of.momentum_between_sections, (last - first) / c.channel.length};
}

/// What comes in and goes out with the water and by its pressure at the sections.
std::vector<MomentumTerm> terms_at_ends(const FlowRecord& record, const Sections& sections) {
    const auto at = [&](const Field& field, int end, double sign) {
        return samples(find_scalar(record, fmt::format("{}_{}", field.name, end), sections.instrument), sign);
    };
    const auto& of = fields::flow_rate;
    return {{"inflow", "momentum that flows in", at(of.momentum_flux, 1, 1.0)},
            {"inflow_pressure", "pressure on the section at the inflow", at(of.pressure_force, 1, 1.0)},
            {"outflow", "momentum that flows out", at(of.momentum_flux, 2, -1.0)},
            {"outflow_pressure", "pressure on the section at the outflow", at(of.pressure_force, 2, -1.0)}};
}

/// The forces on the water between the sections: what acts along the whole channel by their share of it.
std::vector<MomentumTerm> terms_between(const FlowRecord& record, const Case& c, double share) {
    const auto of_force = [&](const std::string& quantity, double sign) {
        return samples(find_scalar(record, quantity), sign);
    };
    const auto& of = fields::forces;
    std::vector<MomentumTerm> terms = {
        {"weight", "weight down the slope", of_force(of.weight_component.name, share)},
        {"bed_drag", "drag of the bed elements", of_force(of.bed_drag.name, -share)},
        {"side_walls", "drag of the side walls", of_force(of.side_wall_drag.name, -share)},
        {"vegetation", "drag of the vegetation", of_force(of.vegetation_drag.name, -1.0)},
        {"porous_zones", "resistance of the porous zones", of_force(of.porous_drag.name, -1.0)}};
    Samples walls = of_force(of.wall_force.name, -1.0);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Samples all = of_force(numbered_name(fields::solid_forces.force, k + 1), -1.0);
        const Samples form = of_force(numbered_name(fields::solid_forces.form_drag, k + 1), -1.0);
        const std::string& name = c.solids[k].name;
        terms.push_back({fmt::format("form_drag_{}", k + 1), fmt::format("form drag of \"{}\"", name), form});
        terms.push_back({fmt::format("solid_friction_{}", k + 1), fmt::format("friction on \"{}\"", name),
                         less(all, form)});
        if (!all.value.empty()) walls = less(std::move(walls), all);
    }
    // Wall particles continue the pressure of the water above them, so that where the depth changes along the
    // channel they push along the bed, as deep as the kernel reaches into it (docs/theory.md 20). The
    // pressure on the sections has that part already. Beds that drag by a law or not at all have no other
    // force.
    if (is_no_slip(c.bed) || is_duct(c)) {
        for (double& value : walls.value) value *= share;
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
            const std::vector<double>& values = term.samples.value;
            if (values.empty()) continue;
            const MeanEstimate mean = mean_with_confidence(values);
            if (terms == &at_ends) pressing = std::max(pressing, std::abs(mean.mean));
            const std::optional<double> half_width = trusted_half_width(mean);
            squares =
                squares && half_width ? std::optional(*squares + *half_width * *half_width) : std::nullopt;
            if (sum.empty()) sum.resize(values.size(), 0.0);
            at_one_time = at_one_time && sum.size() == values.size();
            for (std::size_t i = 0; at_one_time && i < sum.size(); ++i) sum[i] += values[i];
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

/// The change of the stored momentum over the window, and the means that belong to it. It lies between the
/// means of the first and the last tenth of the rows, for single moments count whole rows of particles that
/// have just come in or gone out; so what changes the momentum counts from the rows of the first tenth on
/// that have passed, and less by each row of the last tenth.
class Change {
  public:
    Change(const FlowRecord& record, const Field& stored) {
        const std::vector<double> time = within_window(record, fields::time_series.time);
        const std::vector<double> momentum = within_window(record, stored);
        if (time.size() < 2 || momentum.size() != time.size() || !(time.back() > time.front())) return;
        const auto tenth = static_cast<std::ptrdiff_t>((time.size() + 9) / 10);
        first_.assign(time.begin(), time.begin() + tenth);
        last_.assign(time.end() - tenth, time.end());
        const auto change = [&](const std::vector<double>& values) {
            return std::accumulate(values.end() - tenth, values.end(), 0.0) -
                   std::accumulate(values.begin(), values.begin() + tenth, 0.0);
        };
        rate_ = change(momentum) / change(time);
    }

    /// Change of the momentum in a time, N/m or N.
    [[nodiscard]] double rate() const { return rate_; }

    /// Mean of what changed it; the plain mean where nothing is known of the change.
    [[nodiscard]] double mean(const Samples& samples) const {
        double sum = 0.0;
        double weights = 0.0;
        for (std::size_t i = 0; i < samples.value.size(); ++i) {
            const double weight =
                first_.empty() ? 1.0 : passed(first_, samples.time[i]) - passed(last_, samples.time[i]);
            sum += weight * samples.value[i];
            weights += weight;
        }
        return weights > 0.0 ? sum / weights : mean_of(samples.value);
    }

  private:
    /// Share of the rows up to a time, one at that time by half.
    static double passed(const std::vector<double>& rows, double time) {
        const auto [before, after] = std::equal_range(rows.begin(), rows.end(), time);
        return 0.5 * static_cast<double>((before - rows.begin()) + (after - rows.begin())) /
               static_cast<double>(rows.size());
    }

    std::vector<double> first_, last_;
    double rate_ = 0.0;
};

}  // namespace

void add_momentum_budget(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    if (c.channel.ends != Ends::open) return;
    const Sections between_what = sections(record, c);
    const std::vector<MomentumTerm> at_ends = terms_at_ends(record, between_what);
    const std::vector<MomentumTerm> between = terms_between(record, c, between_what.share);
    const auto missing = [](const MomentumTerm& term) { return term.samples.value.empty(); };
    if (std::any_of(at_ends.begin(), at_ends.end(), missing) ||
        std::all_of(between.begin(), between.end(), missing)) {
        return;
    }
    std::vector<Finding> findings;
    const char* const unit = c.channel.dimensions == 3 ? "N" : "N/m";
    const Change change(record, between_what.momentum);
    const auto add = [&](const MomentumTerm& term) {
        if (term.samples.value.empty()) return 0.0;
        const double mean = change.mean(term.samples);
        if (mean != 0.0) {
            findings.push_back(make_finding(chapters::forces, "momentum_" + term.key,
                                            "momentum budget: " + term.label, unit, mean,
                                            trusted_half_width(mean_with_confidence(term.samples.value))));
        }
        return mean;
    };
    const double stored = -change.rate();
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
