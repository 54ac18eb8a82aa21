#include "analysis/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>

#include "analysis/even_series.hpp"
#include "analysis/measured_files.hpp"
#include "analysis/run_mean_field.hpp"
#include "analysis/run_probes.hpp"
#include "analysis/run_profiles.hpp"
#include "analysis/run_snapshots.hpp"
#include "base/error.hpp"
#include "case/end_levels.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline analysis {

struct RunRecord::Impl {
    Impl(const std::filesystem::path& file, RunRecordOptions given)
        : path(file), options(std::move(given)), results(file), flow(results.flow()) {
        if (has_column(flow)) column = solve_column(flow);
        series = results.series();
        if (const auto thinned = make_even(series)) warnings.push_back(*thinned);
        window = choose_window();
        // Whatever the analysis makes of them: files named on the command line must be there.
        if (!options.measured.empty()) measured = read_measured();
    }

    [[nodiscard]] std::pair<double, double> recorded_times() const {
        const std::vector<double>& time = series[fields::time_series.time];
        if (!time.empty()) return {time.front(), time.back()};
        return {0.0, results.number(fields::summary.window_end).value_or(0.0)};
    }

    [[nodiscard]] TimeWindow choose_window() const {
        const auto [first, last] = recorded_times();
        if (options.window) {
            const TimeWindow asked = *options.window;
            if (asked.from < asked.to && asked.from < last && asked.to > first && asked.from >= 0.0 &&
                asked.to <= last + 1e-6) {
                return asked;
            }
            throw InputError(fmt::format(
                "--window {},{}: the window must be a stretch of the run, which {} holds from {:.6g} s to "
                "{:.6g} s; give FROM,TO in seconds with FROM < TO",
                asked.from, asked.to, path.string(), first, last));
        }
        // A flow that nothing drives steadily, a flood and a tide are of interest from their start to their
        // end.
        if (is_undriven(flow_kind(flow)) || changes_at_ends(flow)) return {0.0, last};
        if (const auto averaged = results.averaging_window()) return {averaged->first, averaged->second};
        return {0.5 * (first + last), last};
    }

    /// Row of the first time within the window, and the number of rows there.
    [[nodiscard]] std::pair<std::size_t, std::size_t> rows_within(const std::vector<double>& time) const {
        const auto first = std::lower_bound(time.begin(), time.end(), window.from - 1e-9);
        const auto last = std::upper_bound(time.begin(), time.end(), window.to + 1e-9);
        return {static_cast<std::size_t>(first - time.begin()),
                static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, last - first))};
    }

    /// The surface record of the run, or a surface line of its instruments where that has more points.
    [[nodiscard]] SpaceTime read_surface() {
        SpaceTime line = instruments().surface_line;
        const auto& of = fields::surface;
        if (!results.has(of.elevation) || !results.has(of.x) || !results.has(of.time)) return line;
        const std::vector<double> x = results.values(of.x);
        const std::vector<double> time = results.values(of.time);
        const std::vector<std::size_t> shape = results.shape(of.elevation);
        if (x.empty() || shape.size() != 2 || shape[1] != x.size()) {
            throw FileError(path.string() +
                            ": /surface/elevation does not fit /surface/x; the file is damaged, "
                            "or not as this Riffle writes it");
        }
        if (line.columns > x.size()) return line;
        auto [first, rows] = rows_within(time);
        first = std::min(first, shape[0]);
        rows = std::min(rows, shape[0] - first);
        const std::size_t most = std::max<std::size_t>(2, options.most_elevations / x.size());
        if (rows > most) {
            warnings.push_back(fmt::format(
                "the surface record of the window has {} rows of {} points; the last {} rows, from "
                "{:.4g} s, were analysed",
                rows, x.size(), most, time[first + rows - most]));
            first += rows - most;
            rows = most;
        }
        if (rows < 2) return line;
        return make_space_time(x, std::span(time).subspan(first, rows),
                               results.rows(of.elevation, first, rows), period_of(flow));
    }

    [[nodiscard]] const RunProbes& instruments() {
        if (!probes) {
            probes = read_probes(results, flow, window, options.most_elevations);
            warnings.insert(warnings.end(), probes->warnings.begin(), probes->warnings.end());
        }
        return *probes;
    }

    [[nodiscard]] Measured read_measured() {
        Measured result;
        const std::filesystem::path& file = flow.measured.velocity_profile;
        for (const std::filesystem::path& named : options.measured) {
            add_measured_file(named, flow, result, warnings);  // on the command line: it must be there
        }
        if (!result.profile.height.empty()) return result;
        if (!file.empty()) {
            std::error_code error;
            for (const auto& candidate :
                 {file, path.parent_path() / file, path.parent_path() / file.filename()}) {
                if (!std::filesystem::is_regular_file(candidate, error)) continue;
                add_measured_file(candidate, flow, result, warnings);
                return result;
            }
            result.note = "the file of the measured profile, " + file.string() +
                          ", was found neither there nor beside the results file";
        }
        constexpr int points = 40;
        result.profile = measured_log_law(flow, points);
        result.from_law = !result.profile.height.empty();
        return result;
    }

    std::filesystem::path path;
    RunRecordOptions options;
    RunResults results;
    const Case& flow;
    std::optional<ColumnResult> column;
    SeriesTable series;
    TimeWindow window;
    std::vector<std::string> warnings;
    std::optional<Profiles> profiles;
    std::optional<SpaceTime> surface;
    std::optional<RunProbes> probes;
    std::optional<Measured> measured;
    bool compared = false;  ///< somebody has asked for what was measured
    std::optional<MeanFlow> mean_field;
    std::optional<EddiesAndNoise> eddies_and_noise;
    std::optional<SurfaceMaps> surface_maps;
    std::optional<SectionTwin> section_twin;
};

