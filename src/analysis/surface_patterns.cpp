// The patterns of the surface: their size and how fast they travel.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/celerity_correlation.hpp"
#include "analysis/celerity_ridge.hpp"
#include "analysis/celerity_tracking.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/stations.hpp"
#include "analysis/surface_correlation.hpp"
#include "analysis/surface_parts.hpp"
#include "analysis/upwelling.hpp"

namespace riffle::inline analysis {

namespace {

/// Blocks of time for the jackknife: ten, fewer of a short record.
std::size_t blocks_of(std::size_t samples) { return std::clamp<std::size_t>(samples / 32, 2, 10); }

/// Adds the spatial correlation that `correlate` makes and the fit of Horoshenkov's function; the
/// characteristic period where it was found.
template <class Correlate>
double add_correlation(const FlowRecord& record, const Correlate& correlate, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::surface, "surface_correlation", "Spatial correlation of the surface",
                    "Correlation of the elevation at two places against their distance, mean over places "
                    "and time, with 95 % intervals; fitted: exp(-rho^2/sigma_w^2) cos(2 pi rho/L0), along "
                    "a periodic line with its periodic images.",
                    "thesis (2.32), Horoshenkov et al. (2013)", make_axis("distance rho", "m"),
                    make_axis("correlation W", "1"));
    double found = 0.0;
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const SpatialCorrelation correlation = correlate();
        Curve curve =
            make_curve(record.origin() == Origin::simulated ? "simulated" : "measured", record.origin(),
                       Mark::points, correlation.distance, correlation.correlation);
        curve.y_half_width = correlation.half_width;
        f.curves.push_back(std::move(curve));
        const SurfaceCorrelationFit fit = fit_surface_correlation(correlation);
        const double period = fit.characteristic_period.value;
        const double half_width = fit.characteristic_period.half_width;
        if (!std::isfinite(period) || !(half_width > 0.0 && half_width < period)) {
            analysis.warnings.emplace_back(
                "the surface correlation does not determine L0 and sigma_w: the line is too short beside the "
                "patterns, these are shorter than four spacings of its points, or their correlation is not "
                "that of (2.32)");
            return;
        }
        found = period;
        Curve law = make_curve("fit (2.32)", Origin::fit, Mark::line, {}, {});
        constexpr int steps = 200;
        for (int i = 0; i <= steps; ++i) {
            const double rho = correlation.distance.back() * i / steps;
            law.x.push_back(rho);
            law.y.push_back(fit.correlated_share.value * horoshenkov_correlation(rho, period,
                                                                                 fit.correlation_radius.value,
                                                                                 correlation.period));
        }
        f.curves.push_back(std::move(law));
        Finding finding = make_finding(chapters::surface, "characteristic_period",
                                       "characteristic period of the surface L0", "m", period,
                                       fit.characteristic_period.half_width);
        if (record.flow() != nullptr) {
            const double depth = water_depth(record);
            finding.remark = fmt::format("{:.2f} h_w", period / depth);
            if (record.flow()->measured.surface_standard_deviation) {
                finding =
                    against(std::move(finding), 1.75 * depth, "measured in the thesis' flume: 1.5-2.0 h_w");
            }
        }
        analysis.findings.push_back(std::move(finding));
        analysis.findings.push_back(
            make_finding(chapters::surface, "correlation_radius", "correlation radius of the surface sigma_w",
                         "m", fit.correlation_radius.value, fit.correlation_radius.half_width));
        analysis.findings.push_back(
            make_finding(chapters::surface, "correlated_share", "share of the variance that (2.32) describes",
                         "1", fit.correlated_share.value, fit.correlated_share.half_width));
    });
    return found;
}

void add_celerity(const FlowRecord& record, const char* key, const char* label, const Estimate& celerity,
                  const std::string& remark, Analysis& analysis) {
    const double velocity = velocity_at_centreline(record);
    const double of_surface = surface_velocity_at_centreline(record);
    if (!std::isfinite(celerity.value)) {
        analysis.warnings.push_back(std::string(label) + ": none found in this record");
        return;
    }
    // A standing wave or noise has no celerity: its extremes do not move with the distance.
    if (!(celerity.half_width < std::abs(celerity.value))) {
        analysis.warnings.push_back(fmt::format("{}: not determined by this record ({:.3g} ± {:.2g} m/s)",
                                                label, celerity.value, celerity.half_width));
        return;
    }
    Finding finding = make_finding(chapters::surface, key, label, "m/s", celerity.value, celerity.half_width);
    if (velocity > 0.0) finding = against(std::move(finding), velocity, depth_mean_name(record));
    finding.remark = remark;
    if (of_surface > 0.0) finding.remark += "; " + beside_surface_velocity(celerity.value, of_surface);
    if (record.flow() != nullptr && record.origin() == Origin::simulated) {
        const auto thesis = thesis_surface(*record.flow());
        if (thesis && thesis->celerity_difference) {
            finding.remark +=
                fmt::format("; the thesis' 2D run: {:+.0f} % beside U", 100.0 * *thesis->celerity_difference);
        } else if (thesis) {
            finding.remark += "; the thesis' 3D runs: within 16 % of U";
        }
    }
    analysis.findings.push_back(std::move(finding));
}

