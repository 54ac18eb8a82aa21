// The stress near the bed across the channel.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/bed_parts.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/section_points.hpp"
#include "base/not_a_number.hpp"
#include "case/bed_friction.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/secondary_flow_laws.hpp"
#include "roughness/side_wall_partition.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double thesis_height = 0.012;  // m above the datum

/// Height that the water above a place of the bed has in the partition of Yang & Lim: up to the division
/// line from the corner, whose base is k times its height.
double yang_lim_height(const Case& c, const SideWallPartition& partition, double y) {
    const double from_wall = std::min(y, c.channel.width - y);
    return std::min(c.total_depth(), from_wall / partition.k);
}

/// The undulation of the stress by cells of secondary flow, away from the side walls.
void add_cells(const Distribution& d, double scale, const Case& c, Figure& figure, Analysis& analysis) {
    std::vector<double> y;
    std::vector<double> stress;
    for (std::size_t i = 0; i < d.y.size(); ++i) {
        // Within a depth of a side wall the stress falls towards it, cells or not.
        const bool beside_wall =
            c.has_side_walls() && std::min(d.y[i], c.channel.width - d.y[i]) < c.total_depth();
        if (beside_wall || !std::isfinite(d.period_mean[i])) continue;
        y.push_back(d.y[i]);
        stress.push_back(d.period_mean[i] / scale);
    }
    const BedStressFit fit = fit_bed_stress(y, stress);
    if (!fit.valid) {
        analysis.warnings.push_back("cells in the bed stress (2.29): " + fit.why_not);
        return;
    }
    // A cell that three of the field's do not resolve is none.
    if (y.size() < 2 || fit.cell_width.value < 3.0 * (y[1] - y[0])) {
        analysis.warnings.emplace_back(
            "cells in the bed stress (2.29): none, the fit follows the scatter from place to place");
        return;
    }
    Finding finding = against(
        make_finding(chapters::bed, "bed_stress_undulation",
                     "undulation of the bed stress over its mean, by cells (2.29)", "1", fit.amplitude),
        secondary_flow_bed_amplitude, "Wang & Cheng, over strips");
    finding.remark = fmt::format(
        "cells {:.3g} H wide, fitted a depth and more from side walls; the thesis' runs: 0.9 to 1.2 H",
        fit.cell_width.value / c.total_depth());
    analysis.findings.push_back(std::move(finding));
    Curve curve = make_curve("cells (2.29)", Origin::fit, Mark::line, {}, {});
    constexpr int points = 200;
    for (int i = 0; i <= points; ++i) {
        curve.x.push_back(fit.from + (fit.to - fit.from) * i / points);
        curve.y.push_back(fit.at(curve.x.back()));
    }
    figure.curves.push_back(std::move(curve));
}

/// Reynolds stresses that were measured across the channel near a height over the bed level, over the uniform
/// value there.
void add_measured_stress(const FlowRecord& record, double z, double uniform, const Distribution* simulated,
                         Figure& figure, Analysis& analysis) {
    constexpr double near = 0.004;  // m
    const Case& c = *record.flow();
    for (const MeasuredRow& row : measured_rows(points_beside(record))) {
        if (std::abs(row.z - z) > near) continue;
        Curve curve =
            make_curve(fmt::format("measured {:.3g} mm above the datum", 1000.0 * (row.z - c.datum())),
                       Origin::measured, Mark::points, {}, {});
        double error = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < row.y.size(); ++i) {
            const double stress = c.fluid.density * row.reynolds_stress[i] / uniform;
            if (!std::isfinite(stress)) continue;
            curve.x.push_back(row.y[i]);
            curve.y.push_back(stress);
            if (simulated == nullptr) continue;
            const double beside = interpolated(simulated->y, simulated->period_mean, row.y[i]) / uniform;
            if (!std::isfinite(beside)) continue;
            error += squared_error_percentage(stress, beside);
            count += 1.0;
        }
        if (curve.x.empty()) continue;
        figure.curves.push_back(std::move(curve));
        if (count > 0.0) {
            analysis.findings.push_back(
                against(make_finding(chapters::bed, "bed_stress_msep",
                                     "MSEP of the bed stress across the channel", "%", error / count),
                        4.0, "thesis, 3D simulations"));
        }
        return;
    }
}

