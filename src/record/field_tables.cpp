#include "record/field_tables.hpp"

#include <iterator>

#include "record/flow_fields.hpp"
#include "record/particle_fields.hpp"
#include "record/probe_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline record {

namespace {

template <class... Tables>
FieldTable table_of(const Group& group, const Tables&... parts) {
    FieldTable table{&group, {}};
    const auto add = [&](const auto& part) {
        const auto rows = fields_of(part);
        table.fields.insert(table.fields.end(), rows.begin(), rows.end());
    };
    (add(parts), ...);
    return table;
}

FieldTable profile_table() {
    FieldTable table{&fields::groups::profiles, {}};
    for (const fields::ProfileField& row : rows_of<fields::ProfileField>(fields::profiles)) {
        table.fields.push_back(row);
    }
    for (const Field& row : fields_of(fields::profile_window)) table.fields.push_back(row);
    return table;
}

}  // namespace

const std::vector<FieldTable>& field_tables() {
    using namespace fields;
    static const std::vector<FieldTable> tables = {
        table_of(groups::file, file),
        table_of(groups::stored_case, stored_case),
        table_of(groups::summary, summary),
        table_of(groups::time_series, time_series),
        profile_table(),
        table_of(groups::profile_blocks, profile_blocks),
        table_of(groups::surface, surface),
        table_of(groups::surface_map, surface_map),
        table_of(groups::mean_field, mean_field_axes, mean_field),
        table_of(groups::column, column, column_numbers),
        table_of(groups::section, section, section_numbers),
        table_of(groups::probe, probe),
        table_of(groups::velocity_points, velocity_points),
        table_of(groups::elevations, elevations),
        table_of(groups::velocity_grid, velocity_grid),
        table_of(groups::velocity_plane, velocity_plane),
        table_of(groups::flow_rate, flow_rate),
        table_of(groups::pressure_gauges, pressure_gauges),
        table_of(groups::forces, forces, solid_forces, body_motion),
        table_of(groups::snapshot, snapshot),
        table_of(groups::walls, walls),
        table_of(groups::solids, solids),
        table_of(groups::spheres, spheres),
        table_of(groups::lost, lost_particles),
        table_of(groups::state, state, clock),
    };
    return tables;
}

}  // namespace riffle::inline record
