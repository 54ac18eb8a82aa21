#include "sph/correction.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "loop_run.hpp"
#include "plain_sums.hpp"

namespace riffle::correction_test {
namespace {

double number(double low, double high) {
    return low +
           (high - low) * std::ldexp(static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1LL << 40)), -40);
}

/// A symmetric positive matrix with eigenvalues in [0.4, 1.6].
template <int D>
Eigen::Matrix<double, D, D> positive_matrix() {
    Eigen::Matrix<double, D, D> a;
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) a(k, l) = number(-1.0, 1.0);
    }
    const Eigen::HouseholderQR<Eigen::Matrix<double, D, D>> qr(a);
    const Eigen::Matrix<double, D, D> q = qr.householderQ();
    Eigen::Matrix<double, D, 1> eigenvalues;
    for (int k = 0; k < D; ++k) eigenvalues[k] = number(0.4, 1.6);
    return q * eigenvalues.asDiagonal() * q.transpose();
}

template <int D>
Symmetric<double, D> upper(const Eigen::Matrix<double, D, D>& m) {
    Symmetric<double, D> s{};
    for (int k = 0; k < D; ++k) {
        for (int l = k; l < D; ++l) s[symmetric_index<D>(k, l)] = m(k, l);
    }
    return s;
}

template <int D>
void check_small_matrices() {
    const Eigen::Matrix<double, D, D> m = positive_matrix<D>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> solver(m);
    RC_ASSERT(std::abs(determinant<double, D>(upper<D>(m)) - m.determinant()) < 1e-13);
    const double smallest = smallest_eigenvalue<double, D>(upper<D>(m));
    const double exact_smallest = solver.eigenvalues()[0];
    RC_ASSERT(std::abs(smallest - exact_smallest) < (D == 2 ? 1e-12 : 1e-4));
    const Symmetric<double, D> inv = inverse<double, D>(upper<D>(m));
    const Eigen::Matrix<double, D, D> exact = m.inverse();
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) RC_ASSERT(std::abs(inv[symmetric_index<D>(k, l)] - exact(k, l)) < 1e-12);
    }
    // With a wall: B M_fluid + M_wall = I. Without blending B = I.
    const Eigen::Matrix<double, D, D> wall = 0.3 * positive_matrix<D>();
    const auto b = pressure_correction<double, D>(upper<D>(m), upper<D>(wall), 1.0);
    const auto none = pressure_correction<double, D>(upper<D>(m), upper<D>(wall), 0.0);
    Eigen::Matrix<double, D, D> matrix;
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) {
            matrix(k, l) = b[static_cast<std::size_t>(k * D + l)];
            RC_ASSERT(none[static_cast<std::size_t>(k * D + l)] == (k == l ? 1.0 : 0.0));
        }
    }
    RC_ASSERT((matrix * m + wall - Eigen::Matrix<double, D, D>::Identity()).norm() < 1e-12);
}

TEST(Correction, SmallMatrices2D) {
    EXPECT_TRUE(rc::check("determinant, inverse, eigenvalue, B", [] { check_small_matrices<2>(); }));
}
TEST(Correction, SmallMatrices3D) {
    EXPECT_TRUE(rc::check("determinant, inverse, eigenvalue, B", [] { check_small_matrices<3>(); }));
}

TEST(Correction, SmoothstepRisesFromZeroToOne) {
    EXPECT_EQ(smoothstep<double>(0.6, 0.9, 0.59), 0.0);
    EXPECT_EQ(smoothstep<double>(0.6, 0.9, 0.91), 1.0);
    EXPECT_NEAR(smoothstep<double>(0.6, 0.9, 0.75), 0.5, 1e-15);
    EXPECT_GT(smoothstep<double>(0.6, 0.9, 0.8), smoothstep<double>(0.6, 0.9, 0.7));
}

// Where two eigenvalues meet, the rounding of r, some 1e-7, moves w by its root, 4e-4: 2e-4 of p, which is at
// most 0.6 here.
TEST(Correction, SmallestEigenvalueInSinglePrecision3D) {
    EXPECT_TRUE(rc::check("the smallest eigenvalue in single precision", [] {
        const Eigen::Matrix3d m = positive_matrix<3>();
        const double exact = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues()[0];
        Symmetric<float, 3> rounded{};
        const auto values = upper<3>(m);
        std::transform(values.begin(), values.end(), rounded.begin(),
                       [](double v) { return static_cast<float>(v); });
        const auto smallest = static_cast<double>(smallest_eigenvalue<float, 3>(rounded));
        RC_ASSERT(std::abs(smallest - exact) < 5e-4);
    }));
}

