#include "analysis/fit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline analysis {

namespace {

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

/// Heights between zero plane and surface at which a law is drawn; closer near the zero plane.
std::vector<double> law_heights(double from, double to) {
    constexpr int count = 80;
    std::vector<double> heights;
    heights.reserve(count);
    for (int i = 0; i < count; ++i) {
        heights.push_back(from * std::pow(to / from, static_cast<double>(i) / (count - 1)));
    }
    return heights;
}

/// Stress of a record at heights above the bed level, over rho u_*^2; at the centreline between side walls.
struct RelativeStress {
    std::vector<double> z, value;
};
RelativeStress relative_stress(const FlowRecord& record, double scale) {
    const Case& c = *record.flow();
    const Profiles& p = record.profiles();
    RelativeStress result;
    if (record.origin() == Origin::measured) {
        result = {p.z, p.reynolds_stress};
    } else if (c.has_side_walls()) {
        if (record.mean_field().empty()) return {};
        const SectionProfile profile =
            strip_profile(record.mean_field(), centreline_strip(c),
                          [&c](const FieldSums& s) { return total_stress(s, c.fluid.density, false); });
        result = {profile.z, profile.value};
    } else {
        result = {p.bin_upper, p.total_stress};
    }
    if (result.value.size() != result.z.size()) return {};
    for (double& value : result.value) value /= scale;
    return result;
}

/// What a phase means, for the remark of its finding.
std::string phase_remark(const FittedValue& phase) {
    if (std::abs(phase.value) > 1.0) {
        return "beyond -1 to 1, which no place in a cell has: the profile departs from the log law by "
               "something else";
    }
    if (phase.interval.contains(0.0)) return "no cell stands out: the interval holds 0";
    return phase.value > 0.0 ? "on the side of the downflow" : "on the side of the upflow";
}

void add_stress_law(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = make_figure(
        chapters::fits, "fitted_stress", "Stress with secondary flow",
        fmt::format("{} over rho g S0 h, with the line 1 - z/h of uniform flow without cells and the law of "
                    "flow with cells of secondary flow, its phase fitted.",
                    record.origin() == Origin::measured ? "Reynolds stress" : "Total shear stress"),
        "thesis (2.15), (2.27)", make_axis("stress over rho g S0 h", "1"),
        make_axis("height above the datum over depth z/h", "1"));
    const double scale = c.fluid.density * c.streamwise_gravity() * flow.depth;
    const RelativeStress stress = scale > 0.0 ? relative_stress(record, scale) : RelativeStress{};
    if (stress.z.size() < 3) {
        add_missing(record, analysis, std::move(figure), "the record holds no profile of the stress");
        return;
    }
    std::vector<double> height;
    for (const double z : stress.z) height.push_back(z - flow.points.zero_plane);
    const FitRange range{flow.whole_range.from - flow.points.zero_plane,
                         flow.whole_range.to - flow.points.zero_plane};
    const SecondaryStressFit fit = fit_secondary_flow_stress(height, stress.value, flow.depth, range);
    const auto over_depth = [&](std::vector<double> heights) {
        for (double& z : heights) z /= flow.depth;
        return heights;
    };
    figure.curves.push_back(make_curve(record.origin() == Origin::simulated ? "simulated" : "measured",
                                       record.origin(), Mark::points, stress.value, over_depth(height)));
    figure.curves.push_back(
        make_curve("without cells: 1 - z/h", Origin::theory, Mark::line, {1.0, 0.0}, {0.0, 1.0}));
    if (fit.valid) {
        Finding phase = fitted("secondary_stress_phase",
                               "phase in a cell of secondary flow, from the stress (2.27)", "1", fit.phase);
        phase.remark += (phase.remark.empty() ? "" : "; ") + phase_remark(fit.phase);
        analysis.findings.push_back(std::move(phase));
        std::vector<double> x;
        std::vector<double> y;
        constexpr int steps = 60;
        for (int i = 0; i <= steps; ++i) {
            y.push_back(static_cast<double>(i) / steps);
            x.push_back(secondary_flow_stress(y.back(), 1.0, fit.phase.value));
        }
        figure.curves.push_back(make_curve("with cells (2.27)", Origin::fit, Mark::line, x, y));
    } else {
        warn_of_failure(analysis, "stress with secondary flow", fit);
    }
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

Finding fitted(std::string key, std::string label, std::string unit, const FittedValue& value) {
    Finding finding = make_finding(chapters::fits, std::move(key), std::move(label), std::move(unit),
                                   value.value, finite(value.half_width));
    const Interval& interval = value.interval;
    const bool lopsided =
        std::abs((interval.upper - value.value) - (value.value - interval.lower)) > 0.2 * value.half_width;
    if (lopsided || !finding.half_width) {
        const bool length = finding.unit == "m";
        const double factor = length ? 1000.0 : 1.0;
        finding.remark =
            fmt::format("95 % interval {:.3g} to {:.3g}", factor * interval.lower, factor * interval.upper);
        if (finding.unit != "1") finding.remark += " " + (length ? std::string("mm") : finding.unit);
    }
    return finding;
}

Finding against_roughness(Finding finding, const Case& c, std::string remark) {
    if (!has_rough_bed(c) && c.bed.equivalent_roughness) {
        return against(std::move(finding), c.bed.equivalent_roughness, "of the bed", std::move(remark));
    }
    return against(std::move(finding), c.measured.equivalent_roughness, measured_name(c), std::move(remark));
}

void warn_of_failure(Analysis& analysis, const char* law, const FitQuality& fit) {
    analysis.warnings.push_back(fmt::format("the {} could not be fitted: {}", law, fit.why_not));
}

Curve law_curve(const char* name, int variant, const FittedFlow& flow, const FitQuality& fit,
                const std::function<double(double)>& law) {
    const std::vector<double> heights =
        law_heights(std::max(fit.from - flow.points.zero_plane, 1e-3 * flow.depth),
                    std::min(fit.to - flow.points.zero_plane, 0.995 * flow.depth));
    std::vector<double> velocity;
    std::vector<double> z;
    for (const double height : heights) {
        velocity.push_back(law(height));
        z.push_back(height + flow.points.zero_plane);
    }
    return make_curve(name, Origin::fit, Mark::line, velocity, z, variant);
}

void add_secondary_flow_laws(const FlowRecord& record, const FittedFlow& flow, Figure& laws,
                             Analysis& analysis) {
    const SecondaryFlowFit fit = fit_secondary_flow_log_law(flow.points, flow.depth, flow.friction_velocity,
                                                            log_law_kappa, flow.whole_range);
    if (fit.valid) {
        Finding phase = fitted("secondary_flow_phase",
                               "phase in a cell of secondary flow, from the velocity (2.24)", "1", fit.phase);
        const std::string with = flow.friction_velocity ? "u* from the stress" : "u* fitted, too";
        phase.remark =
            with + (phase.remark.empty() ? "" : "; " + phase.remark) + "; " + phase_remark(fit.phase);
        analysis.findings.push_back(std::move(phase));
        laws.curves.push_back(law_curve("log law with secondary flow", 5, flow, fit, [&](double height) {
            return secondary_flow_log_law(height, flow.depth, fit.friction_velocity.value,
                                          fit.zero_velocity_height.value, fit.phase.value);
        }));
    } else {
        warn_of_failure(analysis, "log law with secondary flow", fit);
    }
    add_stress_law(record, flow, analysis);
}

}  // namespace riffle::inline analysis
