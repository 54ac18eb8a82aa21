// The surface at single places: spectra in frequency, correlations in time between places.

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/surface_parts.hpp"
#include "analysis/vortices.hpp"
#include "statistics/cross_correlation.hpp"
#include "statistics/power_spectrum.hpp"

namespace riffle::inline analysis {

namespace {

constexpr std::size_t fewest_samples = 16;
constexpr double same_place = 1e-6;                   // m
constexpr double largest_lag_without_velocity = 2.0;  // s

void remove_mean(std::vector<double>& values) {
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& value : values) value -= mean;
}

/// Whether an extreme is one that unrelated records have by chance: the significance is that of a single lag,
/// and the highest of many independent ones is higher (Bonferroni). `samples`: of each record.
bool may_be_chance(const CrossCorrelation& correlation, const CorrelationExtreme& extreme,
                   std::size_t samples, double distance, double velocity) {
    const double step = correlation.lag[1] - correlation.lag[0];
    const double longest = velocity > 0.0 ? 2.0 * distance / velocity : correlation.lag.back();
    const double shortest = velocity > 0.0 ? 0.5 * distance / velocity : 0.0;
    const double independent =
        step * static_cast<double>(samples) / std::max(1.0, correlation.effective_samples);
    const double lags = std::max(1.0, (std::min(longest, correlation.lag.back()) - shortest) / independent);
    const boost::math::normal normal;
    const double factor =
        boost::math::quantile(normal, 1.0 - 0.025 / lags) / boost::math::quantile(normal, 0.975);
    const auto at = static_cast<std::size_t>(std::lround((extreme.lag - correlation.lag.front()) / step));
    return extreme.correlation < factor * correlation.significance[std::min(at, correlation.lag.size() - 1)];
}

/// The extreme that belongs to what the water carries from one place to the next: of the significant maxima
/// whose celerity is between half and twice the velocity the highest, of those as good the first; null
/// without one. Others belong to patterns that follow each other, or that come round a periodic channel once
/// more.
const CorrelationExtreme* arrival(const std::vector<CorrelationExtreme>& extremes, double distance,
                                  double velocity) {
    const auto arrives = [&](const CorrelationExtreme& extreme) {
        if (!extreme.significant || !extreme.maximum || extreme.lag <= 0.0) return false;
        const double celerity = distance / extreme.lag;
        return velocity <= 0.0 || (celerity >= 0.5 * velocity && celerity <= 2.0 * velocity);
    };
    double highest = 0.0;
    for (const CorrelationExtreme& extreme : extremes) {
        if (arrives(extreme)) highest = std::max(highest, extreme.correlation);
    }
    const auto first = std::find_if(extremes.begin(), extremes.end(), [&](const CorrelationExtreme& extreme) {
        return arrives(extreme) && extreme.correlation >= as_good_correlation * highest;
    });
    return first == extremes.end() ? nullptr : &*first;
}

/// After what time a record repeats itself, s: the first maximum of its correlation with itself that is
/// nearly one. Nothing for one that does not, as those of turbulence.
std::optional<double> period_of(std::span<const double> values, double interval, std::size_t lags) {
    constexpr double nearly_one = 0.8;
    const CrossCorrelation own = cross_correlation(values, values, interval, lags);
    for (const CorrelationExtreme& extreme : correlation_extremes(own)) {
        if (extreme.lag > 0.5 * interval && extreme.maximum && extreme.correlation > nearly_one) {
            return extreme.lag;
        }
    }
    return std::nullopt;
}

/// 95 % half-width of the lag of an extreme: the maximum nearest to it in quarters of the record, whose
/// scatter gives that of the whole; not-a-number where a quarter is too short, or has no maximum within half
/// the lag.
double lag_half_width(std::span<const double> a, std::span<const double> b, double interval, double lag) {
    constexpr std::size_t parts = 4;
    constexpr double student_95 = 3.182;  // three degrees of freedom
    const std::size_t length = a.size() / parts;
    const auto lags = static_cast<std::size_t>(std::ceil(2.0 * lag / interval));
    std::vector<double> found;
    for (std::size_t part = 0; part < parts && 2 * lags < length; ++part) {
        const CrossCorrelation correlation = cross_correlation(
            a.subspan(part * length, length), b.subspan(part * length, length), interval, lags);
        const CorrelationExtreme* nearest = nullptr;
        const std::vector<CorrelationExtreme> extremes = correlation_extremes(correlation);
        for (const CorrelationExtreme& extreme : extremes) {
            if (!extreme.maximum || std::abs(extreme.lag - lag) > 0.5 * lag) continue;
            if (nearest == nullptr || std::abs(extreme.lag - lag) < std::abs(nearest->lag - lag)) {
                nearest = &extreme;
            }
        }
        if (nearest != nullptr) found.push_back(nearest->lag);
    }
    if (found.size() < parts) return std::numeric_limits<double>::quiet_NaN();
    const double mean = std::accumulate(found.begin(), found.end(), 0.0) / parts;
    double squares = 0.0;
    for (const double each : found) squares += (each - mean) * (each - mean);
    return student_95 * std::sqrt(squares / (parts - 1) / parts);
}

}  // namespace

