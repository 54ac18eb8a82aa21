// The energy budget of a run: what drives the water, what takes the energy away, and what the scheme itself
// adds or takes.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// A part of the budget: its series, the key and the label of its findings.
struct Part {
    std::optional<Field> series;  ///< none: of instruments
    const char* key;
    const char* label;
    bool input = false;  ///< drives the flow
};

std::vector<Part> budget_parts() {
    const auto& of = fields::time_series;
    return {{of.gravity_power, "gravity", "weight along the channel", true},
            {of.further_power, "further", "stirring and repulsive walls", true},
            {of.solids_power, "solids", "moving solids", true},
            {of.bed_drag_power, "bed_drag", "drag of the bed"},
            {of.vegetation_power, "vegetation", "drag of the vegetation"},
            {of.porous_power, "porous", "resistance of porous zones"},
            {of.side_wall_power, "side_walls", "drag of the side walls"},
            {of.closure_power, "closure", "eddy stresses of the closure"},
            {of.viscosity_power, "viscosity", "molecular viscosity and friction on walls"},
            {of.density_diffusion_power, "density_diffusion", "density diffusion"},
            {of.pressure_power, "pressure", "pressure of the scheme"}};
}

bool acts(const std::vector<double>& power) {
    return std::any_of(power.begin(), power.end(), [](double p) { return p != 0.0; });
}

/// Kinetic, potential and elastic energy together, by row; empty where the file lacks one of them.
std::vector<double> all_energy(const std::vector<double>& kinetic, const std::vector<double>& potential,
                               const std::vector<double>& elastic) {
    if (kinetic.size() != potential.size() || kinetic.size() != elastic.size()) return {};
    std::vector<double> sum = kinetic;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += potential[i] + elastic[i];
    return sum;
}

/// The parts that act, each with its power by row of the time series within the window.
struct Budget {
    std::vector<Part> parts;
    std::vector<std::vector<double>> powers;

    void add(const Part& part, std::vector<double> power) {
        parts.push_back(part);
        powers.push_back(std::move(power));
    }

    [[nodiscard]] std::vector<double> sum(std::size_t rows, bool inputs_alone) const {
        std::vector<double> total(rows, 0.0);
        for (std::size_t n = 0; n < parts.size(); ++n) {
            if (inputs_alone && !parts[n].input) continue;
            for (std::size_t i = 0; i < rows; ++i) total[i] += powers[n][i];
        }
        return total;
    }
};

/// What flows in through the section of an open channel at its inflow less what flows out at the other, at
/// the rows of the time series within the window; empty where no instrument knows.
std::vector<double> energy_between_ends(const FlowRecord& record) {
    const ScalarProbe* const in = find_at_end(record, fields::flow_rate.energy_flux, 1);
    const ScalarProbe* const out = find_at_end(record, fields::flow_rate.energy_flux, 2);
    if (in == nullptr || out == nullptr || in->time.size() != out->time.size()) return {};
    std::vector<double> difference = in->value;
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= out->value[i];
    std::vector<double> at_rows;
    for (const double t : within_window(record, fields::time_series.time)) {
        at_rows.push_back(
            interpolated(in->time, difference, std::clamp(t, in->time.front(), in->time.back())));
    }
    return at_rows;
}

