#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/moments.hpp"
#include "statistics/welch.hpp"

namespace riffle::inline statistics {

/// Power spectral density of a record, one-sided: its sum times the resolution, over all frequencies, is in
/// the mean the variance of the record (exactly, for one segment without taper), the part slower than a
/// segment excepted, which detrending removes.
struct PowerSpectrum {
    std::vector<double> frequency;  ///< cycles per unit of the sampling interval (Hz for s)
    std::vector<double> density;    ///< square of the record's unit per frequency
    /// Degrees of freedom of each density; the 95 % interval of the density is between `lower` and `upper`
    /// times the estimate (chi-square).
    std::vector<double> degrees_of_freedom, lower, upper;
    /// Correlation of the error of each density with that of the next; the last is zero.
    std::vector<double> correlation_with_next;
    double resolution = 0;  ///< 1 / (duration of a segment)
    std::size_t segments = 0;
    std::size_t segment_length = 0;
};

/// Welch's method. `interval` is that of the sampling. The density at frequency zero is what detrending
/// leaves. Throws InputError for gaps, a record too short for its segments, or an interval that is not
/// positive.
[[nodiscard]] PowerSpectrum power_spectrum(std::span<const double> record, double interval,
                                           const WelchOptions& options = {});

/// Frequency of the largest density beyond zero, Hz; zero where there is none.
[[nodiscard]] double peak_frequency(const PowerSpectrum& spectrum);

/// Means of the densities over bins of equal width in the logarithm of frequency, at the geometric mean of
/// the frequencies in each; without frequency zero and half the sampling rate. Bins without a frequency are
/// left out. `segments` must be those of the spectrum: WelchSegments(record length, options).
[[nodiscard]] PowerSpectrum smoothed(const PowerSpectrum& spectrum, const WelchSegments& segments,
                                     int bins_per_decade = 20);

/// power_spectrum() and its smoothed().
struct SmoothedSpectrum {
    PowerSpectrum fine, smooth;
};
[[nodiscard]] SmoothedSpectrum smoothed_power_spectrum(std::span<const double> record, double interval,
                                                       const WelchOptions& options = {},
                                                       int bins_per_decade = 20);

/// A power law fitted to a band of a spectrum.
struct SpectralSlope {
    Estimate slope;          ///< d ln(density) / d ln(frequency)
    double coefficient = 0;  ///< density = coefficient * frequency^slope
    std::size_t points = 0;
    /// Scatter about the line over what chance explains; well above 1 the band is no power law. The interval
    /// is widened by its root then.
    double reduced_chi_square = 0;
};

/// Least squares of the logarithms within from <= frequency <= to, weighted by the variance of the logarithm
/// of a chi-square number (trigamma(degrees of freedom / 2)), its bias removed (digamma). Use the smoothed
/// spectrum: neighbouring densities of the fine one share part of their error, which this does not know of.
/// Throws InputError where fewer than three positive densities lie in the band.
[[nodiscard]] SpectralSlope spectral_slope(const PowerSpectrum& spectrum, double from, double to);

}  // namespace riffle::inline statistics
