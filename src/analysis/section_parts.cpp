#include "analysis/section_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "base/interpolation.hpp"
#include "base/not_a_number.hpp"
#include "case/bed_traits.hpp"
#include "case/sphere_tiling.hpp"
#include "record/flow_fields.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

std::vector<double> over(std::vector<double> values, double scale) {
    for (double& value : values) value /= scale;
    return values;
}

/// Whether the ends are walls, between which nothing carries the surface.
bool between_end_walls(const FlowRecord& record) {
    return record.flow() != nullptr && record.flow()->channel.ends == Ends::walls;
}

}  // namespace

bool is_three_dimensional(const FlowRecord& record) {
    return record.origin() == Origin::simulated && record.flow() != nullptr &&
           record.flow()->channel.dimensions == 3;
}

bool between_side_walls(const FlowRecord& record) {
    return record.origin() == Origin::simulated && record.flow() != nullptr &&
           record.flow()->has_side_walls();
}

std::optional<double> lattice_period_across(const Case& c) {
    if (!has_spheres(c.bed)) return std::nullopt;
    return lattice_periods(c.bed).y;
}

Strip strip_around(const Case& c, double y) {
    const double half = 0.5 * lattice_period_across(c).value_or(0.1 * c.channel.width);
    return {std::max(0.0, y - half), std::min(c.channel.simulated_width(), y + half)};
}

Strip centreline_strip(const Case& c) { return strip_around(c, c.channel.centreline()); }

std::vector<double> resolved_stress(const FieldSums& section, double density, bool lateral) {
    std::vector<double> stress = section.means(lateral ? FieldQuantity::velocity_spanwise_covariance
                                                       : FieldQuantity::velocity_covariance);
    for (double& value : stress) value *= -density;
    return stress;
}

std::vector<double> total_stress(const FieldSums& section, double density, bool lateral) {
    std::vector<double> stress =
        section.means(lateral ? FieldQuantity::lateral_shear_stress : FieldQuantity::shear_stress);
    const std::vector<double> resolved = resolved_stress(section, density, lateral);
    for (std::size_t i = 0; i < stress.size(); ++i) stress[i] += resolved[i];
    return stress;
}

SectionProfile strip_profile(const MeanFlow& field, const Strip& strip, const SectionEstimator& estimator) {
    const FieldEstimates found = section_estimates(field, [&](const FieldSums& section) {
        return estimator(strip_of(field, section, strip.from, strip.to));
    });
    SectionProfile profile;
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        if (!std::isfinite(found.value[iz])) continue;
        profile.z.push_back(field.z[iz]);
        profile.value.push_back(found.value[iz]);
        profile.half_width.push_back(found.half_width[iz]);
    }
    return profile;
}

SectionProfile centreline_velocity_profile(const FlowRecord& record) {
    if (!is_three_dimensional(record) || record.mean_field().empty()) return {};
    return strip_profile(record.mean_field(), centreline_strip(*record.flow()),
                         [](const FieldSums& strip) { return strip.means(FieldQuantity::velocity); });
}

double velocity_at_centreline(const FlowRecord& record) {
    if (between_end_walls(record)) return 0.0;
    if (between_side_walls(record)) {
        const std::vector<double> velocity = within_window(record, fields::time_series.centreline_velocity);
        if (!velocity.empty()) return mean_of(velocity);
    }
    return bulk_velocity(record);
}

const char* depth_mean_name(const FlowRecord& record) {
    return between_side_walls(record) ? "depth-mean velocity U around the centreline"
                                      : "depth-mean velocity U";
}

double surface_velocity_at_centreline(const FlowRecord& record) {
    if (between_end_walls(record)) return 0.0;
    if (!between_side_walls(record)) return surface_velocity(record);
    // As of profiles: 0 where the level varies along the channel.
    if (surface_velocity(record) == 0.0) return 0.0;
    const SectionProfile u = centreline_velocity_profile(record);
    return u.value.empty() ? 0.0 : u.value.back();
}

double velocity_of_patterns(const FlowRecord& record) {
    const double of_surface = surface_velocity_at_centreline(record);
    return of_surface > 0.0 ? of_surface : velocity_at_centreline(record);
}

double mean_above_datum(const Case& c, const std::vector<double>& z, const std::vector<double>& values,
                        const std::vector<double>& water) {
    const double height = z.size() > 1 ? (z.back() - z.front()) / static_cast<double>(z.size() - 1) : 0.0;
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
        if (!std::isfinite(values[i]) || !(water[i] > 0.0)) continue;
        // The part of the cell that lies above the datum, as far as it is full.
        const double part = water[i] * std::clamp((z[i] + 0.5 * height - c.datum()) / height, 0.0, 1.0);
        sum += part * values[i];
        weight += part;
    }
    return weight > 0.0 ? sum / weight : not_a_number;
}

std::vector<double> twin_profile(const SectionTwin& twin, const std::vector<double>& values, double y) {
    const TablePlace place = place_in(twin.y, y);
    std::vector<double> profile;
    for (std::size_t iz = 0; iz < twin.z.size(); ++iz) {
        const double* const row = &values[iz * twin.y.size()];
        profile.push_back(place.in(row));
    }
    return profile;
}

