// What the friction factor of a uniform flow is made of: viscous, turbulent and form-induced stress.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "base/interpolation.hpp"
#include "case/bed_friction.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/friction_parts.hpp"

namespace riffle::inline analysis {

namespace {

/// A stress on horizontal planes, at the upper edges of the layers, Pa.
struct StressPart {
    std::string key;
    std::string label;
    std::vector<double> stress;
    std::vector<double> half_width = {};  ///< of its 95 % intervals; empty: not known
};

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
    return result;
}

/// Stress of the water's own viscosity by the mean profile.
std::vector<double> viscous_stress(const Profiles& p, double viscosity) {
    std::vector<double> stress(p.z.size(), 0.0);
    for (std::size_t k = 0; k + 1 < p.z.size(); ++k) {
        stress[k] = viscosity * (p.velocity[k + 1] - p.velocity[k]) / (p.z[k + 1] - p.z[k]);
    }
    return stress;
}

/// Form-induced stress at the upper edges of the layers; empty where the mean field has too few stretches of
/// time for an interval: the product of two alone is as good as any number where streaks wander.
StressPart form_induced(const FlowRecord& record, const Profiles& p, const FieldEstimates& found) {
    StressPart part{"form_induced", "form-induced stress, -rho <u~w~>", {}};
    const MeanFlow& field = record.mean_field();
    if (field.blocks.size() < 3) return part;
    std::vector<double> z;
    std::vector<double> stress;
    std::vector<double> half_width;
    for (std::size_t i = 0; i < found.value.size(); ++i) {
        if (!std::isfinite(found.value[i]) || !std::isfinite(found.half_width[i])) continue;
        z.push_back(field.z[i]);
        stress.push_back(found.value[i]);
        half_width.push_back(found.half_width[i]);
    }
    if (z.empty()) return part;
    for (const double height : p.bin_upper) {
        part.stress.push_back(place_in(z, height).in(stress));
        part.half_width.push_back(place_in(z, height).in(half_width));
    }
    return part;
}

std::vector<StressPart> stress_parts(const FlowRecord& record, const Profiles& p,
                                     const FieldEstimates& found) {
    const Case& c = *record.flow();
    const std::vector<double> viscous = viscous_stress(p, c.fluid.density * c.fluid.kinematic_viscosity);
    StressPart form = form_induced(record, p, found);
    std::vector<StressPart> parts = {{"viscous", "viscosity of the water", viscous}};
    if (c.turbulence.closure != ClosureKind::none) {
        parts.push_back({"closure", "closure", difference(p.viscous_stress, viscous)});
    }
    if (form.stress.empty()) {
        parts.push_back({"turbulent", "resolved Reynolds stress", p.reynolds_stress});
    } else {
        parts.push_back({"turbulent", "turbulence, -rho <u'w'>", difference(p.reynolds_stress, form.stress),
                         form.half_width});
        parts.push_back(std::move(form));
    }
    parts.push_back({"pressure_of_pairs", "pressure forces of pairs, the scheme's own", p.pair_stress});
    return parts;
}

/// Mean velocity from the crests to the surface; the profile goes on with its ends.
double mean_velocity(const Profiles& p, double crests, double surface) {
    constexpr int steps = 2000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += place_in(p.z, crests + (surface - crests) * (i + 0.5) / steps).in(p.velocity);
    }
    return sum / steps;
}

}  // namespace

void add_friction_parts(const FlowRecord& record, const Profiles& p, const FieldEstimates& form,
                        Analysis& analysis) {
    const Case& c = *record.flow();
    const bool fits = flow_kind(c) == FlowKind::uniform_channel && c.channel.slope > 0.0 &&
                      c.channel.top == Top::free_surface && !c.has_side_walls() && c.vegetation.empty() &&
                      c.porous.empty() && !has_wall_law(c);
    const std::size_t n = p.z.size();
    if (!fits || n < 4 || p.bin_upper.size() != n || p.viscous_stress.size() != n ||
        p.reynolds_stress.size() != n || p.pair_stress.size() != n) {
        return;
    }
    const double surface = mean_level_of(record, p);
    const double crests = c.crest();
    const double depth = surface - crests;
    const double velocity = depth > 0.0 ? mean_velocity(p, crests, surface) : 0.0;
    if (!(velocity > 0.0)) return;
    const double whole = 8.0 * c.streamwise_gravity() * depth / (velocity * velocity);
    Finding factor = make_finding(chapters::profiles, "friction_factor_above_crests",
                                  "friction factor of the water above the crests", "1", whole);
    factor.remark =
        fmt::format("8 g S0 h/U^2 with {:.4g} mm above the crests and their mean velocity {:.4g} m/s",
                    1000.0 * depth, velocity);
    analysis.findings.push_back(std::move(factor));

    Figure figure = profile_figure(
        "friction_factor_parts", "What the friction factor is made of",
        "Stresses on horizontal planes times (z_s - z)/h, over the same integral of the weight above: the area of "
        "each between crests and surface is its part of the friction factor f = 8 u*^2/U^2, and all together are "
        "one in steady uniform flow.",
        "Fukagata, Iwamoto & Kasagi 2002; Nikora et al. 2019", make_axis("3 (1 - xi) tau/tau_c", "1"));
    const double crest_stress = c.fluid.density * c.streamwise_gravity() * depth;
    double rest = whole;
    int variant = 0;
    for (const StressPart& part : stress_parts(record, p, form)) {
        const double share =
            friction_factor_of_stress(p.bin_upper, part.stress, crests, surface, c.fluid.density, velocity);
        rest -= share;
        Finding finding = make_finding(chapters::profiles, "friction_factor_" + part.key,
                                       "part of it by " + part.label, "1", share);
        finding.remark = fmt::format("{:.1f} % of it", 100.0 * share / whole);
        // The errors at neighbouring heights are those of the same eddies: they are taken to go together.
        if (!part.half_width.empty()) {
            finding.half_width = friction_factor_of_stress(p.bin_upper, part.half_width, crests, surface,
                                                           c.fluid.density, velocity);
            finding.remark += "; interval of what is form-induced";
        }
        analysis.findings.push_back(std::move(finding));
        std::vector<double> z;
        std::vector<double> weighted;
        for (std::size_t k = 0; k < n; ++k) {
            if (p.bin_upper[k] < crests) continue;
            const double from_surface = std::clamp((surface - p.bin_upper[k]) / depth, 0.0, 1.0);
            z.push_back(p.bin_upper[k]);
            weighted.push_back(3.0 * from_surface * part.stress[k] / crest_stress);
        }
        figure.curves.push_back(
            make_curve(part.label, Origin::simulated, Mark::line, weighted, z, variant++));
    }
    Finding finding = make_finding(chapters::profiles, "friction_factor_rest",
                                   "rest: of flow that is not steady, or not uniform", "1", rest);
    finding.remark = fmt::format("{:.1f} % of it", 100.0 * rest / whole);
    analysis.findings.push_back(std::move(finding));
    std::vector<double> line_z;
    std::vector<double> line;
    constexpr int points = 40;
    for (int i = 0; i <= points; ++i) {
        const double xi = static_cast<double>(i) / points;
        line_z.push_back(crests + xi * depth);
        line.push_back(3.0 * (1.0 - xi) * (1.0 - xi));
    }
    figure.curves.push_back(
        make_curve("weight of the water above", Origin::theory, Mark::line, line, line_z));
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
