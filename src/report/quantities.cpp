#include "report/quantities.hpp"

#include <algorithm>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle {

namespace {

using Value = std::optional<SummaryValue>;

/// A value derived from another by a monotone law: its interval is the image of the other's ends.
template <typename Law>
Value derived(const Value& from, const Law& law) {
    if (!from || !(from->value > 0)) return std::nullopt;
    SummaryValue result{law(from->value), std::nullopt};
    if (from->half_width && *from->half_width < from->value) {
        const double low = law(from->value - *from->half_width);
        const double high = law(from->value + *from->half_width);
        result.half_width = 0.5 * std::abs(high - low);
    }
    return result;
}

Value plain(const std::optional<double>& value) {
    if (!value) return std::nullopt;
    return SummaryValue{*value, std::nullopt};
}

/// The three columns of a row: simulated, measured, column twin.
struct Sources {
    Value simulated, measured, column;

    template <typename Law>
    [[nodiscard]] Sources through(const Law& law) const {
        return {derived(simulated, law), derived(measured, law), derived(column, law)};
    }
};

class Table {
  public:
    void add(Quantity row, const Sources& sources) {
        if (!sources.simulated && !sources.measured && !sources.column) return;
        row.simulated = sources.simulated;
        row.measured = sources.measured;
        row.column = sources.column;
        rows_.push_back(std::move(row));
    }
    [[nodiscard]] std::vector<Quantity> take() { return std::move(rows_); }

