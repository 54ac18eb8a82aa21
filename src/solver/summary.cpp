#include "solver/summary.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "case/bed_friction.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "case/solid_mesh.hpp"
#include "hydraulics/channel_laws.hpp"
#include "hydraulics/log_law.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline solver {

namespace {

/// Root mean square and largest magnitude of a sequence.
struct Norms {
    double sum = 0.0;
    double largest = 0.0;
    int count = 0;
    void add(double x) {
        sum += x * x;
        largest = std::max(largest, std::abs(x));
        ++count;
    }
    [[nodiscard]] double rms() const { return count > 0 ? std::sqrt(sum / count) : 0.0; }
};

double window_mean(const TimeSeries& series, const Field& field, double from, double to) {
    const auto& time = series.column(fields::time_series.time);
    const auto& values = series.column(field);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] >= from && time[i] <= to && std::isfinite(values[i])) {
            sum += values[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Slope of the straight line through a record's window, per second.
double window_trend(const TimeSeries& series, const Field& field, double from, double to) {
    const auto& time = series.column(fields::time_series.time);
    const auto& values = series.column(field);
    const double mean_time = 0.5 * (from + to);
    const double mean = window_mean(series, field, from, to);
    double covariance = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] >= from && time[i] <= to && std::isfinite(values[i])) {
            covariance += (time[i] - mean_time) * (values[i] - mean);
            variance += (time[i] - mean_time) * (time[i] - mean_time);
        }
    }
    return variance > 0.0 ? covariance / variance : 0.0;
}

void add_column_departures(const Case& c, const Profiles& p, Numbers& summary) {
    Norms above;
    Norms below;
    const PorosityField field(c);
    const auto within_stones = [&](double z) {
        return field.porosity(0.5 * c.channel.length, 0.5 * c.channel.width, z) < 1.0;
    };
    // Over a layer of stones the departures are those of the open water: where the water creeps, a thousandth
    // of the velocity is all of it.
    const bool open_water = !std::all_of(p.z.begin(), p.z.end(), within_stones);
    for (std::size_t k = 0; k < p.z.size(); ++k) {
        if (open_water && within_stones(p.z[k])) continue;
        if (has_wall_law(c) && p.z[k] < top_of_bed_friction(c)) {
            continue;  // rows that stand for the discharge of the law, not for its velocity
        }
        const double relative = p.velocity_deviation[k] / p.column_velocity[k];
        (p.z[k] > c.crest() ? above : below).add(relative);
    }
    summary.set(fields::summary.velocity_error_above_rms, above.rms());
    summary.set(fields::summary.velocity_error_above_maximum, above.largest);
    if (!has_wall_law(c)) {
        summary.set(fields::summary.velocity_error_below_rms, below.rms());
        summary.set(fields::summary.velocity_error_below_maximum, below.largest);
    }
}

/// Height below which bodies carry a part of the weight by the pressure on their faces, m: 0 without bodies.
double top_of_solids(const Case& c) {
    double top = 0.0;
    if (c.channel.dimensions == 3 && !c.solids.empty()) {
        const auto meshes = meshes_of(c);
        for (const SolidMesh& mesh : *meshes) top = std::max(top, mesh.upper()[2]);
    }
    for (const Solid& solid : c.solids) {
        for (const double z : solid.z) top = std::max(top, z);
    }
    return top;
}

void add_stresses(const Case& c, const Profiles& p, Numbers& summary) {
    const double crest_stress = c.fluid.density * c.streamwise_gravity() * (c.total_depth() - c.crest());
    if (crest_stress <= 0.0 || p.z.size() < 6) return;
    // Where the porosity changes along the channel the pressure pushes the grains too, in the pair forces.
    if (porosity_varies_along(c)) return;
    const double from = std::max(top_of_bed_friction(c), top_of_solids(c));
    Norms spurious;
    Norms error;
    for (std::size_t k = 0; k + 4 < p.z.size() && !p.pair_stress.empty(); ++k) {
        if (p.bin_upper[k] < from) continue;
        spurious.add(p.pair_stress[k] / crest_stress);
        if (!p.analytic_stress.empty()) error.add((p.total_stress[k] - p.analytic_stress[k]) / crest_stress);
    }
    if (spurious.count == 0) {
        return;  // bodies stand through the whole depth
    }
    summary.set(fields::summary.spurious_stress_rms, spurious.rms());
    summary.set(fields::summary.spurious_stress_maximum, spurious.largest);
    if (error.count > 0) summary.set(fields::summary.stress_error_rms, error.rms());
    if (has_bodies(c) || !c.vegetation.empty() || !c.porous.empty()) {
        return;  // the stress at the bed is not the one that continues the line
    }
    if (const std::optional<StressLine> line = fit_stress_line(c, p)) {
        summary.set(fields::summary.friction_velocity,
                    std::sqrt(std::max(0.0, line->crest_stress / c.fluid.density)));
    }
}

