#pragma once

#include <cstddef>
#include <span>

namespace riffle::inline statistics {

/// A number with the half-width of its 95 % interval.
struct Estimate {
    double value = 0;
    double half_width = 0;
};

// The intervals follow from the influence of each sample on the estimate (the delta method): a moment's error
// is, to leading order in 1/n, the mean of a record of influences, and mean_with_confidence() gives the
// interval of that mean with the correlation of successive influences taken into account. They need some tens
// of effective samples. Gaps (not-a-number) are left out. InputError for fewer than two samples, or an
// infinite one.

/// Moments of a record.
struct Moments {
    std::size_t samples = 0;  ///< that are there
    Estimate mean;
    Estimate
        variance;  ///< the bias of correlated samples removed: n/(n - 2 integral scales) times the sample's
    Estimate standard_deviation;
    /// m3/m2^(3/2) and m4/m2^2 - 3, m_k the k-th central moment of the samples; zero for a Gaussian record.
    /// Not-a-number, with infinite intervals, for a constant record.
    Estimate skewness, excess_kurtosis;
    double integral_scale = 0.5;       ///< of the fluctuation, in samples
    double effective_samples = 0;      ///< of the mean
    double effective_of_variance = 0;  ///< effective samples of the squared fluctuation
};
[[nodiscard]] Moments moments(std::span<const double> record);

/// Second moments of two records at the same times, over the samples that both have.
struct Covariance {
    std::size_t samples = 0;
    Estimate covariance;           ///< <a' b'>, the bias of correlated samples removed
    Estimate correlation;          ///< <a' b'>/sqrt(<a'^2><b'^2>); not-a-number where a record is constant
    double effective_samples = 0;  ///< of a' b'
};
/// Throws InputError where the records differ in length.
[[nodiscard]] Covariance covariance(std::span<const double> a, std::span<const double> b);

}  // namespace riffle::inline statistics
