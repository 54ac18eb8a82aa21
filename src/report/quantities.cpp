#include "report/quantities.hpp"

#include <algorithm>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "case/flow_kind.hpp"
#include "column/wide_channel.hpp"
#include "hydraulics/channel_laws.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline report {

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

/// A row without values; `factor` turns SI into the unit.
SummaryRow row_of(const char* key, std::string label, const char* symbol, const char* unit,
                  double factor = 1.0, int digits = 4) {
    SummaryRow row;
    row.key = key;
    row.label = std::move(label);
    row.symbol = symbol;
    row.unit = unit;
    row.factor = factor;
    row.digits = digits;
    return row;
}

class Table {
  public:
    void add(SummaryRow row, const Sources& sources) {
        if (!sources.simulated && !sources.measured && !sources.column) return;
        row.simulated = sources.simulated;
        row.measured = sources.measured;
        row.column = sources.column;
        rows_.push_back(std::move(row));
    }
    [[nodiscard]] std::vector<SummaryRow> take() { return std::move(rows_); }

  private:
    std::vector<SummaryRow> rows_;
};

/// The value of a finding with its interval.
Value found(const Analysis& analysis, const char* key) {
    const Finding* const finding = find_finding(analysis, key);
    return finding == nullptr ? Value() : Value(SummaryValue{finding->value, finding->half_width});
}

/// Of the analysis, whose window may be another than the run's own, else of the run. `half_width`: null where
/// the run has none.
Value of_window(const ReportData& data, const Analysis& analysis, const Field& field,
                const Field* half_width = nullptr) {
    Value value = found(analysis, field.name);
    if (const auto of_run = find_value(data.summary, field); !value && of_run) {
        value = SummaryValue{*of_run, {}};
        if (half_width != nullptr) value->half_width = find_value(data.summary, *half_width);
    }
    return value;
}

Sources depth_mean_velocity(const ReportData& data, const Analysis& analysis) {
    const auto& of = fields::summary;
    Sources sources;
    sources.simulated = of_window(data, analysis, of.depth_mean_velocity, &of.depth_mean_velocity_half_width);
    if (data.flow.has_side_walls()) {
        // The measured velocity is that of the centreline: centreline_velocity.
        sources.column = plain(find_value(data.section, fields::section_numbers.depth_mean_velocity));
        return sources;
    }
    sources.measured = plain(data.flow.measured.depth_mean_velocity);
    sources.column = plain(find_value(data.column, fields::column_numbers.depth_mean_velocity));
    return sources;
}

/// Of the centreline between side walls, where the flow was measured and is nearest to that of a wide
/// channel.
std::optional<Sources> centreline_mean(const ReportData& data) {
    const auto centreline = find_value(data.summary, fields::summary.centreline_velocity);
    if (!centreline || !data.flow.has_side_walls()) return std::nullopt;
    return Sources{
        SummaryValue{*centreline, find_value(data.summary, fields::summary.centreline_velocity_half_width)},
        plain(data.flow.measured.depth_mean_velocity),
        plain(find_value(data.section, fields::section_numbers.centreline_velocity))};
}

void add_velocities(Table& table, const ReportData& data, const Sources& mean) {
    const bool between_walls = data.flow.has_side_walls();
    table.add(row_of("depth_mean_velocity",
                     between_walls ? "Depth-mean velocity above the datum, over the whole width"
                                   : "Depth-mean velocity above the datum",
                     "<i>U</i>", "m/s"),
              mean);
    if (const auto centreline = centreline_mean(data)) {
        table.add(row_of("centreline_velocity", "Depth-mean velocity around the centreline",
                         "<i>U</i><sub>c</sub>", "m/s"),
                  *centreline);
    }
    // The column twin is that of a wide channel: it stands beside nothing between side walls.
    table.add(
        row_of("surface_velocity",
               between_walls ? "Velocity at the surface, over the whole width" : "Velocity at the surface",
               "<i>u</i><sub>s</sub>", "m/s"),
        {plain(find_value(data.summary, fields::summary.surface_velocity)),
         {},
         between_walls ? Value() : plain(find_value(data.column, fields::column_numbers.surface_velocity))});
}

