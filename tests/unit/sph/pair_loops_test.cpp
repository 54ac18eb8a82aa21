#include "sph/pair_loops.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "case/words.hpp"
#include "loop_run.hpp"
#include "plain_sums.hpp"
#include "sph/correction.hpp"

namespace riffle::pair_loops_test {
namespace {

constexpr double diffusion = 0.7;
constexpr double hydrostatic_gradient = 0.05;
constexpr double ago = 0.002;  // pairs have come up to 0.06 h since then
/// Low enough for the limiter of the Riemann problem to reach it in some pairs
/// (tests/unit/sph/pair_sample.cpp).
constexpr double impact_bound = 1.0;

template <class Real>
constexpr double epsilon_of = static_cast<double>(std::numeric_limits<Real>::epsilon());

/// Rounding bound of a sum: each term is the product of about ten rounded factors. Terms near the end of the
/// support lose digits in 1 - q/2, but they are below a hundredth of the largest ones.
template <class Real>
void expect_near(const std::vector<PlainSum>& plain, std::size_t particle, const std::vector<Real>& loop,
                 std::size_t slot, const char* what) {
    double largest = 0.0;
    for (const PlainSum& sum : plain) largest = std::max(largest, sum.magnitude);
    // The cubic spline divides by q + 1e-12; no q here is below 0.2.
    const double epsilon = 40.0 * epsilon_of<Real> + 5e-12;
    const double bound = epsilon * (plain[particle].magnitude + 0.01 * largest);
    EXPECT_NEAR(static_cast<double>(loop[slot]), plain[particle].value, bound)
        << what << " of particle " << particle;
}
template <class Real, std::size_t N>
void expect_near(const std::array<std::vector<PlainSum>, N>& plain, std::size_t particle,
                 const std::array<std::vector<Real>, N>& loop, std::size_t slot, const char* what) {
    for (std::size_t k = 0; k < N; ++k) expect_near(plain[k], particle, loop[k], slot, what);
}

/// Weights that no component shares, and a molecular part.
constexpr DirectionalViscosity<double> directional{
    .slope = 0.9, .level = 1.2, .level_across = 0.8, .molecular = 1e-3};

struct Option {
    InstructionSet set;
    KernelKind kernel;
    ViscosityForm viscosity;
    int layers;
    bool gradients;
    bool directional = false;  ///< in three dimensions
    double impact = 0.0;       ///< of the Riemann problem
    double tensile = 0.0;
    double non_conservative = 0.0;  ///< 2: p_j - p_i
};

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

template <int D>
Symmetric<double, D> values_of(const typename PlainSums<D>::SymmetricMatrices& sums, std::size_t i) {
    Symmetric<double, D> result{};
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = sums[k][i].value;
    return result;
}

template <int D>
Matrix<D> full(const Symmetric<double, D>& m) {
    Matrix<D> result;
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) result(k, l) = m[symmetric_index<D>(k, l)];
    }
    return result;
}

template <int D>
Symmetric<double, D> sum_of(Symmetric<double, D> a, const Symmetric<double, D>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
    return a;
}

/// Largest change of an inverse by a change of 1 of the matrix's elements, the determinant rounded too.
template <int D>
double inverse_amplification(const Matrix<D>& m) {
    return m.inverse().norm() * (m.inverse().norm() + 1.0 / m.determinant());
}

