// Double averaging (time, then bed plane) of the means on a grid.

#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"

namespace riffle {

namespace {

constexpr const char* chapter = "profiles";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Mean along x of the products of the departures of two time means from their own mean along x.
std::vector<double> dispersive(const VelocityGrid& grid, const std::vector<double>& a,
                               const std::vector<double>& b) {
    std::vector<double> result(grid.z.size(), nan);
    for (std::size_t j = 0; j < grid.z.size(); ++j) {
        double n = 0.0;
        double sum_a = 0.0;
        double sum_b = 0.0;
        double sum_ab = 0.0;
        for (std::size_t i = 0; i < grid.x.size(); ++i) {
            const double va = a[j * grid.x.size() + i];
            const double vb = b[j * grid.x.size() + i];
            if (!std::isfinite(va) || !std::isfinite(vb)) continue;
            n += 1.0;
            sum_a += va;
            sum_b += vb;
            sum_ab += va * vb;
        }
        if (n > 1.0) result[j] = sum_ab / n - sum_a / n * sum_b / n;
    }
    return result;
}

std::vector<double> mean_along(const VelocityGrid& grid, const std::vector<double>& values) {
    std::vector<double> result(grid.z.size(), nan);
    for (std::size_t j = 0; j < grid.z.size(); ++j) {
        double n = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < grid.x.size(); ++i) {
            const double value = values[j * grid.x.size() + i];
            if (!std::isfinite(value)) continue;
            n += 1.0;
            sum += value;
        }
        if (n > 0.0) result[j] = sum / n;
    }
    return result;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}

void add_map(const VelocityGrid& grid, const char* key, const char* title, const char* label,
             const char* unit, const std::vector<double>& values, bool diverging, Analysis& analysis) {
    Figure figure = make_figure(
        chapter, key, title, "Time mean over the window on the grid of the instrument.",
        "thesis chapter 4, contours in the x-z plane", make_axis("distance along the channel x", "m"),
        make_axis("height above the bed level z", "m"));
    ColourMap map;
    map.x = grid.x;
    map.y = grid.z;
    map.label = label;
    map.unit = unit;
    map.diverging = diverging;
    for (const double value : values) map.values.push_back(static_cast<float>(value));
    figure.maps.push_back(std::move(map));
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

void add_double_averages(const FlowRecord& record, Analysis& analysis) {
    if (record.velocity_grids().empty() || record.flow() == nullptr) return;
    const VelocityGrid& grid = record.velocity_grids().front();
    const double density = record.flow()->fluid.density;
    Figure figure = make_figure(
        chapter, "double_averaged_stress_profile", "Double-averaged stresses of the resolved motion",
        "Means along the bed of the Reynolds stress -rho u'w' in time, and dispersive stress of the time "
        "means, "
        "-rho <u~ w~> with the departures from their mean along the bed.",
        "double-averaging method (Nikora et al. 2001)", make_axis("shear stress", "Pa"),
        make_axis("height above the bed level z", "m"));
    figure.curves.push_back(make_curve("Reynolds stress in time", record.origin(), Mark::line_and_points,
                                       scaled(mean_along(grid, grid.uw), -density), grid.z));
    Curve form = make_curve("dispersive stress", record.origin(), Mark::line_and_points,
                            scaled(dispersive(grid, grid.u, grid.w), -density), grid.z);
    form.variant = 1;
    double largest = 0.0;
    for (const double stress : form.x) {
        if (std::isfinite(stress) && std::abs(stress) > std::abs(largest)) largest = stress;
    }
    figure.curves.push_back(std::move(form));
    analysis.figures.push_back(std::move(figure));
    analysis.findings.push_back(
        make_finding(chapter, "dispersive_stress_largest", "largest dispersive stress", "Pa", largest));
    add_map(grid, "mean_velocity_map", "Mean streamwise velocity", "streamwise velocity u", "m/s", grid.u,
            false, analysis);
    add_map(grid, "mean_vertical_velocity_map", "Mean vertical velocity", "vertical velocity w", "m/s",
            grid.w, true, analysis);
    add_map(grid, "reynolds_stress_map", "Resolved Reynolds stress", "-rho u'w'", "Pa",
            scaled(grid.uw, -density), true, analysis);
}

}  // namespace riffle
