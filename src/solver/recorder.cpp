#include "solver/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/due_times.hpp"
#include "base/error.hpp"
#include "particles/lattice.hpp"
#include "record/field_content.hpp"
#include "record/flow_fields.hpp"
#include "solver/content.hpp"

namespace riffle::inline solver {

namespace {

/// Whether something with this interval is due, and when next. An interval of 0 means never.
bool is_due(double time, double interval, double& due) {
    if (interval <= 0.0 || !has_come(time, due, interval)) return false;
    due = due_next(time, due, interval);
    return true;
}

/// The first rows of a dataset of results, each of this shape. Throws FileError where it has fewer, or
/// others.
std::vector<double> first_rows(const ResultsReader& results, const Field& field, std::size_t rows,
                               const std::vector<std::size_t>& row_shape) {
    if (rows == 0) {
        return {};
    }
    const std::string path = field.path();
    std::vector<std::size_t> shape = results.shape(path);
    const std::size_t there = shape.empty() ? 0 : shape[0];
    if (there < rows || !std::equal(shape.begin() + 1, shape.end(), row_shape.begin(), row_shape.end())) {
        throw FileError(
            fmt::format("{}: {} has {} rows, or such of another width; the checkpoint goes on from {}: "
                        "they are not of one run, or the results are older than the checkpoint",
                        results.path().string(), path, there, rows));
    }
    return results.read_rows(path, 0, rows);
}

}  // namespace

template <int D>
FlowState flow_state(const SimulationIn<D>& simulation, const FluidView* fluid) {
    const ParticleFields& fields = simulation.fields();
    return {.time = simulation.clock().time,
            .streamwise_gravity = simulation.scheme().streamwise_gravity,
            .mass = simulation.particles().mass,
            .x = simulation.particles().position[0],
            .fluid = fluid,
            .drag_x = &fields.drag_acceleration_x,
            .wall_x = &fields.wall_acceleration_x,
            .wall_z = &fields.wall_acceleration_z,
            .side_wall_x = &fields.side_wall_acceleration_x,
            .vegetation_x = &fields.vegetation_acceleration_x,
            .porous_x = &fields.porous_acceleration_x,
            .pressure = &fields.pressure,
            .shear_stress = fields.shear_stress,
            .solids = simulation.solid_forces(),
            .bodies = simulation.bodies(),
            .free_bodies = simulation.clock().free_bodies};
}

template FlowState flow_state(const SimulationIn<2>&, const FluidView*);
template FlowState flow_state(const SimulationIn<3>&, const FluidView*);

std::vector<double> surface_map_places(const Case& c, double extent) {
    const double wanted = 2.0 * c.numerics.spacing;
    std::vector<double> places(
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(extent / wanted))));
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = (static_cast<double>(i) + 0.5) * extent / static_cast<double>(places.size());
    }
    return places;
}

Recorder::Recorder(const Case& c, const Twins& twins)
    : case_(c),
      series_(c),
      profiles_(c, twins.column_or_null(), twins.section_or_null()),
      probes_(c, largest_step(c, make_scheme(c, twins.column_or_null()))),
      mean_field_(c),
      snapshots_(c),
      mean_level_(c.total_depth()),
      has_surface_(c.channel.top == Top::free_surface) {
    const Lattice lattice = lattice_of(c);
    for (int i = 0; i < lattice.columns; ++i) {
        surface_x_.push_back((i + 0.5) * lattice.dx);
        surface_.places.push_back({surface_x_.back(), c.channel.centreline()});
    }
    if (c.channel.dimensions == 3) {
        map_interval_ = c.output.surface_map_interval;
        map_x_ = surface_map_places(c, c.channel.length);
        map_y_ = surface_map_places(c, c.channel.simulated_width());
        for (const double y : map_y_) {
            for (const double x : map_x_) {
                map_.places.push_back({x, y});
            }
        }
    }
}

double Recorder::fields_due() const {
    const auto next = [](double interval, double due) {
        return interval > 0.0 ? earliest_of(due, interval) : std::numeric_limits<double>::infinity();
    };
    const Output& output = case_.output;
    return std::min({next(output.series_interval, due_.series), next(output.profile_interval, due_.profile),
                     next(output.snapshot_interval, due_.snapshot), probes_.forces_due()});
}

