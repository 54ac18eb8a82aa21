// What closures for resolved eddies make of the velocity gradient, against the formulas of their papers in
// matrices.

#include "sph/strain_measure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace riffle::strain_measure_test {
namespace {

using Gradient = Components<double, 9>;
using Matrix = Eigen::Matrix3d;

Gradient components(const Matrix& g) {
    Gradient result{};
    for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) result[static_cast<std::size_t>(3 * k + l)] = g(k, l);
    }
    return result;
}

Matrix random_gradient(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    Matrix g;
    for (int k = 0; k < 9; ++k) g(k / 3, k % 3) = 10.0 * normal(generator);
    return g;
}

double plain_wale(const Matrix& g) {
    const Matrix squared = g * g;
    const Matrix deviator =
        0.5 * (squared + squared.transpose()) - Matrix::Identity() * squared.trace() / 3.0;
    const Matrix strain = 0.5 * (g + g.transpose());
    const double d = deviator.squaredNorm();
    const double s = strain.squaredNorm();
    return std::pow(d, 1.5) / (std::pow(s, 2.5) + std::pow(d, 1.25));
}

double plain_vreman(const Matrix& g) {
    const Matrix beta = g * g.transpose();
    const double minors = 0.5 * (beta.trace() * beta.trace() - (beta * beta).trace());
    return std::sqrt(std::max(minors, 0.0) / g.squaredNorm());
}

/// Plane shear of a rate in some plane.
Matrix turned_shear(double rate) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::UnitRandom();
    Matrix shear = Matrix::Zero();
    shear(0, 2) = rate;
    return turn * shear * turn.conjugate();
}

TEST(StrainMeasure, FollowsTheFormulas) {
    std::mt19937 generator(1);
    for (int trial = 0; trial < 100; ++trial) {
        const Matrix g = random_gradient(generator);
        EXPECT_NEAR(wale_rate<double>(components(g)), plain_wale(g), 1e-12 * plain_wale(g));
        EXPECT_NEAR(vreman_rate<double>(components(g)), plain_vreman(g), 1e-9 * plain_vreman(g));
        const double strain = (0.5 * (g + g.transpose())).norm() * std::sqrt(2.0);
        EXPECT_NEAR((strain_rate<double, 3>(components(g))), strain, 1e-12 * strain);
    }
}

// Sheared, not turbulent: no eddy viscosity, in whatever plane.
TEST(StrainMeasure, VanishesInPlaneShear) {
    std::mt19937 generator(2);
    for (int trial = 0; trial < 20; ++trial) {
        const Matrix g = turned_shear(30.0);
        EXPECT_LT(wale_rate<double>(components(g)), 1e-6 * 30.0);
        EXPECT_LT(vreman_rate<double>(components(g)), 1e-6 * 30.0);
    }
    EXPECT_EQ(wale_rate<double>(Gradient{}), 0.0);
    EXPECT_EQ(vreman_rate<double>(Gradient{}), 0.0);
}

// The three rates of mixing lengths are one where a mixing length was measured, and apart where water is
// drawn out.
TEST(StrainMeasure, OfRotationIsThatOfStrainInPlaneShearAndNoneWithoutTurning) {
    std::mt19937 generator(4);
    for (int trial = 0; trial < 20; ++trial) {
        EXPECT_NEAR((rotation_rate<double, 3>(components(turned_shear(30.0)))), 30.0, 1e-12 * 30.0);
        const Matrix g = random_gradient(generator);
        const Matrix drawn_out = 0.5 * (g + g.transpose());
        const Matrix turning = 0.5 * (g - g.transpose());
        EXPECT_LT((rotation_rate<double, 3>(components(drawn_out))), 1e-14 * g.norm());
        const double expected = turning.norm() * std::sqrt(2.0);
        EXPECT_NEAR((rotation_rate<double, 3>(components(g))), expected, 1e-12 * expected);
    }
}

TEST(StrainMeasure, DoesNotSeeTheAxesAndGrowsWithTheGradient) {
    std::mt19937 generator(3);
    for (int trial = 0; trial < 20; ++trial) {
        const Matrix g = random_gradient(generator);
        const Eigen::Quaterniond turn = Eigen::Quaterniond::UnitRandom();
        const Matrix turned = turn * g * turn.conjugate();
        const double wale = wale_rate<double>(components(g));
        const double vreman = vreman_rate<double>(components(g));
        EXPECT_NEAR(wale_rate<double>(components(turned)), wale, 1e-9 * wale);
        EXPECT_NEAR(vreman_rate<double>(components(turned)), vreman, 1e-9 * vreman);
        EXPECT_NEAR(wale_rate<double>(components(3.0 * g)), 3.0 * wale, 1e-9 * wale);
        EXPECT_NEAR(vreman_rate<double>(components(3.0 * g)), 3.0 * vreman, 1e-9 * vreman);
    }
}

}  // namespace
}  // namespace riffle::strain_measure_test
