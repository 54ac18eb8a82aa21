// Profiles at places across the flow: at the centreline, at the thesis' distances from the wall, and the
// depth mean across the channel.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/section_points.hpp"
#include "base/not_a_number.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle::inline analysis {

namespace {

Figure section_profile_figure(std::string key, std::string title, std::string caption, std::string source,
                              Axis x) {
    return make_figure(chapters::section, std::move(key), std::move(title), std::move(caption),
                       std::move(source), std::move(x), make_axis("height above the bed level z", "m"));
}

Curve profile_curve(std::string name, Origin origin, Mark mark, const SectionProfile& profile) {
    Curve curve = make_curve(std::move(name), origin, mark, profile.value, profile.z);
    const bool known = std::any_of(profile.half_width.begin(), profile.half_width.end(),
                                   [](double width) { return std::isfinite(width); });
    if (known) curve.x_half_width = profile.half_width;
    return curve;
}

/// What stands beside the profile at a place: the section twin's, else the column twin's.
void add_twin(const FlowRecord& record, const std::vector<double>& twin_values,
              const std::vector<double>& column_values, const Strip& strip, int variant, Figure& figure) {
    constexpr std::size_t most = 300;
    const SectionTwin& twin = record.section_twin();
    if (!twin.empty() && !twin_values.empty()) {
        Curve curve = make_curve("section twin", Origin::column, Mark::line,
                                 twin_profile(twin, twin_values, strip), twin.z);
        curve.variant = variant;
        figure.curves.push_back(std::move(curve));
    } else if (record.column() != nullptr && !record.flow()->has_side_walls()) {
        Curve curve = make_curve("column twin", Origin::column, Mark::line, thinned(column_values, most),
                                 thinned(record.column()->profile.z, most));
        curve.variant = variant;
        figure.curves.push_back(std::move(curve));
    }
}

std::string strip_caption(const Case& c) {
    const Strip strip = centreline_strip(c);
    return fmt::format(
        "Means over the length and {:.3g} mm across the channel around the centreline; bars: "
        "95 % intervals from blocks of windows.",
        1000.0 * (strip.to - strip.from));
}

/// The thesis' MSEP of the centreline profile, above and below a quarter of the depth over the datum.
void add_errors(const FlowRecord& record, const SectionProfile& profile, Analysis& analysis) {
    const FlowRecord::Measured& measured = record.measured();
    Figure figure = section_profile_figure(
        "centreline_msep_profile", "MSEP at the centreline",
        "Mean square error percentage of the thesis, 100 ((u_exp - u)/u_exp)^2, of the "
        "centreline's velocity and its gradient: 0.5 % is a departure of 7 %, 4.5 % of 21 %.",
        "thesis chapter 5, MSEP", make_axis("MSEP", "%"));
    if (measured.profile.height.size() < 2) {
        add_missing(record, analysis, std::move(figure),
                    measured.note.empty() ? "no measured profile is known" : measured.note);
        return;
    }
    const Case& c = *record.flow();
    const ProfileSpan computed{profile.z, profile.value};
    const ProfileSpan points{measured.profile.height, measured.profile.velocity};
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const ProfileComparison velocity = compare_profiles(computed, points);
        const ProfileComparison gradient = compare_gradients(computed, points);
        int variant = 0;
        for (const auto& [name, comparison] :
             {std::pair{"velocity", &velocity}, std::pair{"velocity gradient", &gradient}}) {
            Curve curve = make_curve(name, Origin::simulated, Mark::line_and_points, {}, {});
            for (const ComparedPoint& point : comparison->points) {
                curve.x.push_back(point.msep);
                curve.y.push_back(point.z);
            }
            curve.variant = variant++;
            f.curves.push_back(std::move(curve));
        }
        constexpr double lowest = -std::numeric_limits<double>::infinity();
        const double split = c.datum() + 0.25 * c.channel.depth;
        const auto add = [&](const char* key, const char* label, const char* unit, double value,
                             std::optional<double> thesis) {
            if (!std::isfinite(value)) return;
            analysis.findings.push_back(against(
                make_finding(chapters::section, key, label, unit, value), thesis, "thesis, 3D simulations",
                "against: " + (measured.from_law ? measured_name(c) + ", its log law" : "measured profile")));
        };
        add("centreline_velocity_error_rms", "rms relative departure of u at the centreline", "1",
            velocity.errors.rms_relative, std::nullopt);
        add("centreline_velocity_error_mean", "mean relative departure of u at the centreline", "1",
            velocity.errors.mean_relative, std::nullopt);
        add("centreline_msep_upper", "MSEP of u at the centreline above 0.25 h_w over the datum", "%",
            errors_between(velocity.points, split, c.total_depth()).mean_msep, 0.2);
        add("centreline_msep_lower", "MSEP of u at the centreline below 0.25 h_w over the datum", "%",
            errors_between(velocity.points, lowest, split).mean_msep, 4.5);
        add("centreline_msep_gradient", "MSEP of du/dz at the centreline below 0.25 h_w over the datum", "%",
            errors_between(gradient.points, lowest, split).mean_msep, 20.0);
    });
}

