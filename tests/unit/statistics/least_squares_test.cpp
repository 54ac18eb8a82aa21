#include "statistics/least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

#include "base/error.hpp"

namespace riffle::least_squares_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const VectorXd unbounded = VectorXd::Constant(2, 1e9);

TEST(LeastSquares, FindsTheParametersOfAnExponential) {
    const VectorXd t = VectorXd::LinSpaced(12, 0.0, 3.0);
    const auto residuals = [&t](const VectorXd& p) -> std::optional<VectorXd> {
        return VectorXd(p(0) * (-p(1) * t.array()).exp() - 1.3 * (-0.7 * t.array()).exp());
    };
    const auto fit = minimise_least_squares(residuals, VectorXd::Ones(2), -unbounded, unbounded);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->converged);
    EXPECT_NEAR(fit->parameters(0), 1.3, 1e-8);
    EXPECT_NEAR(fit->parameters(1), 0.7, 1e-8);
    // The Jacobian is the one at the minimum, to the square of the difference step.
    const VectorXd exact = -1.3 * t.array() * (-0.7 * t.array()).exp();
    EXPECT_LT((fit->jacobian.col(1) - exact).norm(), 1e-6 * exact.norm());
}

TEST(LeastSquares, FollowsACurvedValley) {
    const auto rosenbrock = [](const VectorXd& p) -> std::optional<VectorXd> {
        return VectorXd(Eigen::Vector2d(10.0 * (p(1) - p(0) * p(0)), 1.0 - p(0)));
    };
    const auto fit = minimise_least_squares(rosenbrock, Eigen::Vector2d(-1.2, 1.0), -unbounded, unbounded);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->converged);
    EXPECT_LT((fit->parameters - VectorXd::Ones(2)).norm(), 1e-8);
}

/// A linear problem with correlated unknowns, so that a step cut at a bound is not the minimum there.
struct LinearProblem {
    MatrixXd matrix;
    VectorXd right;

    explicit LinearProblem(std::uint64_t seed) : matrix(6, 3), right(6) {
        std::mt19937_64 generator(seed);
        std::normal_distribution<double> normal;
        for (Index i = 0; i < 6; ++i) {
            const double common = normal(generator);
            for (Index j = 0; j < 3; ++j) matrix(i, j) = common + 0.3 * normal(generator);
            right(i) = normal(generator);
        }
    }
};

// Necessary and, the problem being convex, sufficient: no slope inside, slopes outwards at the bounds.
TEST(LeastSquares, MeetsTheConditionsOfAMinimumWithinBounds) {
    const VectorXd lower = VectorXd::Constant(3, -0.5);
    const VectorXd upper = VectorXd::Constant(3, 0.4);
    int at_bounds = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const LinearProblem problem(seed);
        const auto residuals = [&problem](const VectorXd& p) -> std::optional<VectorXd> {
            return VectorXd(problem.matrix * p - problem.right);
        };
        const auto fit = minimise_least_squares(residuals, VectorXd::Zero(3), lower, upper);
        ASSERT_TRUE(fit);
        EXPECT_TRUE(fit->converged) << "seed " << seed;
        const VectorXd slope = problem.matrix.transpose() * fit->residuals;
        for (Index j = 0; j < 3; ++j) {
            const double tolerance = 1e-5 * problem.matrix.col(j).norm() * fit->residuals.norm();
            ASSERT_GE(fit->parameters(j), lower(j));
            ASSERT_LE(fit->parameters(j), upper(j));
            if (fit->parameters(j) > lower(j)) {
                EXPECT_LE(slope(j), tolerance) << "seed " << seed;
            }
            if (fit->parameters(j) < upper(j)) {
                EXPECT_GE(slope(j), -tolerance) << "seed " << seed;
            }
            at_bounds += fit->parameters(j) == lower(j) || fit->parameters(j) == upper(j);
        }
    }
    EXPECT_GT(at_bounds, 100);
    EXPECT_LT(at_bounds, 500);
}

/// sqrt(x) - target, only for x > 0.01.
ResidualFunction root_minus(double target) {
    return [target](const VectorXd& p) -> std::optional<VectorXd> {
        if (p(0) < 0.01) return std::nullopt;
        return VectorXd(VectorXd::Constant(1, std::sqrt(p(0)) - target));
    };
}

TEST(LeastSquares, TurnsBackWhereTheResidualsAreNotDefined) {
    const VectorXd bound = VectorXd::Constant(1, 100.0);
    // Newton's first step from 4 to the root at 0.04 leads to -3.2.
    const auto fit = minimise_least_squares(root_minus(0.2), VectorXd::Constant(1, 4.0), -bound, bound);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->converged);
    EXPECT_NEAR(fit->parameters(0), 0.04, 1e-9);
}

TEST(LeastSquares, SaysThatItDidNotReachAMinimum) {
    const VectorXd bound = VectorXd::Constant(1, 100.0);
    // The minimum lies where the residuals are not defined.
    const auto outside = minimise_least_squares(root_minus(-1.0), VectorXd::Constant(1, 4.0), -bound, bound);
    EXPECT_TRUE(!outside || !outside->converged);
    EXPECT_FALSE(minimise_least_squares(root_minus(0.2), VectorXd::Zero(1), -bound, bound));
    LeastSquaresOptions one_iteration;
    one_iteration.max_iterations = 1;
    const auto early =
        minimise_least_squares(root_minus(0.2), VectorXd::Constant(1, 4.0), -bound, bound, one_iteration);
    ASSERT_TRUE(early);
    EXPECT_FALSE(early->converged);
}

TEST(LeastSquares, RefusesAStartOutsideOfItsBounds) {
    const VectorXd one = VectorXd::Ones(1);
    EXPECT_THROW((void)minimise_least_squares(root_minus(0.2), 3.0 * one, one, 2.0 * one), InputError);
    EXPECT_THROW((void)minimise_least_squares(root_minus(0.2), one, VectorXd::Zero(2), 2.0 * one),
                 InputError);
}

TEST(LeastSquares, CovarianceIsTheInverseOfTheNormalMatrix) {
    const LinearProblem problem(1);
    const auto covariance = parameter_covariance(problem.matrix);
    ASSERT_TRUE(covariance);
    const MatrixXd product = *covariance * (problem.matrix.transpose() * problem.matrix);
    EXPECT_LT((product - MatrixXd::Identity(3, 3)).norm(), 1e-10);
    MatrixXd dependent = problem.matrix;
    dependent.col(2) = 2.0 * dependent.col(0);
    EXPECT_FALSE(parameter_covariance(dependent));
    EXPECT_FALSE(parameter_covariance(MatrixXd::Zero(4, 2)));
}

}  // namespace
}  // namespace riffle::least_squares_test
