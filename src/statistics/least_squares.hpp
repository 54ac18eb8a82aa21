#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace riffle::inline statistics {

/// Residuals at a point of the parameters, always the same number of them; none where they are not defined.
using ResidualFunction = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& parameters)>;

/// When to stop, and how to differentiate. All are relative numbers.
struct LeastSquaresOptions {
    double difference_step = 1e-3;      ///< half width of the central differences over |parameter|
    double function_tolerance = 1e-12;  ///< change of the sum of squares
    double parameter_tolerance = 1e-9;  ///< change of the parameters (Euclidean norm)
    double gradient_tolerance =
        1e-12;  ///< cosine of the angle between residuals and a column of the Jacobian
    int max_iterations = 200;
};

/// The minimum found.
struct LeastSquaresFit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;  ///< at `parameters`, one row per residual
    bool converged = false;
};

/// Minimise the sum of squared residuals within lower <= parameters <= upper, from a start in this range, by
/// the Levenberg-Marquardt method (J. J. More, Lecture Notes in Mathematics 630, 1978: damping scaled by the
/// columns of the Jacobian; H. B. Nielsen, IMM-REP-1999-05, Technical University of Denmark: update of the
/// damping). Parameters at a bound that the gradient pushes outwards are held; steps end at the bounds.
/// Central differences may look beyond a bound by their half width. For a handful of parameters of order 1.
///
/// A trial step to where the residuals are not defined is shortened. Returns none where they are not defined
/// at the start, or within a difference step of a point that was reached. Throws InputError if start, lower
/// and upper differ in size, are empty, or the start lies outside of the range.
[[nodiscard]] std::optional<LeastSquaresFit> minimise_least_squares(const ResidualFunction& residuals,
                                                                    const Eigen::VectorXd& start,
                                                                    const Eigen::VectorXd& lower,
                                                                    const Eigen::VectorXd& upper,
                                                                    const LeastSquaresOptions& options = {});

/// Inverse of (J^T J), the covariance of the parameters for residuals of unit variance, through the singular
/// values; none where the smallest is below 1e-6 of the largest: the residuals do not determine the
/// parameters.
[[nodiscard]] std::optional<Eigen::MatrixXd> parameter_covariance(const Eigen::MatrixXd& jacobian);

}  // namespace riffle::inline statistics
