#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/depth_correlation.hpp"
#include "statistics/power_spectrum.hpp"

namespace riffle::inline analysis {

/// Band of frequencies, Hz.
struct FrequencyBand {
    double from = 0.0, to = 0.0;
};

/// Spectrum of a velocity at one height.
struct VelocitySpectrum {
    double z = 0.0;             ///< m
    SmoothedSpectrum spectrum;  ///< m2/s2/Hz, with confidence factors
    FrequencyBand band;         ///< in which the slope was fitted; empty where there is none
    std::optional<SpectralSlope> slope;
    /// A of the line A f^(-5/3) (Kolmogorov 1941) of the same mean logarithm in the band, m2/s2/Hz at 1 Hz.
    std::optional<double> five_thirds_level;
};

/// Spectra by Welch's method. The band is `band`, or from three times the frequency where f S(f) is largest
/// (the energy-containing eddies) to a quarter of the sampling rate; the slope is left out where fewer than
/// three densities lie in it. Whether the band is an inertial range is for the slope and its interval to
/// tell: in a simulation whose closure carries the turbulence there is none. Gaps (a height that falls dry)
/// and records of fewer than 64 samples are InputErrors naming the height.
[[nodiscard]] std::vector<VelocitySpectrum> velocity_spectra(std::span<const HeightRecord> records,
                                                             double interval,
                                                             std::optional<FrequencyBand> band = std::nullopt,
                                                             const WelchOptions& options = {});

}  // namespace riffle::inline analysis
