// Double averaging (time, then bed plane) of the time means: on a grid in two dimensions, of the mean field
// in three.

#include "analysis/double_average.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "base/not_a_number.hpp"
#include "statistics/jackknife.hpp"

namespace riffle::inline analysis {

namespace {

constexpr const char* source = "double-averaging method (Nikora et al. 2001)";

/// Mean over each of so many rows of the products of the departures of two time means from their own mean
/// over the row: a row are the points of one height, `across` of them after each other.
template <class Value>
std::vector<double> dispersive(std::size_t rows, const std::vector<Value>& a, const std::vector<Value>& b) {
    std::vector<double> result(rows, not_a_number);
    const std::size_t across = a.size() / std::max<std::size_t>(1, rows);
    for (std::size_t j = 0; j < rows; ++j) {
        double n = 0.0;
        double sum_a = 0.0;
        double sum_b = 0.0;
        double sum_ab = 0.0;
        for (std::size_t i = 0; i < across; ++i) {
            const auto va = static_cast<double>(a[j * across + i]);
            const auto vb = static_cast<double>(b[j * across + i]);
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
    std::vector<double> result(grid.z.size(), not_a_number);
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

/// By its magnitude; NaN of none.
double largest_of(const std::vector<double>& values) {
    double largest = not_a_number;
    for (const double value : values) {
        if (std::isfinite(value) && !(std::abs(value) <= std::abs(largest))) largest = value;
    }
    return largest;
}

Figure stress_figure(const char* caption) {
    return make_figure(chapters::profiles, "double_averaged_stress_profile",
                       "Double-averaged stresses of the resolved motion", caption, source,
                       make_axis("shear stress", "Pa"), make_axis("height above the bed level z", "m"));
}

void add_grid(const FlowRecord& record, Analysis& analysis) {
    const VelocityGrid& grid = record.velocity_grids().front();
    const double density = record.flow()->fluid.density;
    Figure figure = stress_figure(
        "Means along the bed of the Reynolds stress -rho u'w' in time, and dispersive stress of the time "
        "means, -rho <u~ w~> with the departures from their mean along the bed.");
    figure.curves.push_back(make_curve("Reynolds stress in time", record.origin(), Mark::line_and_points,
                                       scaled(mean_along(grid, grid.uw), -density), grid.z));
    Curve form = make_curve("dispersive stress", record.origin(), Mark::line_and_points,
                            scaled(dispersive(grid.z.size(), grid.u, grid.w), -density), grid.z);
    form.variant = 1;
    const double largest = largest_of(form.x);
    figure.curves.push_back(std::move(form));
    analysis.figures.push_back(std::move(figure));
    if (!std::isfinite(largest)) return;
    analysis.findings.push_back(make_finding(chapters::profiles, "dispersive_stress_largest",
                                             "largest dispersive stress", "Pa", largest));
}

using Velocity = std::vector<float> FieldBlock::*;

/// A form-induced moment of the mean field at each height, from the products of different blocks of windows,
/// in which what the averaging has left of the fluctuation has no part; of a single block the plain one.
/// Intervals by the jackknife over the blocks, of three and more.
FieldEstimates form_induced(const MeanFlow& field, Velocity first, Velocity second) {
    const std::size_t rows = field.z.size();
    const std::size_t blocks = field.blocks.size();
    const auto moment = [&](std::size_t left_out) {
        const std::size_t cells = field.box.cells();
        std::vector<double> a(cells, 0.0);
        std::vector<double> b(cells, 0.0);
        std::vector<double> own(rows, 0.0);
        double n = 0.0;
        for (std::size_t k = 0; k < blocks; ++k) {
            if (k == left_out) continue;
            const std::vector<float>& one = field.blocks[k].*first;
            const std::vector<float>& other = field.blocks[k].*second;
            n += 1.0;
            for (std::size_t cell = 0; cell < cells; ++cell) {
                a[cell] += static_cast<double>(one[cell]);
                b[cell] += static_cast<double>(other[cell]);
            }
            const std::vector<double> part = dispersive(rows, one, other);
            for (std::size_t j = 0; j < rows; ++j) own[j] += part[j];
        }
        std::vector<double> whole = dispersive(rows, a, b);
        for (std::size_t j = 0; j < rows; ++j) {
            whole[j] = n > 1.0 ? (whole[j] - own[j]) / (n * (n - 1.0)) : whole[j];
        }
        return whole;
    };
    FieldEstimates result{moment(blocks), std::vector<double>(rows, std::numeric_limits<double>::infinity())};
    if (blocks < 3) return result;
    std::vector<std::vector<double>> without_one;
    for (std::size_t k = 0; k < blocks; ++k) without_one.push_back(moment(k));
    std::vector<double> values(blocks);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t k = 0; k < blocks; ++k) values[k] = without_one[k][j];
        result.half_width[j] = jackknife_half_width(values);
    }
    return result;
}

Curve form_curve(const char* name, int variant, const MeanFlow& field, FieldEstimates found, double factor) {
    Curve curve = make_curve(name, Origin::simulated, Mark::line_and_points,
                             scaled(std::move(found.value), factor), field.z);
    const bool known = std::any_of(found.half_width.begin(), found.half_width.end(),
                                   [](double width) { return std::isfinite(width); });
    if (known) curve.x_half_width = scaled(std::move(found.half_width), std::abs(factor));
    curve.variant = variant;
    return curve;
}

/// Plan means of the mean field at each height.
std::vector<double> plan_means(const MeanFlow& field, FieldQuantity quantity, bool in_time) {
    const std::size_t across = field.y.size() * field.x.size();
    std::vector<double> result(field.z.size(), not_a_number);
    for (std::size_t iz = 0; iz < result.size(); ++iz) {
        FieldSums row(1);
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t cell = 0; cell < across; ++cell) {
            row.add(0, field.box, iz * across + cell);
            const double value = field.box.mean(quantity, iz * across + cell);
            if (!std::isfinite(value)) continue;
            sum += value;
            count += 1.0;
        }
        result[iz] = in_time ? (count > 0.0 ? sum / count : not_a_number) : row.mean(quantity, 0);
    }
    return result;
}

void add_mean_field(const FlowRecord& record, const FieldEstimates& form, Analysis& analysis) {
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const double density = c.fluid.density;
    Figure velocity = make_figure(
        chapters::profiles, "double_averaged_velocity_profile", "Double-averaged velocity",
        "Mean streamwise velocity in time and over the plan, of the water between and above the crests.",
        source, make_axis("streamwise velocity <u>", "m/s"), make_axis("height above the bed level z", "m"));
    velocity.curves.push_back(make_curve("simulated", record.origin(), Mark::line_and_points,
                                         plan_means(field, FieldQuantity::velocity, false), field.z));
    analysis.figures.push_back(std::move(velocity));

    Figure figure = stress_figure(
        "Means over the plan: stress of viscosity and closure, Reynolds stress -rho u'w' of the fluctuation "
        "in time, and form-induced stress -rho <u~ w~> of the departures of the time means from their mean "
        "over the plan, the latter from products of different stretches of time, so that the fluctuation "
        "left in them has no part; bars: 95 % intervals.");
    figure.curves.push_back(make_curve("viscosity and closure", record.origin(), Mark::line,
                                       plan_means(field, FieldQuantity::shear_stress, false), field.z));
    Curve reynolds =
        make_curve("Reynolds stress in time", record.origin(), Mark::line_and_points,
                   scaled(plan_means(field, FieldQuantity::velocity_covariance, true), -density), field.z);
    reynolds.variant = 1;
    figure.curves.push_back(std::move(reynolds));
    figure.curves.push_back(form_curve("form-induced stress", 2, field, form, 1.0));
    analysis.figures.push_back(std::move(figure));

    Figure moments = make_figure(
        chapters::profiles, "form_induced_moment_profile", "Form-induced velocity variances",
        "Means over the plan of the squared departures of the time means of u, v, w from their means over "
        "the plan, from products of different stretches of time; bars: 95 % intervals.",
        source, make_axis("form-induced variance", "m2/s2"), make_axis("height above the bed level z", "m"));
    moments.curves.push_back(
        form_curve("<u~ u~>", 0, field, form_induced(field, &FieldBlock::u, &FieldBlock::u), 1.0));
    moments.curves.push_back(
        form_curve("<v~ v~>", 1, field, form_induced(field, &FieldBlock::v, &FieldBlock::v), 1.0));
    moments.curves.push_back(
        form_curve("<w~ w~>", 2, field, form_induced(field, &FieldBlock::w, &FieldBlock::w), 1.0));
    analysis.figures.push_back(std::move(moments));

    std::size_t most = field.z.size();
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        if (field.z[iz] < c.crest() || !std::isfinite(form.value[iz])) continue;
        if (most == field.z.size() || std::abs(form.value[iz]) > std::abs(form.value[most])) most = iz;
    }
    if (most == field.z.size()) return;
    Finding finding = make_finding(chapters::profiles, "dispersive_stress_largest",
                                   "largest form-induced stress above the crests", "Pa", form.value[most],
                                   form.half_width[most]);
    finding.remark = fmt::format("{:.4g} mm above the bed level", 1000.0 * field.z[most]);
    const double bed_stress = density * c.streamwise_gravity() * (c.total_depth() - c.crest());
    if (bed_stress > 0.0) {
        finding.remark += fmt::format(", {:.2g} % of tau_b", 100.0 * form.value[most] / bed_stress);
    }
    if (c.has_side_walls()) {
        finding.remark += "; between side walls the departures hold those across the whole section";
    }
    analysis.findings.push_back(std::move(finding));
}

}  // namespace

FieldEstimates form_induced_stress(const FlowRecord& record) {
    if (record.flow() == nullptr || !is_three_dimensional(record) || record.mean_field().empty()) return {};
    const double density = record.flow()->fluid.density;
    FieldEstimates found = form_induced(record.mean_field(), &FieldBlock::u, &FieldBlock::w);
    return {scaled(std::move(found.value), -density), scaled(std::move(found.half_width), density)};
}

void add_double_averages(const FlowRecord& record, const FieldEstimates& form, Analysis& analysis) {
    if (record.flow() == nullptr) return;
    if (!form.value.empty()) {
        add_mean_field(record, form, analysis);
    } else if (!record.velocity_grids().empty() && !record.velocity_grids().front().uw.empty()) {
        add_grid(record, analysis);
    }
}

}  // namespace riffle::inline analysis
