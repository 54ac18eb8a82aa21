// The velocities below the surface: statistics of points, spectra, quadrants, correlation over the depth.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "analysis/chapters.hpp"
#include "analysis/depth_correlation.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/probe_point_statistics.hpp"
#include "analysis/space_time.hpp"
#include "analysis/velocity_spectra.hpp"
#include "solver/scheme.hpp"
#include "statistics/power_spectrum.hpp"
#include "statistics/quadrants.hpp"

namespace riffle {

namespace {

constexpr const char* chapter = "subsurface";

/// A probe with the statistics of its points.
struct Instrument {
    const VelocityProbe* probe = nullptr;
    std::vector<ProbePointStatistics> points;
    double interval = 0;
};

/// The points over each other at the place that has the most of them.
std::vector<ProbePointStatistics> points_of_one_place(const std::vector<ProbePointStatistics>& points) {
    std::vector<ProbePointStatistics> best;
    for (const ProbePointStatistics& first : points) {
        std::vector<ProbePointStatistics> same;
        std::copy_if(points.begin(), points.end(), std::back_inserter(same),
                     [&](const ProbePointStatistics& each) { return std::abs(each.x - first.x) < 1e-6; });
        if (same.size() > best.size()) best = std::move(same);
    }
    return best;
}

/// The velocity probes with enough samples, each with its points at one place; what is left out of them is
/// said.
std::vector<Instrument> instruments_of(const FlowRecord& record, Analysis& analysis) {
    std::vector<Instrument> result;
    for (const VelocityProbe& probe : record.velocity_probes()) {
        if (probe.time.size() < 32) continue;
        const std::vector<ProbePointStatistics> all = probe_point_statistics(probe);
        Instrument each{&probe, points_of_one_place(all), sampling_interval_of(probe)};
        if (each.points.empty()) continue;
        if (each.points.size() < all.size()) {
            analysis.warnings.push_back(
                fmt::format("instrument {}: {} of its {} points stand at x = {:.4g} mm and are analysed as a "
                            "profile, the others are left out",
                            probe.name, each.points.size(), all.size(), 1000.0 * each.points.front().x));
        }
        result.push_back(std::move(each));
    }
    return result;
}

/// The instrument that the chapter is about: one that the user asked for before one that a run has without
/// asking, then the one with the most points. Null where there is none.
const Instrument* main_instrument(const std::vector<Instrument>& instruments) {
    const auto standard = [](const Instrument& each) { return each.probe->name.rfind("standard_", 0) == 0; };
    const Instrument* best = nullptr;
    for (const Instrument& each : instruments) {
        if (best == nullptr || (standard(*best) && !standard(each)) ||
            (standard(*best) == standard(each) && each.points.size() > best->points.size())) {
            best = &each;
        }
    }
    return best;
}

/// The instrument with the most points over each other; of several the main one.
const Instrument* tallest_instrument(const std::vector<Instrument>& instruments, const Instrument* main) {
    const Instrument* best = main;
    for (const Instrument& each : instruments) {
        if (each.points.size() > best->points.size()) best = &each;
    }
    return best;
}

std::string place(const ProbePointStatistics& point) {
    return fmt::format("z = {:.4g} mm", 1000.0 * point.z);
}

/// Up to three points: low, middle, high.
std::vector<ProbePointStatistics> chosen(const std::vector<ProbePointStatistics>& points) {
    if (points.size() <= 3) return points;
    return {points[points.size() / 6], points[points.size() / 2],
            points[points.size() - 1 - points.size() / 6]};
}

void add_scales(const FlowRecord& record, const Instrument& instrument, Analysis& analysis) {
    Figure figure = make_figure(chapter, "integral_scale_profile", "Integral length scale of the velocity",
                                "Integral length scale of u' over the depth, by Taylor's hypothesis from its "
                                "autocorrelation in time up to "
                                "the first zero crossing.",
                                "Tennekes & Lumley (1972)", make_axis("integral length scale", "m"),
                                make_axis("height above the bed level z", "m"));
    Curve curve = make_curve(instrument.probe->name, record.origin(), Mark::line_and_points, {}, {});
    for (const ProbePointStatistics& point : instrument.points) {
        curve.x.push_back(point.integral_length);
        curve.y.push_back(point.z);
    }
    figure.curves.push_back(std::move(curve));
    analysis.figures.push_back(std::move(figure));
    const ProbePointStatistics middle = instrument.points[instrument.points.size() / 2];
    const auto add = [&](const char* key, const std::string& label, const char* unit, const Estimate& value) {
        analysis.findings.push_back(make_finding(chapter, key, label, unit, value.value, value.half_width));
    };
    add("point_velocity_deviation", "standard deviation of u, " + place(middle), "m/s", middle.u_rms);
    if (!instrument.probe->w.empty()) {
        add("point_vertical_velocity_deviation", "standard deviation of w, " + place(middle), "m/s",
            middle.w_rms);
        add("point_covariance", "covariance <u'w'>, " + place(middle), "m2/s2", middle.uw);
    }
    add("point_skewness", "skewness of u, " + place(middle), "1", middle.u_skewness);
    analysis.findings.push_back(make_finding(chapter, "point_integral_time",
                                             "integral time scale of u', " + place(middle), "s",
                                             middle.integral_time));
    analysis.findings.push_back(make_finding(chapter, "point_integral_length",
                                             "integral length scale of u' (Taylor), " + place(middle), "m",
                                             middle.integral_length));
}

/// Records at even times of one component at some points; InputError where one has gaps.
std::vector<HeightRecord> height_records(const VelocityProbe& probe, const std::vector<double>& values,
                                         const std::vector<ProbePointStatistics>& points) {
    std::vector<HeightRecord> records;
    for (const ProbePointStatistics& point : points) {
        SpaceTime single;
        single.columns = 1;
        single.times = probe.time;
        single.values = probe.point(values, point.point);
        records.push_back({point.z, resample_evenly(single).values});
    }
    return records;
}

/// Frequency of the largest density beyond zero; zero where there is none.
double peak_frequency(const PowerSpectrum& spectrum) {
    if (spectrum.density.size() < 2) return 0.0;
    const auto peak = std::max_element(spectrum.density.begin() + 1, spectrum.density.end());
    return spectrum.frequency[static_cast<std::size_t>(peak - spectrum.density.begin())];
}

/// The water's slight compressibility lets it swing up and down as a whole, a quarter of a wave of sound over
/// the depth. Where that is all that w shows, say so.
void warn_of_sound(const FlowRecord& record, const PowerSpectrum& spectrum, const std::string& where,
                   Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const double mode =
        make_scheme(*record.flow(), record.column()).state.sound_speed / (4.0 * record.flow()->total_depth());
    const double peak = peak_frequency(spectrum);
    constexpr double near = 0.15;
    if (std::abs(peak - mode) > near * mode) return;
    analysis.warnings.push_back(fmt::format(
        "the spectrum of w, {}, has its peak at {:.3g} Hz, beside c0/(4 H) = {:.3g} Hz: w' is the "
        "vertical sound mode of the slightly compressible water, no turbulence, and so is its "
        "correlation over the depth",
        where, peak, mode));
}

void add_spectra(const FlowRecord& record, const Instrument& instrument, bool vertical, Analysis& analysis) {
    const std::vector<double>& values = vertical ? instrument.probe->w : instrument.probe->u;
    if (values.empty()) return;
    const char* const symbol = vertical ? "w" : "u";
    Figure figure = make_figure(
        chapter, vertical ? "vertical_velocity_spectrum" : "velocity_spectrum",
        fmt::format("Spectrum of {}", vertical ? "the vertical velocity" : "the streamwise velocity"),
        "One-sided power spectral density by Welch's method (eighths of the record, Hann windows, half "
        "overlap), "
        "averaged over 20 bins per decade; bars: 95 % intervals.",
        "thesis chapters 4-5, power spectra with the -5/3 line", make_axis("frequency f", "Hz", true),
        make_axis(fmt::format("power spectral density of {}", symbol), "m2/s", true));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<ProbePointStatistics> points = chosen(instrument.points);
        const std::vector<VelocitySpectrum> spectra =
            velocity_spectra(height_records(*instrument.probe, values, points), instrument.interval);
        for (std::size_t i = 0; i < spectra.size(); ++i) {
            const PowerSpectrum& smooth = spectra[i].spectrum.smooth;
            Curve curve =
                make_curve(place(points[i]), record.origin(), Mark::line, smooth.frequency, smooth.density);
            set_bounds(curve, smooth.lower, smooth.upper);
            curve.variant = static_cast<int>(i);
            f.curves.push_back(std::move(curve));
            if (i != spectra.size() / 2) continue;
            if (vertical) warn_of_sound(record, spectra[i].spectrum.fine, place(points[i]), analysis);
            const FrequencyBand& band = spectra[i].band;
            if (spectra[i].five_thirds_level) {
                const auto law = [&](double at) {
                    return *spectra[i].five_thirds_level * std::pow(at, -5.0 / 3.0);
                };
                f.curves.push_back(make_curve("slope -5/3", Origin::reference, Mark::line,
                                              {band.from, band.to}, {law(band.from), law(band.to)}));
            }
            if (!spectra[i].slope) continue;
            const SpectralSlope& slope = *spectra[i].slope;
            Finding finding = against(
                make_finding(chapter,
                             vertical ? "vertical_velocity_spectral_slope" : "velocity_spectral_slope",
                             fmt::format("slope of the spectrum of {}, {}", symbol, place(points[i])), "1",
                             slope.slope.value, slope.slope.half_width),
                -5.0 / 3.0, "inertial range");
            finding.remark =
                fmt::format("from {:.3g} Hz to {:.3g} Hz; scatter over chance {:.2g}{}", band.from, band.to,
                            slope.reduced_chi_square,
                            record.origin() == Origin::simulated
                                ? "; the closure carries the turbulence, so that no inertial range "
                                  "is resolved"
                                : "");
            analysis.findings.push_back(std::move(finding));
        }
    });
}

