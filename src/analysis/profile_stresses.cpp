// The vertical profiles of stress, of what the closure adds to it, and of the bed's drag.

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/turbulence_laws.hpp"
#include "roughness/bed_drag.hpp"
#include "roughness/porous_resistance.hpp"
#include "roughness/vegetation.hpp"

namespace riffle::inline analysis {

namespace {

/// Part of the weight above z that bed elements, vegetation and porous zones above z carry, per plan area, at
/// the upper edges of the bins, Pa.
std::vector<double> drag_above(const Profiles& p) {
    std::vector<double> result(p.drag.size());
    double sum = 0.0;
    for (std::size_t k = p.drag.size(); k-- > 0;) {
        result[k] = std::abs(sum);
        sum += p.drag[k] * (p.bin_upper[k] - p.bin_lower[k]);
    }
    return result;
}

/// Acceleration of water that flows at u at height z by the drag of bed, stems and grains, m/s2.
double twin_drag(const BedDrag* bed, const VegetationPatch* canopy, const PorousMedia& porous, double z,
                 double u) {
    double drag = bed != nullptr ? -bed->coefficient(z) * u * std::abs(u) : 0.0;
    if (canopy != nullptr && z < canopy->top()) drag -= canopy->drag().deceleration(u);
    if (!porous.empty()) {
        const PorousMedia::At at = porous.at(0.0, 0.0, z);
        drag -= at.along(at.porosity * std::abs(u)) * at.porosity * u;
    }
    return drag;
}

}  // namespace

void add_stresses(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure(
        "stress_profile", "Shear stress and its parts",
        "Shear stress on horizontal planes: viscous and closure part, resolved Reynolds part -rho u'w', part "
        "carried by the pressure forces between particles, their sum; the part of the weight above that the "
        "bed elements, the vegetation and porous zones carry; the analytic line tau_b (1 - (z - d_h)/(H - d_h)) and the balance with the "
        "drag.",
        "thesis (4.6), stress profiles of chapter 4; paper Figs 3-4", make_axis("shear stress tau", "Pa"));
    const Case& c = *record.flow();
    if ((p.total_stress.empty() && p.reynolds_stress.empty()) || p.bin_upper.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no stresses");
        return;
    }
    const auto add = [&](const char* name, const std::vector<double>& values, int variant) {
        if (values.size() != p.bin_upper.size()) return;
        figure.curves.push_back(make_curve(name, record.origin(), Mark::line, values, p.bin_upper, variant));
    };
    add("total", p.total_stress, 0);
    add("viscous and closure", p.viscous_stress, 1);
    add("resolved Reynolds stress", p.reynolds_stress, 2);
    add("pressure forces of pairs", p.pair_stress, 3);
    const bool grown = !c.vegetation.empty() || !c.porous.empty();
    const bool elements = has_spheres(c.bed) || grown;
    if (elements && p.drag.size() == p.z.size() && p.bin_lower.size() == p.z.size()) {
        add(!c.porous.empty() ? "carried by porous zones and bed above z"
            : grown           ? "carried by vegetation and bed above z"
                              : "carried by the bed elements above z",
            drag_above(p), 4);
    }
    if (!p.analytic_stress.empty()) {
        figure.curves.push_back(profile_curve(grown ? "balance with the drag" : "balance with the bed drag",
                                              Origin::column, p.analytic_stress, p.bin_upper));
    }
    add_measured_turbulence(record, ProfileQuantity::reynolds_stress, &Profiles::reynolds_stress,
                            "measured -rho u'w'", 1.0, 0, figure);
    const double bed_stress =
        crest_stress(c.fluid.density, c.streamwise_gravity(), c.total_depth(), c.crest());
    if (bed_stress > 0.0 && !grown && !p.analytic_stress.empty()) {
        figure.curves.push_back(make_curve("analytic line (4.6)", Origin::theory, Mark::line,
                                           {bed_stress, 0.0}, {c.crest(), c.total_depth()}));
    }
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

void add_closure(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    if (record.flow()->turbulence.closure == ClosureKind::none) return;
    Figure figure = profile_figure("eddy_viscosity_profile", "Eddy viscosity",
                                   "Time-mean eddy viscosity of the closure, and that of the column twin.",
                                   "thesis (4.2), (2.20), (2.21)", make_axis("eddy viscosity nu_t", "m2/s"));
    if (p.eddy_viscosity.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no eddy viscosity");
        return;
    }
    figure.curves.push_back(profile_curve("simulated", Origin::simulated, p.eddy_viscosity, p.z));
    add_twin(record, &ColumnProfile::eddy_viscosity, nullptr, figure);
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

void add_mixing_length(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    if (record.flow()->turbulence.closure == ClosureKind::none) return;
    Figure figure =
        profile_figure("mixing_length_profile", "Mixing length",
                       "Mixing length of the closure: of the run sqrt(nu_t/|du/dz|) of its mean "
                       "profiles, and that of the column twin.",
                       "paper Fig. 3; thesis (4.2), (2.20), (2.21)", make_axis("mixing length l_m", "m"));
    const bool has = p.eddy_viscosity.size() == p.z.size() && p.velocity_gradient.size() == p.z.size();
    if (!has) {
        add_missing(record, analysis, std::move(figure),
                    "the profiles hold no eddy viscosity or no velocity gradient");
        return;
    }
    std::vector<double> length;
    for (std::size_t i = 0; i < p.z.size(); ++i) {
        length.push_back(std::sqrt(p.eddy_viscosity[i] / std::abs(p.velocity_gradient[i])));
    }
    figure.curves.push_back(
        profile_curve("simulated", Origin::simulated, length, p.z, Mark::line_and_points));
    add_twin(record, &ColumnProfile::mixing_length, nullptr, figure);
    analysis.figures.push_back(std::move(figure));
}

void add_drag(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    const bool grown = !c.vegetation.empty();
    const PorousMedia porous(c);
    if (!has_spheres(c.bed) && !grown && porous.empty()) return;
    Figure figure = profile_figure(
        "drag_profile",
        !porous.empty() ? "Drag term of bed and porous zones"
        : grown         ? "Drag term of bed and vegetation"
                        : "Drag term of the bed",
        fmt::format("Drag of the bed's elements {}on the water per mass, tau_d/rho, against the "
                    "flow; of the column twin at its velocity.",
                    !porous.empty() ? "and of porous zones "
                    : grown         ? "and of the vegetation "
                                    : ""),
        "paper Fig. 2c; thesis (4.3)-(4.4)", make_axis("drag term tau_d/rho", "m/s2"));
    if (p.drag.size() != p.z.size() || p.drag.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no drag");
        return;
    }
    std::vector<double> term;
    for (const double drag : p.drag) term.push_back(drag / c.fluid.density);
    figure.curves.push_back(profile_curve("simulated", Origin::simulated, term, p.z, Mark::line_and_points));
    const auto law = make_bed_drag(c);
    const Vegetation* const stems = vegetation_everywhere(c);
    const std::unique_ptr<const VegetationPatch> canopy =
        stems != nullptr ? std::make_unique<VegetationPatch>(c, *stems) : nullptr;
    if (record.column() != nullptr && (law != nullptr || canopy != nullptr || !porous.empty()) &&
        !between_side_walls(record)) {
        const ColumnProfile& column = record.column()->profile;
        std::vector<double> of_column;
        for (std::size_t i = 0; i < column.z.size(); ++i) {
            of_column.push_back(twin_drag(law.get(), canopy.get(), porous, column.z[i], column.velocity[i]));
        }
        figure.curves.push_back(column_curve(column, of_column));
    }
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
