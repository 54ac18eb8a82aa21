#include "analysis/run_probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "base/not_a_number.hpp"

namespace riffle {

namespace {

/// One instrument: its group, and the rows of it that lie within the window.
class ProbeGroup {
  public:
    ProbeGroup(const ResultsReader& reader, std::string name, const TimeWindow& window,
               std::size_t most_values, std::vector<std::string>& warnings)
        : reader_(reader), name_(std::move(name)), group_("/probes/" + name_) {
        const std::vector<double> time = reader.read_doubles(group_ + "/time");
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
    [[nodiscard]] std::vector<double> axis(const char* which) const {
        const std::string path = group_ + "/" + which;
        return reader_.has(path) ? reader_.read_doubles(path) : std::vector<double>{};
    }
    [[nodiscard]] bool has(const std::string& what) const { return reader_.has(group_ + "/" + what); }

    /// Rows of an array within the window, `points` values each.
    [[nodiscard]] std::vector<double> rows(const std::string& what, std::size_t points) const {
        const std::string path = group_ + "/" + what;
        if (!reader_.has(path)) return {};
        const std::vector<std::size_t> shape = reader_.shape(path);
        if (shape.empty() || shape[0] < first_ + rows_) fail(what);
        std::vector<double> values = reader_.read_rows(path, first_, rows_);
        if (values.size() != rows_ * points) fail(what);
        return values;
    }
    [[nodiscard]] std::string text(const std::string& what, const char* attribute) const {
        const auto value = reader_.attribute(group_ + "/" + what, attribute);
        const auto* words = value ? std::get_if<std::string>(&*value) : nullptr;
        return words == nullptr ? std::string() : *words;
    }
    [[nodiscard]] std::vector<std::string> arrays() const { return reader_.children(group_); }

  private:
    /// Values of a row of the widest array.
    [[nodiscard]] std::size_t width() const {
        std::size_t most = 1;
        for (const std::string& array : reader_.children(group_)) {
            const std::vector<std::size_t> shape = reader_.shape(group_ + "/" + array);
            std::size_t values = 1;
            for (std::size_t i = 1; i < shape.size(); ++i) values *= shape[i];
            most = std::max(most, values);
        }
        return most;
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw FileError(
            fmt::format("{}/{} of the results file does not fit the times and positions of its "
                        "instrument; the file is damaged, or not as this Riffle writes it",
                        group_, what));
    }

    const ResultsReader& reader_;
    std::string name_, group_;
    std::size_t first_ = 0;
    std::size_t rows_ = 0;
    std::vector<double> time_;
};

void read_wave(const ProbeGroup& group, RunProbes& probes) {
    const std::vector<double> x = group.axis("x");
    const std::vector<double> y = group.axis("y");  // one, or as many as x
    const bool places_across = y.size() == x.size() && x.size() > 1 && y.front() != y.back();
    const std::vector<double> elevation = group.rows("elevation", x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        ElevationProbe probe;
        probe.name =
            x.size() == 1 ? group.name() : fmt::format("{} x = {:.4g} mm", group.name(), 1000 * x[i]);
        if (places_across) probe.name += fmt::format(", y = {:.4g} mm", 1000 * y[i]);
        probe.x = x[i];
        if (!y.empty()) probe.y = y[std::min(i, y.size() - 1)];
        probe.time = group.time();
        for (std::size_t row = 0; row < probe.time.size(); ++row)
            probe.elevation.push_back(elevation[row * x.size() + i]);
        probes.wave.push_back(std::move(probe));
    }
}

void read_surface_line(const ProbeGroup& group, const Case& c, RunProbes& probes) {
    const std::vector<double> x = group.axis("x");
    const std::vector<double> y = group.axis("y");
    if (c.channel.dimensions == 3 && !y.empty() &&
        std::abs(y.front() - c.channel.centreline()) > c.numerics.spacing) {
        probes.warnings.push_back(
            fmt::format("surface line {}: it lies at y = {:.4g} mm, beside the "
                        "centreline, and is not analysed",
                        group.name(), 1000.0 * y.front()));
        return;
    }
    if (x.size() <= probes.surface_line.columns || group.time().size() < 2) return;
    probes.surface_line = make_space_time(x, group.time(), group.rows("elevation", x.size()), period_of(c));
}

void read_velocity(const ProbeGroup& group, RunProbes& probes) {
    VelocityProbe probe;
    probe.name = group.name();
    probe.x = group.axis("x");
    probe.z = group.axis("z");
    probe.y = group.axis("y");
    const std::size_t points = std::max(probe.x.size(), probe.z.size());
    if (probe.x.size() == 1) probe.x.resize(points, probe.x.front());
    if (probe.z.size() == 1) probe.z.resize(points, probe.z.front());
    if (probe.y.size() == 1) probe.y.resize(points, probe.y.front());
    probe.time = group.time();
    probe.u = group.rows("velocity", points);
    probe.w = group.rows("vertical_velocity", points);
    probe.v = group.rows("spanwise_velocity", points);
    probes.velocity.push_back(std::move(probe));
}

/// Means over the averaging windows of a grid, each counting as often as it has samples: the variance in time
/// is the mean variance within the windows and the variance of their means.
/// A row stands for the time up to its own: the first counts only where it began within the window.
void read_grid(const ProbeGroup& group, const TimeWindow& window, RunProbes& probes) {
    const std::vector<double>& time = group.time();
    const double averaging = time.size() > 1 ? time[1] - time[0] : 0.0;
    const std::size_t first_row =
        time.size() > 1 && time[0] - averaging < window.from - 1e-3 * averaging ? 1 : 0;
    VelocityGrid grid;
    grid.name = group.name();
    grid.x = group.axis("x");
    grid.z = group.axis("z");
    const std::size_t points = grid.x.size() * grid.z.size();
    const std::array names = {"velocity",
                              "vertical_velocity",
                              "velocity_variance",
                              "vertical_velocity_variance",
                              "velocity_covariance",
                              "pressure",
                              "shear_stress"};
    constexpr std::size_t velocities = 5;
    const std::vector<double> samples = group.rows("samples", 1);
    std::array<std::vector<double>, names.size()> rows;
    for (std::size_t k = 0; k < names.size(); ++k) {
        rows[k] = group.rows(names[k], points);
        if (rows[k].empty() && k < velocities) return;
    }
    const std::vector<double> y = group.axis("y");
    if (!y.empty()) grid.y = y.front();
    // What files of earlier versions, and runs without a closure, do not have.
    if (!rows[velocities].empty()) grid.pressure.assign(points, not_a_number);
    if (!rows[velocities + 1].empty()) grid.shear_stress.assign(points, not_a_number);
    for (std::vector<double>* values : {&grid.u, &grid.w, &grid.uu, &grid.ww, &grid.uw})
        values->assign(points, not_a_number);
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
    plane.x = group.axis("x");
    plane.z = group.axis("z");
    plane.time = group.time();
    const std::size_t points = plane.x.size() * plane.z.size();
    plane.u = group.rows("velocity", points);
    plane.w = group.rows("vertical_velocity", points);
    if (plane.x.size() > 1) {
        const double spacing = plane.x[1] - plane.x[0];
        const double length = static_cast<double>(plane.x.size()) * spacing;
        const std::optional<double> period = period_of(c);
        if (period && std::abs(length - *period) < 1e-3 * spacing) plane.period = period;
    }
    probes.planes.push_back(std::move(plane));
}

void read_scalars(const ProbeGroup& group, const std::string& kind, RunProbes& probes) {
    const std::vector<double> x = group.axis("x");
    const std::size_t points = std::max<std::size_t>(1, x.size());
    for (const std::string& array : group.arrays()) {
        if (array == "time" || array == "x" || array == "y" || array == "z") continue;
        const std::vector<double> values = group.rows(array, points);
        for (std::size_t i = 0; i < points; ++i) {
            ScalarProbe probe;
            probe.name = group.name();
            probe.kind = kind;
            probe.quantity = points == 1 ? array : fmt::format("{}_{}", array, i + 1);
            probe.label = group.text(array, "long_name");
            if (!x.empty()) probe.label += fmt::format(", x = {:.4g} mm", 1000.0 * x[i]);
            probe.unit = group.text(array, "units");
            probe.time = group.time();
            for (std::size_t row = 0; row < probe.time.size(); ++row)
                probe.value.push_back(values[row * points + i]);
            probes.scalars.push_back(std::move(probe));
        }
    }
}

}  // namespace

std::optional<double> period_of(const Case& c) {
    return c.channel.ends == Ends::periodic ? std::optional<double>(c.channel.length) : std::nullopt;
}

RunProbes read_probes(const ResultsReader& reader, const Case& c, const TimeWindow& window,
                      std::size_t most_values) {
    RunProbes probes;
    if (!reader.has("/probes")) return probes;
    const std::vector<std::string> names = reader.children("/probes");
    const std::size_t share = most_values / std::max<std::size_t>(1, names.size());
    for (const std::string& name : names) {
        const auto attribute = reader.attribute("/probes/" + name, "kind");
        const auto* kind = attribute ? std::get_if<std::string>(&*attribute) : nullptr;
        if (kind == nullptr || !reader.has("/probes/" + name + "/time")) {
            probes.warnings.push_back("instrument " + name +
                                      " of the results file has no kind or no samples");
            continue;
        }
        const ProbeGroup group(reader, name, window, share, probes.warnings);
        if (group.time().empty()) {
            probes.warnings.push_back("instrument " + name + " has no samples in the window");
        } else if (*kind == "wave") {
            read_wave(group, probes);
        } else if (*kind == "surface_line") {
            read_surface_line(group, c, probes);
        } else if (*kind == "velocity") {
            read_velocity(group, probes);
        } else if (*kind == "grid" && !reader.has("/probes/" + name + "/samples")) {
            read_plane(group, c, probes);
        } else if (*kind == "grid") {
            read_grid(group, window, probes);
        } else if (*kind == "flow_rate" || *kind == "force") {
            read_scalars(group, *kind, probes);
        } else {
            probes.warnings.push_back("instrument " + name + ": its kind \"" + *kind +
                                      "\" is not one that this version of Riffle analyses");
        }
    }
    return probes;
}

}  // namespace riffle
