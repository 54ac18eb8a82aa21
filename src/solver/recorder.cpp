#include "solver/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "particles/lattice.hpp"
#include "solver/content.hpp"

namespace riffle {

namespace {

/// Whether something with this interval is due, and when next. An interval of 0 means never.
bool is_due(double time, double interval, double& due) {
    if (interval <= 0.0 || time < due) {
        return false;
    }
    // Due times are multiples of the interval, without accumulated rounding.
    due = (std::floor(time / interval + 1e-9) + 1.0) * interval;
    return true;
}

template <class T>
Dataset rows_of(const std::string& path, std::vector<std::size_t> shape, std::vector<T> values,
                const std::string& unit, const std::string& long_name) {
    return {.path = path,
            .shape = std::move(shape),
            .values = std::move(values),
            .unit = unit,
            .long_name = long_name,
            .append = true};
}

template <class T>
void add_field(Content& content, const std::string& path, std::size_t components, std::vector<T> values,
               const std::string& unit, const std::string& long_name) {
    const std::size_t n = values.size() / components;
    std::vector<std::size_t> shape = {n};
    if (components > 1) {
        shape.push_back(components);
    }
    content.datasets.push_back(
        {.path = path, .shape = shape, .values = std::move(values), .unit = unit, .long_name = long_name});
}

}  // namespace

FlowState flow_state(const Simulation& simulation, const FluidView* fluid) {
    return {.time = simulation.clock().time,
            .streamwise_gravity = simulation.scheme().streamwise_gravity,
            .particles = &simulation.particles(),
            .fluid = fluid,
            .drag_x = simulation.fields().drag_acceleration_x,
            .wall_x = simulation.fields().wall_acceleration_x,
            .wall_z = simulation.fields().wall_acceleration_z};
}

Recorder::Recorder(const Case& c, const ColumnResult* column)
    : case_(c),
      series_(c),
      profiles_(c, column),
      probes_(c, largest_step(c, make_scheme(c, column))),
      mean_level_(c.total_depth()),
      has_surface_(c.channel.top == Top::free_surface) {
    const Lattice lattice = lattice_of(c);
    for (int i = 0; i < lattice.columns; ++i) {
        surface_x_.push_back((i + 0.5) * lattice.dx);
    }
}

double Recorder::fields_due() const {
    const auto next = [](double interval, double due) {
        return interval > 0.0 ? due : std::numeric_limits<double>::infinity();
    };
    const Output& output = case_.output;
    return std::min({next(output.series_interval, due_.series), next(output.profile_interval, due_.profile),
                     next(output.snapshot_interval, due_.snapshot), probes_.forces_due()});
}

void Recorder::record(const Simulation& simulation) {
    const double time = simulation.clock().time;
    const Output& output = case_.output;
    const bool series_due = is_due(time, output.series_interval, due_.series);
    const bool surface_due = is_due(time, output.surface_interval, due_.surface);
    // One view of the fluid serves the surface and all instruments.
    const bool started = simulation.clock().steps > 0;
    std::optional<FluidView> fluid;
    if ((has_surface_ && surface_due) || (started && probes_.due_for_fluid(time))) {
        const Scheme& scheme = simulation.scheme();
        fluid.emplace(simulation.particles(), domain_of(case_), case_.numerics.kernel, scheme.density,
                      scheme.smoothing_length, case_.output.surface_detection);
    }
    if (has_surface_ && surface_due) {
        record_surface(time, *fluid);
    }
    // Before the first evaluation there are no forces to average.
    if (started) {
        if (probes_.due(time)) {
            record_probes(simulation, fluid ? &*fluid : nullptr);
        }
        if (series_due) {
            series_.sample(simulation, mean_level_);
        }
        if (is_due(time, output.profile_interval, due_.profile)) {
            profiles_.sample(simulation);
        }
    }
    if (is_due(time, output.snapshot_interval, due_.snapshot)) {
        record_snapshot(simulation);
    }
}

void Recorder::record_probes(const Simulation& simulation, const FluidView* fluid) {
    probes_.record(flow_state(simulation, fluid));
}

void Recorder::record_surface(double time, const FluidView& fluid) {
    const std::vector<double> elevation = fluid.surface_at(surface_x_);
    double sum = 0.0;
    double count = 0.0;
    for (const double e : elevation) {
        new_surface_.push_back(static_cast<float>(e));
        if (std::isfinite(e)) {
            sum += e;
            count += 1.0;
        }
    }
    new_surface_time_.push_back(time);
    mean_level_ = count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

void Recorder::record_snapshot(const Simulation& simulation) {
    const Particles<2>& p = simulation.particles();
    const ParticleFields& f = simulation.fields();
    const std::size_t n = p.size();
    // In the order of the particles' numbers, so that row i of every snapshot is the same particle.
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id[a] < p.id[b]; });
    std::vector<float> position(3 * n, 0.0F);
    std::vector<float> velocity(3 * n, 0.0F);
    std::vector<float> pressure(n);
    std::vector<float> density(n);
    std::vector<float> eddy_viscosity(n);
    std::vector<std::int32_t> id(n);
    for (std::size_t row = 0; row < n; ++row) {
        const std::size_t i = order[row];
        for (std::size_t k = 0; k < 2; ++k) {
            const std::size_t axis = k == 0 ? 0 : 2;  // x and z of three axes
            position[3 * row + axis] = static_cast<float>(p.position[k][i]);
            velocity[3 * row + axis] = static_cast<float>(p.velocity[k][i]);
        }
        pressure[row] = static_cast<float>(case_.fluid.density *
                                           simulation.scheme().state.pressure(p.density_deviation[i]));
        density[row] = static_cast<float>(case_.fluid.density * (1.0 + p.density_deviation[i]));
        eddy_viscosity[row] = static_cast<float>(f.eddy_viscosity[i]);
        id[row] = static_cast<std::int32_t>(p.id[i]);
    }
    new_snapshot_bytes_ += n * (6 * sizeof(float) + 3 * sizeof(float) + sizeof(std::int32_t));
    const std::string group = snapshot_group(snapshot_times_.size());
    add_field(new_snapshots_, group + "/position", 3, std::move(position), "m", "position (x, y, z)");
    add_field(new_snapshots_, group + "/velocity", 3, std::move(velocity), "m/s", "velocity (u, v, w)");
    add_field(new_snapshots_, group + "/pressure", 1, std::move(pressure), "Pa", "pressure");
    add_field(new_snapshots_, group + "/density", 1, std::move(density), "kg/m3", "density");
    add_field(new_snapshots_, group + "/eddy_viscosity", 1, std::move(eddy_viscosity), "m2/s",
              "eddy viscosity");
    add_field(new_snapshots_, group + "/id", 1, std::move(id), "1", "particle number");
    new_snapshots_.attributes.push_back({.path = group, .name = "time", .value = simulation.clock().time});
    snapshot_times_.push_back(simulation.clock().time);
}

