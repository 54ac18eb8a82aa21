#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/fourier.hpp"

namespace riffle::inline statistics {

/// Taper of a segment before its transform.
enum class Taper { hann, none };

/// What is taken from each segment before its transform.
enum class Detrend { mean, line };

/// How a record is cut into segments whose spectra are averaged (P. D. Welch, 1967, IEEE Trans. Audio
/// Electroacoustics 15, 70).
struct WelchOptions {
    /// Samples of a segment; 0 takes an eighth of the record (15 segments at half overlap), at most the
    /// record.
    std::size_t segment_length = 0;
    double overlap = 0.5;  ///< share of a segment, in [0, 1)
    Taper taper = Taper::hann;
    Detrend detrend = Detrend::line;
};

/// The segments of records of one length: their places, their spectra, and how much these have in common.
class WelchSegments {
  public:
    /// Throws InputError for a segment below 4 samples or longer than the record, or an overlap outside of
    /// [0, 1).
    WelchSegments(std::size_t record_length, const WelchOptions& options);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t length() const { return transform_.length(); }

    /// Transform of a segment, detrended and tapered, at the frequencies from zero to half the sampling rate;
    /// scaled so that the mean of its square is the one-sided density times the sampling rate: what is
    /// |X|^2 / (sampling rate) has the record's variance as integral over the frequencies.
    [[nodiscard]] std::vector<Complex> spectrum(std::span<const double> record, std::size_t segment) const;

    /// Degrees of freedom of the chi-square distribution of a mean of the densities of all segments over
    /// `bins` neighbouring frequencies, those of zero and half the sampling rate aside: 2 for a density of
    /// one segment, 2 count bins less what segments and frequencies share. Exact for white Gaussian noise
    /// (Welch 1967; Percival & Walden 1993, section 6.17), good where the density changes little across the
    /// resolution.
    [[nodiscard]] double degrees_of_freedom(std::size_t bins = 1) const;

    /// Correlation of the errors of two such means, over `first` and the `second` frequencies that follow.
    [[nodiscard]] double correlation_of_neighbours(std::size_t first = 1, std::size_t second = 1) const;

  private:
    /// Sum of the shared power over all pairs of `bins` neighbouring frequencies.
    [[nodiscard]] double shared_within(std::size_t bins) const;

    WelchOptions options_;
    std::size_t step_ = 1;
    std::size_t count_ = 1;
    FourierTransform transform_;
    std::vector<double> taper_;
    /// Covariance of the averaged densities at frequencies 0, 1, 2 ... bins apart, over that of a single one.
    std::vector<double> shared_;
};

}  // namespace riffle::inline statistics
