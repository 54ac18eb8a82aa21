#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/welch.hpp"

namespace riffle::inline statistics {

/// What two records taken at the same times share at each frequency, by Welch's method.
struct CrossSpectrum {
    std::vector<double> frequency;             ///< cycles per unit of the sampling interval
    std::vector<double> density_a, density_b;  ///< as of power_spectrum()
    /// |S_ab|^2 / (S_aa S_bb), in [0, 1]. Unrelated records give 2 / degrees of freedom in the mean.
    std::vector<double> coherence;
    /// By which `b` follows `a`, in (-pi, pi]: 2 pi frequency T for b(t) = a(t - T).
    std::vector<double> phase;
    std::vector<double>
        phase_half_width;               ///< of the 95 % interval; pi where the coherence is not significant
    double coherence_significance = 0;  ///< exceeded by 5 % of unrelated records
    double degrees_of_freedom = 0;
    std::size_t segments = 0;
};

/// Phase interval and significance: Bendat & Piersol (2010), Random Data, eqs 9.52 and 9.59 with half the
/// degrees of freedom as the number of independent segments. Throws InputError for gaps, different lengths,
/// an interval that is not positive, or fewer than two segments, of which the coherence would be one for any
/// records.
[[nodiscard]] CrossSpectrum cross_spectrum(std::span<const double> a, std::span<const double> b,
                                           double interval, const WelchOptions& options = {});

}  // namespace riffle::inline statistics
