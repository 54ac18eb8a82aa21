#include "analysis/flow_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "hydraulics/channel_laws.hpp"
#include "hydraulics/log_law.hpp"
#include "record/flow_fields.hpp"
#include "solver/summary.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

const SeriesTable& FlowRecord::series() const {
    static const SeriesTable none;
    return none;
}

const Profiles& FlowRecord::profiles() const {
    static const Profiles none;
    return none;
}

const SpaceTime& FlowRecord::surface() const {
    static const SpaceTime none;
    return none;
}

const std::vector<ElevationProbe>& FlowRecord::elevation_probes() const {
    static const std::vector<ElevationProbe> none;
    return none;
}

const std::vector<VelocityProbe>& FlowRecord::velocity_probes() const {
    static const std::vector<VelocityProbe> none;
    return none;
}

const std::vector<VelocityGrid>& FlowRecord::velocity_grids() const {
    static const std::vector<VelocityGrid> none;
    return none;
}

const std::vector<VelocityPlane>& FlowRecord::velocity_planes() const {
    static const std::vector<VelocityPlane> none;
    return none;
}

SpaceTime VelocityPlane::line(const std::vector<double>& values, std::size_t j) const {
    std::vector<double> at_height;
    at_height.reserve(time.size() * x.size());
    for (std::size_t row = 0; row < time.size(); ++row) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>((row * z.size() + j) * x.size());
        at_height.insert(at_height.end(), first, first + static_cast<std::ptrdiff_t>(x.size()));
    }
    return make_space_time(x, time, at_height, period);
}

const std::vector<ScalarProbe>& FlowRecord::scalar_probes() const {
    static const std::vector<ScalarProbe> none;
    return none;
}

const MeanFlow& FlowRecord::mean_field() const {
    static const MeanFlow none;
    return none;
}

const EddiesAndNoise& FlowRecord::eddies_and_noise() const {
    static const EddiesAndNoise none;
    return none;
}

const SurfaceMaps& FlowRecord::surface_maps() const {
    static const SurfaceMaps none;
    return none;
}

const SectionTwin& FlowRecord::section_twin() const {
    static const SectionTwin none;
    return none;
}

const SectionPoints& FlowRecord::section_points() const {
    static const SectionPoints none;
    return none;
}

const FlowRecord::Measured& FlowRecord::measured() const {
    static const Measured none;
    return none;
}

std::vector<double> VelocityProbe::point(const std::vector<double>& values, std::size_t i) const {
    std::vector<double> record;
    record.reserve(time.size());
    for (std::size_t row = 0; row < time.size(); ++row) record.push_back(values[row * z.size() + i]);
    return record;
}

std::vector<double> within_window(const FlowRecord& record, const Field& field) {
    const std::vector<double>& values = record.series()[field];
    const std::vector<double>& time = record.series()[fields::time_series.time];
    const TimeWindow window = record.window();
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i) {
        if (window.holds(time[i]) && std::isfinite(values[i])) result.push_back(values[i]);
    }
    return result;
}

const ScalarProbe* find_scalar(const FlowRecord& record, const std::string& quantity,
                               const std::string& instrument) {
    const ScalarProbe* finest = nullptr;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.quantity == quantity && (instrument.empty() || probe.name == instrument) &&
            probe.value.size() > (finest != nullptr ? finest->value.size() : 1)) {
            finest = &probe;
        }
    }
    return finest;
}

const ScalarProbe* find_at_end(const FlowRecord& record, const Field& quantity, int end) {
    return find_scalar(record, fmt::format("{}_{}", quantity.name, end), "standard_end_sections");
}

double bulk_velocity(const FlowRecord& record) {
    const std::vector<double> velocity = within_window(record, fields::time_series.depth_mean_velocity);
    if (!velocity.empty()) {
        return std::accumulate(velocity.begin(), velocity.end(), 0.0) / static_cast<double>(velocity.size());
    }
    const Case* const flow = record.flow();
    const Profiles& p = record.profiles();
    if (record.origin() == Origin::measured && flow != nullptr && !p.velocity.empty()) {
        const auto mean = profile_depth_mean({p.z, p.velocity, {}, flow->datum()}, flow->channel.depth);
        if (mean) return *mean;
    }
    return flow != nullptr ? flow->measured.depth_mean_velocity.value_or(0.0) : 0.0;
}

double surface_velocity(const FlowRecord& record) {
    const Profiles& p = record.profiles();
    if (record.flow() == nullptr || p.velocity.size() != p.z.size()) return 0.0;
    const auto depth_at = [&](const Field& field) -> std::optional<double> {
        const std::vector<double> depth = within_window(record, field);
        return depth.empty() ? std::nullopt : std::optional(mean_of(depth));
    };
    if (record.origin() == Origin::simulated &&
        !has_level_surface(*record.flow(), depth_at(fields::time_series.inflow_depth),
                           depth_at(fields::time_series.outflow_depth))) {
        return 0.0;
    }
    constexpr double near_surface = 0.8;  // of the total depth
    for (std::size_t i = p.z.size(); i-- > 0;) {
        if (p.z[i] < near_surface * record.flow()->total_depth()) return 0.0;
        if (std::isfinite(p.velocity[i]) && p.velocity[i] != 0.0) return p.velocity[i];
    }
    return 0.0;
}

double water_depth(const FlowRecord& record) {
    const Case& c = *record.flow();
    if (record.origin() != Origin::simulated || c.channel.ends != Ends::open ||
        record.surface().rows() == 0) {
        return c.channel.depth;
    }
    const double depth = mean_level(record.surface()).mean - c.datum();
    return depth > 0.0 ? depth : c.channel.depth;
}

double friction_velocity_of(const FlowRecord& record) {
    const Case* const flow = record.flow();
    if (flow == nullptr) return 0.0;
    const std::optional<StressLine> line = fit_stress_line(*flow, record.profiles());
    if (line && line->crest_stress > 0.0) return std::sqrt(line->crest_stress / flow->fluid.density);
    const auto& of = fields::time_series;
    const std::optional<double> by_force = open_friction_velocity(
        *flow, within_window(record, of.drag_over_gravity), within_window(record, of.wall_over_gravity),
        within_window(record, of.water_volume));
    if (by_force && *by_force > 0.0) return *by_force;
    if (flow->measured.friction_velocity) return *flow->measured.friction_velocity;
    return flow->channel.slope > 0.0
               ? friction_velocity_from_slope(flow->streamwise_gravity(), flow->channel.depth)
               : 0.0;
}

}  // namespace riffle::inline analysis