void add_centreline(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const Strip strip = centreline_strip(c);
    const SectionProfile u = centreline_velocity_profile(record);
    const std::vector<double> none;
    const ColumnProfile* const column = record.column() == nullptr ? nullptr : &record.column()->profile;

    Figure velocity = section_profile_figure(
        "centreline_velocity_profile", "Streamwise velocity at the centreline", strip_caption(c),
        "thesis chapter 5, centreline profiles", make_axis("streamwise velocity u", "m/s"));
    velocity.curves.push_back(profile_curve("simulated", Origin::simulated, Mark::line_and_points, u));
    add_twin(record, record.section_twin().velocity, column ? column->velocity : none, strip, 0, velocity);
    const FlowRecord::Measured& measured = record.measured();
    if (!measured.profile.height.empty()) {
        velocity.curves.push_back(
            make_curve(measured.from_law ? "measured: rough log law (2.3) of its u* and ks" : "measured",
                       Origin::measured, measured.from_law ? Mark::line : Mark::points,
                       measured.profile.velocity, measured.profile.height));
    }
    analysis.figures.push_back(std::move(velocity));
    add_errors(record, u, analysis);

    Figure vertical =
        section_profile_figure("centreline_vertical_velocity_profile", "Vertical velocity at the centreline",
                               strip_caption(c), "thesis chapter 5", make_axis("vertical velocity w", "m/s"));
    vertical.curves.push_back(profile_curve("simulated", Origin::simulated, Mark::line_and_points,
                                            strip_profile(field, strip, [](const FieldSums& s) {
                                                return s.means(FieldQuantity::vertical_velocity);
                                            })));
    analysis.figures.push_back(std::move(vertical));

    const double rho = c.fluid.density;
    Figure stress = section_profile_figure(
        "centreline_stress_profile", "Shear stress at the centreline",
        strip_caption(c) +
            " The line is that of a wide channel, tau_b (1 - (z - d_h)/(H - d_h)): beside "
            "it the stress tau_xy on vertical planes carries weight to the walls.",
        "thesis chapter 5", make_axis("shear stress tau_xz", "Pa"));
    const auto add = [&](const char* name, int variant, const SectionEstimator& estimator) {
        Curve curve =
            profile_curve(name, Origin::simulated, Mark::line, strip_profile(field, strip, estimator));
        curve.variant = variant;
        stress.curves.push_back(std::move(curve));
    };
    add("total", 0, [rho](const FieldSums& s) { return total_stress(s, rho, false); });
    add("viscosity and closure", 1, [](const FieldSums& s) { return s.means(FieldQuantity::shear_stress); });
    add("resolved Reynolds stress", 2, [rho](const FieldSums& s) { return resolved_stress(s, rho, false); });
    add_twin(record, record.section_twin().shear_stress, column ? column->shear_stress : none, strip, 0,
             stress);
    const double bed_stress = crest_stress(rho, c.streamwise_gravity(), c.total_depth(), c.crest());
    if (bed_stress > 0.0) {
        stress.curves.push_back(make_curve("wide channel (4.6)", Origin::theory, Mark::line,
                                           {bed_stress, 0.0}, {c.crest(), c.total_depth()}));
    }
    analysis.figures.push_back(std::move(stress));
}

