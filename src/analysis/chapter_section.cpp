// The cross-section of a run in three dimensions: maps of the mean velocity and stress.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "hydraulics/turbulence_laws.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline analysis {

namespace {

std::vector<double> over(std::vector<double> values, double scale) {
    for (double& value : values) value /= scale;
    return values;
}

double largest_finite(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) most = std::max(most, value);
    }
    return most;
}

/// The twin's values at the cells of the mean field.
std::vector<double> twin_on_cells(const SectionTwin& twin, const std::vector<double>& values,
                                  const MeanFlow& field) {
    std::vector<double> result(field.y.size() * field.z.size());
    for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
        for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
            result[field.at(iz, iy)] = twin_value(twin, values, field.y[iy], field.z[iz]);
        }
    }
    return result;
}

std::string window_text(const MeanFlow& field) {
    return fmt::format(
        "Means over the length of the channel and {} window{} of {:.3g} s, {:.4g} s to {:.4g} s.",
        field.time.size(), field.time.size() == 1 ? "" : "s", field.interval,
        field.time.front() - field.interval, field.time.back());
}

void add_velocities(const FlowRecord& record, const FieldSums& section, double fastest, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    Figure u = section_figure(chapters::section, "section_velocity_map",
                              "Streamwise velocity over the cross-section",
                              window_text(field) +
                                  " Colours: U over its largest value; arrows: the mean "
                                  "velocity across the flow, (V, W).",
                              "thesis chapter 5, cross-section maps");
    const char* const label = "velocity U/U_max";
    u.maps.push_back(
        section_map(field, c, over(section.means(FieldQuantity::velocity), fastest), label, "1", false));
    u.curves.push_back(section_vectors(field, section, c, fastest, "U_max"));
    analysis.figures.push_back(std::move(u));

    const SectionTwin& twin = record.section_twin();
    if (!twin.empty()) {
        Figure beside = section_figure(
            chapters::section, "section_twin_map", "Streamwise velocity of the section twin",
            "The steady flow of the same closure and drags over the cross-section, over the largest velocity "
            "of the run, at the cells of the run.",
            "");
        beside.maps.push_back(section_map(field, c, over(twin_on_cells(twin, twin.velocity, field), fastest),
                                          label, "1", false));
        analysis.figures.push_back(std::move(beside));
    }
    Figure across =
        section_figure(chapters::section, "section_secondary_map", "Velocities across the flow",
                       window_text(field) +
                           " Mean spanwise and vertical velocity over the largest mean velocity; how far "
                           "they stand out of what the averaging has left of the fluctuation, the chapter "
                           "on the secondary flow says.",
                       "thesis chapter 5, cross-section maps");
    across.maps.push_back(section_map(field, c,
                                      over(section.means(FieldQuantity::spanwise_velocity), fastest),
                                      "spanwise velocity V/U_max", "1", true));
    across.maps.push_back(section_map(field, c,
                                      over(section.means(FieldQuantity::vertical_velocity), fastest),
                                      "vertical velocity W/U_max", "1", true));
    analysis.figures.push_back(std::move(across));
}