std::vector<SurfaceStation> stations_of_probes(const FlowRecord& record, std::vector<std::string>& warnings) {
    std::vector<SurfaceStation> stations;
    const auto left_out = [&](const ElevationProbe& probe, const std::string& why) {
        warnings.push_back("wave probe " + probe.name + " is left out: " + why);
    };
    for (const ElevationProbe& probe : record.elevation_probes()) {
        if (probe.time.size() < fewest_samples) {
            left_out(probe, fmt::format("it has {} samples in the window; {} are needed", probe.time.size(),
                                        fewest_samples));
            continue;
        }
        if (!std::all_of(probe.elevation.begin(), probe.elevation.end(),
                         [](double value) { return std::isfinite(value); })) {
            left_out(probe, "its record has gaps, or the place was dry");
            continue;
        }
        const Case* const flow = record.flow();
        if (flow != nullptr && flow->channel.dimensions == 3 && probe.y &&
            std::abs(*probe.y - flow->channel.centreline()) > flow->numerics.spacing) {
            left_out(probe, fmt::format("it stands at y = {}, beside the centreline along which "
                                        "places are compared",
                                        shown_place(*probe.y)));
            continue;
        }
        const auto same = std::find_if(stations.begin(), stations.end(), [&](const SurfaceStation& station) {
            return std::abs(station.x - probe.x) < same_place;
        });
        if (same != stations.end()) {
            left_out(probe, "it stands at the place of " + same->name);
            continue;
        }
        SpaceTime single;
        single.columns = 1;
        single.times = probe.time;
        single.values = probe.elevation;
        try {
            const SpaceTime even = resample_evenly(single);
            SurfaceStation station{probe.name, probe.x, even.times.front(), sampling_interval(even),
                                   even.values};
            remove_mean(station.elevation);
            stations.push_back(std::move(station));
        } catch (const InputError& error) {
            left_out(probe, error.what());
        }
    }
    std::stable_sort(stations.begin(), stations.end(), [](const SurfaceStation& a, const SurfaceStation& b) {
        return std::isfinite(a.x) && (!std::isfinite(b.x) || a.x < b.x);
    });
    return stations;
}

namespace {

/// The column of a line next to a place, within the cells of the line or, where it closes on itself,
/// anywhere.
std::optional<std::size_t> column_at(const SpaceTime& line, double x) {
    const auto columns = static_cast<double>(line.columns);
    double place = (x - line.first_x) / line.spacing;  // of the middles of the cells
    if (line.periodic) place -= columns * std::floor((place + 0.5) / columns);
    constexpr double edge = 0.5 + 1e-6;
    if (!(place >= -edge && place <= columns - 1.0 + edge)) return std::nullopt;
    return static_cast<std::size_t>(std::clamp(std::floor(place + 0.5), 0.0, columns - 1.0));
}

}  // namespace

