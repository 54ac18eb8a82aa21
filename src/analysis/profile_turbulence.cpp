// The vertical profiles of the resolved turbulence, simulated and measured.

#include <cmath>
#include <string>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle::inline analysis {

void add_measured_turbulence(const FlowRecord& record, ProfileQuantity quantity,
                             std::vector<double> Profiles::*values, std::string name, double factor,
                             int variant, Figure& figure) {
    const FlowRecord::Measured& measured = record.measured();
    if (between_side_walls(record)) return;
    Curve curve = make_curve(std::move(name), Origin::measured, Mark::points, {}, {}, variant);
    const auto add = [&](double value, double z) {
        if (!std::isfinite(value)) return false;
        curve.x.push_back(factor * value);
        curve.y.push_back(z);
        return true;
    };
    if (measured.file) {
        const ProfileColumn* const column = measured.file->find(quantity);
        if (column == nullptr) return;
        // The Reynolds stress is in m2/s2 in the file and in Pa here.
        const double unit = quantity == ProfileQuantity::reynolds_stress ? record.flow()->fluid.density : 1.0;
        for (std::size_t i = 0; i < column->values.size(); ++i) {
            if (!add(unit * column->values[i], measured.file->z[i] + record.flow()->datum())) continue;
            if (!column->uncertainty.empty()) {
                curve.x_half_width.push_back(std::abs(factor * unit) * normal_95 * column->uncertainty[i]);
            }
        }
    } else {
        const std::vector<double>& of_field = measured.turbulence.*values;
        for (std::size_t i = 0; i < of_field.size(); ++i) (void)add(of_field[i], measured.turbulence.z[i]);
    }
    if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
}

void add_intensities(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = make_figure(chapters::profiles, "turbulence_intensity_profile", "Turbulence intensities",
                                "Root mean squares of the resolved velocity fluctuations over the friction "
                                "velocity, with Nezu's curves "
                                "2.30 exp(-z/h), 1.27 exp(-z/h) and, across the flow, 1.63 exp(-z/h).",
                                "thesis (2.12)-(2.14)", make_axis("intensity over friction velocity", "1"),
                                make_axis("height above the datum over depth z/h", "1"));
    if (record.origin() == Origin::simulated && resolves_eddies(c)) {
        figure.caption += " The noise of the particles is a part of it.";
    } else if (record.origin() == Origin::simulated && c.turbulence.closure != ClosureKind::none) {
        figure.caption +=
            " The closure carries the turbulence in its stress; what the particles resolve is then far below "
            "the curves.";
    }
    if (between_side_walls(record)) {
        add_missing(
            record, analysis, std::move(figure),
            "between side walls the departures from a layer's mean over the width are those of the mean "
            "flow across the channel, no turbulence; the double averages have the parts in time and in space "
            "apart");
        return;
    }
    const double friction_velocity = friction_velocity_of(record);
    const Profiles& measured = record.measured().turbulence;
    const bool none = p.velocity_rms.empty() && p.vertical_velocity_rms.empty() &&
                      p.spanwise_velocity_rms.empty() && measured.velocity_rms.empty() &&
                      measured.vertical_velocity_rms.empty() && measured.spanwise_velocity_rms.empty();
    if (none || friction_velocity <= 0.0) {
        add_missing(record, analysis, std::move(figure),
                    "the profiles hold no fluctuations, or no friction velocity is known");
        return;
    }
    const double depth = water_depth(record);
    const auto add = [&](const std::string& name, Origin origin, const Profiles& from,
                         const std::vector<double>& rms, double scale, int variant) {
        if (rms.empty()) return;
        std::vector<double> x;
        std::vector<double> y;
        for (std::size_t i = 0; i < rms.size(); ++i) {
            x.push_back(rms[i] / scale);
            y.push_back((from.z[i] - c.datum()) / depth);
        }
        figure.curves.push_back(make_curve(
            name, origin, origin == record.origin() ? Mark::line_and_points : Mark::points, x, y, variant));
    };
    add("u'", record.origin(), p, p.velocity_rms, friction_velocity, 0);
    add("w'", record.origin(), p, p.vertical_velocity_rms, friction_velocity, 1);
    add("v'", record.origin(), p, p.spanwise_velocity_rms, friction_velocity, 2);
    // What was measured is scaled with its own friction velocity.
    const double of_measured = c.measured.friction_velocity.value_or(friction_velocity);
    const std::size_t measured_first = figure.curves.size();
    add_measured_turbulence(record, ProfileQuantity::streamwise_rms, &Profiles::velocity_rms, "measured u'",
                            1.0 / of_measured, 0, figure);
    add_measured_turbulence(record, ProfileQuantity::vertical_rms, &Profiles::vertical_velocity_rms,
                            "measured w'", 1.0 / of_measured, 1, figure);
    add_measured_turbulence(record, ProfileQuantity::spanwise_rms, &Profiles::spanwise_velocity_rms,
                            "measured v'", 1.0 / of_measured, 2, figure);
    for (std::size_t i = measured_first; i < figure.curves.size(); ++i) {
        for (double& z : figure.curves[i].y) z = (z - c.datum()) / depth;
    }
    const auto add_law = [&](const char* name, double TurbulenceIntensities::*component, int variant) {
        Curve curve = make_curve(name, Origin::theory, Mark::line, {}, {}, variant);
        constexpr int steps = 40;
        for (int i = 4; i <= steps; ++i) {
            const double xi = static_cast<double>(i) / steps;
            curve.x.push_back(nezu_intensities(xi, 1.0, 1.0).*component);
            curve.y.push_back(xi);
        }
        figure.curves.push_back(std::move(curve));
    };
    add_law("Nezu: 2.30 exp(-z/h)", &TurbulenceIntensities::streamwise, 0);
    add_law("Nezu: 1.27 exp(-z/h)", &TurbulenceIntensities::vertical, 1);
    add_law("Nezu: v' 1.63 exp(-z/h)", &TurbulenceIntensities::spanwise, 2);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
