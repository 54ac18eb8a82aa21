// Spectra of the surface along a line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/figure_tools.hpp"
#include "analysis/gravity_capillary_waves.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/surface_parts.hpp"
#include "analysis/surface_spectra.hpp"
#include "base/not_a_number.hpp"
#include "case/flow_conditions.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

/// Rows of a segment: an eighth of the record, so that 15 overlapping ones are averaged, at most what shows
/// 256 frequencies.
std::size_t segment_rows(const SpaceTime& line) {
    constexpr std::size_t most = 512;
    return std::clamp<std::size_t>(line.rows() / 8, std::min<std::size_t>(line.rows(), 8), most);
}

/// Lines in the map of a spectrum, which shows omega >= 0 only: a wave of negative frequency is the one of
/// -k. A line is broken where it changes sides or leaves the map.
void add_branch(Curve& curve, double k, double omega, double highest) {
    const bool shown = std::abs(omega) <= highest;
    const double x = omega < 0.0 ? -k : k;
    const bool drawn = !curve.x.empty() && std::isfinite(curve.x.back());
    if (drawn && (!shown || x * curve.x.back() < 0.0)) {
        curve.x.push_back(not_a_number);
        curve.y.push_back(not_a_number);
    }
    if (!shown) return;
    curve.x.push_back(x);
    curve.y.push_back(std::abs(omega));
}

void add_dispersion(const FlowRecord& record, const WaveSpectrum& spectrum, Figure& figure) {
    const GravityCapillaryWaves waves = waves_on(record);
    const double highest = spectrum.frequency.back();
    Curve down = make_curve("waves travelling downstream", Origin::theory, Mark::line, {}, {});
    Curve up = make_curve("waves travelling upstream", Origin::theory, Mark::line, {}, {}, 1);
    constexpr int steps = 200;
    std::vector<Curve> carried;
    std::vector<double> speeds;
    const auto carry = [&](const char* name, double speed) {
        if (!(speed > 0.0)) return;
        carried.push_back(
            make_curve(name, Origin::reference, Mark::line, {}, {}, static_cast<int>(speeds.size())));
        speeds.push_back(speed);
    };
    carry("advection line omega = U k", velocity_at_centreline(record));
    carry("velocity of the surface omega = u_s k", surface_velocity_at_centreline(record));
    const double largest = spectrum.wavenumber.back();
    for (int i = 0; i <= steps; ++i) {
        const double k = largest * i / steps;
        add_branch(down, k, waves.downstream_frequency(k), highest);
        add_branch(up, k, waves.upstream_frequency(k), highest);
        for (std::size_t c = 0; c < carried.size(); ++c) add_branch(carried[c], k, speeds[c] * k, highest);
    }
    figure.curves.push_back(std::move(down));
    figure.curves.push_back(std::move(up));
    for (Curve& line : carried) figure.curves.push_back(std::move(line));
}

void add_wave_spectrum(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::surface, "surface_wave_spectrum", "Spectrum of the surface in wavenumber and frequency",
        "Power spectral density of eta'(x, t); k > 0 travels downstream. Lines: dispersion relation of "
        "gravity-capillary waves on a current of the surface's velocity (the depth mean U where that is not "
        "known), and what the water carries.",
        "thesis chapter 2; Lamb, Hydrodynamics, art. 266", make_axis("wavenumber k", "rad/m"),
        make_axis("angular frequency omega", "rad/s"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const WaveSpectrum spectrum = wave_spectrum(surface.line, segment_rows(surface.line));
        constexpr std::size_t most = 512;
        const std::size_t k_stride = (spectrum.wavenumber.size() + most - 1) / most;
        ColourMap map;
        map.label = "power spectral density";
        map.unit = "m3 s/rad2";
        map.logarithmic = true;
        for (std::size_t i = 0; i < spectrum.wavenumber.size(); i += k_stride) {
            map.x.push_back(spectrum.wavenumber[i]);
        }
        map.y = spectrum.frequency;
        for (std::size_t m = 0; m < spectrum.frequency.size(); ++m) {
            for (std::size_t i = 0; i < spectrum.wavenumber.size(); i += k_stride) {
                map.values.push_back(static_cast<float>(spectrum.at(m, i)));
            }
        }
        f.maps.push_back(std::move(map));
        if (record.flow() != nullptr &&
            (velocity_at_centreline(record) > 0.0 || record.flow()->channel.ends == Ends::walls)) {
            add_dispersion(record, spectrum, f);
        }
    });
}

}  // namespace

GravityCapillaryWaves waves_on(const FlowRecord& record) {
    const Case& c = *record.flow();
    GravityCapillaryWaves waves;
    constexpr double water_surface_tension = 0.072;  // N/m, clean water; the particles have none
    waves.depth = water_depth(record);
    // Short waves and patterns travel with the water at the surface.
    waves.velocity = velocity_of_patterns(record);
    waves.gravity = c.normal_gravity();
    waves.surface_tension = record.origin() == Origin::measured ? water_surface_tension : 0.0;
    waves.density = c.fluid.density;
    return waves;
}

