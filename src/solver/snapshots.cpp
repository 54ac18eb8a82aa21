#include "solver/snapshots.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <sstream>
#include <utility>

#include "solver/content.hpp"
#include "solver/recorder.hpp"

namespace riffle {

namespace {

template <class T>
std::size_t add_field(Content& content, const std::string& path, std::size_t components,
                      std::vector<T> values, const std::string& unit, const std::string& long_name) {
    const std::size_t n = values.size() / components;
    const std::size_t bytes = values.size() * sizeof(T);
    std::vector<std::size_t> shape = {n};
    if (components > 1) {
        shape.push_back(components);
    }
    content.datasets.push_back(
        {.path = path, .shape = shape, .values = std::move(values), .unit = unit, .long_name = long_name});
    return bytes;
}

/// Components of (x, y, z) by particle, in the order of the chosen ones.
template <int D>
std::vector<float> triples(const std::array<std::vector<double>, static_cast<std::size_t>(D)>& vectors,
                           const std::vector<std::uint32_t>& chosen) {
    std::vector<float> result(3 * chosen.size(), 0.0F);
    for (std::size_t k = 0; k < D; ++k) {
        const std::size_t axis = k == D - 1 ? 2 : k;
        for (std::size_t row = 0; row < chosen.size(); ++row) {
            result[3 * row + axis] = static_cast<float>(vectors[k][chosen[row]]);
        }
    }
    return result;
}

}  // namespace

SnapshotRecorder::SnapshotRecorder(const Case& c) : case_(c), boundaries_(c) {
    std::istringstream words(c.output.snapshot_fields);
    for (std::string field; words >> field;) {
        chosen_fields_.push_back(field);
    }
}

bool SnapshotRecorder::has(const char* field) const {
    return std::find(chosen_fields_.begin(), chosen_fields_.end(), field) != chosen_fields_.end();
}

std::vector<SnapshotField> SnapshotRecorder::fields() const {
    std::vector<SnapshotField> fields = {{.name = "position", .components = 3}};
    if (has("velocity")) {
        fields.push_back({.name = "velocity", .components = 3});
    }
    for (const char* scalar : {"pressure", "density", "eddy_viscosity"}) {
        if (has(scalar)) {
            fields.push_back({.name = scalar});
        }
    }
    fields.push_back({.name = "id", .components = 1, .type = ElementType::int32});
    return fields;
}

std::size_t SnapshotRecorder::bytes_per_particle() const {
    std::size_t bytes = 0;
    for (const SnapshotField& field : fields()) {
        bytes += 4 * field.components;
    }
    return bytes;
}

template <int D>
std::vector<std::uint32_t> SnapshotRecorder::chosen(const Particles<D>& p) const {
    std::vector<std::uint32_t> chosen(p.size());
    std::iota(chosen.begin(), chosen.end(), std::uint32_t{0});
    const auto keep_within = [&](const std::vector<double>& range, std::size_t axis) {
        if (!range.empty()) {
            std::erase_if(chosen, [&](std::uint32_t i) {
                return p.position[axis][i] < range[0] || p.position[axis][i] > range[1];
            });
        }
    };
    keep_within(case_.output.snapshot_x, 0);
    if constexpr (D == 3) {
        keep_within(case_.output.snapshot_y, 1);
    }
    keep_within(case_.output.snapshot_z, D - 1);
    // In the order of the particles' numbers: of all particles, row i of every snapshot is the same one.
    std::sort(chosen.begin(), chosen.end(),
              [&](std::uint32_t a, std::uint32_t b) { return p.id[a] < p.id[b]; });
    return chosen;
}

std::size_t SnapshotRecorder::points_in(std::size_t particles) const {
    const auto first = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const SnapshotEntry& e) { return e.particles == particles; });
    return static_cast<std::size_t>(first - entries_.begin());
}