void add_log_law(const Case& c, const Profiles& p, Numbers& summary) {
    if (!has_rough_bed(c)) return;
    const HeightRange range = log_law_range(c);
    const LogLawFit fit = fit_log_law(p.z, p.velocity, log_law_kappa, c.datum(), range.from, range.to);
    if (fit.valid) {
        summary.set(fields::summary.log_law_friction_velocity, fit.friction_velocity);
        summary.set(fields::summary.log_law_friction_velocity_half_width, fit.friction_velocity_half_width);
        summary.set(fields::summary.equivalent_roughness, fit.equivalent_roughness);
        summary.set(fields::summary.equivalent_roughness_half_width, fit.equivalent_roughness_half_width);
        summary.set(fields::summary.zero_plane, fit.zero_plane);
    }
}

}  // namespace

std::optional<double> bed_stress_of_weight(const Case& c, std::span<const double> share,
                                           std::span<const double> volume) {
    const double weight = c.fluid.density * c.streamwise_gravity();
    const double area = c.channel.length * c.channel.flow_width();
    if (!(weight > 0.0) || share.empty() || share.size() != volume.size()) return std::nullopt;
    const double sum = std::inner_product(share.begin(), share.end(), volume.begin(), 0.0);
    return weight * sum / static_cast<double>(share.size()) / area;
}

std::optional<double> open_friction_velocity(const Case& c, std::span<const double> drag_share,
                                             std::span<const double> wall_share,
                                             std::span<const double> volume) {
    const bool other_forces = has_bodies(c) || has_solid_bed(c) || !c.vegetation.empty() ||
                              !c.porous.empty() || c.channel.top == Top::wall || rests_at_sides(c);
    if (c.channel.ends != Ends::open || other_forces) return std::nullopt;
    const auto stress = bed_stress_of_weight(c, is_no_slip(c.bed) ? wall_share : drag_share, volume);
    if (!stress) return std::nullopt;
    const double depth = std::accumulate(volume.begin(), volume.end(), 0.0) /
                         static_cast<double>(volume.size()) / (c.channel.length * c.channel.flow_width());
    const double above_crests = std::max(0.0, 1.0 - c.crest() / depth);
    return std::sqrt(std::max(0.0, *stress * above_crests / c.fluid.density));
}

std::optional<StressLine> fit_stress_line(const Case& c, const Profiles& p) {
    return fit_stress_line(c, p.bin_upper, p.total_stress);
}

std::optional<StressLine> fit_stress_line(const Case& c, const std::vector<double>& height,
                                          const std::vector<double>& total_stress) {
    constexpr std::size_t top_layers = 4;
    const bool balances = only_bed_holds(c) || has_periodic_lid(c);
    if (c.streamwise_gravity() <= 0.0 || c.total_depth() <= c.crest() || !balances) return std::nullopt;
    // The stress at the crests is the value of the line at 1; below a free surface the line ends there with
    // nothing, at a wall at the top with what the wall takes.
    std::vector<double> line;
    std::vector<double> stress;
    for (std::size_t k = 0; k + top_layers < total_stress.size() && k < height.size(); ++k) {
        if (height[k] < top_of_bed_friction(c)) continue;
        line.push_back((c.total_depth() - height[k]) / (c.total_depth() - c.crest()));
        stress.push_back(total_stress[k]);
    }
    const std::size_t unknowns = has_periodic_lid(c) ? 2 : 1;
    if (line.size() < unknowns + 1) return std::nullopt;
    const auto count = static_cast<double>(line.size());
    double line_mean = 0.0;
    double stress_mean = 0.0;
    if (unknowns == 2) {
        line_mean = std::accumulate(line.begin(), line.end(), 0.0) / count;
        stress_mean = std::accumulate(stress.begin(), stress.end(), 0.0) / count;
    }
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        products += (stress[k] - stress_mean) * (line[k] - line_mean);
        squares += (line[k] - line_mean) * (line[k] - line_mean);
    }
    const double slope = products / squares;
    StressLine result{stress_mean + slope * (1.0 - line_mean), 0.0};
    double departures = 0.0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const double departure = stress[k] - stress_mean - slope * (line[k] - line_mean);
        departures += departure * departure;
    }
    const double freedom = count - static_cast<double>(unknowns);
    const double spread =
        (1.0 - line_mean) * (1.0 - line_mean) / squares + (unknowns == 2 ? 1.0 / count : 0.0);
    const boost::math::students_t student(freedom);
    result.half_width = boost::math::quantile(student, 0.975) * std::sqrt(departures / freedom * spread);
    return result;
}