/// w' over the depth against w' at the highest point.
void add_depth_correlation(const FlowRecord& record, const Instrument& instrument, Analysis& analysis) {
    if (instrument.probe->w.empty() || instrument.points.size() < 3) return;
    Figure figure = make_figure(
        chapter, "depth_correlation", "Correlation of the vertical velocity over the depth",
        fmt::format("Correlation of w' at each height with w' at {}, at the same time and at the lag of its "
                    "extreme; bars: 95 % intervals.",
                    place(instrument.points.back())),
        "thesis (4.8)", make_axis("correlation", "1"), make_axis("height above the bed level z", "m"));
    Figure lags =
        make_figure(chapter, "depth_cross_correlation", "Correlation of w' over depth and lag",
                    "Temporal cross-correlation of w' at three heights with w' at the highest point; a "
                    "positive lag: the height follows.",
                    "thesis (4.8)", make_axis("time lag", "s"), make_axis("correlation", "1"));
    figure.x.from = -1.0;
    figure.x.to = 1.0;
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<HeightRecord> records =
            height_records(*instrument.probe, instrument.probe->w, instrument.points);
        const double duration = static_cast<double>(records.front().values.size()) * instrument.interval;
        // A few periods of what w' does most.
        const double peak =
            peak_frequency(smoothed_power_spectrum(records.back().values, instrument.interval).fine);
        constexpr double periods = 8.0;
        double largest = std::min(2.0, 0.25 * duration);
        if (peak > 0.0) largest = std::min(largest, std::max(periods / peak, 8.0 * instrument.interval));
        const std::vector<HeightCorrelation> found =
            depth_correlation(records, records.back().values, instrument.interval, largest);
        Curve same = make_curve("at the same time", record.origin(), Mark::line_and_points, {}, {});
        Curve extreme = make_curve("extreme over the lag", record.origin(), Mark::points, {}, {});
        extreme.variant = 1;
        for (const HeightCorrelation& height : found) {
            same.x.push_back(height.correlation.value);
            same.x_half_width.push_back(height.correlation.half_width);
            same.y.push_back(height.z);
            if (!height.extreme) continue;
            extreme.x.push_back(height.extreme->correlation);
            extreme.y.push_back(height.z);
        }
        for (const std::size_t part : {1U, 3U, 5U}) {
            if (found.empty()) break;
            const HeightCorrelation& height = found[found.size() * part / 6];
            Curve curve =
                make_curve(fmt::format("z = {:.4g} mm", 1000.0 * height.z), record.origin(), Mark::line,
                           thinned(height.lagged.lag, 2000), thinned(height.lagged.correlation, 2000));
            curve.variant = static_cast<int>(part / 2);
            lags.curves.push_back(std::move(curve));
        }
        f.curves.push_back(std::move(same));
        f.curves.push_back(std::move(extreme));
        if (record.flow() == nullptr || found.size() < 3) return;
        const double depth = record.flow()->total_depth();
        // The highest point correlates with itself: a fall between it and the next tells their distance only.
        constexpr double threshold = 0.5;
        if (!(found[found.size() - 2].correlation.value > threshold)) {
            analysis.warnings.push_back(
                fmt::format("influence depth of the surface: not resolved, the correlation falls below 0.5 "
                            "within {:.3g} mm, between the two highest points",
                            1000.0 * (found.back().z - found[found.size() - 2].z)));
            return;
        }
        const auto influence = influence_depth(found, instrument.points.back().z, threshold);
        if (!influence) {
            analysis.warnings.push_back(fmt::format(
                "influence depth of the surface: none, the correlation stays above 0.5 down to the "
                "lowest point at z/H = {:.3g}",
                found.front().z / depth));
            return;
        }
        Finding finding =
            against(make_finding(chapter, "influence_depth",
                                 "influence depth of the surface, z/H where the correlation is 0.5", "1",
                                 influence->z / depth),
                    0.93, "thesis, 2D simulations",
                    "the thesis gives no threshold; here a quarter of the variance explained");
        const double half_width = 0.5 * (influence->upper - influence->lower) / depth;
        if (std::isfinite(half_width)) finding.half_width = std::abs(half_width);
        analysis.findings.push_back(std::move(finding));
    });
    if (!lags.curves.empty()) analysis.figures.push_back(std::move(lags));
}

