#include "statistics/linear_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "base/error.hpp"

namespace riffle::inline statistics {

namespace {

/// Excess of the sum of squares over its minimum that bounds the 95 % interval of one parameter.
double allowed_excess(const LinearFit& fit) {
    const double t = student_quantile(fit.freedom);
    return t * t * fit.sum_of_squares / static_cast<double>(fit.freedom);
}

}  // namespace

std::optional<LinearFit> fit_linear(const Eigen::MatrixXd& basis, const Eigen::VectorXd& values,
                                    const Eigen::VectorXd& uncertainty) {
    if (basis.rows() != values.size() || (uncertainty.size() != 0 && uncertainty.size() != values.size())) {
        throw InputError("linear fit: basis, values and uncertainties differ in number");
    }
    if (uncertainty.size() != 0 && !(uncertainty.minCoeff() > 0.0)) {
        throw InputError("linear fit: uncertainties must be greater than zero");
    }
    LinearFit fit;
    fit.freedom = basis.rows() - basis.cols();
    if (fit.freedom < 1 || !basis.allFinite() || !values.allFinite()) return std::nullopt;

    Eigen::MatrixXd weighted = basis;
    Eigen::VectorXd target = values;
    if (uncertainty.size() != 0) {
        const Eigen::VectorXd weight = uncertainty.cwiseInverse();
        weighted = weight.asDiagonal() * basis;
        target = weight.cwiseProduct(values);
    }
    // Columns of unit length: then the rank does not depend on units.
    const Eigen::VectorXd length = weighted.colwise().norm().transpose();
    if (!(length.minCoeff() > 0.0)) return std::nullopt;
    const Eigen::VectorXd scale = length.cwiseInverse();
    weighted = weighted * scale.asDiagonal();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weighted);
    constexpr double smallest_ratio = 1e-10;
    qr.setThreshold(smallest_ratio);
    if (qr.rank() < basis.cols()) return std::nullopt;

    const Eigen::VectorXd scaled = qr.solve(target);
    fit.coefficients = scale.cwiseProduct(scaled);
    fit.residuals = values - basis * fit.coefficients;
    fit.sum_of_squares = (target - weighted * scaled).squaredNorm();
    // (A^T A)^-1 = P R^-1 R^-T P^T with A P = Q R.
    const auto n = basis.cols();
    const Eigen::MatrixXd r = qr.matrixR().topLeftCorner(n, n);
    const Eigen::MatrixXd inverse =
        r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n).eval());
    const Eigen::MatrixXd root = scale.asDiagonal() * (qr.colsPermutation() * inverse);
    fit.covariance = root * root.transpose();
    return fit;
}

double student_quantile(Eigen::Index freedom) {
    const boost::math::students_t distribution(static_cast<double>(freedom));
    return boost::math::quantile(boost::math::complement(distribution, 0.025));
}

FittedValue coefficient(const LinearFit& fit, Eigen::Index i) {
    FittedValue result;
    result.value = fit.coefficients(i);
    result.half_width = std::sqrt(allowed_excess(fit) * fit.covariance(i, i));
    result.interval = {result.value - result.half_width, result.value + result.half_width};
    return result;
}

FittedValue coefficient_ratio(const LinearFit& fit, Eigen::Index numerator, Eigen::Index denominator) {
    FittedValue result;
    result.value = fit.coefficients(numerator) / fit.coefficients(denominator);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.coefficients.size());
    gradient(numerator) = 1.0 / fit.coefficients(denominator);
    gradient(denominator) = -result.value / fit.coefficients(denominator);
    result.half_width = propagated_half_width(fit, gradient);
    result.interval = ratio_range(fit, numerator, denominator, allowed_excess(fit));
    return result;
}

double propagated_half_width(const LinearFit& fit, const Eigen::VectorXd& gradient) {
    return std::sqrt(allowed_excess(fit) * gradient.dot(fit.covariance * gradient));
}

Interval coefficient_range(const LinearFit& fit, Eigen::Index i, double excess) {
    const double half_width = std::sqrt(std::max(0.0, excess) * fit.covariance(i, i));
    return {fit.coefficients(i) - half_width, fit.coefficients(i) + half_width};
}

Interval ratio_range(const LinearFit& fit, Eigen::Index numerator, Eigen::Index denominator, double excess) {
    // Holding the ratio at r, a - r b = 0, raises the sum of squares by (a - r b)^2/var(a - r b). So the ends
    // are the roots of (a - r b)^2 = excess (V_aa - 2 r V_ab + r^2 V_bb).
    const double a = fit.coefficients(numerator);
    const double b = fit.coefficients(denominator);
    const double e = std::max(0.0, excess);
    const double square = b * b - e * fit.covariance(denominator, denominator);
    if (!(square > 0.0)) return {};
    const double half = a * b - e * fit.covariance(numerator, denominator);
    const double constant = a * a - e * fit.covariance(numerator, numerator);
    const double root = std::sqrt(std::max(0.0, half * half - square * constant));
    return {(half - root) / square, (half + root) / square};
}

}  // namespace riffle::inline statistics
