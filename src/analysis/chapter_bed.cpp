// Bed and side walls of a run in three dimensions: stress and drag across the channel, maps of the drag.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/bed_parts.hpp"
#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "base/not_a_number.hpp"
#include "case/bed_traits.hpp"
#include "record/twin_fields.hpp"
#include "roughness/bed_drag.hpp"
#include "roughness/side_wall_partition.hpp"

namespace riffle::inline analysis {

namespace {

/// Drag per plan area of the section twin across the channel, Pa.
std::vector<double> twin_drag(const SectionTwin& twin, const Case& c) {
    const auto law = make_bed_drag(c);
    std::vector<double> drag(twin.y.size(), not_a_number);
    if (law == nullptr || twin.z.size() < 2) return drag;
    for (std::size_t iy = 0; iy < twin.y.size(); ++iy) {
        double sum = 0.0;
        for (std::size_t iz = 0; iz < twin.z.size(); ++iz) {
            // Cells of different heights may be used near the bed: edges half way between the centres.
            const double lower = iz == 0 ? 0.0 : 0.5 * (twin.z[iz - 1] + twin.z[iz]);
            const double upper =
                iz + 1 < twin.z.size() ? 0.5 * (twin.z[iz] + twin.z[iz + 1]) : c.total_depth();
            const double u = twin.velocity[iz * twin.y.size() + iy];
            sum += law->coefficient(twin.z[iz]) * u * std::abs(u) * (upper - lower);
        }
        drag[iy] = c.fluid.density * sum;
    }
    return drag;
}

/// The drag of the bed's elements on each plan area.
void add_drag(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const double uniform = c.fluid.density * c.streamwise_gravity() * c.total_depth();
    Figure figure = make_figure(
        chapters::bed, "bed_drag_distribution", "Drag of the bed across the channel",
        fmt::format("Drag of the bed's elements per plan area, over rho g S0 H = {:.4g} Pa, the weight "
                    "component on it; bars: 95 % intervals. The rows of spheres show in the cells.",
                    uniform),
        "thesis chapter 5, bed stress from the drag", across_axis(c),
        make_axis("drag per plan area over rho g S0 H", "1"));
    const double height = field.cell_height();
    const Distribution d = distribution_of(field, c, [&](const FieldSums& section) {
        std::vector<double> drag(field.y.size(), 0.0);
        for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
            for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
                const double force = section.mean(FieldQuantity::drag, field.at(iz, iy));
                // The drag on the water is negative, that on the bed its opposite.
                if (std::isfinite(force)) drag[iy] += std::abs(force) * height;
            }
        }
        return drag;
    });
    add_distribution(d, uniform, figure);
    const SectionTwin& twin = record.section_twin();
    if (!twin.empty()) {
        std::vector<double> drag = twin_drag(twin, c);
        for (double& value : drag) value /= uniform;
        figure.curves.push_back(make_curve("section twin", Origin::column, Mark::line, twin.y, drag));
    }
    add_yang_lim(c, figure);
    figure.curves.push_back(make_curve("wide channel", Origin::reference, Mark::line,
                                       {0.0, c.channel.simulated_width()}, {1.0, 1.0}));
    analysis.figures.push_back(std::move(figure));
    Finding mean = make_finding(chapters::bed, "bed_drag_mean", "mean drag of the bed per plan area", "Pa",
                                d.mean.value, d.mean.half_width);
    if (c.has_side_walls()) {
        mean =
            against(std::move(mean), c.fluid.density * side_wall_partition(c).bed_stress, partition_name(c));
        if (const auto beside = twin.value(fields::section_numbers.bed_stress)) {
            mean.remark = fmt::format("section twin: {:.4g} Pa", *beside);
        }
    } else {
        mean = against(std::move(mean), uniform, "rho g S0 H");
    }
    analysis.findings.push_back(std::move(mean));
    add_departure(d, uniform, "bed_drag_departure", "largest departure of the drag from rho g S0 H",
                  std::nullopt, analysis);
}