/// Friction velocities and roughness around the centreline of a channel with side walls, where they were
/// measured; the fits of the section twin's own profile there stand beside them.
void add_centreline_friction(Table& table, const ReportData& data, const Analysis& analysis) {
    const Measured& measured = data.flow.measured;
    table.add(row_of("width_friction_velocity",
                     "Friction velocity, from the stress at the crests over the whole width",
                     "<i>u</i><sub>∗</sub>", "m/s"),
              {plain(find_value(data.summary, fields::summary.friction_velocity)), {}, {}});
    table.add(
        row_of("friction_velocity", "Friction velocity, from the stress at the crests around the centreline",
               "<i>u</i><sub>∗</sub>", "m/s"),
        {found(analysis, "friction_velocity"), plain(measured.friction_velocity),
         found(analysis, "section_twin_friction_velocity")});
    table.add(
        row_of("log_law_friction_velocity", "Friction velocity, from the log-law fit around the centreline",
               "<i>u</i><sub>∗</sub>", "m/s"),
        {found(analysis, "log_law_friction_velocity"), plain(measured.friction_velocity),
         found(analysis, "section_twin_log_law_friction_velocity")});
    table.add(
        row_of("equivalent_roughness", "Equivalent roughness, from the log-law fit around the centreline",
               "<i>k</i><sub>s</sub>", "mm", 1000, 3),
        {found(analysis, "equivalent_roughness"), plain(measured.equivalent_roughness),
         found(analysis, "section_twin_equivalent_roughness")});
}

void add_friction(Table& table, const ReportData& data, const Analysis& analysis) {
    const Measured& measured = data.flow.measured;
    // Of the width there are no laws to fit, and nothing measured to compare with; without a mean field
    // nothing is known of the centreline.
    if (data.flow.has_side_walls()) {
        if (find_finding(analysis, "width_friction_velocity") != nullptr) {
            add_centreline_friction(table, data, analysis);
        } else {
            table.add(row_of("width_friction_velocity",
                             "Friction velocity, from the stress at the crests over the whole width",
                             "<i>u</i><sub>∗</sub>", "m/s"),
                      {plain(find_value(data.summary, fields::summary.friction_velocity)), {}, {}});
        }
        return;
    }
    const auto& of = fields::summary;
    table.add(row_of("friction_velocity",
                     has_rough_bed(data.flow) ? "Friction velocity, from the stress at the crests"
                                              : "Friction velocity, from the stress at the bed",
                     "<i>u</i><sub>∗</sub>", "m/s"),
              {of_window(data, analysis, of.friction_velocity), plain(measured.friction_velocity),
               // Among stems and stones it is that of the bed alone.
               data.flow.vegetation.empty() && data.flow.porous.empty()
                   ? plain(find_value(data.column, fields::column_numbers.friction_velocity))
                   : Value()});
    table.add(
        row_of("log_law_friction_velocity", "Friction velocity, from the log-law fit", "<i>u</i><sub>∗</sub>",
               "m/s"),
        {of_window(data, analysis, of.log_law_friction_velocity, &of.log_law_friction_velocity_half_width),
         plain(measured.friction_velocity),
         plain(find_value(data.column, fields::column_numbers.log_law_friction_velocity))});
    table.add(row_of("equivalent_roughness", "Equivalent roughness, from the log-law fit",
                     "<i>k</i><sub>s</sub>", "mm", 1000, 3),
              {of_window(data, analysis, of.equivalent_roughness, &of.equivalent_roughness_half_width),
               plain(measured.equivalent_roughness),
               plain(find_value(data.column, fields::column_numbers.equivalent_roughness))});
    if (const Value with_stress = found(analysis, "stress_equivalent_roughness")) {
        table.add(row_of("stress_equivalent_roughness",
                         "Equivalent roughness, with the friction velocity of the stress",
                         "<i>k</i><sub>s</sub>", "mm", 1000, 3),
                  {with_stress, plain(measured.equivalent_roughness), {}});
    }
}

/// Surface level and how much it moves: as the analysis finds it, so that a page gives one value.
void add_levels(Table& table, const ReportData& data, const Analysis& analysis) {
    table.add(
        row_of("mean_level", "Mean water level above the bed level", "<i>z</i><sub>s</sub>", "mm", 1000, 4),
        {plain(find_value(data.summary, fields::summary.mean_level)), {}, plain(data.flow.total_depth())});
    table.add(row_of("surface_standard_deviation", "Surface fluctuation, standard deviation",
                     "<i>σ</i><sub>η</sub>", "mm", 1000, 3),
              {found(analysis, "surface_standard_deviation"),
               plain(data.flow.measured.surface_standard_deviation),
               {}});
}

