// The numbers of the channel that follow from its mean velocity.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "base/error.hpp"
#include "column/wide_channel.hpp"
#include "hydraulics/channel_laws.hpp"
#include "record/flow_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// The friction factor by Colebrook and White; not-a-number where the equation has no root.
double colebrook_white(double roughness, double radius, double reynolds) {
    try {
        return colebrook_white_friction_factor(roughness, radius, reynolds);
    } catch (const InputError&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

void add_friction_figure(const Case& c, Origin origin, const Analysis& analysis, double velocity,
                         double factor, Figure& figure) {
    const double depth = c.channel.depth;
    const double reynolds = 4.0 * reynolds_number(velocity, depth, c.fluid.kinematic_viscosity);
    std::vector<double> relative;
    std::vector<double> law;
    constexpr int points = 60;
    for (int i = 0; i < points; ++i) {
        const double at = 0.01 * std::pow(200.0, static_cast<double>(i) / (points - 1));
        relative.push_back(at);
        law.push_back(colebrook_white(at * depth, depth, reynolds));
    }
    figure.curves.push_back(make_curve(fmt::format("Colebrook-White (2.9), Re = {:.3g}", reynolds),
                                       Origin::theory, Mark::line, relative, law));
    const Finding* const roughness = find_finding(analysis, "equivalent_roughness");
    if (roughness != nullptr) {
        figure.curves.push_back(
            make_curve("this flow", origin, Mark::points, {roughness->value / depth}, {factor}));
    }
    if (origin == Origin::simulated && c.measured.depth_mean_velocity && c.measured.equivalent_roughness) {
        figure.curves.push_back(
            make_curve("measured", Origin::measured, Mark::points, {*c.measured.equivalent_roughness / depth},
                       {friction_factor(c.streamwise_gravity(), depth, *c.measured.depth_mean_velocity)}));
    }
}

}  // namespace

void add_channel_numbers(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    // Between side walls the centreline is what was measured, and what is nearest to a wide channel.
    const std::vector<double> centreline =
        c.has_side_walls() && record.origin() == Origin::simulated
            ? within_window(record, fields::time_series.centreline_velocity)
            : std::vector<double>{};
    const bool at_centreline = centreline.size() > 1;
    const std::vector<double> samples =
        at_centreline ? centreline : within_window(record, fields::time_series.depth_mean_velocity);
    const MeanEstimate mean = samples.size() > 1 ? mean_with_confidence(samples) : MeanEstimate{};
    const double velocity = at_centreline ? mean.mean : bulk_velocity(record);
    if (velocity <= 0.0) return;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double half_width = samples.size() > 1 ? trusted_half_width(mean).value_or(unknown) : unknown;
    const WideChannel channel = wide_channel(c);
    const auto add = [&](const char* key, const char* label, const char* unit,
                         const std::function<double(double)>& law) {
        Finding finding = make_finding(chapters::fits, key, label, unit, law(velocity));
        if (half_width < velocity) {
            finding.half_width = 0.5 * std::abs(law(velocity + half_width) - law(velocity - half_width));
        }
        if (c.measured.depth_mean_velocity && record.origin() == Origin::simulated) {
            finding =
                against(std::move(finding), law(*c.measured.depth_mean_velocity), "from the measured U");
        }
        if (at_centreline) finding.remark = "with the depth-mean velocity around the centreline";
        analysis.findings.push_back(std::move(finding));
    };
    const bool between_walls = channel.hydraulic_radius < channel.depth;
    add("friction_factor",
        between_walls ? "friction factor f (2.6) between two walls, R = h/2"
                      : "friction factor f (2.6), wide channel",
        "1", [&](double u) { return channel.friction_factor(u); });
    const double factor = channel.friction_factor(velocity);
    if (const Finding* const roughness = find_finding(analysis, "equivalent_roughness")) {
        const double law = colebrook_white(roughness->value, channel.depth, 4.0 * channel.reynolds(velocity));
        Finding finding = make_finding(chapters::fits, "colebrook_white_friction_factor",
                                       "f by Colebrook-White (2.9) from the fitted ks", "1", law);
        if (std::isfinite(law)) {
            analysis.findings.push_back(
                against(std::move(finding), factor, "f of this flow",
                        "the law integrates the log profile from the bed; at such large ks/h it is used at "
                        "the edge of its range"));
        }
    }
    if (channel.has_surface) {
        add("manning", "Manning's n (2.7)", "s/m^1/3", [&](double u) { return channel.manning(u); });
        add("chezy", "Chezy's C (2.8)", "m^1/2/s", [&](double u) { return channel.chezy(u); });
    }
    add("reynolds", "Reynolds number U h/nu", "1", [&](double u) { return channel.reynolds(u); });
    if (!channel.has_surface) return;
    add("froude", "Froude number", "1", [&](double u) { return channel.froude(u); });
    Figure figure =
        make_figure(chapters::fits, "friction_factor", "Friction factor",
                    "Friction factor of Darcy and Weisbach against the relative roughness ks/R with the "
                    "law of Colebrook and White for wide channels at the Reynolds number of the flow.",
                    "thesis (2.6), (2.9)", make_axis("relative roughness ks/R", "1", true),
                    make_axis("friction factor f", "1", true));
    add_friction_figure(c, record.origin(), analysis, velocity, factor, figure);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