/// Of a driven channel: the means of the parts over the window as shares of what drives the flow.
void add_shares(const FlowRecord& record, const Figure& frame, Analysis& analysis) {
    Budget budget;
    const auto& of = fields::time_series;
    const Case& c = *record.flow();
    const bool open = c.channel.ends == Ends::open;
    if (open) {
        const Part ends{.series = std::nullopt,
                        .key = "ends",
                        .label = "what flows in less what flows out",
                        .input = true};
        budget.add(ends, energy_between_ends(record));
    }
    for (const Part& part : budget_parts()) {
        if (acts(record.series()[*part.series])) budget.add(part, within_window(record, *part.series));
    }
    const std::vector<double> time = within_window(record, of.time);
    const std::vector<double> energy =
        all_energy(within_window(record, of.kinetic_energy), within_window(record, of.potential_energy),
                   within_window(record, of.elastic_energy));
    const std::size_t rows = time.size();
    const bool whole = std::all_of(budget.powers.begin(), budget.powers.end(),
                                   [&](const auto& power) { return power.size() == rows; });
    if (rows < 2 || !whole) {
        add_missing(record, analysis, frame, "the averaging window holds no budget of energy yet");
        return;
    }
    const MeanEstimate input = mean_with_confidence(budget.sum(rows, true));
    if (!(input.mean > 0.0)) {
        add_missing(
            record, analysis, frame,
            open
                ? "in the window more energy leaves through the ends than comes in and the weight brings: the "
                  "water is draining, or waves pass"
            : c.channel.lid_velocity != 0.0
                ? "the wall at the top drives the flow, and its work is among that of viscosity: there is no "
                  "input to compare with"
                : "nothing drives the flow");
        return;
    }
    const double area = c.channel.length * c.channel.flow_width();
    Finding drive =
        make_finding(chapters::energy, "energy_input", "energy that drives the flow, per plan area", "W/m2",
                     input.mean / area, trusted_half_width(input));
    if (drive.half_width) *drive.half_width /= area;
    analysis.findings.push_back(std::move(drive));
    const auto share = [&](const std::string& key, const std::string& label, const std::vector<double>& power,
                           const std::string& remark = {}) {
        const MeanEstimate mean = mean_with_confidence(power);
        Finding finding =
            make_finding(chapters::energy, "energy_share_" + key, label + " over the energy input", "1",
                         mean.mean / input.mean, trusted_half_width(mean));
        if (finding.half_width) *finding.half_width /= input.mean;
        finding.remark = remark;
        analysis.findings.push_back(std::move(finding));
    };
    Figure figure = frame;
    constexpr std::size_t most = 3000;
    const std::vector<double>& all_time = record.series()[of.time];
    int variant = 0;
    for (std::size_t n = 0; n < budget.parts.size(); ++n) {
        const Part& part = budget.parts[n];
        // Of one input there is nothing to say.
        const bool whole_input = part.input && std::count_if(budget.parts.begin(), budget.parts.end(),
                                                             [](const Part& p) { return p.input; }) == 1;
        if (!whole_input) {
            share(part.key, part.label, budget.powers[n],
                  part.series == of.pressure_power
                      ? "what pressure forces give to the motion and the continuity does not take from the "
                        "compression; none in the exact equations"
                      : "");
        }
        // What passes the ends is known within the window.
        const bool of_series = part.series.has_value();
        std::vector<double> shares = of_series ? record.series()[*part.series] : budget.powers[n];
        for (double& value : shares) value /= input.mean;
        figure.curves.push_back(make_curve(part.label, Origin::simulated, Mark::line,
                                           thinned(of_series ? all_time : time, most), thinned(shares, most),
                                           variant++));
    }
    mark_window(record, figure);
    analysis.figures.push_back(std::move(figure));

    if (energy.size() != rows || !(time.back() > time.front())) return;
    const double change = (energy.back() - energy.front()) / (time.back() - time.front());
    analysis.findings.push_back(make_finding(chapters::energy, "energy_share_change",
                                             "rate of change of the water's energy over the energy input",
                                             "1", change / input.mean));
    // What the parts leave open is the stepping's, and the filters'.
    std::vector<double> scheme(rows, change);
    const std::vector<double> all = budget.sum(rows, false);
    for (std::size_t i = 0; i < rows; ++i) scheme[i] -= all[i];
    if (open) {
        const Numerics& numerics = record.flow()->numerics;
        const bool damped = numerics.impact_dissipation > 0.0 || numerics.acoustic_damping > 0.0;
        share("residual", "what the budget leaves open", scheme,
              fmt::format(
                  "the change of the energy less all other parts: {}time stepping, and what the sections "
                  "at the ends miss, whose fluxes are far larger than their difference",
                  damped ? "what numerics.impact_dissipation and acoustic_damping take, " : ""));
        return;
    }
    share("stepping", "time stepping, filters and spray", scheme,
          "the change of the energy less all other parts, sampled once each row");
    for (std::size_t n = 0; n < budget.parts.size(); ++n) {
        if (budget.parts[n].series != of.pressure_power) continue;
        for (std::size_t i = 0; i < rows; ++i) scheme[i] += budget.powers[n][i];
    }
    share("scheme", "what the scheme itself adds", scheme, "pressure and stepping; below zero: takes");
}