SurfaceFluctuation surface_fluctuation(const SpaceTime& surface) {
    SurfaceFluctuation result;
    FluctuationOptions options;
    options.remove_trend = true;
    options.remove_line_mean = surface.periodic;
    result.line = resample_evenly(surface);
    result.interval = sampling_interval(result.line);
    std::vector<double> level;
    for (std::size_t j = 0; j < result.line.rows(); ++j) level.push_back(mean_of(result.line.row(j)));
    result.level_deviation = mean_with_confidence(level).standard_deviation;
    result.line = fluctuation(result.line, options);
    return result;
}

bool is_flat(const FlowRecord& record, double standard_deviation) {
    constexpr double resolved = 1e-3;  // of the particle spacing
    return record.flow() != nullptr && record.origin() == Origin::simulated &&
           standard_deviation < resolved * record.flow()->numerics.spacing;
}

bool is_flat(const FlowRecord& record, const SpaceTime& fluctuation) {
    return is_flat(record, standard_deviation(fluctuation).value);
}

std::optional<ThesisSurface> thesis_surface(const Case& c) {
    const std::optional<int> condition = flow_condition_of(c);
    if (!condition) return std::nullopt;
    if (c.channel.dimensions == 3) {
        switch (*condition) {
            case 1:
                return ThesisSurface{0.060e-3, std::nullopt};
            case 2:
                return ThesisSurface{0.070e-3, std::nullopt};
            case 5:
                return ThesisSurface{0.076e-3, std::nullopt};
            case 8:
                return ThesisSurface{0.085e-3, std::nullopt};
            default:
                return std::nullopt;
        }
    }
    switch (*condition) {
        case 1:
            return ThesisSurface{0.145e-3, -0.25};
        case 2:
            return ThesisSurface{0.140e-3, -0.27};
        case 5:
            return ThesisSurface{0.140e-3, 0.11};
        case 8:
            return ThesisSurface{0.145e-3, 0.06};
        default:
            return std::nullopt;
    }
}

std::string beside_surface_velocity(double celerity, double surface_velocity) {
    return fmt::format("{:+.1f} % beside the surface velocity {:.4g} m/s",
                       100.0 * (celerity / surface_velocity - 1.0), surface_velocity);
}

void add_surface_spectra(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::surface, "surface_wavenumber_spectrum", "Spectrum of the surface elevation in wavenumber",
        "Power spectral density along the line, both directions together, mean over time; bars: "
        "95 % intervals.",
        "thesis chapters 4-5", make_axis("wavenumber k", "rad/m", true),
        make_axis("power spectral density", "m3/rad", true));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const WavenumberSpectrum spectrum = wavenumber_spectrum(surface.line);
        Curve curve = make_curve("along the line", record.origin(), Mark::line_and_points,
                                 {spectrum.wavenumber.begin() + 1, spectrum.wavenumber.end()},
                                 {spectrum.density.begin() + 1, spectrum.density.end()});
        curve.y_half_width.assign(spectrum.half_width.begin() + 1, spectrum.half_width.end());
        f.curves.push_back(std::move(curve));
        const auto peak = std::max_element(spectrum.density.begin() + 1, spectrum.density.end());
        const double k = spectrum.wavenumber[static_cast<std::size_t>(peak - spectrum.density.begin())];
        analysis.findings.push_back(make_finding(chapters::surface, "surface_peak_wavelength",
                                                 "wavelength of the highest spectral density", "m",
                                                 2.0 * std::numbers::pi / k));
    });
    Figure in_frequency = make_figure(
        chapters::surface, "surface_line_frequency_spectrum",
        "Spectrum of the surface in frequency, mean over the line",
        "Power spectral density in frequency, the mean over all places of the line; bars: 95 % intervals.",
        "thesis chapters 4-5, power spectra", make_axis("frequency f", "Hz", true),
        make_axis("power spectral density", "m2/Hz", true));
    attempt(record, analysis, std::move(in_frequency), [&](Figure& f) {
        const FrequencySpectrum spectrum = frequency_spectrum(surface.line);
        Curve curve = make_curve("mean over the line", record.origin(), Mark::line,
                                 {spectrum.frequency.begin() + 1, spectrum.frequency.end()},
                                 {spectrum.density.begin() + 1, spectrum.density.end()});
        for (std::size_t k = 1; k < spectrum.density.size(); ++k) {
            curve.y_lower.push_back(spectrum.density[k] / spectrum.factor[k]);
            curve.y_upper.push_back(spectrum.density[k] * spectrum.factor[k]);
        }
        f.curves.push_back(std::move(curve));
    });
    add_wave_spectrum(record, surface, analysis);
}

}  // namespace riffle::inline analysis
