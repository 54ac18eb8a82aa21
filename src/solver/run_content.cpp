#include "solver/run_content.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "base/version.hpp"
#include "output/xdmf.hpp"
#include "record/field_content.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline solver {

namespace {

void add_column(Content& content, const ColumnResult& column, const Case& c) {
    const int dimensions = c.channel.dimensions;
    const ColumnProfile& p = column.profile;
    const auto profile = [&](const Field& field, const std::vector<double>& values) {
        add_field(content, field, dimensions, values);
    };
    profile(fields::column.z, p.z);
    profile(fields::column.velocity, p.velocity);
    profile(fields::column.velocity_gradient, p.velocity_gradient);
    profile(fields::column.shear_stress, p.shear_stress);
    profile(fields::column.mixing_length, p.mixing_length);
    profile(fields::column.eddy_viscosity, p.eddy_viscosity);
    const auto& numbers = fields::column_numbers;
    const auto number = [&](const Field& field, double value) { add_field(content, field, value); };
    number(numbers.depth_mean_velocity, column.depth_mean_velocity);
    number(numbers.total_mean_velocity, column.total_mean_velocity);
    number(numbers.surface_velocity, column.surface_velocity);
    number(numbers.friction_velocity, column.friction_velocity);
    if (column.log_law.valid) {
        number(numbers.log_law_friction_velocity, column.log_law.friction_velocity);
        number(numbers.equivalent_roughness, column.log_law.equivalent_roughness);
        number(numbers.zero_plane, column.log_law.zero_plane);
    }
    number(numbers.drag_share, column.drag_share);
    number(numbers.wall_share, column.wall_force_share);
    if (!c.vegetation.empty()) number(numbers.vegetation_share, column.vegetation_share);
    if (!c.porous.empty()) number(numbers.porous_share, column.porous_share);
    number(numbers.friction_factor, column.friction_factor);
    number(numbers.manning, column.manning);
    number(numbers.chezy, column.chezy);
    number(numbers.reynolds, column.reynolds);
    number(numbers.froude, column.froude);
    number(numbers.relaxation_time, column.relaxation_time);
}

void add_section(Content& content, const SectionResult& section, const Case& c) {
    const double density = c.fluid.density;
    add_field(content, fields::section.y, 3, section.y);
    add_field(content, fields::section.z, 3, section.z);
    const auto plane = [&](const Field& field, const std::vector<double>& values) {
        content.datasets.push_back(dataset_of(field, 3, {section.z.size(), section.y.size()}, values));
    };
    plane(fields::section.velocity, section.velocity);
    plane(fields::section.mixing_length, section.mixing_length);
    plane(fields::section.shear_stress, section.shear_stress);
    plane(fields::section.lateral_shear_stress, section.lateral_shear_stress);
    const auto& numbers = fields::section_numbers;
    const auto number = [&](const Field& field, double value) { add_field(content, field, value); };
    number(numbers.bulk_velocity, section.bulk_velocity);
    number(numbers.depth_mean_velocity, section.depth_mean_velocity);
    number(numbers.centreline_velocity, section.centreline_velocity);
    number(numbers.maximum_velocity, section.maximum_velocity);
    number(numbers.wall_layer_velocity, section.wall_layer_velocity);
    number(numbers.discharge, section.discharge);
    // As the particles book them: what rests at the bed and the side walls as the friction of walls.
    const bool at_rest = section.wall_share > 0.0;
    number(numbers.drag_share, at_rest ? 0.0 : section.drag_share);
    number(numbers.side_wall_share, at_rest ? 0.0 : section.side_wall_share);
    number(numbers.wall_share, section.wall_share);
    if (!c.vegetation.empty()) number(numbers.vegetation_share, section.vegetation_share);
    if (!c.porous.empty()) number(numbers.porous_share, section.porous_share);
    number(numbers.bed_stress, section.bed_stress);
    number(numbers.wall_stress, section.wall_stress);
    number(numbers.side_wall_coefficient, section.side_wall_coefficient);
    number(numbers.relaxation_time, section.relaxation_time);
    number(numbers.partition_k, section.partition.k);
    number(numbers.partition_bed_stress, density * section.partition.bed_stress);
    number(numbers.partition_wall_stress, density * section.partition.wall_stress);
    number(numbers.partition_bed_share, section.partition.bed_share);
}

/// Averaging window so far: the tested one, or the second half while it is still too short.
std::pair<double, double> window(const Recorder& recorder, const Convergence& convergence) {
    const double end = recorder.series().last(fields::time_series.time);
    const bool usable = convergence.window_start < end - 2.0 * profile_block_duration;
    return {usable ? convergence.window_start : 0.5 * end, end};
}

}  // namespace