void add_quadrants(const FlowRecord& record, const Instrument& instrument, Analysis& analysis) {
    if (instrument.probe->w.empty()) return;
    Figure figure = make_figure(
        chapter, "quadrant_profile", "Quadrants of the Reynolds stress over the depth",
        "Part of <u'w'> that each quadrant of the plane of u' and w' carries, without a hole; bars: 95 % "
        "intervals.",
        "Lu & Willmarth (1973)", make_axis("part of <u'w'>", "m2/s2"),
        make_axis("height above the bed level z", "m"));
    constexpr std::array names = {"outward interactions (Q1)", "ejections (Q2)", "inward interactions (Q3)",
                                  "sweeps (Q4)"};
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        std::array<Curve, 4> curves;
        for (std::size_t q = 0; q < curves.size(); ++q) {
            curves[q] = make_curve(names[q], record.origin(), Mark::line_and_points, {}, {});
            curves[q].variant = static_cast<int>(q);
        }
        for (const ProbePointStatistics& point : instrument.points) {
            const Quadrants result =
                quadrant_analysis(instrument.probe->point(instrument.probe->u, point.point),
                                  instrument.probe->point(instrument.probe->w, point.point));
            for (std::size_t q = 0; q < curves.size(); ++q) {
                curves[q].x.push_back(result.quadrant[q].stress.value);
                curves[q].x_half_width.push_back(result.quadrant[q].stress.half_width);
                curves[q].y.push_back(point.z);
            }
        }
        for (Curve& curve : curves) f.curves.push_back(std::move(curve));
    });
    const ProbePointStatistics& middle = instrument.points[instrument.points.size() / 2];
    Figure holes = make_figure(
        chapter, "quadrant_holes", "Quadrants against the hole size",
        fmt::format("Share of the time in each quadrant with |u'w'| above H u_rms w_rms, at {}.",
                    place(middle)),
        "Lu & Willmarth (1973)", make_axis("hole size H", "1"), make_axis("share of the time", "1"));
    attempt(record, analysis, std::move(holes), [&](Figure& f) {
        std::array<Curve, 4> curves;
        for (std::size_t q = 0; q < curves.size(); ++q) {
            curves[q] = make_curve(names[q], record.origin(), Mark::line_and_points, {}, {});
            curves[q].variant = static_cast<int>(q);
        }
        const std::vector<double> u = instrument.probe->point(instrument.probe->u, middle.point);
        const std::vector<double> w = instrument.probe->point(instrument.probe->w, middle.point);
        constexpr int steps = 12;
        for (int i = 0; i <= steps; ++i) {
            const double hole = 0.5 * i;
            const Quadrants result = quadrant_analysis(u, w, hole);
            for (std::size_t q = 0; q < curves.size(); ++q) {
                curves[q].x.push_back(hole);
                curves[q].y.push_back(result.quadrant[q].time.value);
                curves[q].y_half_width.push_back(result.quadrant[q].time.half_width);
            }
            // Shares of a mean that is zero within its interval say nothing.
            if (i > 0 || !(result.mean_product.half_width < std::abs(result.mean_product.value))) continue;
            const auto share = [&](const char* key, const char* label, std::size_t q) {
                if (!std::isfinite(result.quadrant[q].stress_share)) return;
                analysis.findings.push_back(make_finding(chapter, key, label + (", " + place(middle)), "1",
                                                         result.quadrant[q].stress_share));
            };
            share("ejection_share", "share of ejections in <u'w'>", 1);
            share("sweep_share", "share of sweeps in <u'w'>", 3);
        }
        for (Curve& curve : curves) f.curves.push_back(std::move(curve));
    });
}

}  // namespace

