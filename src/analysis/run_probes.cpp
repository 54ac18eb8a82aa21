#include "analysis/run_probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "case/end_buffers.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline analysis {

namespace {

/// One instrument: its group, and the rows of it that lie within the window.
class ProbeGroup {
  public:
    ProbeGroup(const RunResults& results, std::string name, const TimeWindow& window, std::size_t most_values,
               std::vector<std::string>& warnings)
        : results_(results), name_(std::move(name)), group_(probe_group(name_)) {
        const std::vector<double> time = values(fields::forces.time);  // as of all kinds
        const auto first = std::lower_bound(time.begin(), time.end(), window.from - 1e-9);
        const auto last = std::upper_bound(time.begin(), time.end(), window.to + 1e-9);
        first_ = static_cast<std::size_t>(first - time.begin());
        rows_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, last - first));
        const std::size_t most = std::max<std::size_t>(2, most_values / std::max<std::size_t>(1, width()));
        if (rows_ > most) {
            warnings.push_back(fmt::format(
                "instrument {}: of {} samples in the window the last {} were analysed", name_, rows_, most));
            first_ += rows_ - most;
            rows_ = most;
        }
        time_.assign(time.begin() + static_cast<std::ptrdiff_t>(first_),
                     time.begin() + static_cast<std::ptrdiff_t>(first_ + rows_));
    }

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<double>& time() const { return time_; }
    [[nodiscard]] std::vector<double> values(const Field& field) const {
        return results_.values({group_, field});
    }

    /// Rows of an array within the window, `points` values each.
    [[nodiscard]] std::vector<double> rows(const FieldPlace& place, std::size_t points) const {
        if (!results_.has(place)) return {};
        const std::vector<std::size_t> shape = results_.shape(place);
        if (shape.empty() || shape[0] < first_ + rows_) fail(place);
        std::vector<double> values = results_.rows(place, first_, rows_);
        if (values.size() != rows_ * points) fail(place);
        return values;
    }
    [[nodiscard]] std::vector<double> rows(const Field& field, std::size_t points) const {
        return rows(FieldPlace(group_, field), points);
    }
    /// The samples of one of `points` points from the rows of its array.
    [[nodiscard]] std::vector<double> of_point(const std::vector<double>& rows, std::size_t points,
                                               std::size_t point) const {
        std::vector<double> samples(rows_);
        for (std::size_t row = 0; row < rows_; ++row) samples[row] = rows[row * points + point];
        return samples;
    }
    [[nodiscard]] std::vector<std::string> arrays() const { return results_.children(group_); }
    [[nodiscard]] FieldPlace place(const std::string& array) const { return {group_, array}; }

  private:
    /// Values of a row of the widest array.
    [[nodiscard]] std::size_t width() const {
        std::size_t most = 1;
        for (const std::string& array : arrays()) {
            const std::vector<std::size_t> shape = results_.shape(place(array));
            std::size_t values = 1;
            for (std::size_t i = 1; i < shape.size(); ++i) values *= shape[i];
            most = std::max(most, values);
        }
        return most;
    }
    [[noreturn]] void fail(const FieldPlace& place) const {
        throw FileError(
            fmt::format("{} of the results file does not fit the times and positions of its "
                        "instrument; the file is damaged, or not as this Riffle writes it",
                        place.path()));
    }

    const RunResults& results_;
    std::string name_, group_;
    std::size_t first_ = 0;
    std::size_t rows_ = 0;
    std::vector<double> time_;
};

void read_wave(const ProbeGroup& group, RunProbes& probes) {
    const std::vector<double> x = group.values(fields::elevations.x);
    const std::vector<double> y = group.values(fields::elevations.y);  // one, or as many as x
    const bool places_across = y.size() == x.size() && x.size() > 1 && y.front() != y.back();
    const std::vector<double> elevation = group.rows(fields::elevations.elevation, x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        ElevationProbe probe;
        probe.name = x.size() == 1 ? group.name() : fmt::format("{} x = {}", group.name(), shown_place(x[i]));
        if (places_across) probe.name += fmt::format(", y = {}", shown_place(y[i]));
        probe.x = x[i];
        if (!y.empty()) probe.y = y[std::min(i, y.size() - 1)];
        probe.time = group.time();
        probe.elevation = group.of_point(elevation, x.size(), i);
        probes.wave.push_back(std::move(probe));
    }
}

void read_surface_line(const ProbeGroup& group, const Case& c, RunProbes& probes) {
    const std::vector<double> x = group.values(fields::elevations.x);
    const std::vector<double> y = group.values(fields::elevations.y);
    if (c.channel.dimensions == 3 && !y.empty() &&
        std::abs(y.front() - c.channel.centreline()) > c.numerics.spacing) {
        probes.warnings.push_back(
            fmt::format("surface line {}: it lies at y = {}, beside the "
                        "centreline, and is not analysed",
                        group.name(), shown_place(y.front())));
        return;
    }
    if (x.size() <= probes.surface_line.columns || group.time().size() < 2) return;
    probes.surface_line =
        make_space_time(x, group.time(), group.rows(fields::elevations.elevation, x.size()), period_of(c));
}