template <int D>
void Recorder::record(SimulationIn<D>& simulation) {
    const double time = simulation.clock().time;
    const Output& output = case_.output;
    // Before the first evaluation there are no forces to average.
    const bool started = simulation.clock().steps > 0;
    const bool series_due = is_due(time, output.series_interval, due_.series) && started;
    const bool surface_due = is_due(time, output.surface_interval, due_.surface) && has_surface_;
    const bool map_due = has_maps() && is_due(time, map_interval_, due_.surface_map);
    const bool profile_due = started && is_due(time, output.profile_interval, due_.profile);
    const bool fluid_due = surface_due || map_due || (started && probes_.due_for_fluid(time));
    // First what looks at the fields of the particles, which are then freed: they and the view of the fluid
    // are each as large as much of the state.
    if (started) {
        probes_.record(flow_state(simulation, nullptr), false);
        if (series_due) series_.sample(simulation, mean_level_);
        if (profile_due) {
            profiles_.sample(simulation);
            if constexpr (D == 3) {
                if (mean_field_.on()) mean_field_.sample(simulation);
            }
        }
    }
    // Fields that an instrument looks up in the fluid stay until then; the viscosity for the snapshot of the
    // last state.
    const bool looked_up = started && probes_.due_for_fields_in_fluid(time);
    const auto drop_fields = [&](bool with_viscosity) {
        if constexpr (D == 3) simulation.drop_fields(with_viscosity);
    };
    if (!looked_up) drop_fields(false);
    if (is_due(time, output.snapshot_interval, due_.snapshot)) snapshots_.record(simulation);
    if (!looked_up && !snapshots_.shows_viscosity()) drop_fields(true);
    if (fluid_due) {
        // One view of the fluid serves the surface and all instruments.
        const FluidViewIn<D> fluid(case_, simulation.particles(), simulation.scheme().smoothing_length,
                                   &simulation.walls());
        if (surface_due) mean_level_ = surface_.record(time, fluid);
        if (map_due) map_.record(time, fluid);
        if (started) probes_.record(flow_state(simulation, &fluid), true);
    }
    if (looked_up) drop_fields(!snapshots_.shows_viscosity());
    if (series_due) series_.set_mean_level(mean_level_);
}

template void Recorder::record(SimulationIn<2>&);
template void Recorder::record(SimulationIn<3>&);

