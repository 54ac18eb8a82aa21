#include "solver/snapshots.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <sstream>
#include <utility>

#include "record/field_content.hpp"
#include "record/particle_fields.hpp"
#include "solver/content.hpp"
#include "solver/recorder.hpp"

namespace riffle::inline solver {

namespace {

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
    for (std::string field; words >> field;) chosen_fields_.push_back(field);
}

bool SnapshotRecorder::has(const Field& field) const {
    return std::find(chosen_fields_.begin(), chosen_fields_.end(), field.name) != chosen_fields_.end();
}

std::vector<SnapshotField> SnapshotRecorder::fields() const {
    const auto& of = fields::snapshot;
    std::vector<SnapshotField> all = {{.name = of.position.name, .components = 3}};
    if (has(of.velocity)) {
        all.push_back({.name = of.velocity.name, .components = 3});
    }
    for (const Field& scalar : {of.pressure, of.density, of.eddy_viscosity}) {
        if (has(scalar)) {
            all.push_back({.name = scalar.name});
        }
    }
    all.push_back({.name = of.id.name, .components = 1, .type = ElementType::int32});
    return all;
}

std::size_t SnapshotRecorder::bytes_per_particle() const {
    std::size_t bytes = 0;
    for (const SnapshotField& field : fields()) bytes += 4 * field.components;
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
    if constexpr (D == 3) keep_within(case_.output.snapshot_y, 1);
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
    const auto add = [&]<class T>(const Field& field, std::vector<T> values, std::size_t components = 1) {
        new_bytes_ += values.size() * sizeof(T);
        std::vector<std::size_t> shape = {n};
        if (components > 1) shape.push_back(components);
        Dataset dataset = dataset_of(field, D, std::move(shape), std::move(values));
        dataset.path = field.path_in(group);
        new_.datasets.push_back(std::move(dataset));
    };
    const auto scalar = [&](const Field& field, const auto& value) {
        if (has(field)) {
            std::vector<float> values(n);
            for (std::size_t row = 0; row < n; ++row) values[row] = static_cast<float>(value(rows[row]));
            add(field, std::move(values));
        }
    };
    const auto& of = fields::snapshot;
    const double density = case_.fluid.density;
    add(of.position, triples<D>(p.position, rows), 3);
    if (has(of.velocity)) add(of.velocity, triples<D>(p.velocity, rows), 3);
    scalar(of.pressure, [&](std::size_t i) {
        return density * simulation.scheme().state.pressure(p.density_deviation[i]);
    });
    scalar(of.density, [&](std::size_t i) { return density * (1.0 + p.density_deviation[i]); });
    scalar(of.eddy_viscosity, [&](std::size_t i) { return simulation.fields().eddy_viscosity[i]; });
    std::vector<std::int32_t> id(n);
    for (std::size_t row = 0; row < n; ++row) id[row] = static_cast<std::int32_t>(p.id[rows[row]]);
    add(of.id, std::move(id));
    SnapshotEntry entry{.index = index, .time = simulation.clock().time, .particles = n};
    if constexpr (D == 3) {
        entry.points_in = points_in(n);
        if (*entry.points_in == index) {
            std::vector<std::int32_t> points(n);
            std::iota(points.begin(), points.end(), 0);
            add(of.point, std::move(points));
        }
    }
    new_.attributes.push_back({.path = group, .name = of.time.name, .value = entry.time});
    new_bytes_ += boundaries_.add_moved(new_, group, entry.time, simulation.clock().free_bodies);
    entries_.push_back(entry);
}

template <int D>
void SnapshotRecorder::record_last(const SimulationIn<D>& simulation) {
    if (case_.output.snapshot_interval <= 0.0) return;
    if (!entries_.empty() && entries_.back().time >= simulation.clock().time) return;
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
        if (case_.channel.dimensions == 3) entry.points_in = points_in(entry.particles);
        entries_.push_back(entry);
    }
}

void SnapshotRecorder::keep_last(const ResultsReader& results, double time) {
    const std::string group = snapshot_group(entries_.size());
    if (!results.has(group) || results.attribute(group, fields::snapshot.time.name) != AttributeValue(time)) {
        return;
    }
    SnapshotEntry entry{.index = entries_.size(),
                        .time = time,
                        .particles = results.shape(fields::snapshot.id.path_in(group)).front()};
    if (case_.channel.dimensions == 3) entry.points_in = points_in(entry.particles);
    entries_.push_back(entry);
    has_last_ = true;
}

}  // namespace riffle::inline solver