std::size_t row_at(const MeanFlow& field, double z) {
    std::size_t nearest = 0;
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        if (std::abs(field.z[iz] - z) < std::abs(field.z[nearest] - z)) nearest = iz;
    }
    return nearest;
}

/// Height over the bed level at which the stress is taken, m: the thesis', but above the layer in which the
/// friction of a plane bed acts, where a part of the stress is with the bed already.
double stress_height(const Case& c) {
    const double lowest = has_wall_law(c) ? top_of_bed_friction(c) + 0.5 * c.numerics.spacing : 0.0;
    return std::max(c.datum() + thesis_height, lowest);
}

/// The stress at that height.
void add_simulated(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const std::size_t iz = row_at(field, stress_height(c));
    const double z = field.z[iz];
    const double rho = c.fluid.density;
    const double uniform = rho * c.streamwise_gravity() * (c.total_depth() - z);
    Figure figure = make_figure(
        chapters::bed, "bed_stress_distribution", "Bed stress across the channel",
        fmt::format(
            "Stress of viscosity and closure and resolved Reynolds stress at {:.3g} mm above the "
            "datum, over the uniform value rho g S0 (H - z) = {:.4g} Pa of a wide channel; bars: 95 "
            "% intervals. Yang & Lim: the weight of the water above each place of the bed up to the line "
            "that divides the bed's water from the walls'.",
            1000.0 * (z - c.datum()), uniform),
        "thesis chapter 5, lateral distribution of the bed stress", across_axis(c),
        make_axis("stress over the uniform value", "1"));
    const Distribution d = distribution_of(field, c, [&](const FieldSums& section) {
        const std::vector<double> stress = total_stress(section, rho, false);
        const auto first = stress.begin() + static_cast<std::ptrdiff_t>(iz * field.y.size());
        return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(field.y.size()));
    });
    add_distribution(d, uniform, figure);
    const SectionTwin& twin = record.section_twin();
    if (!twin.empty() && !twin.shear_stress.empty()) {
        std::vector<double> stress;
        for (const double y : twin.y) stress.push_back(twin_value(twin, twin.shear_stress, y, z) / uniform);
        figure.curves.push_back(
            make_curve("section twin", Origin::column, Mark::line, twin.y, std::move(stress)));
    }
    add_measured_stress(record, z, uniform, &d, figure, analysis);
    add_cells(d, uniform, c, figure, analysis);
    add_yang_lim(c, figure);
    figure.curves.push_back(make_curve("wide channel", Origin::reference, Mark::line,
                                       {0.0, c.channel.simulated_width()}, {1.0, 1.0}));
    analysis.figures.push_back(std::move(figure));
    analysis.findings.push_back(
        against(make_finding(chapters::bed, "bed_stress_mean",
                             fmt::format("mean stress {:.3g} mm above the datum", 1000.0 * (z - c.datum())),
                             "Pa", d.mean.value, d.mean.half_width),
                uniform, "wide channel, rho g S0 (H - z)"));
    add_departure(d, uniform, "bed_stress_departure", "largest departure of the stress from the uniform one",
                  c.has_side_walls() ? std::optional<double>(-0.26) : std::nullopt, analysis);
}

