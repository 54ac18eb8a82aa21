#include "report/field_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace riffle {

namespace {

constexpr std::size_t most_particles = 20'000;
constexpr std::size_t most_rows = 400;
constexpr double crossings = 5.0;

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// One component of an (N, 3) dataset.
std::vector<double> component(const std::vector<double>& rows, std::size_t which) {
    std::vector<double> values(rows.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = rows[3 * i + which];
    return values;
}

/// The free surface at the recorded time nearest to the snapshot's, if one lies within half a record interval
/// (records every 0.02 s by default; snapshots fall between them).
void add_surface(const ResultsReader& reader, Snapshot& snapshot) {
    if (!reader.has("/surface/elevation") || !reader.has("/surface/x") || !reader.has("/surface/time"))
        return;
    const std::vector<double> x = reader.read_doubles("/surface/x");
    const std::vector<double> time = reader.read_doubles("/surface/time");
    const std::vector<double> elevation = reader.read_doubles("/surface/elevation");
    if (time.empty() || x.empty() || elevation.size() != x.size() * time.size()) return;
    const auto distance = [&](double t) { return std::abs(t - snapshot.time); };
    const auto nearest = std::min_element(time.begin(), time.end(),
                                          [&](double a, double b) { return distance(a) < distance(b); });
    const double interval = time.size() > 1 ? time[1] - time[0] : 0.0;
    if (distance(*nearest) > 0.51 * interval + 1e-9) return;
    const auto row = static_cast<std::size_t>(nearest - time.begin());
    const auto first = elevation.begin() + static_cast<std::ptrdiff_t>(row * x.size());
    snapshot.surface_x = x;
    snapshot.surface_z.assign(first, first + static_cast<std::ptrdiff_t>(x.size()));
}

/// Keep the particles within half a spacing of the centreline, in half a channel those next to it.
void slice(const std::vector<double>& y, const Case& c, Snapshot& snapshot) {
    const double middle = c.channel.sides == Sides::half
                              ? c.channel.simulated_width() - 0.5 * c.numerics.spacing
                              : c.channel.centreline();
    for (std::vector<double>* values :
         {&snapshot.x, &snapshot.z, &snapshot.velocity, &snapshot.vertical_velocity, &snapshot.pressure,
          &snapshot.eddy_viscosity}) {
        if (values->size() != y.size()) continue;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < y.size(); ++i) {
            if (std::abs(y[i] - middle) <= 0.5 * c.numerics.spacing) (*values)[kept++] = (*values)[i];
        }
        values->resize(kept);
    }
    snapshot.y = middle;
}

/// Keep the particles with x below the value under which `most_particles` of them lie.
void shorten(Snapshot& snapshot) {
    if (snapshot.x.size() <= most_particles) return;
    std::vector<double> sorted = snapshot.x;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(most_particles),
                     sorted.end());
    const double limit = sorted[most_particles];
    const std::vector<double> x = snapshot.x;
    for (std::vector<double>* values :
         {&snapshot.x, &snapshot.z, &snapshot.velocity, &snapshot.vertical_velocity, &snapshot.pressure,
          &snapshot.eddy_viscosity}) {
        if (values->size() != x.size()) continue;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (x[i] < limit) (*values)[kept++] = (*values)[i];
        }
        values->resize(kept);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < snapshot.surface_x.size(); ++i) {
        if (snapshot.surface_x[i] >= limit) continue;
        snapshot.surface_x[kept] = snapshot.surface_x[i];
        snapshot.surface_z[kept++] = snapshot.surface_z[i];
    }
    snapshot.surface_x.resize(kept);
    snapshot.surface_z.resize(kept);
    snapshot.x_end = limit;
    snapshot.left_out = true;
}

}  // namespace

std::optional<SurfaceRecord> read_surface(const ResultsReader& reader, const ReportData& data) {
    if (!reader.has("/surface/elevation") || !reader.has("/surface/x") || !reader.has("/surface/time"))
        return std::nullopt;
    const std::vector<double> x = reader.read_doubles("/surface/x");
    const std::vector<double> time = reader.read_doubles("/surface/time");
    const std::vector<double> elevation = reader.read_doubles("/surface/elevation");
    const std::size_t columns = x.size();
    const std::size_t rows = columns == 0 ? 0 : std::min(time.size(), elevation.size() / columns);
    if (rows < 2) return std::nullopt;

    SurfaceRecord record;
    record.x = x;
    // Standard deviation over the averaging window (or all of the record before there is one), about the mean
    // of each instant's record, so that a slow drift of the level does not count as waves.
    double squares = 0;
    std::size_t samples = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        if (data.window_end > data.window_start && time[row] < data.window_start) continue;
        const std::vector<double> line(elevation.begin() + static_cast<std::ptrdiff_t>(row * columns),
                                       elevation.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
        const double mean = mean_of(line);
        for (const double value : line) squares += (value - mean) * (value - mean);
        samples += line.size();
    }
    if (samples > 0) record.standard_deviation = std::sqrt(squares / static_cast<double>(samples));

    const double velocity =
        find_value(data.summary, "depth_mean_velocity")
            .value_or(find_value(data.column_summary, "depth_mean_velocity").value_or(0.0));
    const double stretch =
        velocity > 0 ? crossings * data.flow.channel.length / velocity : time[rows - 1] - time[0];
    std::size_t first = rows;
    while (first > 0 && (rows - first < 2 || time[first - 1] >= time[rows - 1] - stretch)) --first;
    const std::size_t stride = (rows - first + most_rows - 1) / most_rows;
    double sum = 0;
    for (std::size_t row = first; row < rows; row += stride) {
        record.time.push_back(time[row]);
        record.elevation.emplace_back(elevation.begin() + static_cast<std::ptrdiff_t>(row * columns),
                                      elevation.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
        sum += mean_of(record.elevation.back());
    }
    record.mean_level = sum / static_cast<double>(record.time.size());
    return record;
}

std::optional<Snapshot> read_snapshot(const ResultsReader& reader, const Case& c) {
    if (!reader.has("/snapshots")) return std::nullopt;
    const std::vector<std::string> names = reader.children("/snapshots");
    if (names.empty()) return std::nullopt;
    const std::string group = "/snapshots/" + names.back();
    if (!reader.has(group + "/position")) return std::nullopt;
    Snapshot snapshot;
    if (const auto time = reader.attribute(group, "time")) {
        if (const auto* value = std::get_if<double>(&*time)) snapshot.time = *value;
    }
    const std::vector<double> position = reader.read_doubles(group + "/position");
    snapshot.x = component(position, 0);
    snapshot.z = component(position, 2);
    if (snapshot.x.empty()) return std::nullopt;
    if (reader.has(group + "/velocity")) {
        const std::vector<double> velocity = reader.read_doubles(group + "/velocity");
        snapshot.velocity = component(velocity, 0);
        snapshot.vertical_velocity = component(velocity, 2);
    }
    if (reader.has(group + "/pressure")) snapshot.pressure = reader.read_doubles(group + "/pressure");
    if (reader.has(group + "/eddy_viscosity")) {
        snapshot.eddy_viscosity = reader.read_doubles(group + "/eddy_viscosity");
    }
    if (c.channel.dimensions == 3) slice(component(position, 1), c, snapshot);
    if (snapshot.x.empty()) return std::nullopt;
    snapshot.x_end = *std::max_element(snapshot.x.begin(), snapshot.x.end());
    add_surface(reader, snapshot);
    shorten(snapshot);
    return snapshot;
}

}  // namespace riffle
