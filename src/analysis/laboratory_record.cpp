#include "analysis/laboratory_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/figure_tools.hpp"
#include "analysis/measured_files.hpp"
#include "base/error.hpp"
#include "column/section.hpp"
#include "laboratory/probe_record.hpp"
#include "laboratory/record_repair.hpp"
#include "laboratory/velocity_series.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline analysis {

namespace {

/// The section twin of a case as analyses take it; empty where it has none.
SectionTwin section_twin_of(const Case& c) {
    SectionTwin twin;
    if (!has_section(c)) return twin;
    const SectionResult section = solve_section(c);
    twin.y = section.y;
    twin.z = section.z;
    twin.velocity = section.velocity;
    twin.shear_stress = section.shear_stress;
    twin.numbers.set(fields::section_numbers.centreline_velocity, section.centreline_velocity);
    return twin;
}

}  // namespace

struct LaboratoryRecord::Impl {
    Impl(std::filesystem::path csv, LaboratoryRecordOptions given)
        : path(std::move(csv)), options(std::move(given)) {
        if (!options.case_file.empty()) {
            flow = read_case(options.case_file);
            if (has_column(*flow)) column = solve_column(*flow);
        }
        switch (laboratory_kind(path)) {
            case LaboratoryKind::profile:
                read_profile();
                break;
            case LaboratoryKind::section:
                read_section();
                break;
            case LaboratoryKind::field:
                read_field();
                break;
            case LaboratoryKind::velocity:
                read_velocity();
                break;
            case LaboratoryKind::waves:
                read_waves();
                break;
        }
    }

    [[nodiscard]] double datum() const { return flow ? flow->datum() : 0.0; }

    void choose_window(double first, double last) {
        window = options.window.value_or(TimeWindow{first, last});
        if (window.from < window.to && window.from < last && window.to > first) return;
        throw InputError(
            fmt::format("--window {},{}: {} holds {:.6g} s to {:.6g} s; give FROM,TO in seconds with "
                        "FROM < TO within this",
                        window.from, window.to, path.string(), first, last));
    }

    /// Times of an even record within the window, and the range of its samples.
    [[nodiscard]] std::pair<std::size_t, std::vector<double>> times(double start, double frequency,
                                                                    std::size_t samples) {
        const auto at = [&](std::size_t i) { return start + static_cast<double>(i) / frequency; };
        choose_window(start, at(samples == 0 ? 0 : samples - 1));
        std::size_t first = 0;
        std::vector<double> result;
        for (std::size_t i = 0; i < samples; ++i) {
            if (!window.holds(at(i))) {
                if (result.empty()) first = i + 1;
                continue;
            }
            result.push_back(at(i));
        }
        return {first, result};
    }

    void take(const std::string& record_title, const std::vector<std::string>& record_warnings) {
        title = record_title;
        warnings.insert(warnings.end(), record_warnings.begin(), record_warnings.end());
    }

    [[nodiscard]] double density() const { return flow ? flow->fluid.density : 1000.0; }

    void read_profile() {
        const ProfileRecord record = read_profile_record(path);
        take(record.title, record.warnings);
        profiles = profiles_of(record, datum(), density());
    }

    void read_section() {
        if (!flow) {
            throw InputError(path.string() +
                             ": points across a channel need its case, which tells width and depth: --case "
                             "CASE.toml");
        }
        const SectionRecord record = read_section_record(path);
        take(record.title, record.warnings);
        section = section_points_of(record, *flow);
    }

    /// The window is that of the frames; of a field of means there is none.
    void read_field() {
        VelocityField field = read_velocity_field(path, options.sampling_frequency);
        take(field.title, field.warnings);
        if (field.time.empty()) {
            if (field.frames > 1) {
                warnings.emplace_back(
                    "the frames tell no times: means and variances only; --frequency HZ gives them times");
            }
        } else {
            choose_window(field.time.front(), field.time.back());
            keep_window(field);
        }
        grids.push_back(grid_of(field, datum()));
        profiles = profiles_of(grids.front(), density());
        if (field.time.empty()) return;
        planes.push_back(plane_of(field, datum()));
        add_column_of_points(planes.front());
    }