/// Matrices of a particle: regularity, B, viscosity factor and the corrected velocity gradient.
template <int D, class Real>
void compare_matrices(const PlainSums<D>& plain, const LoopRun<D, Real>& run, std::size_t i) {
    const std::size_t slot = run.fluid_slot[i];
    const auto m_fluid = values_of<D>(plain.m_fluid, i);
    const auto m_wall = values_of<D>(plain.m_wall, i);
    const auto free = sum_of<D>(m_fluid, values_of<D>(plain.m_continued, i));
    const auto total = sum_of<D>(free, m_wall);
    // Each element of M is a sum whose terms add up to about 1.
    const double rounding = 200.0 * epsilon_of<Real> + 5e-12;

    // In 3D a root of the characteristic cubic: its rounding over its slope there.
    const double smallest = smallest_eigenvalue<double, D>(total);
    double slope = 1.0;
    if constexpr (D == 3) {
        const double minors = total[0] * total[3] - total[1] * total[1] + total[0] * total[5] -
                              total[2] * total[2] + total[3] * total[5] - total[4] * total[4];
        slope = (3.0 * smallest - 2.0 * (total[0] + total[3] + total[5])) * smallest + minors;
        ASSERT_GT(slope, 0.0);
    }
    const double regularity = static_cast<double>(run.gradient.regularity[slot]);
    EXPECT_NEAR(regularity, smallest, rounding / std::min(slope, 1.0)) << "regularity of particle " << i;

    if (regularity > 0.901) {
        EXPECT_NEAR(static_cast<double>(run.gradient.viscosity_factor[slot]), D / full<D>(total).trace(),
                    rounding);
        Matrix<D> exact = (Matrix<D>::Identity() - full<D>(m_wall)) * full<D>(free).inverse();
        double bound = rounding * inverse_amplification<D>(full<D>(free));
        if (D == 3) {
            // Along the channel fewer walls continue the fluid.
            const Matrix<D> along = full<D>(sum_of<D>(m_fluid, values_of<D>(plain.m_along, i)));
            const Matrix<D> walls = full<D>(total) - along;
            exact.row(0) = ((Matrix<D>::Identity() - walls) * along.inverse()).row(0);
            bound = std::max(bound, rounding * inverse_amplification<D>(along));
        }
        for (int k = 0; k < D * D; ++k) {
            EXPECT_NEAR(static_cast<double>(run.gradient.correction[static_cast<std::size_t>(k)][slot]),
                        exact(k / D, k % D), bound)
                << "correction of particle " << i;
        }
    }
    // The velocity gradient is corrected by M_fluid alone, fully from 0.3 on.
    if (smallest_eigenvalue<double, D>(m_fluid) > 0.31) {
        Matrix<D> gradient;
        double magnitude = 0.0;
        for (int k = 0; k < D * D; ++k) {
            const PlainSum& sum = plain.gradient[static_cast<std::size_t>(k)][i];
            gradient(k / D, k % D) = sum.value;
            magnitude = std::max(magnitude, sum.magnitude);
        }
        const Matrix<D> exact = gradient * full<D>(m_fluid).inverse();
        const double bound = rounding * inverse_amplification<D>(full<D>(m_fluid)) * magnitude;
        for (int k = 0; k < D * D; ++k) {
            EXPECT_NEAR(
                static_cast<double>(run.gradient.velocity_gradient[static_cast<std::size_t>(k)][slot]),
                exact(k / D, k % D), bound)
                << "velocity gradient of particle " << i;
        }
    }
}

template <int D, class Real>
void compare_with_plain_sums(const Option& option) {
    if (!instruction_set_available(option.set)) {
        GTEST_SKIP() << "this processor does not offer " << instruction_set_name(option.set);
    }
    PairSample<D> sample = disordered_sample<D>(0.3, option.layers, 11);
    if (option.tensile > 0.0) {  // some of the particles under suction
        for (auto* particles : {&sample.fluid, &sample.wall}) {
            for (auto& p : *particles) p.pressure -= 0.5;
        }
    }
    LoopRun<D, Real> run(sample, {.diffusion = diffusion,
                                  .hydrostatic_gradient = hydrostatic_gradient,
                                  .ago = ago,
                                  .gradients = option.gradients,
                                  .directional = directional,
                                  .kernel = option.kernel,
                                  .viscosity = option.viscosity,
                                  .impact = option.impact,
                                  .impact_bound = impact_bound,
                                  .non_conservative = option.non_conservative,
                                  .tensile = option.tensile,
                                  .by_direction = option.directional});
    run.run(pair_loops<D, Real>({.kernel = option.kernel,
                                 .viscosity = option.viscosity,
                                 .gradients = option.gradients,
                                 .directional = option.directional,
                                 .pair_pressure = option.impact > 0.0 || option.tensile > 0.0},
                                option.set));
    Corrections<D> correction(sample.fluid.size());
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        for (std::size_t k = 0; k < D * D; ++k) {
            const double identity = k % (D + 1) == 0 ? 1.0 : 0.0;
            if (option.gradients) {
                correction[i][k] = static_cast<double>(run.gradient.correction[k][run.fluid_slot[i]]);
            } else {
                correction[i][k] = identity;
                sample.fluid[i].stress[k] = identity * sample.fluid[i].pressure;
            }
        }
    }
    const PlainSums<D> plain = plain_sums<D>(sample,
                                             {.kernel = option.kernel,
                                              .viscosity = option.viscosity,
                                              .diffusion = diffusion,
                                              .ago = ago,
                                              .hydrostatic_gradient = hydrostatic_gradient,
                                              .impact = option.impact,
                                              .impact_bound = impact_bound,
                                              .non_conservative = option.non_conservative,
                                              .tensile = option.tensile,
                                              .weighted = option.directional,
                                              .directional = directional},
                                             correction);
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot[i];
        expect_near(plain.density_rate, i, run.gradient.density_rate, slot, "density rate");
        expect_near(plain.midway_density_rate, i, run.gradient.midway_density_rate, slot,
                    "density rate midway");
        expect_near(plain.diffusion, i, run.gradient.diffusion, slot, "diffusion");
        expect_near(plain.tensor, i, run.force.tensor, slot, "tensor force");
        expect_near(plain.viscous, i, run.force.viscous, slot, "viscous force");
        expect_near(plain.wall, i, run.force.wall, slot, "wall force");
        expect_near(plain.zeroth, i, run.filter.zeroth, slot, "zeroth moment");
        expect_near(plain.first, i, run.filter.first, slot, "first moment");
        expect_near(plain.second, i, run.filter.second, slot, "second moment");
        expect_near(plain.mass, i, run.filter.mass, slot, "mass moment");
        expect_near(plain.mass_first, i, run.filter.mass_first, slot, "first mass moment");
        expect_near(plain.velocity, i, run.filter.velocity, slot, "smoothed velocity");
        if (option.gradients) compare_matrices<D, Real>(plain, run, i);
    }
    for (std::size_t i = 0; i < sample.wall.size(); ++i) {
        const std::size_t slot = run.wall_slot[i];
        expect_near(plain.wall_weight, i, run.wall.weight, slot, "wall weight");
        expect_near(plain.wall_pressure, i, run.wall.pressure, slot, "wall pressure");
        expect_near(plain.wall_density_rate, i, run.wall.density_rate, slot, "wall density rate");
        expect_near(plain.wall_offset, i, run.wall.offset, slot, "wall offset");
        expect_near(plain.wall_velocity, i, run.wall.velocity, slot, "wall velocity");
    }
}