// The whole neighbourhood of the triple root, which most particles are near to: M is nearly the identity.
TEST(Correction, SmallestEigenvalueWhereEigenvaluesMeet3D) {
    for (const double departure : {0.0, 1e-6, 1e-3, 0.1}) {
        for (const double middle : {-1.0, -0.999, 0.0, 0.7, 1.0}) {
            const Symmetric<double, 3> m{1.0 - departure,          0.0, 0.0,
                                         1.0 + middle * departure, 0.0, 1.0 + departure};
            EXPECT_NEAR((smallest_eigenvalue<double, 3>(m)), 1.0 - departure, 1e-4 * departure + 1e-15);
            Symmetric<float, 3> rounded{};
            std::transform(m.begin(), m.end(), rounded.begin(),
                           [](double v) { return static_cast<float>(v); });
            EXPECT_NEAR(static_cast<double>(smallest_eigenvalue<float, 3>(rounded)), 1.0 - departure,
                        5e-4 * departure + 3e-7);
        }
    }
}

// Of three equal eigenvalues, and of two larger ones, which is as far from the fixed point's start as it
// gets.
TEST(Correction, SmallestEigenvalueOfMultipleRoots3D) {
    EXPECT_EQ((smallest_eigenvalue<double, 3>({1.0, 0.0, 0.0, 1.0, 0.0, 1.0})), 1.0);
    EXPECT_EQ((smallest_eigenvalue<double, 3>({0.0, 0.0, 0.0, 0.0, 0.0, 0.0})), 0.0);
    EXPECT_NEAR((smallest_eigenvalue<double, 3>({0.5, 0.0, 0.0, 1.0, 0.0, 1.0})), 0.5, 1e-4);
    EXPECT_NEAR((smallest_eigenvalue<double, 3>({0.5, 0.0, 0.0, 0.5, 0.0, 1.0})), 0.5, 1e-4);
}

// The point of the corrected pressure form (numerics.md): with a uniform pressure the virial of the pair
// forces, sum_i sum_j V_i V_j (B_i + B_j) (r F) x r / 2, is minus the volume times the identity whatever the
// arrangement, so that pressure cannot act as friction. A displacement of a tenth of the spacing leaves every
// particle where B is not blended; the usual form is anisotropic by some 1e-3 on the same particles.
template <int D>
void check_virial() {
    using Matrix = Eigen::Matrix<double, D, D>;
    const PairSample<D> sample = disordered_sample<D>(0.1, 0, 3);
    LoopRun<D, double> run(sample, {});
    run.run(pair_loops<D, double>({}));
    Matrix corrected = Matrix::Zero();
    Matrix usual = Matrix::Zero();
    const Corrections<D> unused(sample.fluid.size());
    const PlainSums<D> plain = plain_sums<D>(sample, {}, unused);
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot[i];
        ASSERT_GT(run.gradient.regularity[slot], 0.9);
        Matrix b;
        Matrix m;
        for (int k = 0; k < D; ++k) {
            for (int l = 0; l < D; ++l) {
                b(k, l) = run.gradient.correction[static_cast<std::size_t>(D * k + l)][slot];
                m(k, l) = plain.m_fluid[symmetric_index<D>(k, l)][i].value;
            }
        }
        EXPECT_LT((b * m - Matrix::Identity()).norm(), 1e-12);
        corrected += sample.fluid[i].volume * b * m;
        usual += sample.fluid[i].volume * m;
    }
    const auto anisotropy = [&](const Matrix& virial) {
        return (virial - virial.trace() / D * Matrix::Identity()).norm() / sample.volume();
    };
    EXPECT_GT(anisotropy(usual), 3e-4);
    EXPECT_LT(anisotropy(corrected), 1e-12);
}

TEST(Correction, MakesTheVirialOfUniformPressureIsotropic2D) { check_virial<2>(); }
TEST(Correction, MakesTheVirialOfUniformPressureIsotropic3D) { check_virial<3>(); }