Numbers summarise(const Case& c, const Twins& twins, const TimeSeries& series, const Profiles& profiles,
                  const Convergence& convergence) {
    Numbers summary;
    const auto& time = series.column(fields::time_series.time);
    if (time.empty()) return summary;
    const double from = profiles.empty() ? convergence.window_start : profiles.window_start;
    const double to = time.back();
    summary.set(fields::summary.converged, convergence.converged ? 1.0 : 0.0);
    summary.set(fields::summary.window_start, from);
    summary.set(fields::summary.window_end, to);
    if (const auto relaxation = tested_relaxation_time(c, twins)) {
        summary.set(fields::summary.relaxation_time, *relaxation);
    }
    const auto first =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from) - time.begin());
    const auto estimate = mean_with_confidence(
        std::span(series.column(fields::time_series.depth_mean_velocity)).subspan(first));
    summary.set(fields::summary.depth_mean_velocity, estimate.mean);
    summary.set(fields::summary.depth_mean_velocity_effective_samples, estimate.effective_samples);
    // A mean from too few independent samples has no interval.
    if (const auto half_width = trusted_half_width(estimate)) {
        summary.set(fields::summary.depth_mean_velocity_half_width, *half_width);
    }
    summary.set(fields::summary.depth_mean_velocity_integral_time,
                estimate.integral_time * (to - time[first]) /
                    std::max<double>(1.0, static_cast<double>(time.size() - first - 1)));
    summary.set(fields::summary.remaining_drift, convergence.remaining_drift);
    summary.set(fields::summary.velocity_fluctuation_growth, std::expm1(convergence.fluctuation_growth));
    summary.set(fields::summary.velocity_fluctuation_growth_least,
                std::expm1(convergence.fluctuation_growth - convergence.fluctuation_growth_half_width));
    const auto& outcomes = fields::summary;
    const auto& of_series = fields::time_series;
    const auto set_mean = [&](const Field& outcome, const Field& field) {
        summary.set(outcome, window_mean(series, field, from, to));
    };
    set_mean(outcomes.total_mean_velocity, of_series.total_mean_velocity);
    set_mean(outcomes.drag_over_gravity, of_series.drag_over_gravity);
    set_mean(outcomes.wall_over_gravity, of_series.wall_over_gravity);
    if (!c.vegetation.empty()) set_mean(outcomes.vegetation_over_gravity, of_series.vegetation_over_gravity);
    if (!c.porous.empty()) set_mean(outcomes.porous_over_gravity, of_series.porous_over_gravity);
    set_mean(outcomes.mean_level, of_series.mean_level);
    set_mean(outcomes.velocity_fluctuation, of_series.velocity_fluctuation);
    set_mean(outcomes.particle_order, of_series.particle_order);
    set_mean(outcomes.density_deviation_minimum, of_series.density_deviation_minimum);
    set_mean(outcomes.density_deviation_maximum, of_series.density_deviation_maximum);
    if (c.channel.dimensions == 3) {
        const auto centreline = mean_with_confidence(
            std::span(series.column(fields::time_series.centreline_velocity)).subspan(first));
        summary.set(fields::summary.centreline_velocity, centreline.mean);
        if (const auto half_width = trusted_half_width(centreline)) {
            summary.set(fields::summary.centreline_velocity_half_width, *half_width);
        }
        set_mean(outcomes.side_wall_over_gravity, of_series.side_wall_over_gravity);
        set_mean(outcomes.secondary_velocity, of_series.secondary_velocity);
    }
    summary.set(fields::summary.level_trend, window_trend(series, fields::time_series.mean_level, from, to));
    // The level's drift over the whole run, from the means of its first and last seconds.
    summary.set(fields::summary.level_drift,
                window_mean(series, fields::time_series.mean_level, to - 1.0, to) -
                    window_mean(series, fields::time_series.mean_level, 0.0, std::min(1.0, to)));
    if (profiles.empty()) return summary;
    const bool open = c.channel.ends == Ends::open;
    const auto depth_at = [&](const Field& field) {
        return open ? std::optional<double>(window_mean(series, field, from, to)) : std::nullopt;
    };
    if (has_level_surface(c, depth_at(of_series.inflow_depth), depth_at(of_series.outflow_depth))) {
        summary.set(fields::summary.surface_velocity, profiles.velocity.back());
    }
    if (twins.column) {
        add_column_departures(c, profiles, summary);
        const double reference =
            twins.section ? twins.section->depth_mean_velocity : twins.column->depth_mean_velocity;
        const double total = twins.section ? twins.section->bulk_velocity : twins.column->total_mean_velocity;
        if (reference != 0.0) {
            summary.set(fields::summary.depth_mean_velocity_error, estimate.mean / reference - 1.0);
        }
        if (total != 0.0) {
            summary.set(fields::summary.total_mean_velocity_error,
                        summary.value(fields::summary.total_mean_velocity) / total - 1.0);
        }
    }
    add_stresses(c, profiles, summary);
    const auto in_window = [&](const Field& field) { return std::span(series.column(field)).subspan(first); };
    const auto by_force =
        open_friction_velocity(c, in_window(of_series.drag_over_gravity),
                               in_window(of_series.wall_over_gravity), in_window(of_series.water_volume));
    if (by_force) summary.set(fields::summary.friction_velocity, *by_force);
    add_log_law(c, profiles, summary);
    return summary;
}

}  // namespace riffle::inline solver