    /// Leave the frames outside of the window out.
    void keep_window(VelocityField& field) const {
        const std::size_t points = field.points();
        std::size_t kept = 0;
        for (std::size_t k = 0; k < field.frames; ++k) {
            if (!window.holds(field.time[k])) continue;
            for (auto* const values : {&field.u, &field.w}) {
                const auto from = values->begin() + static_cast<std::ptrdiff_t>(k * points);
                std::copy(from, from + static_cast<std::ptrdiff_t>(points),
                          values->begin() + static_cast<std::ptrdiff_t>(kept * points));
            }
            field.time[kept++] = field.time[k];
        }
        field.frames = kept;
        field.time.resize(kept);
        field.u.resize(kept * points);
        field.w.resize(kept * points);
    }

    /// The column in the middle as the points of a velocity probe, less the heights with lost vectors.
    void add_column_of_points(const VelocityPlane& plane) {
        const std::size_t middle = plane.x.size() / 2;
        std::vector<std::size_t> rows;
        for (std::size_t j = 0; j < plane.z.size(); ++j) {
            bool whole = true;
            for (std::size_t k = 0; k < plane.time.size(); ++k) {
                whole = whole && std::isfinite(plane.u[(k * plane.z.size() + j) * plane.x.size() + middle]);
            }
            if (whole) rows.push_back(j);
        }
        if (rows.size() < plane.z.size()) {
            warnings.push_back(
                fmt::format("vectors are missing at {} of {} heights of the column x = {}; spectra "
                            "and quadrants are those of the others",
                            plane.z.size() - rows.size(), plane.z.size(), shown_place(plane.x[middle])));
        }
        if (rows.empty()) return;
        VelocityProbe probe;
        probe.name = plane.name;
        probe.time = plane.time;
        for (const std::size_t j : rows) {
            probe.x.push_back(plane.x[middle]);
            probe.z.push_back(plane.z[j]);
        }
        for (std::size_t k = 0; k < plane.time.size(); ++k) {
            for (const std::size_t j : rows) {
                const std::size_t at = (k * plane.z.size() + j) * plane.x.size() + middle;
                probe.u.push_back(plane.u[at]);
                probe.w.push_back(plane.w[at]);
            }
        }
        velocity.push_back(std::move(probe));
    }

