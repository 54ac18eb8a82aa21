#include "analysis/momentum_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle {

namespace {

/// A term of the budget, by sample: what it gives the water, or takes from it (negative).
struct MomentumTerm {
    std::string key;
    std::string label;
    std::vector<double> value;
};

class MomentumTerms {
  public:
    explicit MomentumTerms(const FlowRecord& record) : record_(record) {}

    /// Adds a record of an instrument times a factor; returns whether it is there.
    bool add(const std::string& instrument, const std::string& quantity, double factor, std::string key,
             std::string label, const std::string& less = "") {
        std::vector<double> values = values_of(instrument, quantity);
        if (values.empty()) return false;
        if (!less.empty()) {
            const std::vector<double> other = values_of(instrument, less);
            if (other.size() != values.size()) return false;
            for (std::size_t i = 0; i < values.size(); ++i) values[i] -= other[i];
        }
        for (double& value : values) value *= factor;
        terms_.push_back({std::move(key), std::move(label), std::move(values)});
        return true;
    }
    [[nodiscard]] std::vector<MomentumTerm>& terms() { return terms_; }

    [[nodiscard]] std::vector<double> values_of(const std::string& instrument,
                                                const std::string& quantity) const {
        for (const ScalarProbe& probe : record_.scalar_probes()) {
            if (probe.name == instrument && probe.quantity == quantity) return probe.value;
        }
        return {};
    }

  private:
    const FlowRecord& record_;
    std::vector<MomentumTerm> terms_;
};

/// Rate of change of the stored momentum over the window, from its first to its last sample.
double rate_of_change(const FlowRecord& record) {
    const std::vector<double> time = within_window(record, fields::time_series.time);
    const std::vector<double> momentum = within_window(record, fields::time_series.momentum_stored);
    if (time.size() < 2 || momentum.size() != time.size() || !(time.back() > time.front())) return 0.0;
    return (momentum.back() - momentum.front()) / (time.back() - time.front());
}

}  // namespace

void add_momentum_budget(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    if (c.channel.ends != Ends::open) return;
    const std::string ends = "standard_end_sections";
    const std::string forces = "standard_force";
    const auto& of = fields::forces;
    MomentumTerms budget(record);
    const std::string flux = fields::flow_rate.momentum_flux.name;
    const std::string pressure = fields::flow_rate.pressure_force.name;
    const bool whole =
        budget.add(ends, flux + "_1", 1.0, "inflow", "momentum that flows in") &&
        budget.add(ends, pressure + "_1", 1.0, "inflow_pressure", "pressure on the section at the inflow") &&
        budget.add(ends, flux + "_2", -1.0, "outflow", "momentum that flows out") &&
        budget.add(ends, pressure + "_2", -1.0, "outflow_pressure",
                   "pressure on the section at the outflow") &&
        budget.add(forces, of.weight_component.name, 1.0, "weight", "weight down the slope") &&
        budget.add(forces, of.bed_drag.name, -1.0, "bed_drag", "drag of the bed elements");
    if (!whole) return;
    budget.add(forces, of.side_wall_drag.name, -1.0, "side_walls", "drag of the side walls");
    budget.add(forces, of.vegetation_drag.name, -1.0, "vegetation", "drag of the vegetation");
    budget.add(forces, of.porous_drag.name, -1.0, "porous_zones", "resistance of the porous zones");
    std::vector<double> on_walls = budget.values_of(forces, of.wall_force.name);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const std::string force = numbered_name(fields::solid_forces.force, k + 1);
        const std::string form_drag = numbered_name(fields::solid_forces.form_drag, k + 1);
        const std::string& name = c.solids[k].name;
        budget.add(forces, form_drag, -1.0, fmt::format("form_drag_{}", k + 1),
                   fmt::format("form drag of \"{}\"", name));
        budget.add(forces, force, -1.0, fmt::format("solid_friction_{}", k + 1),
                   fmt::format("friction on \"{}\"", name), form_drag);
        const std::vector<double> on_solid = budget.values_of(forces, force);
        for (std::size_t i = 0; i < on_walls.size() && on_solid.size() == on_walls.size(); ++i)
            on_walls[i] -= on_solid[i];
    }
    for (double& value : on_walls) value = -value;
    budget.terms().push_back({"walls", "force of bed and walls, without the bodies", std::move(on_walls)});

    double sum = -rate_of_change(record);
    double size = std::abs(sum);
    std::vector<Finding> findings;
    const char* const unit = c.channel.dimensions == 3 ? "N" : "N/m";
    double ends_sum = 0.0;
    for (const MomentumTerm& term : budget.terms()) {
        if (term.value.size() < 2) continue;
        const MeanEstimate mean = mean_with_confidence(term.value);
        sum += mean.mean;
        const bool at_end = term.key.find("flow") != std::string::npos;
        (at_end ? ends_sum : size) += at_end ? mean.mean : std::abs(mean.mean);
        if (mean.mean == 0.0) continue;
        findings.push_back(make_finding(chapters::forces, "momentum_" + term.key,
                                        "momentum budget: " + term.label, unit, mean.mean,
                                        trusted_half_width(mean)));
    }
    findings.push_back(make_finding(chapters::forces, "momentum_change",
                                    "momentum budget: what the water stored", unit, -rate_of_change(record),
                                    std::nullopt));
    // The ends give as much as the forces take: half of both is what passes through the budget.
    size = 0.5 * (size + std::abs(ends_sum));
    // Grains are pressed on too where the porosity changes, which nothing records.
    const bool grains = !c.porous.empty();
    Finding rest = make_finding(chapters::forces, "momentum_residual",
                                grains ? "momentum budget: pressure on the grains, and what does not close"
                                       : "momentum budget: what does not close",
                                unit, sum, std::nullopt);
    if (size > 0.0 && !grains)
        rest.remark = fmt::format("{:.3g} of what passes from the ends to the forces", sum / size);
    findings.push_back(std::move(rest));
    if (size > 0.0 && !grains) {
        findings.push_back(against(make_finding(chapters::forces, "momentum_residual_share",
                                                "the same over what passes from the ends to the forces", "1",
                                                sum / size, std::nullopt),
                                   0.0, "momentum balance"));
    }
    for (Finding& finding : findings) analysis.findings.push_back(std::move(finding));
}

}  // namespace riffle
