// The velocities below the surface: the instruments, statistics of points, spectra.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/space_time.hpp"
#include "analysis/subsurface_parts.hpp"
#include "analysis/velocity_spectra.hpp"
#include "statistics/power_spectrum.hpp"

namespace riffle::inline analysis {

namespace {

/// The points over each other at the place that has the most of them.
std::vector<ProbePointStatistics> points_of_one_place(const std::vector<ProbePointStatistics>& points) {
    std::vector<ProbePointStatistics> best;
    for (const ProbePointStatistics& first : points) {
        std::vector<ProbePointStatistics> same;
        std::copy_if(points.begin(), points.end(), std::back_inserter(same),
                     [&](const ProbePointStatistics& each) {
                         return std::abs(each.x - first.x) < 1e-6 && std::abs(each.y - first.y) < 1e-6;
                     });
        if (same.size() > best.size()) best = std::move(same);
    }
    return best;
}

/// The velocity probes with enough samples, each with its points at one place; what is left out of them is
/// said.
std::vector<VelocityInstrument> instruments_of(const FlowRecord& record, Analysis& analysis) {
    std::vector<VelocityInstrument> result;
    for (const VelocityProbe& probe : record.velocity_probes()) {
        if (probe.time.size() < 32) continue;
        const std::vector<ProbePointStatistics> all = probe_point_statistics(probe);
        VelocityInstrument each{&probe, points_of_one_place(all), sampling_interval_of(probe)};
        if (each.points.empty()) continue;
        if (each.points.size() < all.size()) {
            analysis.warnings.push_back(
                fmt::format("instrument {}: {} of its {} points stand at x = {} and are analysed as a "
                            "profile, the others are left out",
                            probe.name, each.points.size(), all.size(), shown_place(each.points.front().x)));
        }
        result.push_back(std::move(each));
    }
    return result;
}

/// The instrument that the chapter is about: one that the user asked for before one that a run has without
/// asking, then the one with the most points. Null where there is none.
const VelocityInstrument* main_instrument(const std::vector<VelocityInstrument>& instruments) {
    const auto standard = [](const VelocityInstrument& each) {
        return each.probe->name.rfind("standard_", 0) == 0;
    };
    const VelocityInstrument* best = nullptr;
    for (const VelocityInstrument& each : instruments) {
        if (best == nullptr || (standard(*best) && !standard(each)) ||
            (standard(*best) == standard(each) && each.points.size() > best->points.size())) {
            best = &each;
        }
    }
    return best;
}

/// The instrument with the most points over each other; of several the main one.
const VelocityInstrument* tallest_instrument(const std::vector<VelocityInstrument>& instruments,
                                             const VelocityInstrument* main) {
    const VelocityInstrument* best = main;
    for (const VelocityInstrument& each : instruments) {
        if (each.points.size() > best->points.size()) best = &each;
    }
    return best;
}

/// Up to three points: low, middle, high.
std::vector<ProbePointStatistics> chosen(const std::vector<ProbePointStatistics>& points) {
    if (points.size() <= 3) return points;
    return {points[points.size() / 6], points[points.size() / 2],
            points[points.size() - 1 - points.size() / 6]};
}

void add_scales(const FlowRecord& record, const VelocityInstrument& instrument, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::subsurface, "integral_scale_profile", "Integral length scale of the velocity",
                    "Integral length scale of u' over the depth, by Taylor's hypothesis from its "
                    "autocorrelation in time up to the first zero crossing.",
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
        analysis.findings.push_back(
            make_finding(chapters::subsurface, key, label, unit, value.value, value.half_width));
    };
    add("point_velocity_deviation", "standard deviation of u, " + place(middle), "m/s", middle.u_rms);
    if (!instrument.probe->v.empty()) {
        add("point_spanwise_velocity_deviation", "standard deviation of v, " + place(middle), "m/s",
            middle.v_rms);
    }
    if (!instrument.probe->w.empty()) {
        add("point_vertical_velocity_deviation", "standard deviation of w, " + place(middle), "m/s",
            middle.w_rms);
        add("point_covariance", "covariance <u'w'>, " + place(middle), "m2/s2", middle.uw);
    }
    add("point_skewness", "skewness of u, " + place(middle), "1", middle.u_skewness);
    analysis.findings.push_back(make_finding(chapters::subsurface, "point_integral_time",
                                             "integral time scale of u', " + place(middle), "s",
                                             middle.integral_time));
    analysis.findings.push_back(make_finding(chapters::subsurface, "point_integral_length",
                                             "integral length scale of u' (Taylor), " + place(middle), "m",
                                             middle.integral_length));
}

/// The water's slight compressibility lets it swing up and down as a whole, a quarter of a wave of sound over
/// the depth. Where that is all that w shows, say so.
void warn_of_sound(const FlowRecord& record, const PowerSpectrum& spectrum, const std::string& where,
                   Analysis& analysis) {
    const std::optional<double> sound = record.sound_speed();
    if (record.flow() == nullptr || !sound) return;
    const double mode = *sound / (4.0 * record.flow()->total_depth());
    const double peak = peak_frequency(spectrum);
    constexpr double near = 0.15;
    if (std::abs(peak - mode) > near * mode) return;
    analysis.warnings.push_back(fmt::format(
        "the spectrum of w, {}, has its peak at {:.3g} Hz, beside c0/(4 H) = {:.3g} Hz: w' is the "
        "vertical sound mode of the slightly compressible water, no turbulence, and so is its "
        "correlation over the depth",
        where, peak, mode));
}

void add_spectra(const FlowRecord& record, const VelocityInstrument& instrument, bool vertical,
                 Analysis& analysis) {
    const std::vector<double>& values = vertical ? instrument.probe->w : instrument.probe->u;
    if (values.empty()) return;
    const char* const symbol = vertical ? "w" : "u";
    Figure figure = make_figure(
        chapters::subsurface, vertical ? "vertical_velocity_spectrum" : "velocity_spectrum",
        fmt::format("Spectrum of {}", vertical ? "the vertical velocity" : "the streamwise velocity"),
        "One-sided power spectral density by Welch's method (eighths of the record, Hann windows, half "
        "overlap), averaged over 20 bins per decade; bars: 95 % intervals.",
        "thesis chapters 4-5, power spectra with the -5/3 line", make_axis("frequency f", "Hz", true),
        make_axis(fmt::format("power spectral density of {}", symbol), "m2/s", true));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<ProbePointStatistics> points = chosen(instrument.points);
        const std::vector<VelocitySpectrum> spectra =
            velocity_spectra(height_records(*instrument.probe, values, points), instrument.interval);
        for (std::size_t i = 0; i < spectra.size(); ++i) {
            const PowerSpectrum& smooth = spectra[i].spectrum.smooth;
            f.curves.push_back(
                spectrum_curve(place(points[i]), record.origin(), smooth, static_cast<int>(i)));
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
                make_finding(chapters::subsurface,
                             vertical ? "vertical_velocity_spectral_slope" : "velocity_spectral_slope",
                             fmt::format("slope of the spectrum of {}, {}", symbol, place(points[i])), "1",
                             slope.slope.value, slope.slope.half_width),
                -5.0 / 3.0, "inertial range");
            finding.remark =
                fmt::format("from {:.3g} Hz to {:.3g} Hz; scatter over chance {:.2g}{}", band.from, band.to,
                            slope.reduced_chi_square,
                            record.origin() != Origin::simulated ? ""
                            : record.flow() && resolves_eddies(*record.flow())
                                ? "; of the eddies, those larger than some spacings are resolved"
                                : "; the closure carries the turbulence, so that no inertial range "
                                  "is resolved");
            analysis.findings.push_back(std::move(finding));
        }
    });
}

}  // namespace

std::string place(const ProbePointStatistics& point) {
    return fmt::format("z = {:.4g} mm", 1000.0 * point.z);
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

void analyse_subsurface(const FlowRecord& record, Analysis& analysis) {
    const std::vector<VelocityInstrument> instruments = instruments_of(record, analysis);
    if (instruments.empty()) {
        add_missing(
            record, analysis,
            make_figure(chapters::subsurface, "velocity_spectrum", "Spectrum of the streamwise velocity", "",
                        "", make_axis("frequency f", "Hz", true),
                        make_axis("power spectral density of u", "m2/s", true)),
            "the results file holds no velocity probe with at least 32 samples in the window; [[probe]] "
            "kind = \"velocity\" in the case file records one");
        return;
    }
    const VelocityInstrument& instrument = *main_instrument(instruments);
    const VelocityInstrument& tallest = *tallest_instrument(instruments, &instrument);
    for (const VelocityInstrument& each : instruments) {
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
    add_streamwise_correlation(record, analysis);
    add_quadrants(record, instrument, analysis);
    add_ejections_and_upwellings(record, instrument, analysis);
}

}  // namespace riffle::inline analysis