/// A linear velocity field u = u0 + A x has its exact gradient on disordered particles, beside walls and at
/// the free surface. With `of_height` A acts on z alone, and the field is periodic; otherwise only particles
/// away from the seams see it as linear.
template <int D>
void check_linear_field(bool of_height, int fewest) {
    PairSample<D> sample = disordered_sample<D>(0.3, 3, 5);
    std::mt19937 generator(17);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    Eigen::Matrix<double, D, D> a;
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) a(k, l) = of_height && l < D - 1 ? 0.0 : uniform(generator);
    }
    for (auto& p : sample.fluid) {
        const Eigen::Matrix<double, D, 1> u = a * Eigen::Map<const Eigen::Matrix<double, D, 1>>(p.x.data());
        std::copy(u.begin(), u.end(), p.u.begin());
    }
    LoopRun<D, double> run(sample, {});
    run.run(pair_loops<D, double>({}));
    int checked = 0;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot[i];
        // The gradient fades out where the fluid's own matrix is nearly singular.
        if (run.gradient.regularity[slot] < 0.35 || (!of_height && !sample.far_from_seams(sample.fluid[i]))) {
            continue;
        }
        for (int k = 0; k < D; ++k) {
            for (int l = 0; l < D; ++l) {
                EXPECT_NEAR(run.gradient.velocity_gradient[static_cast<std::size_t>(D * k + l)][slot],
                            a(k, l), 1e-12);
            }
        }
        ++checked;
    }
    EXPECT_GE(checked, fewest);
}

// Of 160 and 512 particles; 10 and 2 x 2 of the columns are away from the seams.
TEST(Correction, ReproducesALinearVelocityField2D) {
    check_linear_field<2>(true, 150);
    check_linear_field<2>(false, 80);
}
TEST(Correction, ReproducesALinearVelocityField3D) {
    check_linear_field<3>(true, 480);
    check_linear_field<3>(false, 20);
}

// Pair forces of the whole loop: the momentum of an isolated set is kept to rounding, with tensors, volumes
// and viscosities that differ from particle to particle.
template <int D>
void check_pair_forces() {
    const PairSample<D> sample = disordered_sample<D>(0.4, 0, 9);
    for (const bool gradients : {true, false}) {
        for (const ViscosityForm form : {ViscosityForm::morris, ViscosityForm::monaghan_gingold,
                                         ViscosityForm::lo_shao, ViscosityForm::artificial}) {
            LoopRun<D, double> run(
                sample, {.gradients = gradients, .viscosity = form, .impact = 3.0, .impact_bound = 1.0});
            run.run(pair_loops<D, double>({.viscosity = form, .gradients = gradients}));
            for (std::size_t k = 0; k < D; ++k) {
                double tensor = 0.0;
                double viscous = 0.0;
                double magnitude = 0.0;
                for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
                    const std::size_t slot = run.fluid_slot[i];
                    tensor += sample.fluid[i].volume * run.force.tensor[k][slot];
                    viscous += sample.fluid[i].volume * run.force.viscous[k][slot];
                    magnitude += sample.fluid[i].volume * std::abs(run.force.tensor[k][slot]);
                }
                EXPECT_LT(std::abs(tensor), 1e-14 * magnitude);
                EXPECT_LT(std::abs(viscous), 1e-14 * magnitude);
            }
        }
    }
}

// The non-conservative form of the Riemann problem: at one pressure and one velocity, disordered particles
// feel nothing, whatever the pressure.
template <int D>
void check_uniform_pressure() {
    PairSample<D> sample = disordered_sample<D>(0.4, 0, 9);
    for (auto& particle : sample.fluid) {
        particle.pressure = 3.0;
        particle.u = {};
    }
    LoopRun<D, double> run(sample,
                           {.gradients = false, .impact = 3.0, .impact_bound = 1.0, .non_conservative = 2.0});
    run.run(pair_loops<D, double>({.gradients = false, .pair_pressure = true}));
    LoopRun<D, double> conservative(sample, {.gradients = false, .impact = 3.0, .impact_bound = 1.0});
    conservative.run(pair_loops<D, double>({.gradients = false, .pair_pressure = true}));
    double largest = 0.0;
    double felt = 0.0;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            largest = std::max(largest, std::abs(run.force.tensor[k][run.fluid_slot[i]]));
            felt = std::max(felt, std::abs(conservative.force.tensor[k][conservative.fluid_slot[i]]));
        }
    }
    EXPECT_LT(largest, 1e-12 * felt);
}

TEST(PairForces, VanishAtUniformPressureInTheNonConservativeForm2D) { check_uniform_pressure<2>(); }
TEST(PairForces, VanishAtUniformPressureInTheNonConservativeForm3D) { check_uniform_pressure<3>(); }

TEST(PairForces, SumToNothing2D) { check_pair_forces<2>(); }
TEST(PairForces, SumToNothing3D) { check_pair_forces<3>(); }

}  // namespace
}  // namespace riffle::correction_test
