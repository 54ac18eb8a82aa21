#include "statistics/linear_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "statistics/separable_fit.hpp"

namespace riffle::linear_fit_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Line through (1, 1), (2, 2), (3, 2), (4, 3): slope 0.6, offset 0.5, residual sum of squares 0.2.
MatrixXd line_basis() {
    MatrixXd basis(4, 2);
    basis << 1, 1, 2, 1, 3, 1, 4, 1;
    return basis;
}
const VectorXd line_values = Eigen::Vector4d(1, 2, 2, 3);

TEST(LinearFit, TextbookLine) {
    const auto fit = fit_linear(line_basis(), line_values);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->coefficients(0), 0.6, 1e-14);
    EXPECT_NEAR(fit->coefficients(1), 0.5, 1e-14);
    EXPECT_NEAR(fit->sum_of_squares, 0.2, 1e-14);
    EXPECT_EQ(fit->freedom, 2);
    // Variance of the slope s^2/sum (x - mean)^2 = 0.1/5; t(2, 0.975) = 4.30265.
    EXPECT_NEAR(student_quantile(2), 4.30265, 1e-5);
    EXPECT_NEAR(coefficient(*fit, 0).half_width, 4.30265 * std::sqrt(0.02), 1e-5);
}

TEST(LinearFit, FiellersIntervalIsTheRangeOfRatiosThatTheSumOfSquaresAllows) {
    const auto fit = fit_linear(line_basis(), line_values);
    const double excess = 0.3;
    const Interval range = ratio_range(*fit, 1, 0, excess);
    // With offset = r slope the model has one coefficient; at the ends its sum of squares is that much
    // larger.
    for (const double r : {range.lower, range.upper}) {
        MatrixXd held(4, 1);
        held << 1 + r, 2 + r, 3 + r, 4 + r;
        EXPECT_NEAR(fit_linear(held, line_values)->sum_of_squares, 0.2 + excess, 1e-12);
    }
    EXPECT_TRUE(range.contains(0.5 / 0.6));
    // A slope that may be zero bounds no ratio.
    EXPECT_TRUE(std::isinf(ratio_range(*fit, 1, 0, 100.0).upper));
}

TEST(LinearFit, UncertaintiesAreRelativeWeights) {
    // A point whose uncertainty is enormous does not count but for the degree of freedom.
    VectorXd uncertainty = VectorXd::Ones(4);
    uncertainty(3) = 1e9;
    VectorXd values = line_values;
    values(3) = 77;
    const auto fit = fit_linear(line_basis(), values, uncertainty);
    EXPECT_NEAR(fit->coefficients(0), 0.5, 1e-6);  // through (1, 1), (2, 2), (3, 2)
    const auto scaled = fit_linear(line_basis(), values, 5.0 * uncertainty);
    EXPECT_NEAR(coefficient(*scaled, 0).half_width, coefficient(*fit, 0).half_width, 1e-12);
}

TEST(LinearFit, SaysThatTheCoefficientsAreNotDetermined) {
    MatrixXd basis = line_basis();
    basis.col(1) = 3.0 * basis.col(0);
    EXPECT_FALSE(fit_linear(basis, line_values));
    EXPECT_FALSE(fit_linear(line_basis().topRows(2), line_values.head(2)));
    EXPECT_THROW((void)fit_linear(line_basis(), line_values.head(3)), InputError);
    EXPECT_THROW((void)fit_linear(line_basis(), line_values, VectorXd::Zero(4)), InputError);
}

/// a exp(-p x), strongly curved in p.
TEST(SeparableFit, ProfileIntervalIsWhereTheSumOfSquaresReachesItsLimit) {
    const VectorXd x = VectorXd::LinSpaced(8, 0.0, 3.0);
    const auto basis = [&x](double p) { return MatrixXd((-p * x.array()).exp().matrix()); };
    VectorXd values = 2.0 * (-0.8 * x.array()).exp();
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    for (double& v : values) v += 0.15 * normal(generator);
    const SeparableFit fit(basis, values, {}, 0.01, 5.0);
    ASSERT_TRUE(fit.determined());
    const FittedValue p = fit.parameter();
    const double t = student_quantile(6);
    const double limit = fit.linear().sum_of_squares * (1.0 + t * t / 6.0);
    for (const double end : {p.interval.lower, p.interval.upper}) {
        EXPECT_NEAR(fit_linear(basis(end), values)->sum_of_squares, limit, 1e-6 * limit);
    }
    // An end of the coefficient's interval: no parameter lets the sum reach the limit with more than it.
    const Interval a = fit.coefficient(0).interval;
    double least = 1e300;
    for (double q = 0.01; q < 5.0; q += 1e-3) {
        least = std::min(least, (values - basis(q) * a.upper).squaredNorm());
    }
    EXPECT_NEAR(least, limit, 1e-4 * limit);
}

TEST(SeparableFit, SaysWhenTheParameterIsNotBounded) {
    // A straight line is the limit p -> 0 of a + b exp(-p x): the sum of squares has no minimum inside.
    const VectorXd x = VectorXd::LinSpaced(8, 0.0, 3.0);
    const auto basis = [&x](double p) {
        MatrixXd b(x.size(), 2);
        b.col(0).setOnes();
        b.col(1) = (-p * x.array()).exp();
        return b;
    };
    const SeparableFit exact(basis, x, {}, 0.01, 5.0);
    EXPECT_FALSE(exact.determined());
    EXPECT_TRUE(exact.at_the_edge());
    // Hardly bent and noisy: a minimum, but no lower end of the interval.
    VectorXd values = (-0.3 * x.array()).exp();
    for (Eigen::Index i = 0; i < 8; ++i) values(i) += i % 2 == 0 ? 0.05 : -0.05;
    const SeparableFit noisy(basis, values, {}, 0.01, 5.0);
    ASSERT_TRUE(noisy.determined());
    EXPECT_TRUE(std::isinf(noisy.parameter().interval.lower));
    EXPECT_TRUE(std::isfinite(noisy.parameter().interval.upper));
    EXPECT_TRUE(std::isinf(noisy.coefficient(1).interval.upper));
    EXPECT_THROW(SeparableFit(basis, values, {}, 1.0, 1.0), InputError);
}

}  // namespace
}  // namespace riffle::linear_fit_test