void read_velocity(const ProbeGroup& group, RunProbes& probes) {
    VelocityProbe probe;
    probe.name = group.name();
    probe.x = group.values(fields::velocity_points.x);
    probe.z = group.values(fields::velocity_points.z);
    probe.y = group.values(fields::velocity_points.y);
    const std::size_t points = std::max(probe.x.size(), probe.z.size());
    if (probe.x.size() == 1) probe.x.resize(points, probe.x.front());
    if (probe.z.size() == 1) probe.z.resize(points, probe.z.front());
    if (probe.y.size() == 1) probe.y.resize(points, probe.y.front());
    probe.time = group.time();
    probe.u = group.rows(fields::velocity_points.velocity, points);
    probe.w = group.rows(fields::velocity_points.vertical_velocity, points);
    probe.v = group.rows(fields::velocity_points.spanwise_velocity, points);
    probes.velocity.push_back(std::move(probe));
}

/// Means over the averaging windows of a grid, each counting as often as it has samples: the variance in time
/// is the mean variance within the windows and the variance of their means.
/// A row stands for the time up to its own: the first counts only where it began within the window.
void read_grid(const ProbeGroup& group, const Case& c, const TimeWindow& window, RunProbes& probes) {
    const std::vector<double>& time = group.time();
    const auto own = std::find_if(c.probes.begin(), c.probes.end(),
                                  [&](const Probe& probe) { return probe.name == group.name(); });
    const double averaging = time.size() > 1         ? time[1] - time[0]
                             : own != c.probes.end() ? own->averaging_time
                                                     : 0.0;
    const std::size_t first_row = time[0] - averaging < window.from - 1e-3 * averaging ? 1 : 0;
    if (first_row >= time.size()) {
        probes.warnings.push_back(fmt::format(
            "instrument {}: its only mean of the window began {:.3g} s before it, and is left out",
            group.name(), window.from - (time[0] - averaging)));
        return;
    }
    const auto& of = fields::velocity_grid;
    VelocityGrid grid;
    grid.name = group.name();
    grid.x = group.values(of.x);
    grid.z = group.values(of.z);
    const std::size_t points = grid.x.size() * grid.z.size();
    const std::array arrays = {of.velocity,
                               of.vertical_velocity,
                               of.velocity_variance,
                               of.vertical_velocity_variance,
                               of.velocity_covariance,
                               of.pressure,
                               of.shear_stress};
    constexpr std::size_t velocities = 5;
    const std::vector<double> samples = group.rows(of.samples, 1);
    std::array<std::vector<double>, arrays.size()> rows;
    for (std::size_t k = 0; k < arrays.size(); ++k) {
        rows[k] = group.rows(arrays[k], points);
        if (rows[k].empty() && k < velocities) return;
    }
    const std::vector<double> y = group.values(of.y);
    if (!y.empty()) grid.y = y.front();
    // What files of earlier versions, and runs without a closure, do not have.
    if (!rows[velocities].empty()) grid.pressure.assign(points, not_a_number);
    if (!rows[velocities + 1].empty()) grid.shear_stress.assign(points, not_a_number);
    for (std::vector<double>* values : {&grid.u, &grid.w, &grid.uu, &grid.ww, &grid.uw}) {
        values->assign(points, not_a_number);
    }
    for (std::size_t i = 0; i < points; ++i) {
        double n = 0.0;
        std::array<double, 10> sum{};
        for (std::size_t row = first_row; row < time.size(); ++row) {
            const auto at = [&](std::size_t k) { return rows[k].empty() ? 0.0 : rows[k][row * points + i]; };
            const double u = at(0);
            const double w = at(1);
            if (!std::isfinite(u) || !std::isfinite(w)) continue;
            const double weight = samples.empty() ? 1.0 : samples[row];
            n += weight;
            const std::array<double, 10> add = {u,     w,     at(2), at(3),          at(4),
                                                u * u, w * w, u * w, at(velocities), at(velocities + 1)};
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * add[k];
        }
        if (!(n > 0.0)) continue;
        grid.u[i] = sum[0] / n;
        grid.w[i] = sum[1] / n;
        grid.uu[i] = sum[2] / n + sum[5] / n - grid.u[i] * grid.u[i];
        grid.ww[i] = sum[3] / n + sum[6] / n - grid.w[i] * grid.w[i];
        grid.uw[i] = sum[4] / n + sum[7] / n - grid.u[i] * grid.w[i];
        if (!grid.pressure.empty()) grid.pressure[i] = sum[8] / n;
        if (!grid.shear_stress.empty()) grid.shear_stress[i] = sum[9] / n;
    }
    probes.grids.push_back(std::move(grid));
}