/// Numbers of hydraulics that follow from the depth-mean velocity, for a wide channel (hydraulic radius =
/// depth above the datum); between side walls from that around the centreline, as the findings have them.
void add_channel_numbers(Table& table, const ReportData& data, const Sources& whole) {
    const Case& c = data.flow;
    if (c.channel.slope <= 0) return;  // no mean flow to characterise
    const WideChannel channel = wide_channel(c);
    const Sources mean = centreline_mean(data).value_or(whole);
    const auto through = [&](double (WideChannel::*law)(double) const) {
        return mean.through([&channel, law](double u) { return (channel.*law)(u); });
    };
    table.add(row_of("friction_factor", "Friction factor (Darcy and Weisbach)", "<i>f</i>", "1"),
              through(&WideChannel::friction_factor));
    if (channel.has_surface) {
        table.add(row_of("manning", "Manning's coefficient", "<i>n</i>", "s/m<sup>1/3</sup>"),
                  through(&WideChannel::manning));
        table.add(row_of("chezy", "Chezy's coefficient", "<i>C</i>", "m<sup>1/2</sup>/s"),
                  through(&WideChannel::chezy));
        table.add(row_of("froude", "Froude number", "Fr", "1", 1, 3), through(&WideChannel::froude));
    }
    table.add(row_of("reynolds", "Reynolds number", "Re", "1"), through(&WideChannel::reynolds));
}

void add_forces(Table& table, const ReportData& data) {
    if (data.flow.channel.slope <= 0) return;
    const auto of_twin = [&](const Field& of_section, const Field& of_column) {
        return plain(data.flow.has_side_walls() ? find_value(data.section, of_section)
                                                : find_value(data.column, of_column));
    };
    const auto& section = fields::section_numbers;
    const auto& column = fields::column_numbers;
    table.add(row_of("drag_over_gravity", "Drag of the bed elements / weight component", "", "1"),
              {plain(find_value(data.summary, fields::summary.drag_over_gravity)),
               {},
               of_twin(section.drag_share, column.drag_share)});
    if (const auto side = find_value(data.summary, fields::summary.side_wall_over_gravity);
        side && data.flow.has_side_wall_drag()) {
        table.add(
            row_of("side_wall_over_gravity", "Drag of the side walls / weight component", "", "1"),
            {plain(side), {}, plain(find_value(data.section, fields::section_numbers.side_wall_share))});
    }
    if (const auto stems = find_value(data.summary, fields::summary.vegetation_over_gravity)) {
        table.add(row_of("vegetation_over_gravity", "Drag of the vegetation / weight component", "", "1"),
                  {plain(stems), {}, of_twin(section.vegetation_share, column.vegetation_share)});
    }
    if (const auto grains = find_value(data.summary, fields::summary.porous_over_gravity)) {
        table.add(row_of("porous_over_gravity", "Resistance of porous zones / weight component", "", "1"),
                  {plain(grains), {}, of_twin(section.porous_share, column.porous_share)});
    }
    // A bed that acts by its elements alone has no wall friction to report.
    const auto wall = find_value(data.summary, fields::summary.wall_over_gravity);
    const auto twin_wall = data.flow.has_side_walls() ? find_value(data.section, section.wall_share)
                                                      : find_value(data.column, column.wall_share);
    if (wall.value_or(0.0) == 0.0 && twin_wall.value_or(0.0) == 0.0) return;
    table.add(row_of("wall_over_gravity", "Wall friction / weight component", "", "1", 1, 3),
              {plain(wall), {}, plain(twin_wall)});
}

void add_forces_on_bodies(Table& table, const ReportData& data, const Analysis& analysis) {
    const auto& of = fields::summary;
    for (const auto& [field, label] :
         {std::pair{of.drag_over_gravity, "Drag of the bed elements / weight component"},
          std::pair{of.wall_over_gravity, "Force of walls and bodies / weight component"},
          std::pair{of.side_wall_over_gravity, "Drag of the side walls / weight component"},
          std::pair{of.vegetation_over_gravity, "Drag of the vegetation / weight component"},
          std::pair{of.porous_over_gravity, "Resistance of porous zones / weight component"}}) {
        const auto value = find_value(data.summary, field);
        if (value.value_or(0.0) != 0.0) table.add(row_of(field.name, label, "", "1"), {plain(value), {}, {}});
    }
    table.add(row_of("solid_force_share", "of these the force on the bodies", "", "1"),
              {found(analysis, "solid_force_share"), {}, {}});
    table.add(row_of("solid_form_drag_share", "of these by pressure, their form drag", "", "1"),
              {found(analysis, "solid_form_drag_share"), {}, {}});
}