/// Celerity from the lags between places, which `find` makes, with its figure.
template <class Find>
void add_station_celerity(const FlowRecord& record, const Find& find, Analysis& analysis) {
    const double velocity = velocity_at_centreline(record);
    Figure stations = make_figure(
        chapters::surface, "surface_station_lags", "Lag of the surface against distance",
        "Lag of the extreme of the temporal cross-correlation over the distance of the places, with 95 % "
        "intervals; the lines are x = c t of the celerity found, of the depth-mean velocity U and of the "
        "velocity of the surface u_s.",
        "thesis (4.7), x_l = U t_l", make_axis("time lag t_l", "s"), make_axis("distance x_l", "m"));
    attempt(record, analysis, std::move(stations), [&](Figure& f) {
        const StationCelerity found = find();
        Curve points = make_curve("extremes", record.origin(), Mark::points, {}, {});
        double last = 0.0;
        for (const StationCorrelation& station : found.stations) {
            if (!std::isfinite(station.extreme_lag.value)) continue;
            points.x.push_back(station.extreme_lag.value);
            points.x_half_width.push_back(station.extreme_lag.half_width);
            points.y.push_back(station.distance);
            last = std::max(last, station.extreme_lag.value);
        }
        f.curves.push_back(std::move(points));
        const auto straight = [&](const char* name, Origin origin, double speed) {
            if (!std::isfinite(speed) || speed <= 0.0 || last <= 0.0) return;
            f.curves.push_back(make_curve(name, origin, Mark::line, {0.0, last}, {0.0, speed * last}));
        };
        straight("fit", Origin::fit, found.celerity.value);
        straight("x = U t", Origin::reference, velocity);
        const double of_surface = surface_velocity_at_centreline(record);
        if (of_surface > 0.0) {
            const std::size_t before = f.curves.size();
            straight("x = u_s t", Origin::reference, of_surface);
            if (f.curves.size() > before) f.curves.back().variant = 1;
        }
        add_celerity(record, "celerity_stations", "celerity from the lags between places", found.celerity,
                     fmt::format("{} distances", found.used), analysis);
        add_surface_extremes(record, found, analysis);
    });
}

/// Duration of all tracks together that go the way of a velocity, s.
double followed_for(const CrestCelerity& crests, double velocity) {
    double sum = 0.0;
    for (const CrestTrack& track : crests.tracks) {
        if (track.celerity * velocity > 0.0) sum += track.times.back() - track.times.front();
    }
    return sum;
}

void add_celerities(const FlowRecord& record, const SpaceTime& line, double period, Analysis& analysis) {
    add_station_celerity(
        record,
        [&] {
            StationOptions options;
            options.blocks = blocks_of(line.rows());
            return station_celerity(line, options);
        },
        analysis);
    try {
        const RidgeCelerity ridge = ridge_celerity(line, blocks_of(line.rows()));
        add_celerity(
            record, "celerity_ridge", "celerity from the ridge of the (k, omega) spectrum", ridge.celerity,
            fmt::format("{} wavenumbers; scatter of omega/k {:.2g} m/s", ridge.ridge.size(), ridge.deviation),
            analysis);
        for (Figure& figure : analysis.figures) {
            if (figure.key != "surface_wave_spectrum" || !figure.missing.empty()) continue;
            Curve points = make_curve("ridge", record.origin(), Mark::points, {}, {});
            for (const RidgePoint& point : ridge.ridge) {
                points.x.push_back(point.frequency < 0.0 ? -point.wavenumber : point.wavenumber);
                points.y.push_back(std::abs(point.frequency));
            }
            figure.curves.push_back(std::move(points));
        }
    } catch (const InputError& error) {
        analysis.warnings.push_back(std::string("celerity from the (k, omega) ridge: ") + error.what());
    }
    try {
        CrestOptions options;
        options.expected_celerity = velocity_of_patterns(record);
        options.smoothing = 0.2 * period;
        options.blocks = blocks_of(line.rows());
        const CrestCelerity crests = track_crests(line, options);
        // Crests of noise are linked by chance, and against the flow as long.
        CrestOptions upstream = options;
        upstream.expected_celerity = -options.expected_celerity;
        const double against_flow = followed_for(track_crests(line, upstream), upstream.expected_celerity);
        const double with_flow = followed_for(crests, options.expected_celerity);
        if (against_flow > 0.5 * with_flow) {
            throw InputError(fmt::format(
                "crests can be followed against the flow for {:.3g} s in all and with it for {:.3g} s: they are those of noise, or "
                "of waves that travel both ways",
                against_flow, with_flow));
        }
        add_celerity(record, "celerity_crests", "celerity of crests followed in the space-time map",
                     crests.celerity,
                     fmt::format("{} crests; scatter of their celerities {:.2g} m/s", crests.tracks.size(),
                                 crests.scatter),
                     analysis);
    } catch (const InputError& error) {
        analysis.warnings.push_back(std::string("celerity of crests: ") + error.what());
    }
}

}  // namespace

