#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/moments.hpp"

namespace riffle::inline statistics {

/// How far a record's distribution is from the Gaussian one of the same mean and standard deviation.
struct GaussianTest {
    double distance = 0;  ///< Kolmogorov-Smirnov: the largest difference of the cumulative distributions
    /// Chance of at least this distance for a Gaussian record of as many effective samples.
    double p_value = 1;
    double effective_samples = 0;
};

/// Histogram of a record as a probability density, with the Gaussian density fitted to it.
struct ProbabilityDensity {
    std::vector<double> centre;      ///< of the bins, in the unit of the record
    std::vector<double> density;     ///< one over that unit; its sum times the bin width is one
    std::vector<double> half_width;  ///< of the 95 % interval of each bin's density
    double bin_width = 0;
    Moments moments;               ///< mean and standard deviation are those of the Gaussian fit
    std::vector<double> gaussian;  ///< the fitted density, its mean over each bin
    GaussianTest test;
};

/// The bins cover all samples, one bin being centred on the mean. `bin_width` 0 takes 3.49 standard
/// deviations over the cube root of the effective samples (D. W. Scott, 1979, Biometrika 66, 605), but at
/// most half a standard deviation and at least what makes 200 bins of the range. Intervals: correlation of
/// being in the bin taken into account; Agresti & Coull (1998), so that empty bins have one, too. Gaps
/// (not-a-number) are left out. Throws InputError for an infinite sample, a constant record, fewer than eight
/// samples, or a bin width that is negative or makes 2000 bins or more.
[[nodiscard]] ProbabilityDensity probability_density(std::span<const double> record, double bin_width = 0);

/// The test alone. Mean and deviation are fitted, so the p-value is that of Lilliefors' distribution, by the
/// approximation of Dallal & Wilkinson (1986, American Statistician 40, 294), good below 0.1 and cut there
/// (0.1 means "at least 0.1"). Its samples are the effective ones of the skewness: what remains when mean and
/// deviation are fitted decorrelates as fast as the third power of the fluctuation.
[[nodiscard]] GaussianTest test_of_gaussian(std::span<const double> record);

}  // namespace riffle::inline statistics