/// Stress on the side walls over the height.
void add_walls(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    if (!c.has_side_wall_drag()) return;
    const double walls = c.channel.sides == Sides::half ? 1.0 : 2.0;
    const SideWallPartition partition = side_wall_partition(c);
    const double cell_width = field.y.size() > 1 ? field.cell_width() : c.channel.simulated_width();
    const double scale = c.fluid.density * c.streamwise_gravity() * c.total_depth();
    const SectionEstimator stress = [&](const FieldSums& section) {
        std::vector<double> values(field.z.size(), 0.0);
        for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
            for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
                const double force = section.mean(FieldQuantity::side_wall_drag, field.at(iz, iy));
                if (std::isfinite(force)) values[iz] += std::abs(force) * cell_width / walls;
            }
        }
        return values;
    };
    Figure figure = make_figure(
        chapters::bed, "wall_stress_distribution", "Stress on the side walls over the height",
        fmt::format("Drag of the side walls' layers per wall area, over rho g S0 H = {:.4g} Pa, with 95 % "
                    "intervals; Yang & Lim: the weight of the water beside each height up to the division "
                    "line.",
                    scale),
        "thesis (5.11)-(5.13)", make_axis("wall stress over rho g S0 H", "1"),
        make_axis("height above the bed level z", "m"));
    FieldEstimates found = section_estimates(field, stress);
    for (double& value : found.value) value /= scale;
    for (double& value : found.half_width) value /= scale;
    Curve curve = make_curve("simulated", Origin::simulated, Mark::line_and_points, found.value, field.z);
    if (std::isfinite(found.half_width.front())) curve.x_half_width = found.half_width;
    figure.curves.push_back(std::move(curve));
    figure.curves.push_back(make_curve(partition_name(c), Origin::theory, Mark::line, {0.0, partition.k},
                                       {0.0, c.total_depth()}));
    analysis.figures.push_back(std::move(figure));
    const Estimate estimate = section_estimate(field, [&](const FieldSums& section) {
        double sum = 0.0;
        for (const double value : stress(section)) sum += value * field.cell_height() / c.total_depth();
        return sum;
    });
    Finding finding = against(make_finding(chapters::bed, "wall_stress_mean", "mean stress on the side walls",
                                           "Pa", estimate.value, estimate.half_width),
                              c.fluid.density * partition.wall_stress, partition_name(c));
    if (const auto beside = record.section_twin().value(fields::section_numbers.wall_stress)) {
        finding.remark = fmt::format("section twin: {:.4g} Pa", *beside);
    }
    analysis.findings.push_back(std::move(finding));
}

ColourMap force_map(const std::vector<double>& x, const std::vector<double>& y,
                    const std::vector<double>& values, double factor, const char* label, const char* unit) {
    ColourMap map;
    map.x = x;
    map.y = y;
    map.label = label;
    map.unit = unit;
    map.diverging = true;
    map.values.reserve(values.size());
    for (const double value : values) map.values.push_back(static_cast<float>(factor * value));
    return map;
}

/// Maps of the drag on the water: over the bed, the cross-section and the plane along the flow.
void add_maps(const FlowRecord& record, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const Axis along = make_axis("distance along the channel x", "m");
    const Axis height = make_axis("height z", "m");
    const char* const source = "thesis chapter 5, drag-force maps";
    const auto add = [&](const char* key, const char* title, std::string caption, const Axis& x,
                         const Axis& y, const std::vector<double>& xs, const std::vector<double>& ys,
                         const FieldSums& sums, double factor, const char* unit, bool in_plan) {
        Figure figure = make_figure(chapters::bed, key, title, std::move(caption), source, x, y);
        figure.y.equal_scale = in_plan;
        figure.maps.push_back(
            force_map(xs, ys, sums.means(FieldQuantity::drag), factor, "streamwise drag f_x", unit));
        figure.maps.push_back(
            force_map(xs, ys, sums.means(FieldQuantity::spanwise_drag), factor, "spanwise drag f_y", unit));
        analysis.figures.push_back(std::move(figure));
    };
    add("drag_plan_map", "Drag of the bed in plan",
        "Force of the bed's elements on the water per plan area, summed over the depth.", along,
        across_axis(c), field.x, field.y, field.plan(),
        field.cell_height() * static_cast<double>(field.z.size()), "Pa", true);
    add("drag_section_map", "Drag of the bed over the cross-section",
        "Force of the bed's elements on the water per volume, mean over the length.", across_axis(c), height,
        field.y, field.z, field.section(), 1.0, "N/m3", false);
    add("drag_side_map", "Drag of the bed along the channel",
        "Force of the bed's elements on the water per volume, mean over the width.", along, height, field.x,
        field.z, field.side(), 1.0, "N/m3", false);
    // Above the crests there is none.
    for (Figure& figure : analysis.figures) {
        if (figure.key == "drag_section_map" || figure.key == "drag_side_map") {
            figure.y.from = 0.0;
            figure.y.to = std::min(c.total_depth(), 1.25 * c.crest());
        }
    }
}

}  // namespace

void analyse_bed(const FlowRecord& record, Analysis& analysis) {
    if (record.origin() == Origin::measured) add_bed_stress(record, analysis);
    if (!is_three_dimensional(record)) return;
    const Case& c = *record.flow();
    if (record.mean_field().empty() || c.channel.slope <= 0.0) {
        add_missing(record, analysis,
                    make_figure(chapters::bed, "bed_stress_distribution", "Bed stress across the channel", "",
                                "", across_axis(c), make_axis("stress over the uniform value", "1")),
                    c.channel.slope <= 0.0 ? "the channel has no slope, so no stress to compare with"
                                           : "the results file holds no window of the mean field within the "
                                             "averaging window");
        return;
    }
    add_bed_stress(record, analysis);
    if (has_spheres(c.bed)) {
        add_drag(record, analysis);
        add_maps(record, analysis);
    }
    add_walls(record, analysis);
}

}  // namespace riffle::inline analysis
