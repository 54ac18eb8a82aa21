// Vertical profiles of the time means: the chapter and its figures of the velocity and its gradient.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/double_average.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "analysis/section_parts.hpp"
#include "hydraulics/profile_comparison.hpp"

namespace riffle::inline analysis {

namespace {

const char* own_name(const FlowRecord& record) {
    return record.origin() == Origin::simulated ? "simulated" : "measured";
}

void add_measured_points(Figure& figure, const FlowRecord::Measured& measured) {
    if (measured.profile.height.empty()) return;
    Curve curve = profile_curve(measured_curve_name(measured), Origin::measured, measured.profile.velocity,
                                measured.profile.height, measured.from_law ? Mark::line : Mark::points);
    for (const double uncertainty : measured.profile.uncertainty) {
        curve.x_half_width.push_back(normal_95 * uncertainty);
    }
    figure.curves.push_back(std::move(curve));
}

/// What the profiles of a run are means over beside time.
std::string bed_plane(const FlowRecord& record) {
    if (record.flow() == nullptr || record.flow()->channel.dimensions == 2) return "along the bed";
    return record.flow()->has_side_walls() ? "over the whole plan, side walls and all; what was measured at "
                                             "the centreline stands beside the "
                                             "centreline's profile, in the chapter on the cross-section"
                                           : "over the whole plan";
}

void add_velocity(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure(
        "velocity_profile", "Streamwise velocity",
        record.origin() == Origin::simulated
            ? fmt::format(
                  "Time-mean streamwise velocity over {:.4g} s to {:.4g} s in layers one particle spacing "
                  "thick, averaged over time and {}; bars: 95 % intervals of the time mean.",
                  p.window_start, p.window_end, bed_plane(record))
            : "Time-mean streamwise velocity; bars: 95 % intervals.",
        "thesis, velocity profiles of chapter 4; paper Fig. 2", make_axis("streamwise velocity u", "m/s"));
    Curve simulated =
        profile_curve(own_name(record), record.origin(), p.velocity, p.z, Mark::line_and_points);
    const auto known = [](double half_width) { return std::isfinite(half_width); };
    if (std::any_of(p.velocity_half_width.begin(), p.velocity_half_width.end(), known)) {
        simulated.x_half_width = p.velocity_half_width;
    }
    figure.curves.push_back(std::move(simulated));
    add_twin(record, &ColumnProfile::velocity, &SectionTwin::velocity, figure);
    if (!between_side_walls(record)) add_measured_points(figure, record.measured());
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

void add_gradient(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure("velocity_gradient_profile", "Velocity gradient",
                                   "Time-mean du/dz of the particles, the column's, and that of the measured "
                                   "profile: its own du/dz, or differences between neighbouring points.",
                                   "thesis chapter 4, du/dz", make_axis("velocity gradient du/dz", "1/s"));
    if (p.velocity_gradient.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no velocity gradient");
        return;
    }
    figure.curves.push_back(profile_curve(own_name(record), record.origin(), p.velocity_gradient, p.z));
    add_twin(record, &ColumnProfile::velocity_gradient, nullptr, figure);
    const FlowRecord::Measured& measured = record.measured();
    if (measured.file && measured.file->find(ProfileQuantity::velocity_gradient) != nullptr) {
        add_measured_turbulence(record, ProfileQuantity::velocity_gradient, &Profiles::velocity_gradient,
                                measured_curve_name(measured), 1.0, 0, figure);
    } else if (measured.profile.height.size() > 1 && !between_side_walls(record)) {
        std::vector<double> height;
        std::vector<double> gradient;
        for (const ComparedPoint& point :
             compare_gradients({p.z, p.velocity}, {measured.profile.height, measured.profile.velocity})
                 .points) {
            height.push_back(point.z);
            gradient.push_back(point.measured);
        }
        figure.curves.push_back(profile_curve(measured_curve_name(measured), Origin::measured, gradient,
                                              height, measured.from_law ? Mark::line : Mark::points));
    }
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

Curve column_curve(const ColumnProfile& column, const std::vector<double>& values) {
    constexpr std::size_t most = 300;
    return profile_curve("column twin", Origin::column, thinned(values, most), thinned(column.z, most));
}

void add_twin(const FlowRecord& record, const std::vector<double> ColumnProfile::*of_column,
              const std::vector<double> SectionTwin::*of_section, Figure& figure) {
    if (!between_side_walls(record)) {
        if (record.column() != nullptr) {
            figure.curves.push_back(
                column_curve(record.column()->profile, record.column()->profile.*of_column));
        }
        return;
    }
    const SectionTwin& twin = record.section_twin();
    if (twin.empty() || of_section == nullptr) return;
    figure.curves.push_back(profile_curve(
        "section twin, mean over the width", Origin::column,
        twin_profile(twin, twin.*of_section, Strip{0.0, record.flow()->channel.simulated_width()}), twin.z));
}

Figure profile_figure(std::string key, std::string title, std::string caption, std::string source, Axis x) {
    return make_figure(chapters::profiles, std::move(key), std::move(title), std::move(caption),
                       std::move(source), std::move(x), make_axis("height above the bed level z", "m"));
}

Curve profile_curve(std::string name, Origin origin, const std::vector<double>& values,
                    const std::vector<double>& z, Mark mark) {
    return make_curve(std::move(name), origin, mark, values, z);
}

std::string measured_curve_name(const FlowRecord::Measured& measured) {
    return measured.from_law ? "measured: rough log law (2.3) of its u* and ks" : "measured";
}

void analyse_profiles(const FlowRecord& record, Analysis& analysis) {
    const Profiles& p = record.profiles();
    if (record.origin() == Origin::simulated && record.flow() != nullptr &&
        is_undriven(flow_kind(*record.flow()))) {
        // Layers of a flow that changes in time and place have no mean worth the name, but still water has.
        if (!p.empty() && stands_level(record, p)) add_pressure(record, p, analysis);
        return;
    }
    if (record.flow() == nullptr) {
        if (p.empty()) return;
        add_velocity(record, p, analysis);
        if (!record.velocity_grids().empty()) add_plane_maps(record, analysis);
        analysis.warnings.emplace_back(
            "of a profile without its case only the velocity is drawn: --case CASE.toml gives depth, slope "
            "and datum");
        return;
    }
    if (p.empty() || p.velocity.empty()) {
        add_missing(record, analysis,
                    profile_figure("velocity_profile", "Streamwise velocity", "", "",
                                   make_axis("streamwise velocity u", "m/s")),
                    "the results file holds no profiles of this window: time averages had not started, or "
                    "the window is shorter than a block of 0.1 s");
        return;
    }
    if (!record.measured().note.empty()) analysis.warnings.push_back(record.measured().note);
    add_velocity(record, p, analysis);
    add_gradient(record, p, analysis);
    add_profile_errors(record, p, analysis);
    add_stresses(record, p, analysis);
    add_intensities(record, p, analysis);
    add_eddies_and_noise(record, analysis);
    add_pressure(record, p, analysis);
    add_closure(record, p, analysis);
    if (record.origin() == Origin::simulated) {
        add_mixing_length(record, p, analysis);
        add_drag(record, p, analysis);
    }
    const FieldEstimates form = form_induced_stress(record);
    add_double_averages(record, form, analysis);
    if (record.origin() == Origin::simulated) add_friction_parts(record, p, form, analysis);
    add_plane_maps(record, analysis);
}

}  // namespace riffle::inline analysis
