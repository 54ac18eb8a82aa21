#include "analysis/body_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "case/end_floor.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"
#include "statistics/dominant_frequency.hpp"

namespace riffle::inline analysis {

namespace {

/// What a body presents to the stream: its area, m2, in two dimensions its height, m; and its extent across
/// the stream.
struct Front {
    double area = 0.0;
    double extent = 0.0;
};

/// The part of a surface within a rectangle across the channel as seen along it, by lines along x on a grid.
double silhouette(const SolidMesh& mesh, const Extent& across, const Extent& upright) {
    constexpr int lines = 200;
    const Point3& low = mesh.lower();
    const Point3& high = mesh.upper();
    const double dy = (across.high - across.low) / lines;
    const double dz = (upright.high - upright.low) / lines;
    int hit = 0;
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < lines; ++j) {
            const double y = across.low + (i + 0.5) * dy;
            const double z = upright.low + (j + 0.5) * dz;
            const double beyond = 0.01 * (high[0] - low[0]);
            hit += mesh.tree().first_crossing({low[0] - beyond, y, z}, {high[0] + beyond, y, z}).has_value()
                       ? 1
                       : 0;
        }
    }
    return std::max(0.0, hit * dy * dz);
}

/// Nothing of a body that fills a part of the bed rather than stands in the stream. `level`: of the water,
/// over the bed level, m.
std::optional<Front> front_of(const Case& c, const Solid& solid, double level) {
    if (!solid.rests() || is_bed_shape(solid.shape)) return std::nullopt;
    const auto z = extent_of(c, solid, 2);
    if (!z) return std::nullopt;
    if (c.channel.dimensions == 2) {
        const bool stands_on_bed = z->low < 0.5 * c.numerics.spacing;
        const double height = std::min(z->high, level) - z->low;
        return stands_on_bed || height <= 0.0 ? std::nullopt : std::optional(Front{height, height});
    }
    const auto y = extent_of(c, solid, 1);
    const SolidMesh* const mesh = mesh_of(c, solid);
    if (!y || mesh == nullptr || z->low >= level) return std::nullopt;
    Extent across = *y;
    if (c.channel.sides != Sides::periodic) {
        across.low = std::max(across.low, 0.0);
        across.high = std::min(across.high, c.channel.simulated_width());
    }
    const double width = across.high - across.low;
    if (width > 0.9 * c.channel.simulated_width()) return std::nullopt;
    // Of a body that a plane of symmetry cuts the other half is not simulated, and feels as much.
    const bool cut = c.channel.sides == Sides::half && y->high > c.channel.simulated_width();
    Extent upright = *z;
    upright.low = std::max(upright.low, 0.0);
    upright.high = std::min(upright.high, level);
    return Front{silhouette(*mesh, across, upright),
                 std::min(cut ? 2.0 * width : width, upright.high - upright.low)};
}

/// Mean of a series over the window.
std::optional<double> window_mean(const FlowRecord& record, const Field& field) {
    if (!record.series().has(field)) return std::nullopt;
    const std::vector<double> values = within_window(record, field);
    if (values.size() < 2) return std::nullopt;
    return mean_with_confidence(values).mean;
}

/// The stream that comes to the bodies, over the window.
struct Approach {
    double velocity = 0.0;  ///< bulk velocity, m/s
    double depth = 0.0;     ///< from the bed level, m
};

/// Between open ends that of what enters; the depth of such a case is that of the start alone.
std::optional<Approach> approach(const FlowRecord& record) {
    const Case& c = *record.flow();
    if (c.channel.ends != Ends::open) {
        const auto velocity = window_mean(record, fields::time_series.total_mean_velocity);
        return velocity ? std::optional(Approach{*velocity, c.total_depth()}) : std::nullopt;
    }
    const auto discharge = window_mean(record, fields::time_series.inflow_discharge);
    const auto depth = window_mean(record, fields::time_series.inflow_depth);
    if (!discharge || !depth || *depth <= end_floors(c).upstream) return std::nullopt;
    const double over_floor = *depth - end_floors(c).upstream;
    return Approach{*discharge / (c.channel.flow_width() * over_floor), *depth};
}

