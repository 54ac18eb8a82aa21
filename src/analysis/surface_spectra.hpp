#pragma once

#include <cstddef>
#include <vector>

#include "analysis/space_time.hpp"

namespace riffle::inline analysis {

// Spectra of a fluctuation (mean zero: fluctuation()) over a line and time, without dry points, at even times
// (resample_evenly()). Otherwise InputError. Densities per rad/m and per rad/s: their integral is the
// variance.

/// Hann window of n points, of unit mean square.
[[nodiscard]] std::vector<double> hann_window(std::size_t n);

/// Spectrum in wavenumber, mean over time.
struct WavenumberSpectrum {
    std::vector<double> wavenumber;  ///< 0 to pi/spacing in steps of `step`, rad/m
    std::vector<double> density;     ///< both signs of k together; of an elevation m3/rad
    std::vector<double> half_width;  ///< of the 95 % intervals, from the records of each component in time
    double step = 0.0;               ///< sum of density times step: the variance
};

/// A periodic line is transformed as it is, and the integral is the variance exactly. Another one is tapered
/// by a Hann window, of unit mean square, which widens peaks to two steps; the integral is the variance as
/// the window weighs it.
[[nodiscard]] WavenumberSpectrum wavenumber_spectrum(const SpaceTime& fluctuation);

/// Spectrum in frequency, mean over the line.
struct FrequencySpectrum {
    std::vector<double> frequency;  ///< 0 to half the sampling rate, Hz
    std::vector<double> density;    ///< of an elevation m2/Hz
    /// The 95 % interval lies between the density divided and multiplied by this factor. By the jackknife
    /// over the blocks in the logarithm (Thomson & Chave 1991), so the columns may depend on each other:
    /// those that see the same patterns pass are one.
    std::vector<double> factor;
    double resolution = 0.0;  ///< sum of density times resolution: the variance, Hz
    std::size_t blocks = 0;
};

/// Mean of the spectra of all columns over `blocks` of time, each detrended and under a Hann window: variance
/// slower than a block is left out. Throws InputError for fewer than two blocks or less than 8 times in each.
[[nodiscard]] FrequencySpectrum frequency_spectrum(const SpaceTime& fluctuation, std::size_t blocks = 10);

/// Spectrum in wavenumber and frequency. k > 0 with omega > 0 travels downstream, towards larger x; k < 0
/// with omega > 0 upstream.
struct WaveSpectrum {
    std::vector<double> wavenumber;  ///< ascending, of both signs, rad/m
    std::vector<double> frequency;   ///< 0 to pi/interval, rad/s
    std::vector<double> density;     ///< density[m * wavenumber.size() + i] at frequency m, wavenumber i
    double wavenumber_step = 0.0, frequency_step = 0.0;
    std::size_t segments = 0;  ///< averaged

    [[nodiscard]] double at(std::size_t m, std::size_t i) const { return density[m * wavenumber.size() + i]; }
    /// Integral over all wavenumbers and frequencies.
    [[nodiscard]] double variance() const;
};

/// Mean over segments of `segment_rows` times that overlap by half, each under a Hann window of unit mean
/// square in time, and along the line as wavenumber_spectrum(). The integral is the variance as the windows
/// weigh it. Patterns faster than spacing/interval are beyond the sampling and appear at wrong frequencies
/// (aliases). Throws InputError also for segments of less than 4 rows or longer than the record.
[[nodiscard]] WaveSpectrum wave_spectrum(const SpaceTime& fluctuation, std::size_t segment_rows);

}  // namespace riffle::inline analysis