std::vector<SurfaceStation> stations_of_line(const SpaceTime& line,
                                             const std::vector<ElevationProbe>& probes) {
    std::vector<SurfaceStation> stations;
    if (line.rows() < fewest_samples || line.columns == 0) return stations;
    std::set<std::size_t> columns;  // ascending, each once
    for (const ElevationProbe& probe : probes) {
        if (const auto column = column_at(line, probe.x)) columns.insert(*column);
    }
    if (columns.size() < 2) {
        columns.clear();
        for (const std::size_t eighths : {0U, 1U, 2U, 4U}) columns.insert(line.columns * eighths / 8);
    }
    const double interval = sampling_interval(line);
    for (const std::size_t column : columns) {
        SurfaceStation station{fmt::format("x = {}", shown_place(line.x(column))), line.x(column),
                               line.times.front(), interval, line.record(column)};
        if (!std::all_of(station.elevation.begin(), station.elevation.end(),
                         [](double value) { return std::isfinite(value); })) {
            continue;
        }
        remove_mean(station.elevation);
        stations.push_back(std::move(station));
    }
    return stations;
}

void add_station_spectra(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                         Analysis& analysis) {
    Figure figure = make_figure(
        chapters::surface, "surface_frequency_spectrum", "Spectrum of the surface elevation in frequency",
        "One-sided power spectral density by Welch's method (eighths of the record, Hann windows, half "
        "overlap), averaged over 20 bins per decade; bars: 95 % intervals.",
        "thesis chapters 4-5, power spectra", make_axis("frequency f", "Hz", true),
        make_axis("power spectral density", "m2/Hz", true));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        for (std::size_t i = 0; i < stations.size(); ++i) {
            const SmoothedSpectrum spectrum =
                smoothed_power_spectrum(stations[i].elevation, stations[i].interval);
            f.curves.push_back(
                spectrum_curve(stations[i].name, record.origin(), spectrum.smooth, static_cast<int>(i)));
            if (i > 0) continue;
            const PowerSpectrum& fine = spectrum.fine;
            const double peak = peak_frequency(fine);
            if (fine.frequency.size() > 2 && peak <= fine.frequency[1]) {
                analysis.warnings.push_back(fmt::format(
                    "the spectrum of the surface is highest at its lowest frequency, {:.3g} Hz, of waves as long as an "
                    "eighth of the record: a longer record tells the frequency",
                    peak));
            } else if (fine.frequency.size() > 2) {
                Finding finding =
                    make_finding(chapters::surface, "surface_peak_frequency",
                                 "frequency of the highest spectral density, " + stations[i].name, "Hz", peak,
                                 0.5 * fine.resolution);
                finding.remark = "half-width: half the resolution of the spectrum";
                analysis.findings.push_back(std::move(finding));
            }
        }
    });
}

