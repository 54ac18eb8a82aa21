#include "synthetic_surface.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace riffle {

namespace {

constexpr double pi = std::numbers::pi;

/// Transform of exp(-rho^2/s^2) cos(2 pi rho/L0) at k, of integral 1 over k > 0 where the two halves do not
/// overlap.
double spectrum_shape(const RandomSurface& s, double k) {
    const double peak = 2.0 * pi / s.period;
    const double r = s.correlation_radius;
    const auto half = [&](double d) { return std::exp(-0.25 * d * d * r * r); };
    return r / (2.0 * std::sqrt(pi)) * (half(k - peak) + half(k + peak));
}

}  // namespace

SpaceTime synthetic_surface(const SurfaceGrid& grid, const RandomSurface& surface,
                            const std::function<double(double)>& omega, double fastest) {
    std::mt19937_64 generator(surface.seed);
    std::normal_distribution<double> normal;
    SpaceTime data;
    data.columns = grid.columns;
    data.spacing = grid.spacing;
    data.first_x = 0.5 * grid.spacing;
    data.periodic = grid.periodic;
    data.values.assign(grid.rows * grid.columns, surface.mean);
    for (std::size_t j = 0; j < grid.rows; ++j) data.times.push_back(static_cast<double>(j) * grid.interval);

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
    if (surface.noise > 0.0) {
        for (double& value : data.values) value += surface.noise * normal(generator);
    }
    return data;
}

SpaceTime travelling_surface(const SurfaceGrid& grid, const RandomSurface& surface, double celerity) {
    return synthetic_surface(
        grid, surface, [celerity](double k) { return celerity * k; }, std::abs(celerity));
}

}  // namespace riffle