Dataset case_dataset(const Case& c) {
    return dataset_of(fields::stored_case.text, c.channel.dimensions, {}, c.text);
}

Content run_head(const Case& c, const Twins& twins) {
    Content content;
    const auto& file = fields::file;
    add_field(content, file.riffle_version, version());
    add_field(content, file.build, build_description());
    add_field(content, file.title, c.title);
    add_field(content, file.dimension, std::int64_t{c.channel.dimensions});
    add_field(content, file.created, fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
    content.datasets.push_back(case_dataset(c));
    if (twins.column) add_column(content, *twins.column, c);
    if (twins.section) add_section(content, *twins.section, c);
    return content;
}

Numbers current_summary(const Case& c, const Twins& twins, const Recorder& recorder,
                        const Convergence& convergence) {
    const auto [from, to] = window(recorder, convergence);
    Convergence shown = convergence;
    shown.window_start = from;
    return summarise(c, twins, recorder.series(), recorder.profiles().average(from, to), shown);
}

void add_profiles_content(Content& content, const Twins& twins, const Recorder& recorder,
                          const Convergence& convergence) {
    const auto [from, to] = window(recorder, convergence);
    const Profiles p = recorder.profiles().average(from, to);
    if (p.empty()) return;
    const unsigned twin = twins.section ? section_twin : no_section_twin;
    for (const fields::ProfileField& field : rows_of<fields::ProfileField>(fields::profiles)) {
        const unsigned wanted = field.written & (section_twin | no_section_twin);
        const bool compared = twins.column && (wanted & twin) != 0U;
        if ((wanted == 0U || compared) && !(p.*field.values).empty()) {
            add_field(content, field, 2, p.*field.values);  // named alike in three dimensions
        }
    }
    add_field(content, fields::profile_window.start, p.window_start);
    add_field(content, fields::profile_window.end, p.window_end);
    add_field(content, fields::profile_window.samples, p.samples);
    std::string quantities;
    for (const std::string& name : profile_quantity_names(p.spanwise_velocity.empty() ? 2 : 3)) {
        quantities += (quantities.empty() ? "" : " ") + name;
    }
    add_field(content, fields::profile_blocks.quantities, quantities);
}

void write_indexes(const RunFiles& files, const Recorder& recorder) {
    const std::string results = files.results().filename().string();
    const SnapshotRecorder& snapshots = recorder.snapshots();
    if (!snapshots.entries().empty()) {
        write_xdmf(files.xdmf(), results, snapshots.entries(), snapshots.fields());
    }
    const BoundaryContent& boundaries = snapshots.boundaries();
    write_boundary_xdmf(files.boundary_xdmf(), results,
                        {.walls = boundaries.walls(),
                         .vertices = boundaries.vertices(),
                         .corners = boundaries.corners(),
                         .triangles = boundaries.triangles(),
                         .spheres = boundaries.spheres(),
                         .moved = boundaries.moves() ? snapshots.entries() : std::vector<SnapshotEntry>()});
    const MeanField& field = recorder.mean_field();
    if (field.on() && !field.window_ends().empty()) {
        write_grid_xdmf(files.mean_field_xdmf(), results,
                        {.group = fields::groups::mean_field.path,
                         .edges = {field.edges(0), field.edges(1), field.edges(2)},
                         .times = field.window_ends(),
                         .fields = MeanField::field_names()});
    }
}

}  // namespace riffle::inline solver
