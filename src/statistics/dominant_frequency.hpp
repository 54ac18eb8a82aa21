#pragma once

#include <optional>
#include <span>

namespace riffle::inline statistics {

/// An oscillation that rules a record, up to a frequency.
struct Oscillation {
    double frequency = 0.0;    ///< Hz
    double amplitude = 0.0;    ///< in the record's unit
    double share = 0.0;        ///< of the variance below the limit that its peak holds, 0 to 1
    double whole_share = 0.0;  ///< the same of the variance at all frequencies
    double periods = 0.0;      ///< how many of them the record holds
};

/// The strongest oscillation of a record below a frequency, from its transform with a Hann window, padded
/// with zeros, the peak found by a parabola through the logarithms: to about a hundredth of the resolution
/// 1/duration for one that is pure. Nothing where the record has fewer than 16 samples, does not vary, or
/// rises at the lower edge of the band (which a trend does). `interval`: of the sampling, s.
[[nodiscard]] std::optional<Oscillation> dominant_oscillation(std::span<const double> record, double interval,
                                                              double highest);

}  // namespace riffle::inline statistics