/// Rows that are findings of the analysis, with what theory says beside them.
void add_findings(Table& table, const Analysis& analysis,
                  const std::vector<std::pair<const char*, const char*>>& keys_and_symbols) {
    for (const auto& [key, symbol] : keys_and_symbols) {
        const Finding* const finding = find_finding(analysis, key);
        if (finding == nullptr) continue;
        const bool millimetres = finding->unit == "m";
        std::string label = finding->label;
        if (!label.empty() && label.front() >= 'a' && label.front() <= 'z') {
            label.front() = static_cast<char>(label.front() - 'a' + 'A');
        }
        const std::string unit = millimetres               ? "mm"
                                 : finding->unit == "m2/s" ? "m²/s"
                                 : finding->unit == "m3/s" ? "m³/s"
                                 : finding->unit == "W/m3" ? "W/m³"
                                                           : finding->unit;
        SummaryRow row = row_of(key, std::move(label), symbol, unit.c_str(), millimetres ? 1000.0 : 1.0);
        row.theory = plain(finding->reference);
        table.add(std::move(row), {SummaryValue{finding->value, finding->half_width}, {}, {}});
    }
}

/// What a flood is known by, as it passes the sections of the instruments, and a tide at the sections
/// furthest up and down the channel; the findings have those between.
void add_passages(Table& table, const Analysis& analysis) {
    std::string furthest;  // "_5"
    for (const Finding& finding : analysis.findings) {
        const std::string& key = finding.key;
        if (key.starts_with("tailwater_")) furthest = key.substr(key.rfind('_'));
    }
    for (const Finding& finding : analysis.findings) {
        const std::string& key = finding.key;
        const bool of_tide =
            key.starts_with("tailwater_") && (key.ends_with("_1") || key.ends_with(furthest));
        if (key.starts_with("flood_") || of_tide) add_findings(table, analysis, {{key.c_str(), ""}});
    }
}

}  // namespace

std::vector<SummaryRow> summarize(const ReportData& data, const Analysis& analysis) {
    Table table;
    const FlowKind kind = flow_kind(data.flow);
    if (is_undriven(kind)) {
        add_findings(table, analysis,
                     {{"front_speed", ""},
                      {"mode_period", "<i>T</i>"},
                      {"mode_decay_rate", ""},
                      {"velocity_decay_rate", ""},
                      {"kinetic_energy_largest", ""},
                      {"energy_change", ""},
                      {"volume_change_largest", ""}});
        if (kind == FlowKind::tank && data.flow.channel.top == Top::free_surface) {
            table.add(row_of("mean_level", "Mean level of the wet places, over the averaging window",
                             "<i>z</i><sub>s</sub>", "mm", 1000, 4),
                      {plain(find_value(data.summary, fields::summary.mean_level)), {}, {}});
        }
        return table.take();
    }
    const Sources mean = depth_mean_velocity(data, analysis);
    add_velocities(table, data, mean);
    if (varies_along(kind)) {
        add_findings(table, analysis,
                     {{"canal_velocity", "<i>U</i>"},
                      {"canal_discharge", "<i>Q</i>"},
                      {"unit_discharge", "<i>q</i>"},
                      {"highest_level", ""},
                      {"lowest_level", ""},
                      {"drowned_inflow_depth", ""},
                      {"largest_froude", "Fr"},
                      {"pool_fall", "Δ<i>h</i>"},
                      {"pool_jet_velocity", ""},
                      {"pool_power", ""},
                      {"backwater_departure", ""}});
        add_passages(table, analysis);
        add_forces_on_bodies(table, data, analysis);
        for (std::size_t k = 1; k <= data.flow.solids.size(); ++k) {
            const std::string number = std::to_string(k);
            const std::vector<std::string> keys = {"drag_coefficient_" + number, "lift_coefficient_" + number,
                                                   "strouhal_number_" + number};
            add_findings(table, analysis,
                         {{keys[0].c_str(), ""}, {keys[1].c_str(), ""}, {keys[2].c_str(), ""}});
        }
        return table.take();
    }
    add_friction(table, data, analysis);
    add_levels(table, data, analysis);
    add_channel_numbers(table, data, mean);
    add_forces(table, data);
    return table.take();
}

const SummaryRow* find_quantity(const std::vector<SummaryRow>& quantities, const std::string& key) {
    const auto found =
        std::find_if(quantities.begin(), quantities.end(), [&](const SummaryRow& q) { return q.key == key; });
    return found == quantities.end() ? nullptr : &*found;
}

}  // namespace riffle::inline report