/// Points of a laboratory alone.
void add_measured(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    const double uniform = c.fluid.density * c.streamwise_gravity() * (c.channel.depth - thesis_height);
    if (!(uniform > 0.0)) return;
    Figure figure = make_figure(
        chapters::bed, "bed_stress_distribution", "Bed stress across the channel",
        fmt::format("Measured Reynolds stress over the uniform value rho g S0 (H - z) = {:.4g} Pa of a wide "
                    "channel, {:.3g} mm above the datum.",
                    uniform, 1000.0 * thesis_height),
        "thesis Figs 3.3, 5.20(e) and 5.22(e)", across_axis(c),
        make_axis("stress over the uniform value", "1"));
    add_measured_stress(record, c.datum() + thesis_height, uniform, nullptr, figure, analysis);
    if (figure.curves.empty()) return;
    add_yang_lim(c, figure);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

Distribution distribution_of(const MeanFlow& field, const Case& c, const SectionEstimator& estimator) {
    const double period = lattice_period_across(c).value_or(0.0);
    Distribution result;
    result.of_elements = period > 0.0;
    result.y = field.y;
    result.value = section_estimates(field, estimator).value;
    const FieldEstimates smooth = section_estimates(
        field, [&](const FieldSums& section) { return period_means(field.y, estimator(section), period); });
    result.period_mean = smooth.value;
    result.half_width = smooth.half_width;
    result.mean = section_estimate(field, [&](const FieldSums& section) {
        double sum = 0.0;
        double count = 0.0;
        for (const double value : estimator(section)) {
            if (!std::isfinite(value)) continue;
            sum += value;
            count += 1.0;
        }
        return count > 0.0 ? sum / count : not_a_number;
    });
    return result;
}

void add_distribution(const Distribution& d, double scale, Figure& figure) {
    const auto over = [scale](std::vector<double> values) {
        for (double& value : values) value /= scale;
        return values;
    };
    if (d.of_elements) {
        Curve cells = make_curve("cells", Origin::simulated, Mark::line, d.y, over(d.value));
        cells.variant = 4;
        figure.curves.push_back(std::move(cells));
    }
    Curve mean = make_curve(d.of_elements ? "mean over a period of the spheres" : "simulated",
                            Origin::simulated, Mark::line_and_points, d.y, over(d.period_mean));
    if (std::isfinite(d.half_width.front())) mean.y_half_width = over(d.half_width);
    figure.curves.push_back(std::move(mean));
}

void add_departure(const Distribution& d, double uniform, const char* key, const char* what,
                   const std::optional<double>& thesis, Analysis& analysis) {
    double most = 0.0;
    double where = 0.0;
    for (std::size_t i = 0; i < d.y.size(); ++i) {
        const double departure = d.period_mean[i] / uniform - 1.0;
        if (!std::isfinite(departure) || std::abs(departure) <= std::abs(most)) continue;
        most = departure;
        where = d.y[i];
    }
    Finding finding = against(make_finding(chapters::bed, key, what, "1", most), thesis,
                              "thesis, 3D: up to 26 % near the wall");
    finding.remark = fmt::format("at y = {}{}", shown_place(where),
                                 d.of_elements ? ", of means over a period of the spheres" : "");
    analysis.findings.push_back(std::move(finding));
}

const char* partition_name(const Case& c) {
    const auto& wall = c.side_walls.equivalent_roughness;
    const bool alike = c.side_walls.drag_form != SideDragForm::log_law ||
                       (c.bed_patches.empty() && (!wall || wall == c.bed.equivalent_roughness));
    return alike ? "Yang & Lim" : "Yang & Lim, of walls as rough as the bed";
}

void add_yang_lim(const Case& c, Figure& figure) {
    if (!c.has_side_walls()) return;
    const SideWallPartition partition = side_wall_partition(c);
    Curve curve =
        make_curve(std::string(partition_name(c)) + ", at the bed", Origin::theory, Mark::line, {}, {});
    constexpr int points = 200;
    for (int i = 0; i <= points; ++i) {
        const double y = c.channel.simulated_width() * i / points;
        curve.x.push_back(y);
        curve.y.push_back(yang_lim_height(c, partition, y) / c.total_depth());
    }
    figure.curves.push_back(std::move(curve));
}

void add_bed_stress(const FlowRecord& record, Analysis& analysis) {
    if (record.origin() == Origin::measured) {
        if (record.flow() != nullptr && !record.section_points().empty()) add_measured(record, analysis);
    } else {
        add_simulated(record, analysis);
    }
}

}  // namespace riffle::inline analysis