double Recorder::Elevations::record(double time_now, const FluidView& fluid) {
    double sum = 0.0;
    double count = 0.0;
    for (const double e : fluid.surface_at(places)) {
        values.push_back(static_cast<float>(e));
        if (std::isfinite(e)) {
            sum += e;
            count += 1.0;
        }
    }
    time.push_back(time_now);
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

void Recorder::Elevations::take(Content& content, const Field& time_field, const Field& elevation_field,
                                std::vector<std::size_t> shape, int dimensions) {
    const std::size_t n = time.size();
    taken += n;
    shape.insert(shape.begin(), n);
    content.datasets.push_back(dataset_of(time_field, dimensions, {n}, std::exchange(time, {}), true));
    content.datasets.push_back(
        dataset_of(elevation_field, dimensions, std::move(shape), std::exchange(values, {}), true));
}

std::size_t Recorder::pending_bytes() const {
    const std::size_t series = (series_.rows() - taken_series_) * series_.columns().size() * sizeof(double);
    const std::size_t blocks = (profiles_.blocks().size() - taken_blocks_) * profiles_.layers() *
                               profiles_.quantities() * sizeof(double);
    return series + blocks + (surface_.values.size() + map_.values.size()) * sizeof(float) +
           snapshots_.pending_bytes() + mean_field_.pending_bytes() + probes_.pending_bytes();
}

Content Recorder::take_new_rows() {
    Content content = snapshots_.take();
    const int dimensions = case_.channel.dimensions;
    const auto add_rows = [&](const Field& field, std::vector<std::size_t> shape,
                              std::vector<double> values) {
        content.datasets.push_back(dataset_of(field, dimensions, std::move(shape), std::move(values), true));
    };

    const std::size_t rows = series_.rows() - taken_series_;
    for (const SeriesColumn& column : series_.columns()) {
        std::vector<double> values(column.values.begin() + static_cast<std::ptrdiff_t>(taken_series_),
                                   column.values.end());
        add_rows(column.field, {rows}, std::move(values));
    }
    taken_series_ = series_.rows();

    const auto& blocks = profiles_.blocks();
    std::vector<double> end;
    std::vector<double> samples;
    std::vector<double> sums;
    for (std::size_t b = taken_blocks_; b < blocks.size(); ++b) {
        end.push_back(blocks[b].end);
        samples.push_back(blocks[b].samples);
        sums.insert(sums.end(), blocks[b].sums.begin(), blocks[b].sums.end());
    }
    const std::size_t new_blocks = end.size();
    const auto& of_blocks = fields::profile_blocks;
    add_rows(of_blocks.time, {new_blocks}, std::move(end));
    add_rows(of_blocks.samples, {new_blocks}, std::move(samples));
    add_rows(of_blocks.sums, {new_blocks, profiles_.layers(), profiles_.quantities()}, std::move(sums));
    taken_blocks_ = blocks.size();

    if (has_surface_) {
        surface_.take(content, fields::surface.time, fields::surface.elevation, {surface_x_.size()},
                      dimensions);
        add_field(content, fields::surface.x, dimensions, surface_x_);
    }
    if (has_maps()) {
        const auto& map = fields::surface_map;
        map_.take(content, map.time, map.elevation, {map_y_.size(), map_x_.size()}, dimensions);
        add_field(content, map.x, dimensions, map_x_);
        add_field(content, map.y, dimensions, map_y_);
    }
    for (Content part : {mean_field_.take_new_rows(), probes_.take_new_rows()}) {
        std::move(part.datasets.begin(), part.datasets.end(), std::back_inserter(content.datasets));
        std::move(part.attributes.begin(), part.attributes.end(), std::back_inserter(content.attributes));
    }
    return content;
}

std::map<std::string, std::size_t> Recorder::rows() const {
    std::map<std::string, std::size_t> rows = probes_.rows();
    for (const SeriesColumn& column : series_.columns()) rows[column.field.path()] = taken_series_;
    const auto& blocks = fields::profile_blocks;
    for (const Field& field : {blocks.time, blocks.samples, blocks.sums}) {
        rows[field.path()] = taken_blocks_;
    }
    if (has_surface_) {
        rows[fields::surface.time.path()] = surface_.taken;
        rows[fields::surface.elevation.path()] = surface_.taken;
    }
    if (has_maps()) {
        rows[fields::surface_map.time.path()] = map_.taken;
        rows[fields::surface_map.elevation.path()] = map_.taken;
    }
    mean_field_.add_rows(rows);
    return rows;
}

void Recorder::save(Content& checkpoint) const {
    const auto number = [&](const char* name, double value) { add_attribute(checkpoint, "/", name, value); };
    number("due_series", due_.series);
    number("due_surface", due_.surface);
    number("due_profile", due_.profile);
    number("due_snapshot", due_.snapshot);
    number("due_surface_map", due_.surface_map);
    number("mean_level", mean_level_);
    number("block_end", profiles_.current().end);
    number("block_samples", profiles_.current().samples);
    number("series_rows", static_cast<double>(taken_series_));
    number("block_rows", static_cast<double>(taken_blocks_));
    number("surface_rows", static_cast<double>(surface_.taken));
    number("surface_map_rows", static_cast<double>(map_.taken));
    add_array(checkpoint, "/recorder/block_sums", profiles_.current().sums, "1",
              "sums of the block that is being filled");
    snapshots_.save(checkpoint);
    mean_field_.save(checkpoint);
    probes_.save(checkpoint);
}

void Recorder::restore(const CheckpointReader& checkpoint, const ResultsReader& results) {
    const auto number = [&](const char* name) { return checkpoint.number("/", name); };
    due_ = {.series = number("due_series"),
            .surface = number("due_surface"),
            .profile = number("due_profile"),
            .snapshot = number("due_snapshot"),
            .surface_map = number("due_surface_map")};
    mean_level_ = number("mean_level");
    // How many the results really have is told by those who read them, and by require_rows().
    constexpr std::size_t any_number = std::size_t{1} << 48U;
    const auto rows = [&](const char* name) { return checkpoint.count("/", name, any_number); };
    taken_series_ = rows("series_rows");
    taken_blocks_ = rows("block_rows");
    surface_.taken = rows("surface_rows");
    map_.taken = rows("surface_map_rows");
    snapshots_.restore(checkpoint);
    mean_field_.restore(checkpoint);
    probes_.restore(checkpoint);
    for (SeriesColumn& column : series_.columns()) {
        column.values = first_rows(results, column.field, taken_series_, {});
    }
    const std::size_t width = profiles_.layers() * profiles_.quantities();
    const auto& of_blocks = fields::profile_blocks;
    const std::vector<double> end = first_rows(results, of_blocks.time, taken_blocks_, {});
    const std::vector<double> samples = first_rows(results, of_blocks.samples, taken_blocks_, {});
    const std::vector<double> sums =
        first_rows(results, of_blocks.sums, taken_blocks_, {profiles_.layers(), profiles_.quantities()});
    std::vector<ProfileBlock> blocks;
    for (std::size_t b = 0; b < taken_blocks_; ++b) {
        const auto first = sums.begin() + static_cast<std::ptrdiff_t>(b * width);
        blocks.push_back({.end = end[b],
                          .samples = samples[b],
                          .sums = std::vector<double>(first, first + static_cast<std::ptrdiff_t>(width))});
    }
    ProfileBlock current{.end = number("block_end"),
                         .samples = number("block_samples"),
                         .sums = checkpoint.doubles("/recorder/block_sums", width)};
    profiles_.restore(std::move(blocks), std::move(current));
}

}  // namespace riffle::inline solver