void read_plane(const ProbeGroup& group, const Case& c, RunProbes& probes) {
    VelocityPlane plane;
    plane.name = group.name();
    plane.x = group.values(fields::velocity_plane.x);
    plane.z = group.values(fields::velocity_plane.z);
    plane.time = group.time();
    const std::size_t points = plane.x.size() * plane.z.size();
    plane.u = group.rows(fields::velocity_plane.velocity, points);
    plane.w = group.rows(fields::velocity_plane.vertical_velocity, points);
    if (plane.x.size() > 1) {
        const double spacing = plane.x[1] - plane.x[0];
        const double length = static_cast<double>(plane.x.size()) * spacing;
        const std::optional<double> period = period_of(c);
        if (period && std::abs(length - *period) < 1e-3 * spacing) plane.period = period;
    }
    probes.planes.push_back(std::move(plane));
}

void read_scalars(const RunResults& results, const ProbeGroup& group, const std::string& kind,
                  RunProbes& probes) {
    const std::vector<double> x = group.values(fields::flow_rate.x);
    const std::size_t points = std::max<std::size_t>(1, x.size());
    for (const std::string& array : group.arrays()) {
        if (array == "time" || array == "x" || array == "y" || array == "z") continue;
        const FieldPlace place = group.place(array);
        const std::vector<double> values = group.rows(place, points);
        for (std::size_t i = 0; i < points; ++i) {
            ScalarProbe probe;
            probe.name = group.name();
            probe.kind = kind;
            probe.quantity = points == 1 ? array : fmt::format("{}_{}", array, i + 1);
            probe.label = results.long_name(place);
            if (!x.empty()) probe.label += fmt::format(", x = {}", shown_place(x[i]));
            probe.unit = results.unit(place);
            probe.time = group.time();
            probe.value = group.of_point(values, points, i);
            if (i < x.size()) probe.x = x[i];
            probes.scalars.push_back(std::move(probe));
        }
    }
}

void read_gauges(const ProbeGroup& group, RunProbes& probes) {
    const auto& of = fields::pressure_gauges;
    const std::vector<double> x = group.values(of.x);
    const std::vector<double> y = group.values(of.y);
    const std::vector<double> z = group.values(of.z);
    const std::size_t points = std::max({x.size(), y.size(), z.size()});
    const std::vector<double> pressure = group.rows(of.pressure, points);
    const auto place = [](const char* axis, const std::vector<double>& values, std::size_t point) {
        return values.empty()
                   ? std::string()
                   : fmt::format(", {} = {}", axis, shown_place(values[std::min(point, values.size() - 1)]));
    };
    for (std::size_t i = 0; i < points && !pressure.empty(); ++i) {
        ScalarProbe probe;
        probe.name = group.name();
        probe.kind = "pressure";
        probe.quantity = points == 1 ? "pressure" : fmt::format("pressure_{}", i + 1);
        probe.label = group.name() + place("x", x, i) + place("y", y, i) + place("z", z, i);
        probe.unit = "Pa";
        probe.time = group.time();
        probe.value = group.of_point(pressure, points, i);
        probes.scalars.push_back(std::move(probe));
    }
}

}  // namespace

std::optional<double> period_of(const Case& c) {
    return c.channel.ends == Ends::periodic ? std::optional<double>(c.channel.length) : std::nullopt;
}

RunProbes read_probes(const RunResults& results, const Case& c, const TimeWindow& window,
                      std::size_t most_values) {
    RunProbes probes;
    const std::vector<std::string> names = results.children(probes_group);
    const std::size_t share = most_values / std::max<std::size_t>(1, names.size());
    for (const std::string& name : names) {
        const std::string place = probe_group(name);
        const std::string kind = results.text({place, fields::probe.kind});
        if (kind.empty() || !results.has({place, fields::forces.time})) {
            probes.warnings.push_back("instrument " + name +
                                      " of the results file has no kind or no samples");
            continue;
        }
        const ProbeGroup group(results, name, window, share, probes.warnings);
        if (group.time().empty()) {
            probes.warnings.push_back("instrument " + name + " has no samples in the window");
        } else if (kind == "wave") {
            read_wave(group, probes);
        } else if (kind == "surface_line") {
            read_surface_line(group, c, probes);
        } else if (kind == "velocity") {
            read_velocity(group, probes);
        } else if (kind == "grid" && !results.has({place, fields::velocity_grid.samples})) {
            read_plane(group, c, probes);
        } else if (kind == "grid") {
            read_grid(group, c, window, probes);
        } else if (name == momentum_sections_name) {
            read_scalars(results, group, "momentum", probes);  // for the budget alone
        } else if (kind == "flow_rate" || kind == "force") {
            read_scalars(results, group, kind, probes);
        } else if (kind == "pressure") {
            read_gauges(group, probes);
        } else {
            probes.warnings.push_back(
                fmt::format("instrument {}: its kind \"{}\" is not one that this version of Riffle analyses",
                            name, kind));
        }
    }
    return probes;
}

}  // namespace riffle::inline analysis
