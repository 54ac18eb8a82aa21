#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

namespace riffle::inline statistics {

/// A 95 % confidence interval; an infinite end where the data do not bound the value on that side.
struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool contains(double value) const { return value >= lower && value <= upper; }
};

/// A fitted number. `half_width` is the 95 % half-width of the linear propagation of errors, right where it
/// is small; `interval` holds 95 % also where the number depends on the data in a curved way, and is then not
/// symmetric.
struct FittedValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    double half_width = std::numeric_limits<double>::infinity();
    Interval interval;
};

/// Least-squares fit of values = basis * coefficients + noise, with independent errors.
struct LinearFit {
    Eigen::VectorXd coefficients;
    Eigen::VectorXd residuals;   ///< values - basis * coefficients, not weighted
    Eigen::MatrixXd covariance;  ///< of the coefficients for errors of unit variance (or weight)
    double sum_of_squares = 0;   ///< of the weighted residuals
    /// Number of values less that of the unknowns; a nonlinear parameter found beside counts as an unknown.
    Eigen::Index freedom = 0;
};

/// Fit by QR decomposition. `uncertainty` is empty or gives the standard uncertainty of each value: they
/// weigh the values against each other, while the size of the errors is taken from the residuals, so that a
/// common factor in the uncertainties does not matter. None where the coefficients are not determined: less
/// than one degree of freedom or linearly dependent columns. Throws InputError if the sizes differ or an
/// uncertainty is not greater than zero.
[[nodiscard]] std::optional<LinearFit> fit_linear(const Eigen::MatrixXd& basis, const Eigen::VectorXd& values,
                                                  const Eigen::VectorXd& uncertainty = {});

/// Two-sided 95 % quantile of Student's t.
[[nodiscard]] double student_quantile(Eigen::Index freedom);

/// Coefficient `i` with its Student interval.
[[nodiscard]] FittedValue coefficient(const LinearFit& fit, Eigen::Index i);

/// coefficient(numerator)/coefficient(denominator): linear propagation for the half-width, Fieller's theorem
/// (Fieller 1954) for the interval, which is exact for Gaussian errors. Unbounded where the denominator is
/// not significantly different from zero.
[[nodiscard]] FittedValue coefficient_ratio(const LinearFit& fit, Eigen::Index numerator,
                                            Eigen::Index denominator);

/// Half-width of a number with this gradient by the coefficients, by linear propagation.
[[nodiscard]] double propagated_half_width(const LinearFit& fit, const Eigen::VectorXd& gradient);

/// Values of coefficient `i` for which the sum of squares can stay within `excess` of its minimum.
[[nodiscard]] Interval coefficient_range(const LinearFit& fit, Eigen::Index i, double excess);

/// The same for the ratio of two coefficients.
[[nodiscard]] Interval ratio_range(const LinearFit& fit, Eigen::Index numerator, Eigen::Index denominator,
                                   double excess);

}  // namespace riffle::inline statistics