void add_stresses(const FlowRecord& record, const FieldSums& section, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const double bed_stress =
        crest_stress(c.fluid.density, c.streamwise_gravity(), c.total_depth(), c.crest());
    Figure total = section_figure(
        chapters::section, "section_stress_map", "Shear stresses over the cross-section",
        window_text(field) +
            fmt::format(" Stress of viscosity and closure and resolved Reynolds stress together, over "
                        "tau_b = rho g S0 (H - d_h) = {:.4g} Pa.",
                        bed_stress),
        "thesis chapter 5, stress over the cross-section");
    if (!(bed_stress > 0.0)) {
        add_missing(record, analysis, std::move(total), "the channel has no slope, so no stress to scale by");
        return;
    }
    const double rho = c.fluid.density;
    const auto add = [&](Figure& figure, const std::vector<double>& values, const char* label) {
        figure.maps.push_back(section_map(field, c, over(values, bed_stress), label, "1", true));
    };
    add(total, total_stress(section, rho, false), "stress tau_xz/tau_b");
    add(total, total_stress(section, rho, true), "stress tau_xy/tau_b");
    analysis.figures.push_back(std::move(total));
    Figure parts = section_figure(
        chapters::section, "section_resolved_stress_map", "Resolved Reynolds stresses over the cross-section",
        "The part of the stresses that the resolved motion carries, -rho u'w' and -rho u'v' with the "
        "departures from the mean in time and along the bed, over tau_b.",
        "thesis chapter 5");
    add(parts, resolved_stress(section, rho, false), "-rho u'w'/tau_b");
    add(parts, resolved_stress(section, rho, true), "-rho u'v'/tau_b");
    analysis.figures.push_back(std::move(parts));
}

void add_findings(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const SectionTwin& twin = record.section_twin();
    const Estimate fastest = section_estimate(field, [](const FieldSums& section) {
        return largest_finite(section.means(FieldQuantity::velocity));
    });
    std::optional<double> reference;
    if (!twin.empty()) reference = largest_finite(twin.velocity);
    analysis.findings.push_back(
        against(make_finding(chapters::section, "maximum_mean_velocity", "largest mean velocity, U_max",
                             "m/s", fastest.value, fastest.half_width),
                reference, "section twin"));
    const Strip strip = centreline_strip(c);
    const Estimate centre = section_estimate(field, [&](const FieldSums& section) {
        const FieldSums middle = strip_of(field, section, strip.from, strip.to);
        return mean_above_datum(c, field.z, middle.means(FieldQuantity::velocity),
                                middle.means(FieldQuantity::count));
    });
    Finding finding =
        against(make_finding(chapters::section, "centreline_depth_mean_velocity",
                             "depth-mean velocity above the datum at the centreline", "m/s", centre.value,
                             centre.half_width),
                c.has_side_walls() ? c.measured.depth_mean_velocity : std::nullopt, measured_name(c));
    finding.remark = fmt::format(
        "mean over {:.3g} mm around the centreline{}", 1000.0 * (strip.to - strip.from),
        c.has_side_walls() ? ""
                           : ", of a width that repeats itself: what was measured stands beside the whole");
    analysis.findings.push_back(std::move(finding));
    if (const auto beside = twin.value(fields::section_numbers.centreline_velocity)) {
        analysis.findings.push_back(against(make_finding(chapters::section, "centreline_velocity_over_twin",
                                                         "the same over that of the section twin", "1",
                                                         centre.value / *beside, centre.half_width / *beside),
                                            1.0, "section twin"));
    }
}

}  // namespace

void analyse_section(const FlowRecord& record, Analysis& analysis) {
    if (!record.section_points().empty()) add_section_stations(record, analysis);
    if (!is_three_dimensional(record)) return;
    const MeanFlow& field = record.mean_field();
    if (field.empty()) {
        add_missing(record, analysis,
                    section_figure(chapters::section, "section_velocity_map",
                                   "Streamwise velocity over the cross-section", "", ""),
                    "the results file holds no window of the mean field within the averaging window "
                    "(output.mean_field_interval sets their length)");
        return;
    }
    const FieldSums section = field.section();
    const double fastest = largest_finite(section.means(FieldQuantity::velocity));
    if (!(fastest > 0.0)) {
        add_missing(record, analysis,
                    section_figure(chapters::section, "section_velocity_map",
                                   "Streamwise velocity over the cross-section", "", ""),
                    "the water does not flow down the channel");
        return;
    }
    add_velocities(record, section, fastest, analysis);
    add_stresses(record, section, analysis);
    add_findings(record, analysis);
    add_section_profiles(record, analysis);
}

}  // namespace riffle::inline analysis