RunRecord::RunRecord(const std::filesystem::path& results, RunRecordOptions options)
    : impl_(std::make_unique<Impl>(results, std::move(options))) {}
RunRecord::~RunRecord() = default;

std::string RunRecord::name() const {
    if (!impl_->flow.title.empty()) return impl_->flow.title;
    const std::filesystem::path folder = std::filesystem::absolute(impl_->path).parent_path().filename();
    return folder.empty() ? impl_->path.string() : folder.string();
}

const RunResults& RunRecord::results() const { return impl_->results; }
std::string RunRecord::source() const { return impl_->path.string(); }
const Case* RunRecord::flow() const { return &impl_->flow; }
const ColumnResult* RunRecord::column() const { return impl_->column ? &*impl_->column : nullptr; }
std::optional<double> RunRecord::sound_speed() const {
    return impl_->results.number(fields::summary.sound_speed);
}
TimeWindow RunRecord::window() const { return impl_->window; }
const SeriesTable& RunRecord::series() const { return impl_->series; }
std::vector<std::string> RunRecord::warnings() const { return impl_->warnings; }

const Profiles& RunRecord::profiles() const {
    if (!impl_->profiles) {
        impl_->profiles = impl_->options.window
                              ? average_profile_blocks(impl_->results, impl_->flow, column(), impl_->window)
                              : read_profiles_group(impl_->results);
    }
    return *impl_->profiles;
}

const SpaceTime& RunRecord::surface() const {
    if (!impl_->surface) impl_->surface = impl_->read_surface();
    return *impl_->surface;
}

const std::vector<ElevationProbe>& RunRecord::elevation_probes() const { return impl_->instruments().wave; }
const std::vector<VelocityProbe>& RunRecord::velocity_probes() const { return impl_->instruments().velocity; }
const std::vector<VelocityGrid>& RunRecord::velocity_grids() const { return impl_->instruments().grids; }
const std::vector<VelocityPlane>& RunRecord::velocity_planes() const { return impl_->instruments().planes; }
const std::vector<ScalarProbe>& RunRecord::scalar_probes() const { return impl_->instruments().scalars; }

const MeanFlow& RunRecord::mean_field() const {
    if (!impl_->mean_field) {
        impl_->mean_field = read_mean_field(impl_->results, impl_->flow, impl_->window, impl_->warnings);
    }
    return *impl_->mean_field;
}

const EddiesAndNoise& RunRecord::eddies_and_noise() const {
    if (!impl_->eddies_and_noise) {
        impl_->eddies_and_noise = read_eddies_and_noise(impl_->results, impl_->flow, impl_->window);
    }
    return *impl_->eddies_and_noise;
}

const SurfaceMaps& RunRecord::surface_maps() const {
    if (!impl_->surface_maps) {
        impl_->surface_maps =
            read_surface_maps(impl_->results, impl_->window, impl_->options.most_elevations, impl_->warnings);
    }
    return *impl_->surface_maps;
}

const SectionTwin& RunRecord::section_twin() const {
    if (!impl_->section_twin) impl_->section_twin = read_section_twin(impl_->results);
    return *impl_->section_twin;
}

const FlowRecord::Measured& RunRecord::measured() const {
    if (!impl_->measured) impl_->measured = impl_->read_measured();
    impl_->compared = true;
    return *impl_->measured;
}

bool RunRecord::is_compared() const { return impl_->compared; }

}  // namespace riffle::inline analysis
