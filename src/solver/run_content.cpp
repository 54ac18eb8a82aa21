#include "solver/run_content.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "base/version.hpp"
#include "output/xdmf.hpp"
#include "solver/content.hpp"

namespace riffle {

namespace {

void add_column(Content& content, const ColumnResult& column) {
    const ColumnProfile& p = column.profile;
    add_array(content, "/column/z", p.z, "m", "height above the bed level");
    add_array(content, "/column/velocity", p.velocity, "m/s", "streamwise velocity of the column");
    add_array(content, "/column/velocity_gradient", p.velocity_gradient, "1/s",
              "velocity gradient of the column");
    add_array(content, "/column/shear_stress", p.shear_stress, "Pa", "shear stress of the column");
    add_array(content, "/column/mixing_length", p.mixing_length, "m", "mixing length");
    add_array(content, "/column/eddy_viscosity", p.eddy_viscosity, "m2/s", "eddy viscosity of the column");
    const auto attribute = [&](const char* name, double value) {
        add_attribute(content, "/column", name, value);
    };
    attribute("depth_mean_velocity", column.depth_mean_velocity);
    attribute("total_mean_velocity", column.total_mean_velocity);
    attribute("surface_velocity", column.surface_velocity);
    attribute("friction_velocity", column.friction_velocity);
    attribute("log_law_friction_velocity", column.log_law.friction_velocity);
    attribute("equivalent_roughness", column.log_law.equivalent_roughness);
    attribute("zero_plane", column.log_law.zero_plane);
    attribute("drag_share", column.drag_share);
    attribute("wall_share", column.wall_share);
    attribute("friction_factor", column.friction_factor);
    attribute("manning", column.manning);
    attribute("chezy", column.chezy);
    attribute("reynolds", column.reynolds);
    attribute("froude", column.froude);
    attribute("relaxation_time", column.relaxation_time);
}

/// `density`: of the water, kg/m3.
void add_section(Content& content, const SectionResult& section, double density) {
    add_array(content, "/section/y", section.y, "m", "distance across the channel, cell centres");
    add_array(content, "/section/z", section.z, "m", "height above the bed level, cell centres");
    const auto field = [&](const char* name, const std::vector<double>& values, const char* unit,
                           const char* long_name) {
        content.datasets.push_back({.path = std::string("/section/") + name,
                                    .shape = {section.z.size(), section.y.size()},
                                    .values = values,
                                    .unit = unit,
                                    .long_name = long_name});
    };
    field("velocity", section.velocity, "m/s", "streamwise velocity of the section");
    field("mixing_length", section.mixing_length, "m", "mixing length l_x");
    field("shear_stress", section.shear_stress, "Pa", "stress tau_xz of the section");
    field("lateral_shear_stress", section.lateral_shear_stress, "Pa", "stress tau_xy of the section");
    const auto attribute = [&](const char* name, double value) {
        add_attribute(content, "/section", name, value);
    };
    attribute("bulk_velocity", section.bulk_velocity);
    attribute("depth_mean_velocity", section.depth_mean_velocity);
    attribute("centreline_velocity", section.centreline_velocity);
    attribute("maximum_velocity", section.maximum_velocity);
    attribute("wall_layer_velocity", section.wall_layer_velocity);
    attribute("discharge", section.discharge);
    attribute("drag_share", section.drag_share);
    attribute("side_wall_share", section.side_wall_share);
    attribute("bed_stress", section.bed_stress);
    attribute("wall_stress", section.wall_stress);
    attribute("side_wall_coefficient", section.side_wall_coefficient);
    attribute("relaxation_time", section.relaxation_time);
    attribute("partition_k", section.partition.k);
    attribute("partition_bed_stress", density * section.partition.bed_stress);
    attribute("partition_wall_stress", density * section.partition.wall_stress);
    attribute("partition_bed_share", section.partition.bed_share);
}

/// Averaging window so far: the tested one, or the second half while it is still too short.
std::pair<double, double> window(const Recorder& recorder, const Convergence& convergence) {
    const double end = recorder.series().last("time");
    const bool usable = convergence.window_start < end - 2.0 * profile_block_duration;
    return {usable ? convergence.window_start : 0.5 * end, end};
}

}  // namespace

Dataset case_dataset(const Case& c) {
    return {.path = "/case/text",
            .shape = {},
            .values = c.text,
            .unit = "1",
            .long_name = "complete case (TOML)"};
}

Content run_head(const Case& c, const Twins& twins) {
    Content content;
    const auto attribute = [&](const char* name, AttributeValue value) {
        add_attribute(content, "/", name, std::move(value));
    };
    attribute("riffle_version", version());
    attribute("build", build_description());
    attribute("title", c.title);
    attribute("dimension", std::int64_t{c.channel.dimensions});
    attribute("created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
    content.datasets.push_back(case_dataset(c));
    if (twins.column) {
        add_column(content, *twins.column);
    }
    if (twins.section) {
        add_section(content, *twins.section, c.fluid.density);
    }
    return content;
}

RunSummary current_summary(const Case& c, const Twins& twins, const Recorder& recorder,
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
    if (p.empty()) {
        return;
    }
    const auto add = [&](const char* name, const std::vector<double>& values, const char* unit,
                         const char* long_name) {
        add_array(content, std::string("/profiles/") + name, values, unit, long_name);
    };
    add("z", p.z, "m", "mean height of the particles in the layer above the bed level");
    add("bin_lower", p.bin_lower, "m", "lower edge of the layer");
    add("bin_upper", p.bin_upper, "m", "upper edge of the layer");
    add("velocity", p.velocity, "m/s", "time-mean streamwise velocity");
    add("velocity_half_width", p.velocity_half_width, "m/s", "half-width of its 95 % interval");
    add("vertical_velocity", p.vertical_velocity, "m/s", "time-mean vertical velocity");
    if (twins.column) {
        const bool section = twins.section.has_value();
        add("column_velocity", p.column_velocity, "m/s",
            section ? "velocity of the section at the particles' places"
                    : "column velocity at the particles' heights");
        add("velocity_deviation", p.velocity_deviation, "m/s",
            section ? "departure from the section at the particles' places"
                    : "departure from the column at the particles' heights");
    }
    add("velocity_gradient", p.velocity_gradient, "1/s", "time-mean du/dz");
    add("eddy_viscosity", p.eddy_viscosity, "m2/s", "time-mean eddy viscosity");
    add("pressure", p.pressure, "Pa", "time-mean pressure");
    add("density", p.density, "kg/m3", "time-mean density");
    add("viscous_stress", p.viscous_stress, "Pa", "viscous and closure shear stress at the upper edge");
    add("pair_stress", p.pair_stress, "Pa", "shear stress carried by pressure forces at the upper edge");
    add("reynolds_stress", p.reynolds_stress, "Pa", "resolved Reynolds stress at the upper edge");
    add("total_stress", p.total_stress, "Pa", "total shear stress at the upper edge");
    add("analytic_stress", p.analytic_stress, "Pa", "shear stress of the momentum balance at the upper edge");
    add("velocity_rms", p.velocity_rms, "m/s", "rms fluctuation of u");
    add("vertical_velocity_rms", p.vertical_velocity_rms, "m/s", "rms fluctuation of w");
    add("drag", p.drag, "N/m3", "bed drag per unit volume");
    if (!p.spanwise_velocity.empty()) {
        add("spanwise_velocity", p.spanwise_velocity, "m/s", "time-mean spanwise velocity");
        add("spanwise_velocity_rms", p.spanwise_velocity_rms, "m/s", "rms fluctuation of v");
        add("side_wall_drag", p.side_wall_drag, "N/m3", "drag of the side walls' layers per unit volume");
    }
    const auto attribute = [&](const char* name, double value) {
        add_attribute(content, "/profiles", name, value);
    };
    attribute("window_start", p.window_start);
    attribute("window_end", p.window_end);
    attribute("samples", p.samples);
    std::string quantities;
    for (const std::string& name : profile_quantity_names(p.spanwise_velocity.empty() ? 2 : 3)) {
        quantities += (quantities.empty() ? "" : " ") + name;
    }
    add_attribute(content, "/profile_blocks", "quantities", quantities);
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
                        {.group = "/mean_field",
                         .edges = {field.edges(0), field.edges(1), field.edges(2)},
                         .times = field.window_ends(),
                         .fields = MeanField::field_names()});
    }
}

}  // namespace riffle