std::vector<double> twin_profile(const SectionTwin& twin, const std::vector<double>& values,
                                 const Strip& strip) {
    constexpr int places = 40;
    std::vector<double> mean(twin.z.size(), 0.0);
    for (int i = 0; i < places; ++i) {
        const double y = strip.from + (i + 0.5) / places * (strip.to - strip.from);
        const std::vector<double> profile = twin_profile(twin, values, y);
        for (std::size_t iz = 0; iz < mean.size(); ++iz) mean[iz] += profile[iz] / places;
    }
    return mean;
}

double twin_value(const SectionTwin& twin, const std::vector<double>& values, double y, double z) {
    const std::vector<double> profile = twin_profile(twin, values, y);
    const TablePlace place = place_in(twin.z, z);
    return place.in(profile);
}

Axis across_axis(const Case& c, const char* over) {
    const char* const from =
        c.has_side_walls() ? "distance from the side wall y" : "distance across the channel y";
    return make_axis(std::string(from) + over, *over == '\0' ? "m" : "1");
}

Figure section_figure(const char* chapter, std::string key, std::string title, std::string caption,
                      std::string source) {
    Figure figure =
        make_figure(chapter, std::move(key), std::move(title), std::move(caption), std::move(source),
                    make_axis("distance from the wall y/H", "1"), make_axis("height z/H", "1"));
    figure.y.equal_scale = true;
    return figure;
}

ColourMap section_map(const MeanFlow& field, const Case& c, const std::vector<double>& values,
                      std::string label, std::string unit, bool diverging) {
    ColourMap map;
    map.x = over(field.y, c.total_depth());
    map.y = over(field.z, c.total_depth());
    map.label = std::move(label);
    map.unit = std::move(unit);
    map.diverging = diverging;
    map.contours = true;
    map.values.reserve(values.size());
    for (const double value : values) map.values.push_back(static_cast<float>(value));
    return map;
}

Curve section_vectors(const MeanFlow& field, const FieldSums& section, const Case& c, double velocity_scale,
                      const std::string& scale_name) {
    // Means over squares of cells, so that the arrows do not cover each other.
    constexpr double arrows_over_depth = 12.0;
    const double depth = c.total_depth();
    const auto across = static_cast<std::size_t>(
        std::max(1.0, std::round(depth / arrows_over_depth / std::max(field.cell_width(), 1e-9))));
    const auto along = static_cast<std::size_t>(
        std::max(1.0, std::round(depth / arrows_over_depth / std::max(field.cell_height(), 1e-9))));
    struct Arrow {
        double y, z, v, w;
    };
    std::vector<Arrow> arrows;
    double most = 0.0;
    for (std::size_t z0 = 0; z0 < field.z.size(); z0 += along) {
        for (std::size_t y0 = 0; y0 < field.y.size(); y0 += across) {
            FieldSums sums(1);
            const std::size_t z1 = std::min(z0 + along, field.z.size());
            const std::size_t y1 = std::min(y0 + across, field.y.size());
            for (std::size_t iz = z0; iz < z1; ++iz) {
                for (std::size_t iy = y0; iy < y1; ++iy) sums.add(0, section, field.at(iz, iy));
            }
            const Arrow arrow{0.5 * (field.y[y0] + field.y[y1 - 1]), 0.5 * (field.z[z0] + field.z[z1 - 1]),
                              sums.mean(FieldQuantity::spanwise_velocity, 0),
                              sums.mean(FieldQuantity::vertical_velocity, 0)};
            if (!std::isfinite(arrow.v) || !std::isfinite(arrow.w)) continue;
            most = std::max(most, std::hypot(arrow.v, arrow.w));
            arrows.push_back(arrow);
        }
    }
    Curve curve = make_curve(fmt::format("(V, W), longest arrow {:.2g} % of {}",
                                         100.0 * most / std::max(velocity_scale, 1e-300), scale_name),
                             Origin::simulated, Mark::line, {}, {});
    if (!(most > 0.0)) return curve;
    const double scale = 1.0 / (arrows_over_depth * most);
    const auto segment = [&](double y0, double z0, double y1, double z1) {
        curve.x.insert(curve.x.end(), {y0, y1, not_a_number});
        curve.y.insert(curve.y.end(), {z0, z1, not_a_number});
    };
    for (const Arrow& arrow : arrows) {
        const double dy = arrow.v * scale;
        const double dz = arrow.w * scale;
        if (std::hypot(arrow.v, arrow.w) < 0.02 * most) continue;  // shorter than the line is wide
        const double y0 = arrow.y / depth - 0.5 * dy;
        const double z0 = arrow.z / depth - 0.5 * dz;
        segment(y0, z0, y0 + dy, z0 + dz);
        constexpr double head = 0.35;
        for (const double side : {-0.5, 0.5}) {
            segment(y0 + dy, z0 + dz, y0 + dy - head * (dy - side * dz), z0 + dz - head * (dz + side * dy));
        }
    }
    return curve;
}

}  // namespace riffle::inline analysis
