#include "synthetic_surface.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace riffle {

namespace {

using std::numbers::pi;

/// Transform of exp(-rho^2/s^2) cos(2 pi rho/L0) at k, of integral 1 over k > 0 where the two halves do not
/// overlap.
double spectrum_shape(const RandomSurface& s, double k) {
    const double peak = 2.0 * pi / s.period;
    const double r = s.correlation_radius;
    const auto half = [&](double d) { return std::exp(-0.25 * d * d * r * r); };
    return r / (2.0 * std::sqrt(pi)) * (half(k - peak) + half(k + peak));
}

/// Columns and times without values.
SpaceTime frame_of(const SurfaceGrid& grid) {
    SpaceTime data;
    data.columns = grid.columns;
    data.spacing = grid.spacing;
    data.first_x = 0.5 * grid.spacing;
    data.periodic = grid.periodic;
    for (std::size_t j = 0; j < grid.rows; ++j) data.times.push_back(static_cast<double>(j) * grid.interval);
    return data;
}

void add_noise(SpaceTime& data, double deviation, std::mt19937_64& generator) {
    if (!(deviation > 0.0)) return;
    std::normal_distribution<double> normal(0.0, deviation);
    for (double& value : data.values) value += normal(generator);
}

}  // namespace

SpaceTime synthetic_surface(const SurfaceGrid& grid, const RandomSurface& surface,
                            const std::function<double(double)>& omega, double fastest) {
    std::mt19937_64 generator(surface.seed);
    std::normal_distribution<double> normal;
    SpaceTime data = frame_of(grid);
    data.values.assign(grid.rows * grid.columns, surface.mean);

    const double duration = static_cast<double>(grid.rows) * grid.interval;
    const double reach = data.length() + fastest * duration;
    const double step = 2.0 * pi / (grid.periodic ? data.length() : 1.3 * reach);
    const double highest = 2.0 * pi / surface.period + 6.0 / surface.correlation_radius;
    for (double k = step; k < highest; k += step) {
        const double amplitude = surface.deviation * std::sqrt(spectrum_shape(surface, k) * step);
        if (amplitude < 1e-5 * surface.deviation) continue;
        // A sum of a cosine and a sine of independent Gaussian amplitudes, turned along x by a rotation.
        const std::complex<double> random(amplitude * normal(generator), amplitude * normal(generator));
        const std::complex<double> turn = std::polar(1.0, k * grid.spacing);
        const double frequency = omega(k);
        for (std::size_t j = 0; j < grid.rows; ++j) {
            std::complex<double> wave =
                random * std::polar(1.0, k * data.first_x - frequency * data.times[j]);
            for (double& value : data.row(j)) {
                value += wave.real();
                wave *= turn;
            }
        }
    }
    add_noise(data, surface.noise, generator);
    return data;
}

SpaceTime travelling_surface(const SurfaceGrid& grid, const RandomSurface& surface, double celerity) {
    // Where the surface moves by a simple fraction of the spacing per interval, one line holds all of it.
    const double shift = celerity * grid.interval / grid.spacing;
    for (int parts = 1; parts <= 8 && !grid.periodic && shift > 0.0; ++parts) {
        const double steps = shift * parts;
        if (std::abs(steps - std::round(steps)) > 1e-9) continue;
        const auto m = static_cast<std::size_t>(parts);
        const auto n = static_cast<std::size_t>(std::lround(steps));
        SurfaceGrid line = grid;
        line.spacing = grid.spacing / parts;
        line.columns = (grid.rows - 1) * n + (grid.columns - 1) * m + 1;
        line.rows = 1;
        RandomSurface smooth = surface;
        smooth.noise = 0.0;
        const SpaceTime profile = synthetic_surface(
            line, smooth, [](double) { return 0.0; }, 0.0);
        SpaceTime data = frame_of(grid);
        for (std::size_t j = 0; j < grid.rows; ++j) {
            for (std::size_t i = 0; i < grid.columns; ++i) {
                data.values.push_back(profile.values[(grid.rows - 1 - j) * n + i * m]);
            }
        }
        std::mt19937_64 generator(surface.seed + 1000000);
        add_noise(data, surface.noise, generator);
        return data;
    }
    return synthetic_surface(
        grid, surface, [celerity](double k) { return celerity * k; }, std::abs(celerity));
}

}  // namespace riffle