/// The swing of a body that vortices make which leave it in turn: the strongest of lift and side force, where
/// it rules what is slower than the time of passing the body, in at least four periods.
std::optional<Oscillation> shedding(const FlowRecord& record, std::size_t number, double highest) {
    std::optional<Oscillation> strongest;
    for (const Field& field : {fields::solid_forces.lift, fields::solid_forces.side_force}) {
        const ScalarProbe* const force = find_scalar(record, numbered_name(field, number));
        if (force == nullptr) continue;
        const double interval =
            (force->time.back() - force->time.front()) / static_cast<double>(force->time.size() - 1);
        const auto found = dominant_oscillation(force->value, interval, highest);
        if (found && (!strongest || found->amplitude > strongest->amplitude)) strongest = found;
    }
    // What leaks below the limit from sound above it is a small part of all.
    const bool rules = strongest && strongest->share >= 0.5 && strongest->whole_share >= 0.1;
    return rules && strongest->periods >= 4.0 ? strongest : std::nullopt;
}

/// The highest frequency that is looked at: bodies shed at 0.1 to 0.4 U/D. Above stands sound, in a duct from
/// its first wave across the height, c0/(2 H), on.
double highest_shedding(const FlowRecord& record, double velocity, double extent) {
    const Case& c = *record.flow();
    const double of_body = 0.5 * velocity / extent;
    const std::optional<double> sound = record.sound_speed();
    if (c.channel.top != Top::wall || !sound) return of_body;
    return std::min(of_body, 0.8 * *sound / (2.0 * c.total_depth()));
}

}  // namespace

void add_body_coefficients(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    if (c.solids.empty() || is_undriven(flow_kind(c))) return;
    const auto stream = approach(record);
    if (!stream || !(stream->velocity > 0.0)) return;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        if (c.solids[k].part_of_bed) continue;
        const auto front = front_of(c, c.solids[k], stream->depth);
        if (!front || front->area <= 0.0) continue;
        const double head = 0.5 * c.fluid.density * stream->velocity * stream->velocity * front->area;
        const std::string& name = c.solids[k].name;
        const auto add = [&](const Field& field, const char* key, const char* label) {
            const ScalarProbe* const force = find_scalar(record, numbered_name(field, k + 1));
            if (force == nullptr) return;
            const MeanEstimate mean = mean_with_confidence(force->value);
            Finding finding = make_finding(chapters::forces, fmt::format("{}_{}", key, k + 1),
                                           fmt::format("{} of \"{}\"", label, name), "1", mean.mean / head,
                                           trusted_half_width(mean));
            if (finding.half_width) *finding.half_width /= head;
            finding.remark = fmt::format(
                "with the bulk velocity {:.4g} m/s and {} {:.4g} {}", stream->velocity,
                c.channel.dimensions == 3 ? "the area seen along the channel" : "the height of the body",
                front->area, c.channel.dimensions == 3 ? "m2" : "m");
            if (c.channel.ends == Ends::open && c.channel.top == Top::free_surface) {
                finding.remark += fmt::format(" below the {:.4g} m of the water that comes", stream->depth);
            }
            analysis.findings.push_back(std::move(finding));
        };
        add(fields::solid_forces.force, "drag_coefficient", "drag coefficient");
        if (c.channel.top !=
            Top::free_surface) {  // else it carries the weight of the water that it displaces
            add(fields::solid_forces.lift, "lift_coefficient", "lift coefficient");
        }
        const auto swing = shedding(record, k + 1, highest_shedding(record, stream->velocity, front->extent));
        if (!swing) continue;
        Finding strouhal = make_finding(chapters::forces, fmt::format("strouhal_number_{}", k + 1),
                                        fmt::format("Strouhal number of \"{}\", f D/U", name), "1",
                                        swing->frequency * front->extent / stream->velocity, std::nullopt);
        strouhal.remark =
            fmt::format("{:.4g} Hz in {:.0f} periods; amplitude of its coefficient {:.3g}; D = {:.4g} m",
                        swing->frequency, swing->periods, swing->amplitude / head, front->extent);
        analysis.findings.push_back(std::move(strouhal));
    }
}

}  // namespace riffle::inline analysis
