#include "analysis/laboratory_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "laboratory/csv_table.hpp"
#include "laboratory/probe_record.hpp"
#include "laboratory/profile_record.hpp"
#include "laboratory/record_repair.hpp"
#include "laboratory/velocity_series.hpp"

namespace riffle {

namespace {

enum class Kind { profile, velocity, wave };

/// What a file holds, by the names of its columns.
Kind kind_of(const std::filesystem::path& csv) {
    const CsvTable table = read_csv_table(csv, MissingValues::allowed);
    const auto has = [&](const char* name) {
        return std::any_of(table.columns.begin(), table.columns.end(),
                           [&](const CsvColumn& column) { return column.name == name; });
    };
    if (has("z") || has("height") || table.header_line == 0) return Kind::profile;
    if (has("u") || has("U")) return Kind::velocity;
    return Kind::wave;
}

}  // namespace

struct LaboratoryRecord::Impl {
    Impl(std::filesystem::path csv, LaboratoryRecordOptions given)
        : path(std::move(csv)), options(std::move(given)) {
        if (!options.case_file.empty()) {
            flow = read_case(options.case_file);
            try {
                column = solve_column(*flow);
            } catch (const InputError&) {
                // No steady uniform flow belongs to the case.
            }
        }
        switch (kind_of(path)) {
            case Kind::profile:
                read_profile();
                break;
            case Kind::velocity:
                read_velocity();
                break;
            case Kind::wave:
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

    void read_profile() {
        const ProfileRecord record = read_profile_record(path);
        take(record.title, record.warnings);
        const auto values = [&](ProfileQuantity quantity) {
            const ProfileColumn* const found = record.find(quantity);
            return found == nullptr ? std::vector<double>{} : found->values;
        };
        const std::vector<double> u = values(ProfileQuantity::velocity);
        if (u.empty()) {
            throw FileError(path.string() + ": the profile has no column u (streamwise velocity)");
        }
        // Points without u belong to no profile of it.
        const auto keep = [&](const std::vector<double>& all) {
            std::vector<double> kept;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (std::isfinite(u[i])) kept.push_back(all[i]);
            }
            return kept;
        };
        profiles.velocity = keep(u);
        for (const double z : keep(record.z)) profiles.z.push_back(z + datum());
        constexpr double normal_95 = 1.96;
        for (const double each : keep(record.find(ProfileQuantity::velocity)->uncertainty))
            profiles.velocity_half_width.push_back(normal_95 * each);
        profiles.velocity_rms = keep(values(ProfileQuantity::streamwise_rms));
        profiles.vertical_velocity = keep(values(ProfileQuantity::vertical_velocity));
        profiles.vertical_velocity_rms = keep(values(ProfileQuantity::vertical_rms));
        profiles.spanwise_velocity_rms = keep(values(ProfileQuantity::spanwise_rms));
        profiles.velocity_gradient = keep(values(ProfileQuantity::velocity_gradient));
        const double density = flow ? flow->fluid.density : 1000.0;
        for (const double stress : keep(values(ProfileQuantity::reynolds_stress)))
            profiles.reynolds_stress.push_back(density * stress);
        profiles.bin_upper = profiles.z;
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
std::vector<std::string> LaboratoryRecord::warnings() const { return impl_->warnings; }

}  // namespace riffle