  private:
    std::vector<Quantity> rows_;
};

Sources depth_mean_velocity(const ReportData& data) {
    Sources sources;
    if (const auto value = find_value(data.summary, "depth_mean_velocity")) {
        sources.simulated = SummaryValue{*value, find_value(data.summary, "depth_mean_velocity_half_width")};
    }
    if (data.flow.has_side_walls()) {
        // The measured velocity is that of the centreline: centreline_velocity.
        sources.column = plain(find_value(data.section_summary, "depth_mean_velocity"));
        return sources;
    }
    sources.measured = plain(data.flow.measured.depth_mean_velocity);
    sources.column = plain(find_value(data.column_summary, "depth_mean_velocity"));
    return sources;
}

void add_velocities(Table& table, const ReportData& data, const Sources& mean) {
    table.add(
        {"depth_mean_velocity", "Depth-mean velocity above the datum", "<i>U</i>", "m/s", 1, 4, {}, {}, {}},
        mean);
    const auto centreline = find_value(data.summary, "centreline_velocity");
    if (centreline && data.flow.has_side_walls()) {
        table.add({"centreline_velocity",
                   "Depth-mean velocity around the centreline",
                   "<i>U</i><sub>c</sub>",
                   "m/s",
                   1,
                   4,
                   {},
                   {},
                   {}},
                  {SummaryValue{*centreline, find_value(data.summary, "centreline_velocity_half_width")},
                   plain(data.flow.measured.depth_mean_velocity),
                   plain(find_value(data.section_summary, "centreline_velocity"))});
    }
    table.add(
        {"surface_velocity", "Velocity at the surface", "<i>u</i><sub>s</sub>", "m/s", 1, 4, {}, {}, {}},
        {plain(find_value(data.summary, "surface_velocity")),
         {},
         plain(find_value(data.column_summary, "surface_velocity"))});
}

void add_friction(Table& table, const ReportData& data) {
    const Measured& measured = data.flow.measured;
    table.add({"friction_velocity",
               data.flow.bed.kind == BedKind::spheres ? "Friction velocity, from the stress at the crests"
                                                      : "Friction velocity, from the stress at the bed",
               "<i>u</i><sub>∗</sub>",
               "m/s",
               1,
               4,
               {},
               {},
               {}},
              {plain(find_value(data.summary, "friction_velocity")), plain(measured.friction_velocity),
               plain(find_value(data.column_summary, "friction_velocity"))});
    Value fitted_velocity;
    Value fitted_roughness;
    if (data.log_law.valid) {
        fitted_velocity =
            SummaryValue{data.log_law.friction_velocity, data.log_law.friction_velocity_half_width};
        fitted_roughness =
            SummaryValue{data.log_law.equivalent_roughness, data.log_law.equivalent_roughness_half_width};
    } else {
        fitted_roughness = plain(find_value(data.summary, "equivalent_roughness"));
    }
    table.add({"log_law_friction_velocity",
               "Friction velocity, from the log-law fit",
               "<i>u</i><sub>∗</sub>",
               "m/s",
               1,
               4,
               {},
               {},
               {}},
              {fitted_velocity, plain(measured.friction_velocity),
               plain(find_value(data.column_summary, "log_law_friction_velocity"))});
    table.add({"equivalent_roughness",
               "Equivalent roughness, from the log-law fit",
               "<i>k</i><sub>s</sub>",
               "mm",
               1000,
               3,
               {},
               {},
               {}},
              {fitted_roughness, plain(measured.equivalent_roughness),
               plain(find_value(data.column_summary, "equivalent_roughness"))});
}

/// Surface level and how much it moves: as the analysis finds it, so that a page gives one value.
void add_levels(Table& table, const ReportData& data, const Analysis& analysis) {
    table.add({"mean_level",
               "Mean water level above the bed level",
               "<i>z</i><sub>s</sub>",
               "mm",
               1000,
               4,
               {},
               {},
               {}},
              {plain(find_value(data.summary, "mean_level")), {}, plain(data.flow.total_depth())});
    Value fluctuation;
    if (const Finding* const found = find_finding(analysis, "surface_standard_deviation")) {
        fluctuation = SummaryValue{found->value, found->half_width};
    } else if (data.surface) {
        fluctuation = SummaryValue{data.surface->standard_deviation, std::nullopt};
    }
    table.add({"surface_standard_deviation",
               "Surface fluctuation, standard deviation",
               "<i>σ</i><sub>η</sub>",
               "mm",
               1000,
               3,
               {},
               {},
               {}},
              {fluctuation, plain(data.flow.measured.surface_standard_deviation), {}});
}

/// Numbers of hydraulics that follow from the depth-mean velocity, for a wide channel (no side walls, as the
/// flow is computed: hydraulic radius = depth above the datum).
void add_channel_numbers(Table& table, const ReportData& data, const Sources& mean) {
    const Case& c = data.flow;
    const double depth = c.channel.depth;
    if (c.channel.slope <= 0) return;  // no mean flow to characterise
    const double component = c.streamwise_gravity();
    const double slope = c.channel.slope;
    table.add({"friction_factor", "Friction factor (Darcy and Weisbach)", "<i>f</i>", "1", 1, 4, {}, {}, {}},
              mean.through([=](double u) { return friction_factor(component, depth, u); }));
    table.add({"manning", "Manning's coefficient", "<i>n</i>", "s/m<sup>1/3</sup>", 1, 4, {}, {}, {}},
              mean.through([=](double u) { return manning_coefficient(slope, depth, u); }));
    table.add({"chezy", "Chezy's coefficient", "<i>C</i>", "m<sup>1/2</sup>/s", 1, 4, {}, {}, {}},
              mean.through([=](double u) { return chezy_coefficient(slope, depth, u); }));
    table.add({"froude", "Froude number", "Fr", "1", 1, 3, {}, {}, {}},
              mean.through([=, g = c.fluid.gravity](double u) { return froude_number(u, g, depth); }));
    table.add({"reynolds", "Reynolds number", "Re", "1", 1, 4, {}, {}, {}},
              mean.through(
                  [=, nu = c.fluid.kinematic_viscosity](double u) { return reynolds_number(u, depth, nu); }));
}

void add_forces(Table& table, const ReportData& data) {
    if (data.flow.channel.slope <= 0) return;
    table.add({"drag_over_gravity", "Drag of the bed elements / weight component", "", "1", 1, 4, {}, {}, {}},
              {plain(find_value(data.summary, "drag_over_gravity")),
               {},
               plain(find_value(data.flow.has_side_walls() ? data.section_summary : data.column_summary,
                                "drag_share"))});
    if (const auto side = find_value(data.summary, "side_wall_over_gravity");
        side && data.flow.has_side_walls()) {
        table.add({"side_wall_over_gravity",
                   "Drag of the side walls / weight component",
                   "",
                   "1",
                   1,
                   4,
                   {},
                   {},
                   {}},
                  {plain(side), {}, plain(find_value(data.section_summary, "side_wall_share"))});
    }
    // A bed that acts by its elements alone has no wall friction to report.
    const auto wall = find_value(data.summary, "wall_over_gravity");
    const auto column_wall = find_value(data.column_summary, "wall_share");
    if (wall.value_or(0.0) == 0.0 && column_wall.value_or(0.0) == 0.0) return;
    table.add({"wall_over_gravity", "Wall friction / weight component", "", "1", 1, 3, {}, {}, {}},
              {plain(wall), {}, plain(column_wall)});
}

}  // namespace

std::vector<Quantity> summarize(const ReportData& data, const Analysis& analysis) {
    Table table;
    const Sources mean = depth_mean_velocity(data);
    add_velocities(table, data, mean);
    add_friction(table, data);
    add_levels(table, data, analysis);
    add_channel_numbers(table, data, mean);
    add_forces(table, data);
    return table.take();
}

const Quantity* find_quantity(const std::vector<Quantity>& quantities, const std::string& key) {
    const auto found =
        std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.key == key; });
    return found == quantities.end() ? nullptr : &*found;
}

}  // namespace riffle