namespace {

/// Upwellings and downwellings from the vertical velocity of the surface (kinematic condition).
void add_upwellings(const FlowRecord& record, const SpaceTime& line, Analysis& analysis) {
    if (record.flow() == nullptr) return;
    const double velocity = velocity_of_patterns(record);
    if (velocity <= 0.0) return;
    const Case& c = *record.flow();
    try {
        const UpwellingCounts counts =
            count_upwellings(surface_vertical_velocity(line, velocity), water_depth(record));
        const auto add = [&](const char* key, const char* label, const MeanEstimate& number,
                             double per_depth) {
            if (!(number.half_width < number.mean)) {
                analysis.warnings.push_back(fmt::format("{}: not determined by this record ({:.3g} ± {:.2g})",
                                                        label, number.mean, number.half_width));
                return;
            }
            Finding finding =
                make_finding(chapters::surface, key, label, "1", number.mean, trusted_half_width(number));
            finding.remark = fmt::format(
                "{:.3g} per water depth along the bed; across a flume of {:.3g} m about A_r/2 = {:.2g} are "
                "expected (Tamburrino & Gulliver)",
                per_depth, c.channel.width, expected_upwellings(c.channel.width, water_depth(record)));
            analysis.findings.push_back(std::move(finding));
        };
        add("upwellings", "upwellings on the line at a time", counts.upwellings, counts.upwellings_per_depth);
        add("downwellings", "downwellings on the line at a time", counts.downwellings,
            counts.downwellings_per_depth);
    } catch (const InputError& error) {
        analysis.warnings.push_back(std::string("upwellings: ") + error.what());
    }
}

}  // namespace

void add_surface_patterns(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis) {
    constexpr std::size_t most_columns = 512;
    const SpaceTime line = fewer_columns(surface.line, most_columns);
    const double period = add_correlation(
        record,
        [&] {
            const double reach = line.periodic ? 0.5 * line.length() : 0.75 * line.length();
            return spatial_correlation(line, reach, blocks_of(line.rows()));
        },
        analysis);
    add_celerities(record, line, period, analysis);
    add_surface_space_time(record, line, analysis);
    // What a flat surface shows are rows of particles and rounding, which a warning says.
    if (!is_flat(record, surface.line)) add_upwellings(record, line, analysis);
}

void add_place_patterns(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                        Analysis& analysis) {
    std::vector<StationRecord> places;
    std::size_t samples = 0;
    for (const SurfaceStation& station : stations) {
        if (!std::isfinite(station.x)) continue;
        samples = places.empty() ? station.elevation.size() : std::min(samples, station.elevation.size());
        places.push_back({station.x, station.elevation});
    }
    if (places.size() < 2) return;
    for (StationRecord& place : places) place.values.resize(samples);
    if (record.flow() != nullptr) {
        // A pattern is 1.5-2 depths long: places further apart than half of it cannot tell it from the next.
        const std::vector<StationPair> pairs = pairs_by_distance(places);
        if (pairs.empty() || pairs.front().distance > water_depth(record)) {
            analysis.warnings.emplace_back(
                "the nearest places are further apart than a water depth, about half a pattern of the "
                "surface: neither its celerity nor L0 can be had from their lags alone");
            return;
        }
    }
    // With two places there is one distance: no correlation function can be fitted.
    if (places.size() > 2) {
        add_correlation(
            record, [&] { return spatial_correlation(places, blocks_of(samples)); }, analysis);
    }
    add_station_celerity(
        record,
        [&] {
            StationOptions options;
            options.blocks = blocks_of(samples);
            return station_celerity(places, stations.front().interval, options);
        },
        analysis);
}

}  // namespace riffle::inline analysis