    void read_velocity() {
        VelocitySeriesOptions how;
        how.sampling_frequency = options.sampling_frequency;
        const VelocitySeries series = read_velocity_series(path, how);
        take(series.title, series.warnings);
        const auto [first, time] = times(series.start, series.sampling_frequency, series.u.values.size());
        const auto part = [&, from = first, count = time.size()](const std::vector<double>& all) {
            if (all.size() < from + count) return std::vector<double>{};
            return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(from),
                                       all.begin() + static_cast<std::ptrdiff_t>(from + count));
        };
        VelocityProbe probe;
        probe.name = path.stem().string();
        probe.x = {std::isfinite(series.x) ? series.x : 0.0};
        probe.z = {(std::isfinite(series.z) ? series.z : 0.0) + datum()};
        if (!std::isfinite(series.z)) {
            warnings.emplace_back(
                "the file does not tell the height of the point (\"# z: 12 mm\"); it is taken as 0");
        }
        probe.time = time;
        probe.u = part(series.u.values);
        probe.v = part(series.v.values);
        probe.w = part(series.w.values);
        velocity.push_back(std::move(probe));
    }

    /// Bridge the gaps that the repair left where they are short beside the passage of a pattern (0.1 s): a
    /// whole record loses less by that than by leaving the probe out.
    void bridge_gaps(ProbeRecord& record) {
        constexpr double longest = 0.1;  // s
        for (auto& wave : record.probes) {
            const std::size_t bridged = interpolate_gaps(
                wave.elevation, static_cast<std::size_t>(longest * record.sampling_frequency));
            if (bridged == 0) continue;
            warnings.push_back(
                fmt::format("wave probe {}: {} of the samples left without a value, in gaps of at most "
                            "{} s, were interpolated, too",
                            wave.name, bridged, longest));
        }
    }

    void read_waves() {
        ProbeRecordOptions how;
        how.sampling_frequency = options.sampling_frequency;
        if (!options.calibration.empty()) how.calibrations = read_probe_calibrations(options.calibration);
        ProbeRecord record = read_probe_record(path, how);
        take(record.title, record.warnings);
        bridge_gaps(record);
        const auto [start, time] = times(record.start, record.sampling_frequency, record.samples());
        const std::size_t first = start;
        const auto valid = [&](const auto& wave, std::size_t i) {
            return std::isfinite(wave.elevation[first + i]);
        };
        // Values missing at an end shorten all records alike, so that they stay records of the same times.
        std::size_t begin = 0;
        std::size_t end = time.size();
        const auto all_valid = [&](std::size_t i) {
            return std::all_of(record.probes.begin(), record.probes.end(),
                               [&](const auto& wave) { return valid(wave, i); });
        };
        while (begin < end && !all_valid(begin)) ++begin;
        while (end > begin && !all_valid(end - 1)) --end;
        if (end - begin < time.size()) {
            warnings.push_back(
                fmt::format("{} samples at the ends of the window, at which not all probes have a "
                            "value, are left out",
                            time.size() - (end - begin)));
        }
        for (const auto& wave : record.probes) {
            ElevationProbe probe;
            probe.name = wave.name;
            probe.x = wave.x;
            bool whole = true;
            for (std::size_t i = begin; i < end; ++i) {
                whole = whole && valid(wave, i);
                probe.time.push_back(time[i]);
                probe.elevation.push_back(wave.elevation[first + i]);
            }
            if (!whole) {
                warnings.push_back(
                    fmt::format("wave probe {}: the record still has gaps in the window and is left "
                                "out; choose a --window without them",
                                probe.name));
                continue;
            }
            waves.push_back(std::move(probe));
        }
    }

    std::filesystem::path path;
    LaboratoryRecordOptions options;
    std::optional<Case> flow;
    std::optional<ColumnResult> column;
    TimeWindow window;
    std::string title;
    std::vector<std::string> warnings;
    Profiles profiles;
    std::vector<ElevationProbe> waves;
    std::vector<VelocityProbe> velocity;
    std::vector<VelocityGrid> grids;
    std::vector<VelocityPlane> planes;
    SectionPoints section;
    std::optional<SectionTwin> twin;
};

LaboratoryRecord::LaboratoryRecord(const std::filesystem::path& csv, const LaboratoryRecordOptions& options)
    : impl_(std::make_unique<Impl>(csv, options)) {}
LaboratoryRecord::~LaboratoryRecord() = default;

std::string LaboratoryRecord::name() const {
    return impl_->title.empty() ? impl_->path.stem().string() : impl_->title;
}
std::string LaboratoryRecord::source() const { return impl_->path.string(); }
const Case* LaboratoryRecord::flow() const { return impl_->flow ? &*impl_->flow : nullptr; }
const ColumnResult* LaboratoryRecord::column() const { return impl_->column ? &*impl_->column : nullptr; }
TimeWindow LaboratoryRecord::window() const { return impl_->window; }
const Profiles& LaboratoryRecord::profiles() const { return impl_->profiles; }
const std::vector<ElevationProbe>& LaboratoryRecord::elevation_probes() const { return impl_->waves; }
const std::vector<VelocityProbe>& LaboratoryRecord::velocity_probes() const { return impl_->velocity; }
const std::vector<VelocityGrid>& LaboratoryRecord::velocity_grids() const { return impl_->grids; }
const std::vector<VelocityPlane>& LaboratoryRecord::velocity_planes() const { return impl_->planes; }
const SectionPoints& LaboratoryRecord::section_points() const { return impl_->section; }
const SectionTwin& LaboratoryRecord::section_twin() const {
    if (!impl_->twin) impl_->twin = impl_->section.empty() ? SectionTwin{} : section_twin_of(*impl_->flow);
    return *impl_->twin;
}
std::vector<std::string> LaboratoryRecord::warnings() const { return impl_->warnings; }

}  // namespace riffle::inline analysis