/// A word of the case file as part of a test's name.
template <class Enum>
std::string in_name(Enum value) {
    std::string name(word(value));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string name_of(const testing::TestParamInfo<Option>& info) {
    return instruction_set_name(info.param.set) + "_" + in_name(info.param.kernel) + "_" +
           in_name(info.param.viscosity) + (info.param.layers > 0 ? "_walls" : "_periodic") +
           (info.param.gradients ? "" : "_plain") + (info.param.directional ? "_directional" : "") +
           (info.param.impact > 0.0 ? "_riemann" : "") + (info.param.tensile > 0.0 ? "_tensile" : "") +
           (info.param.non_conservative > 0.0 ? "_nonconservative" : "");
}

std::vector<Option> all_options() {
    std::vector<Option> options;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        for (const KernelKind kernel : {KernelKind::wendland_c2, KernelKind::cubic_spline}) {
            for (const ViscosityForm viscosity : {ViscosityForm::morris, ViscosityForm::monaghan_gingold,
                                                  ViscosityForm::lo_shao, ViscosityForm::artificial}) {
                for (const int layers : {0, 3}) {
                    if (viscosity == ViscosityForm::morris) {
                        options.push_back({set, kernel, viscosity, layers, true, true});
                    }
                    for (const bool gradients : {true, false}) {
                        options.push_back({set, kernel, viscosity, layers, gradients});
                    }
                }
            }
        }
        for (const KernelKind kernel :
             {KernelKind::gaussian, KernelKind::quadratic, KernelKind::quintic_spline,
              KernelKind::wendland_c4, KernelKind::wendland_c6}) {
            for (const bool gradients : {true, false}) {
                options.push_back({set, kernel, ViscosityForm::morris, 3, gradients});
                options.push_back({set, kernel, ViscosityForm::monaghan_gingold, 0, gradients});
            }
            options.push_back({set, kernel, ViscosityForm::morris, 0, true, true});
        }
        // Pressures of the pair beside the sum of two.
        for (const bool gradients : {true, false}) {
            options.push_back(
                {set, KernelKind::wendland_c2, ViscosityForm::morris, 3, gradients, false, 3.0, 0.0});
            options.push_back(
                {set, KernelKind::cubic_spline, ViscosityForm::morris, 3, gradients, false, 0.0, 0.2});
            options.push_back(
                {set, KernelKind::wendland_c2, ViscosityForm::morris, 3, gradients, false, 3.0, 0.0, 2.0});
            options.push_back(
                {set, KernelKind::wendland_c6, ViscosityForm::lo_shao, 0, gradients, false, 3.0, 0.0});
        }
    }
    return options;
}

class PairLoopsTest : public testing::TestWithParam<Option> {};

TEST_P(PairLoopsTest, SingleEqualsPlainSums2D) { compare_with_plain_sums<2, float>(GetParam()); }
TEST_P(PairLoopsTest, DoubleEqualsPlainSums2D) { compare_with_plain_sums<2, double>(GetParam()); }
TEST_P(PairLoopsTest, SingleEqualsPlainSums3D) { compare_with_plain_sums<3, float>(GetParam()); }
TEST_P(PairLoopsTest, DoubleEqualsPlainSums3D) { compare_with_plain_sums<3, double>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, PairLoopsTest, testing::ValuesIn(all_options()), name_of);

template <int D>
void expect_all_loops() {
    const PairLoops<D, float> loops = pair_loops<D, float>({});
    EXPECT_NE(loops.gradient, nullptr);
    EXPECT_NE(loops.gradient_midway, nullptr);
    EXPECT_NE(loops.force, nullptr);
    EXPECT_NE(loops.wall, nullptr);
    EXPECT_NE(loops.filter, nullptr);
}

TEST(PairLoops, ActiveSetIsOffered) {
    EXPECT_TRUE(instruction_set_available(active_instruction_set()));
    expect_all_loops<2>();
    expect_all_loops<3>();
}

}  // namespace
}  // namespace riffle::pair_loops_test
