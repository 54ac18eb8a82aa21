#include "sph/correction.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <Eigen/Dense>
#include <cmath>

#include "plain_sums.hpp"

namespace riffle {
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
        for (int l = 0; l < D; ++l) {
            a(k, l) = number(-1.0, 1.0);
        }
    }
    const Eigen::HouseholderQR<Eigen::Matrix<double, D, D>> qr(a);
    const Eigen::Matrix<double, D, D> q = qr.householderQ();
    Eigen::Matrix<double, D, 1> eigenvalues;
    for (int k = 0; k < D; ++k) {
        eigenvalues[k] = number(0.4, 1.6);
    }
    return q * eigenvalues.asDiagonal() * q.transpose();
}

template <int D>
Symmetric<double, D> upper(const Eigen::Matrix<double, D, D>& m) {
    Symmetric<double, D> s{};
    for (int k = 0; k < D; ++k) {
        for (int l = k; l < D; ++l) {
            s[symmetric_index<D>(k, l)] = m(k, l);
        }
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
    // In 3D eight Newton steps from below: a triple root is approached by 2/3 per step, (2/3)^8 = 4 %.
    RC_ASSERT(smallest < exact_smallest + 1e-12);
    RC_ASSERT(smallest > exact_smallest * (D == 2 ? 1.0 - 1e-12 : 0.96));
    const Symmetric<double, D> inv = inverse<double, D>(upper<D>(m));
    const Eigen::Matrix<double, D, D> exact = m.inverse();
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) {
            RC_ASSERT(std::abs(inv[symmetric_index<D>(k, l)] - exact(k, l)) < 1e-12);
        }
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

// The point of the corrected pressure form (numerics.md): with a uniform pressure the virial of the pair
// forces, sum_i sum_j V_i V_j (B_i + B_j) (r F) x r / 2, is minus the area times the identity whatever the
// arrangement, so that pressure cannot act as friction. The usual form is anisotropic by 1e-3 to 1e-2 on the
// same particles.
TEST(Correction, MakesTheVirialOfUniformPressureIsotropic) {
    const PairSample sample = disordered_sample(0.2, 0, 3);
    LoopRun<double> run(sample, 0.0, 0.0, true);
    run.run(pair_loops<2, double>({}));
    std::array<double, 4> corrected{};
    std::array<double, 4> usual{};
    double area = 0.0;
    std::vector<std::array<double, 4>> unused(sample.fluid.size());
    const PlainSums plain =
        plain_sums(sample, KernelKind::wendland_c2, ViscosityForm::morris, 0.0, 0.0, unused);
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot(i);
        ASSERT_GT(run.gradient.regularity[slot], 0.6);
        const auto b = [&](std::size_t k) { return run.gradient.correction[k][slot]; };
        const std::array<double, 4> m = {plain.m_fluid[0][i].value, plain.m_fluid[1][i].value,
                                         plain.m_fluid[1][i].value, plain.m_fluid[2][i].value};
        const double volume = sample.fluid[i].volume;
        area += volume;
        for (std::size_t k = 0; k < 2; ++k) {
            for (std::size_t l = 0; l < 2; ++l) {
                const double product = b(2 * k) * m[l] + b(2 * k + 1) * m[2 + l];
                // Each particle for itself, where B is not blended.
                if (run.gradient.regularity[slot] > 0.9) {
                    EXPECT_NEAR(product, k == l ? 1.0 : 0.0, 1e-12);
                }
                corrected[2 * k + l] += volume * product;
                usual[2 * k + l] += volume * m[2 * k + l];
            }
        }
    }
    const double usual_anisotropy = std::abs(usual[1]) + std::abs(usual[0] - usual[3]);
    const double corrected_anisotropy = std::abs(corrected[1]) + std::abs(corrected[0] - corrected[3]);
    EXPECT_GT(usual_anisotropy / area, 1e-3);
    EXPECT_LT(corrected_anisotropy, 0.1 * usual_anisotropy);
}

// A linear velocity field has its exact gradient on disordered particles, beside walls and at the free
// surface.
TEST(Correction, ReproducesALinearVelocityField) {
    PairSample sample = disordered_sample(0.3, 3, 5);
    for (auto& p : sample.fluid) {
        p.u = {0.7 - 1.3 * p.x[1], 0.2 + 0.9 * p.x[1]};  // of z alone: x is periodic
    }
    LoopRun<double> run(sample, 0.0, 0.0, true);
    run.run(pair_loops<2, double>({}));
    int checked = 0;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot(i);
        if (run.gradient.regularity[slot] < 0.35) {
            continue;
        }
        EXPECT_NEAR(run.gradient.velocity_gradient[0][slot], 0.0, 1e-12);
        EXPECT_NEAR(run.gradient.velocity_gradient[1][slot], -1.3, 1e-12);
        EXPECT_NEAR(run.gradient.velocity_gradient[2][slot], 0.0, 1e-12);
        EXPECT_NEAR(run.gradient.velocity_gradient[3][slot], 0.9, 1e-12);
        ++checked;
    }
    EXPECT_GT(checked, 150);
}

// Pair forces of the whole loop: the momentum of an isolated set is kept to rounding, with tensors, volumes
// and viscosities that differ from particle to particle.
TEST(PairForces, SumToNothing) {
    const PairSample sample = disordered_sample(0.4, 0, 9);
    for (const ViscosityForm form : {ViscosityForm::morris, ViscosityForm::monaghan_gingold}) {
        LoopRun<double> run(sample, 0.0, 0.0, true);
        run.run(pair_loops<2, double>({.viscosity = form}));
        for (std::size_t k = 0; k < 2; ++k) {
            double tensor = 0.0;
            double viscous = 0.0;
            double magnitude = 0.0;
            for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
                const std::size_t slot = run.fluid_slot(i);
                tensor += sample.fluid[i].volume * run.force.tensor[k][slot];
                viscous += sample.fluid[i].volume * run.force.viscous[k][slot];
                magnitude += sample.fluid[i].volume * std::abs(run.force.tensor[k][slot]);
            }
            EXPECT_LT(std::abs(tensor), 1e-14 * magnitude);
            EXPECT_LT(std::abs(viscous), 1e-14 * magnitude);
        }
    }
}

}  // namespace
}  // namespace riffle