template <int D>
void SnapshotRecorder::record(const SimulationIn<D>& simulation) {
    const Particles<D>& p = simulation.particles();
    const std::vector<std::uint32_t> rows = chosen(p);
    const std::size_t n = rows.size();
    const std::size_t index = entries_.size();
    const std::string group = snapshot_group(index);
    const auto add = [&](const char* name, std::size_t components, auto values, const char* unit,
                         const char* long_name) {
        new_bytes_ += add_field(new_, group + "/" + name, components, std::move(values), unit, long_name);
    };
    const auto scalar = [&](const char* name, const char* unit, const char* long_name, const auto& value) {
        if (has(name)) {
            std::vector<float> values(n);
            for (std::size_t row = 0; row < n; ++row) {
                values[row] = static_cast<float>(value(rows[row]));
            }
            add(name, 1, std::move(values), unit, long_name);
        }
    };
    const double density = case_.fluid.density;
    add("position", 3, triples<D>(p.position, rows), "m", "position (x, y, z)");
    if (has("velocity")) {
        add("velocity", 3, triples<D>(p.velocity, rows), "m/s", "velocity (u, v, w)");
    }
    scalar("pressure", "Pa", "pressure", [&](std::size_t i) {
        return density * simulation.scheme().state.pressure(p.density_deviation[i]);
    });
    scalar("density", "kg/m3", "density",
           [&](std::size_t i) { return density * (1.0 + p.density_deviation[i]); });
    scalar("eddy_viscosity", "m2/s", "eddy viscosity",
           [&](std::size_t i) { return simulation.fields().eddy_viscosity[i]; });
    std::vector<std::int32_t> id(n);
    for (std::size_t row = 0; row < n; ++row) {
        id[row] = static_cast<std::int32_t>(p.id[rows[row]]);
    }
    add("id", 1, std::move(id), "1", "particle number");
    SnapshotEntry entry{.index = index, .time = simulation.clock().time, .particles = n};
    if constexpr (D == 3) {
        entry.points_in = points_in(n);
        if (*entry.points_in == index) {
            std::vector<std::int32_t> points(n);
            std::iota(points.begin(), points.end(), 0);
            add("point", 1, std::move(points), "1", "rows of the snapshot, for its index");
        }
    }
    new_.attributes.push_back({.path = group, .name = "time", .value = entry.time});
    new_bytes_ += boundaries_.add_moved(new_, group, entry.time);
    entries_.push_back(entry);
}

template <int D>
void SnapshotRecorder::record_last(const SimulationIn<D>& simulation) {
    if (case_.output.snapshot_interval <= 0.0) {
        return;
    }
    if (!entries_.empty() && entries_.back().time >= simulation.clock().time) {
        return;
    }
    record(simulation);
    has_last_ = true;
}

template void SnapshotRecorder::record(const SimulationIn<2>&);
template void SnapshotRecorder::record(const SimulationIn<3>&);
template void SnapshotRecorder::record_last(const SimulationIn<2>&);
template void SnapshotRecorder::record_last(const SimulationIn<3>&);

Content SnapshotRecorder::take() {
    new_bytes_ = 0;
    return std::exchange(new_, {});
}

void SnapshotRecorder::save(Content& checkpoint) const {
    std::vector<double> times;
    std::vector<double> particles;
    for (const SnapshotEntry& entry : std::span(entries_).first(entries_.size() - (has_last_ ? 1 : 0))) {
        times.push_back(entry.time);
        particles.push_back(static_cast<double>(entry.particles));
    }
    add_array(checkpoint, "/recorder/snapshot_times", std::move(times), "s", "times of the snapshots so far");
    add_array(checkpoint, "/recorder/snapshot_particles", std::move(particles), "1",
              "particles in the snapshots so far");
}

void SnapshotRecorder::restore(const CheckpointReader& checkpoint) {
    const std::string path = "/recorder/snapshot_times";
    const std::vector<std::size_t> shape = checkpoint.shape(path);
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const std::vector<double> times = checkpoint.doubles(path, n);
    const std::vector<double> particles = checkpoint.doubles("/recorder/snapshot_particles", n);
    entries_.clear();
    for (std::size_t i = 0; i < n; ++i) {
        SnapshotEntry entry{
            .index = i, .time = times[i], .particles = static_cast<std::size_t>(particles[i])};
        if (case_.channel.dimensions == 3) {
            entry.points_in = points_in(entry.particles);
        }
        entries_.push_back(entry);
    }
}

void SnapshotRecorder::keep_last(const ResultsReader& results, double time) {
    const std::string group = snapshot_group(entries_.size());
    if (!results.has(group) || results.attribute(group, "time") != AttributeValue(time)) {
        return;
    }
    SnapshotEntry entry{
        .index = entries_.size(), .time = time, .particles = results.shape(group + "/id").front()};
    if (case_.channel.dimensions == 3) {
        entry.points_in = points_in(entry.particles);
    }
    entries_.push_back(entry);
    has_last_ = true;
}

}  // namespace riffle
