// What the profile of the velocity says where the friction velocity is known from the stress.

#include <fmt/format.h>

#include <string>
#include <utility>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/fit_parts.hpp"
#include "hydraulics/channel_laws.hpp"
#include "hydraulics/law_fits.hpp"

namespace riffle::inline analysis {

void add_roughness_of_stress(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis) {
    if (!flow.friction_velocity) return;
    const RoughnessFit fit =
        fit_roughness(flow.points, *flow.friction_velocity, flow.friction_velocity_half_width, log_law_kappa,
                      flow.log_law_range);
    if (!fit.valid) {
        warn_of_failure(analysis, "roughness with u* from the stress", fit);
        return;
    }
    const Case& c = *record.flow();
    const Measured& measured = c.measured;
    Finding finding = fitted("stress_equivalent_roughness", "ks of the log law with u* from the stress", "m",
                             fit.equivalent_roughness);
    std::string remark = finding.remark;
    if (measured.friction_velocity && measured.depth_mean_velocity && measured.equivalent_roughness) {
        // The three are not independent: the law has one mean velocity for a u_* and a k_s.
        const double of_mean = equivalent_roughness_from_mean(c.channel.depth, *measured.friction_velocity,
                                                              *measured.depth_mean_velocity);
        remark += fmt::format("{}the measured U and u* have {:.4g} m by the same law",
                              remark.empty() ? "" : "; ", of_mean);
    }
    analysis.findings.push_back(against_roughness(std::move(finding), c, remark));
}

void add_kappa(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis) {
    if (!flow.friction_velocity) return;
    const double length = record.flow()->fluid.kinematic_viscosity / *flow.friction_velocity;
    const KappaFit fit = fit_kappa(flow.points, *flow.friction_velocity, flow.friction_velocity_half_width,
                                   length, flow.log_law_range);
    if (!fit.valid) {
        warn_of_failure(analysis, "check of kappa", fit);
        return;
    }
    Finding finding =
        against(fitted("kappa", "von Karman's constant with u* from the stress", "1", fit.kappa),
                log_law_kappa, "thesis (2.1)");
    if (finding.remark.empty()) finding.remark = "check of Nezu & Rodi (1986)";
    analysis.findings.push_back(std::move(finding));
}

}  // namespace riffle::inline analysis