/// Depth means above the datum across the channel of values on the cells of a section, by the water in them.
std::vector<double> depth_means(const MeanFlow& field, const Case& c, const FieldSums& section,
                                const std::vector<double>& values) {
    std::vector<double> means(field.y.size());
    std::vector<double> profile(field.z.size());
    std::vector<double> water(field.z.size());
    for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
        for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
            profile[iz] = values[field.at(iz, iy)];
            water[iz] = section.mean(FieldQuantity::count, field.at(iz, iy));
        }
        means[iy] = mean_above_datum(c, field.z, profile, water);
    }
    return means;
}

void add_lateral(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const FieldEstimates found = section_estimates(field, [&](const FieldSums& section) {
        return depth_means(field, c, section, section.means(FieldQuantity::velocity));
    });
    Figure figure = make_figure(
        chapters::section, "lateral_velocity", "Depth-mean velocity across the channel",
        "Mean of u over the water above the datum, at each place across the channel, with 95 % intervals; the "
        "section twin's at the same cells.",
        "thesis chapter 5", across_axis(c), make_axis("depth-mean velocity U", "m/s"));
    Curve curve = make_curve("simulated", Origin::simulated, Mark::line_and_points, field.y, found.value);
    if (std::isfinite(found.half_width.front())) curve.y_half_width = found.half_width;
    figure.curves.push_back(std::move(curve));
    const SectionTwin& twin = record.section_twin();
    if (!twin.empty()) {
        std::vector<double> values(field.y.size() * field.z.size(), not_a_number);
        // Where the run has no water, the twin's velocity does not count either.
        const FieldSums section = field.section();
        for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
            for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
                if (std::isfinite(section.mean(FieldQuantity::velocity, field.at(iz, iy)))) {
                    values[field.at(iz, iy)] = twin_value(twin, twin.velocity, field.y[iy], field.z[iz]);
                }
            }
        }
        const std::vector<double> beside = depth_means(field, c, section, values);
        figure.curves.push_back(make_curve("section twin", Origin::column, Mark::line, field.y, beside));
        const double layer = c.side_layer();
        double squares = 0.0;
        double count = 0.0;
        for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
            const double from_wall = c.channel.sides == Sides::half
                                         ? field.y[iy]
                                         : std::min(field.y[iy], c.channel.width - field.y[iy]);
            if (from_wall < layer || !(beside[iy] > 0.0)) continue;
            squares += std::pow(found.value[iy] / beside[iy] - 1.0, 2);
            count += 1.0;
        }
        if (count > 0.0) {
            Finding finding = make_finding(
                chapters::section, "lateral_velocity_error_rms",
                "rms relative departure of the depth-mean velocity across the channel from the section twin",
                "1", std::sqrt(squares / count));
            finding.remark = "outside of the side walls' layers";
            analysis.findings.push_back(std::move(finding));
        }
    } else if (record.column() != nullptr && !c.has_side_walls()) {
        figure.curves.push_back(
            make_curve("column twin", Origin::column, Mark::line, {field.y.front(), field.y.back()},
                       {record.column()->depth_mean_velocity, record.column()->depth_mean_velocity}));
    }
    const MeasuredRow means = measured_depth_means(points_beside(record));
    if (!means.y.empty()) {
        Curve points = make_curve("measured", Origin::measured, Mark::points, means.y, means.velocity);
        for (const double uncertainty : means.uncertainty) {
            if (std::isfinite(uncertainty)) points.y_half_width.push_back(normal_95 * uncertainty);
        }
        if (points.y_half_width.size() != points.y.size()) points.y_half_width.clear();
        figure.curves.push_back(std::move(points));
    } else if (c.measured.depth_mean_velocity) {
        figure.curves.push_back(make_curve("measured at the centreline", Origin::measured, Mark::points,
                                           {c.channel.centreline()}, {*c.measured.depth_mean_velocity}));
    }
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

void add_section_profiles(const FlowRecord& record, Analysis& analysis) {
    add_centreline(record, analysis);
    add_section_stations(record, analysis);
    add_lateral(record, analysis);
}

}  // namespace riffle::inline analysis