/// Of a flow that nothing drives steadily: the work of the parts since the start.
void add_works(const FlowRecord& record, Figure figure, Analysis& analysis) {
    const auto& of = fields::time_series;
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[of.time];
    const std::vector<double>& kinetic = series[of.kinetic_energy];
    const std::vector<double> energy =
        all_energy(kinetic, series[of.potential_energy], series[of.elastic_energy]);
    if (time.size() < 2 || energy.size() != time.size()) {
        add_missing(record, analysis, std::move(figure), "the results file holds no budget of energy yet");
        return;
    }
    const double largest = *std::max_element(kinetic.begin(), kinetic.end());
    std::vector<double> rest(energy.size());
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = energy[i] - energy.front();
    figure.curves.push_back(
        make_curve("change of the energy", Origin::simulated, Mark::line, thinned(time), thinned(rest)));
    int variant = 1;
    double scheme = 0.0;
    const auto finding = [&](const std::string& key, const std::string& label, double work,
                             const char* remark = "") {
        if (!(largest > 0.0)) return;
        Finding found =
            make_finding(chapters::energy, "energy_work_" + key,
                         "work of " + label + " over the largest kinetic energy", "1", work / largest);
        found.remark = remark;
        analysis.findings.push_back(std::move(found));
    };
    for (const Part& part : budget_parts()) {
        const std::vector<double>& power = series[*part.series];
        if (power.size() != time.size() || !acts(power)) continue;
        std::vector<double> work(power.size(), 0.0);
        for (std::size_t i = 1; i < work.size(); ++i) {
            work[i] = work[i - 1] + 0.5 * (power[i] + power[i - 1]) * (time[i] - time[i - 1]);
        }
        for (std::size_t i = 0; i < work.size(); ++i) rest[i] -= work[i];
        if (part.series == of.pressure_power) scheme += work.back();
        finding(part.key, part.label, work.back());
        figure.curves.push_back(
            make_curve(part.label, Origin::simulated, Mark::line, thinned(time), thinned(work), variant++));
    }
    figure.curves.push_back(make_curve("the rest: time stepping, filters, contact", Origin::simulated,
                                       Mark::line, thinned(time), thinned(rest), variant));
    finding("rest", "time stepping, filters and contact", rest.back(),
            "the change of the energy less the work of all other parts, whose powers are known each row");
    finding("scheme", "the scheme itself", scheme + rest.back(),
            "pressure and the rest; below zero: it takes");
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

void analyse_energy(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const Case& c = *record.flow();
    const bool driven = is_channel(flow_kind(c));
    const bool space = c.channel.dimensions == 3;
    if (driven) {
        add_shares(
            record,
            make_figure(chapters::energy, "energy_budget", "Energy budget",
                        "What drives the flow and what takes its energy, from the sums over pairs of "
                        "particles, each over the mean of what drives it in the averaging window. Above "
                        "zero the water gains.",
                        "", make_axis("time t", "s"), make_axis("power over energy input", "1")),
            analysis);
        return;
    }
    add_works(
        record,
        make_figure(chapters::energy, "energy_budget", "Energy budget",
                    "Work on the water since the start by each part, from the sums over pairs of particles, "
                    "and the change of its kinetic, potential and elastic energy. Above zero the water "
                    "gains.",
                    "", make_axis("time t", "s"),
                    space ? make_axis("work", "J") : make_axis("work per unit width", "J/m")),
        analysis);
}

}  // namespace riffle::inline analysis