std::size_t Recorder::pending_bytes() const {
    const std::size_t series = (series_.rows() - taken_series_) * series_.columns().size() * sizeof(double);
    const std::size_t blocks = (profiles_.blocks().size() - taken_blocks_) * profiles_.layers() *
                               profile_quantities * sizeof(double);
    return series + blocks + new_surface_.size() * sizeof(float) + new_snapshot_bytes_ +
           probes_.pending_bytes();
}

Content Recorder::take_new_rows() {
    Content content = std::move(new_snapshots_);
    new_snapshots_ = {};
    new_snapshot_bytes_ = 0;

    const std::size_t rows = series_.rows() - taken_series_;
    for (const SeriesColumn& column : series_.columns()) {
        std::vector<double> values(column.values.begin() + static_cast<std::ptrdiff_t>(taken_series_),
                                   column.values.end());
        content.datasets.push_back(
            rows_of("/time_series/" + column.name, {rows}, std::move(values), column.unit, column.long_name));
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
    content.datasets.push_back(
        rows_of("/profile_blocks/time", {new_blocks}, std::move(end), "s", "end of the block"));
    content.datasets.push_back(
        rows_of("/profile_blocks/samples", {new_blocks}, std::move(samples), "1", "samples in the block"));
    content.datasets.push_back(rows_of("/profile_blocks/sums",
                                       {new_blocks, profiles_.layers(), profile_quantities}, std::move(sums),
                                       "1", "sums over particles and samples, SI, by layer and quantity"));
    taken_blocks_ = blocks.size();

    if (has_surface_) {
        const std::size_t n = new_surface_time_.size();
        surface_rows_ += n;
        content.datasets.push_back(rows_of("/surface/time", {n}, std::move(new_surface_time_), "s", "time"));
        content.datasets.push_back(rows_of("/surface/elevation", {n, surface_x_.size()},
                                           std::move(new_surface_), "m",
                                           "surface elevation above the bed level"));
        new_surface_time_ = {};
        new_surface_ = {};
        add_array(content, "/surface/x", surface_x_, "m", "distance along the channel");
    }
    Content probes = probes_.take_new_rows();
    std::move(probes.datasets.begin(), probes.datasets.end(), std::back_inserter(content.datasets));
    std::move(probes.attributes.begin(), probes.attributes.end(), std::back_inserter(content.attributes));
    return content;
}

std::map<std::string, std::size_t> Recorder::rows() const {
    std::map<std::string, std::size_t> rows = probes_.rows();
    for (const SeriesColumn& column : series_.columns()) {
        rows["/time_series/" + column.name] = taken_series_;
    }
    for (const char* name : {"time", "samples", "sums"}) {
        rows[std::string("/profile_blocks/") + name] = taken_blocks_;
    }
    if (has_surface_) {
        rows["/surface/time"] = surface_rows_;
        rows["/surface/elevation"] = surface_rows_;
    }
    return rows;
}

void Recorder::save(Content& checkpoint) const {
    const auto number = [&](const char* name, double value) { add_attribute(checkpoint, "/", name, value); };
    number("due_series", due_.series);
    number("due_surface", due_.surface);
    number("due_profile", due_.profile);
    number("due_snapshot", due_.snapshot);
    number("mean_level", mean_level_);
    number("block_end", profiles_.current().end);
    number("block_samples", profiles_.current().samples);
    number("series_rows", static_cast<double>(taken_series_));
    number("block_rows", static_cast<double>(taken_blocks_));
    number("surface_rows", static_cast<double>(surface_rows_));
    add_array(checkpoint, "/recorder/block_sums", profiles_.current().sums, "1",
              "sums of the block that is being filled");
    add_array(checkpoint, "/recorder/snapshot_times", snapshot_times_, "s", "times of the snapshots so far");
    probes_.save(checkpoint);
}

void Recorder::restore(const Content& checkpoint, const ResultsReader& results) {
    due_ = {.series = checkpoint_number(checkpoint, "due_series"),
            .surface = checkpoint_number(checkpoint, "due_surface"),
            .profile = checkpoint_number(checkpoint, "due_profile"),
            .snapshot = checkpoint_number(checkpoint, "due_snapshot")};
    mean_level_ = checkpoint_number(checkpoint, "mean_level");
    taken_series_ = static_cast<std::size_t>(checkpoint_number(checkpoint, "series_rows"));
    taken_blocks_ = static_cast<std::size_t>(checkpoint_number(checkpoint, "block_rows"));
    surface_rows_ = static_cast<std::size_t>(checkpoint_number(checkpoint, "surface_rows"));
    snapshot_times_ =
        std::get<std::vector<double>>(checkpoint_dataset(checkpoint, "/recorder/snapshot_times").values);

    probes_.restore(checkpoint);
    for (SeriesColumn& column : series_.columns()) {
        column.values = results.read_doubles("/time_series/" + column.name);
        column.values.resize(taken_series_);
    }
    const std::vector<double> end = results.read_doubles("/profile_blocks/time");
    const std::vector<double> samples = results.read_doubles("/profile_blocks/samples");
    const std::vector<double> sums = results.read_doubles("/profile_blocks/sums");
    const std::size_t width = profiles_.layers() * profile_quantities;
    std::vector<ProfileBlock> blocks;
    for (std::size_t b = 0; b < taken_blocks_; ++b) {
        const auto first = sums.begin() + static_cast<std::ptrdiff_t>(b * width);
        blocks.push_back({.end = end[b],
                          .samples = samples[b],
                          .sums = std::vector<double>(first, first + static_cast<std::ptrdiff_t>(width))});
    }
    ProfileBlock current{
        .end = checkpoint_number(checkpoint, "block_end"),
        .samples = checkpoint_number(checkpoint, "block_samples"),
        .sums = std::get<std::vector<double>>(checkpoint_dataset(checkpoint, "/recorder/block_sums").values)};
    profiles_.restore(std::move(blocks), std::move(current));
}

double checkpoint_number(const Content& content, const std::string& name) {
    for (const Attribute& attribute : content.attributes) {
        if (attribute.path == "/" && attribute.name == name) {
            if (const auto* number = std::get_if<double>(&attribute.value)) {
                return *number;
            }
            if (const auto* integer = std::get_if<std::int64_t>(&attribute.value)) {
                return static_cast<double>(*integer);
            }
        }
    }
    throw FileError(
        fmt::format("the checkpoint lacks `{}`: it was written by another build; start the run again", name));
}

const Dataset& checkpoint_dataset(const Content& content, const std::string& path) {
    const auto found = std::find_if(content.datasets.begin(), content.datasets.end(),
                                    [&](const Dataset& dataset) { return dataset.path == path; });
    if (found == content.datasets.end()) {
        throw FileError(fmt::format(
            "the checkpoint lacks `{}`: it was written by another build; start the run again", path));
    }
    return *found;
}

}  // namespace riffle