void analyse_subsurface(const FlowRecord& record, Analysis& analysis) {
    const std::vector<Instrument> instruments = instruments_of(record, analysis);
    if (instruments.empty()) {
        add_missing(
            record, analysis,
            make_figure(chapter, "velocity_spectrum", "Spectrum of the streamwise velocity", "", "",
                        make_axis("frequency f", "Hz", true),
                        make_axis("power spectral density of u", "m2/s", true)),
            "the results file holds no velocity probe with at least 32 samples in the window; [[probe]] "
            "kind = \"velocity\" in the case file records one");
        return;
    }
    const Instrument& instrument = *main_instrument(instruments);
    const Instrument& tallest = *tallest_instrument(instruments, &instrument);
    for (const Instrument& each : instruments) {
        if (&each == &instrument) continue;
        analysis.warnings.push_back(fmt::format(
            "the velocities of instrument {} are {}; those of {} are analysed", each.probe->name,
            &each == &tallest ? "used for the correlation over the depth only" : "recorded, but not analysed",
            instrument.probe->name));
    }
    add_scales(record, instrument, analysis);
    add_spectra(record, instrument, false, analysis);
    add_spectra(record, instrument, true, analysis);
    add_depth_correlation(record, tallest, analysis);
    add_quadrants(record, instrument, analysis);
}

}  // namespace riffle