void add_station_correlations(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                              Analysis& analysis) {
    if (stations.size() < 2 || !std::isfinite(stations[1].x)) return;
    Figure figure = make_figure(
        chapters::surface, "surface_cross_correlation", "Correlation of the surface between places",
        "Temporal cross-correlation of the elevation at the first place and at those downstream; points: "
        "extremes beyond what unrelated records show in 5 % of lags, and the lags x/U at which the water "
        "arrives.",
        "thesis (4.7)", make_axis("time lag t_l", "s"), make_axis("correlation R", "1"));
    const double velocity = velocity_at_centreline(record);
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const SurfaceStation& first = stations.front();
        // Of a surface that is flat the patterns are those of rounding.
        const bool flat = is_flat(record, root_mean_square(first.elevation));
        const double of_surface = surface_velocity_at_centreline(record);
        for (std::size_t i = 1; i < stations.size(); ++i) {
            const SurfaceStation& other = stations[i];
            if (!std::isfinite(other.x)) continue;
            const std::size_t samples = std::min(first.elevation.size(), other.elevation.size());
            const double distance = other.x - first.x;
            double largest = 0.25 * static_cast<double>(samples) * first.interval;
            if (velocity > 0.0) largest = std::min(largest, std::max(4.0 * distance / velocity, 1.0));
            if (!(velocity > 0.0)) largest = std::min(largest, largest_lag_without_velocity);
            const auto lags = static_cast<std::size_t>(largest / first.interval);
            const CrossCorrelation correlation = cross_correlation(
                std::span(first.elevation).first(samples), std::span(other.elevation).first(samples),
                first.interval, std::clamp<std::size_t>(lags, 1, samples - 1));
            const int variant = static_cast<int>(i) - 1;
            f.curves.push_back(make_curve(fmt::format("{} apart", shown_place(distance)), record.origin(),
                                          Mark::line, correlation.lag, correlation.correlation, variant));
            const std::vector<CorrelationExtreme> extremes = correlation_extremes(correlation);
            Curve points = make_curve(fmt::format("extremes, {}", shown_place(distance)), record.origin(),
                                      Mark::points, {}, {}, variant);
            for (const CorrelationExtreme& extreme : extremes) {
                if (!extreme.significant) continue;
                points.x.push_back(extreme.lag);
                points.y.push_back(extreme.correlation);
            }
            if (!points.x.empty()) f.curves.push_back(std::move(points));
            if (velocity > 0.0 && distance > 0.0) {
                f.curves.push_back(
                    make_curve(fmt::format("x/U, {}", shown_place(distance)), Origin::reference, Mark::line,
                               {distance / velocity, distance / velocity}, {-1.0, 1.0}, variant));
            }
            if (!(distance > 0.0) || flat) continue;
            const CorrelationExtreme* const best = arrival(extremes, distance, velocity);
            if (best == nullptr) continue;
            if (may_be_chance(correlation, *best, samples, distance, velocity)) {
                analysis.warnings.push_back(fmt::format(
                    "celerity from the lag between places {} apart: left out, unrelated records have an "
                    "extreme of R = {:.3g} by chance",
                    shown_place(distance), best->correlation));
                continue;
            }
            Finding finding = make_finding(
                chapters::surface, fmt::format("celerity_between_places_{}", i),
                fmt::format("celerity from the lag between places {} apart", shown_place(distance)), "m/s",
                distance / best->lag);
            if (velocity > 0.0) finding = against(std::move(finding), velocity, depth_mean_name(record));
            finding.remark = fmt::format("extreme R = {:.3g} at {:.4g} s", best->correlation, best->lag);
            if (velocity > 0.0) finding.remark += ", looked for from 0.5 U to 2 U";
            if (of_surface > 0.0) finding.remark += "; " + beside_surface_velocity(finding.value, of_surface);
            if (const auto period = period_of(std::span(first.elevation).first(samples), first.interval,
                                              correlation.lag.size() / 2)) {
                finding.remark += fmt::format(
                    "; the record repeats itself after {:.3g} s, and the lag is known but for whole periods: it is "
                    "right for places less than a wave apart",
                    *period);
            }
            // The arrival in parts of the record: independent estimates of the lag.
            const double half_width =
                lag_half_width(std::span(first.elevation).first(samples),
                               std::span(other.elevation).first(samples), first.interval, best->lag);
            if (std::isfinite(half_width) && half_width < best->lag) {
                finding.half_width = finding.value * half_width / best->lag;
            } else {
                finding.remark += "; quarters of the record do not tell how well it is known";
            }
            analysis.findings.push_back(std::move(finding));
        }
    });
}

}  // namespace riffle::inline analysis
