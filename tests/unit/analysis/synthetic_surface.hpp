#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "analysis/space_time.hpp"

namespace riffle {

/// Where and when a synthetic surface is sampled.
struct SurfaceGrid {
    std::size_t columns = 64;
    double spacing = 0.01;  ///< m
    bool periodic = false;
    std::size_t rows = 1000;
    double interval = 0.02;  ///< s
};

/// A random Gaussian surface whose spatial correlation is Horoshenkov's function (thesis 2.32) of L0 and
/// sigma_w.
struct RandomSurface {
    double period = 0.1;              ///< L0, m
    double correlation_radius = 0.1;  ///< sigma_w, m
    double deviation = 1e-3;          ///< standard deviation, m
    double noise = 0.0;               ///< standard deviation of white noise added to each point, m
    double mean = 0.0;                ///< m
    std::uint64_t seed = 1;
};

/// Spectral synthesis: each wavenumber k (rad/m) is a wave of random amplitude and phase with the frequency
/// omega(k) (rad/s). Of a periodic line the wavenumbers are those that fit; otherwise they lie so close that
/// the surface does not repeat itself while patterns of velocity up to `fastest` (m/s) pass.
SpaceTime synthetic_surface(const SurfaceGrid& grid, const RandomSurface& surface,
                            const std::function<double(double)>& omega, double fastest);

/// The surface that travels at one celerity (m/s), unchanged.
SpaceTime travelling_surface(const SurfaceGrid& grid, const RandomSurface& surface, double celerity);

}  // namespace riffle
