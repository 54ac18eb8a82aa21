#include "sph/pair_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "plain_sums.hpp"

namespace riffle {
namespace {

constexpr double diffusion = 0.7;
constexpr double hydrostatic_gradient = 0.05;

/// Loops of a set in `Real`, or nothing where the processor lacks it.
template <class Real>
std::optional<PairLoops<2, Real>> loops_of(InstructionSet set, KernelKind kernel, ViscosityForm viscosity) {
    if (!processor_offers(set)) {
        return std::nullopt;
    }
    return pair_loops<2, Real>({.kernel = kernel, .viscosity = viscosity}, set);
}

/// Rounding bound of a sum: each term is the product of about ten rounded factors. Terms near the end of the
/// support lose digits in 1 - q/2, but they are below a hundredth of the largest ones.
template <class Real>
void expect_near(const std::vector<PlainSum>& plain, std::size_t particle, const std::vector<Real>& loop,
                 std::size_t slot, const char* what) {
    double largest = 0.0;
    for (const PlainSum& sum : plain) {
        largest = std::max(largest, sum.magnitude);
    }
    // The cubic spline divides by q + 1e-12; no q here is below 0.2.
    const double epsilon = 40.0 * static_cast<double>(std::numeric_limits<Real>::epsilon()) + 5e-12;
    const double bound = epsilon * (plain[particle].magnitude + 0.01 * largest);
    EXPECT_NEAR(static_cast<double>(loop[slot]), plain[particle].value, bound)
        << what << " of particle " << particle;
}

struct Option {
    InstructionSet set;
    KernelKind kernel;
    ViscosityForm viscosity;
    int layers;
};

template <class Real>
void compare_with_plain_sums(const Option& option) {
    const auto loops = loops_of<Real>(option.set, option.kernel, option.viscosity);
    if (!loops) {
        GTEST_SKIP() << "this processor does not offer " << instruction_set_name(option.set);
    }
    const PairSample sample = disordered_sample(0.3, option.layers, 11);
    LoopRun<Real> run(sample, diffusion, hydrostatic_gradient, true);
    run.run(*loops);
    std::vector<std::array<double, 4>> correction(sample.fluid.size());
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            correction[i][k] = static_cast<double>(run.gradient.correction[k][run.fluid_slot(i)]);
        }
    }
    const PlainSums plain =
        plain_sums(sample, option.kernel, option.viscosity, diffusion, hydrostatic_gradient, correction);

    const auto& data = run;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const std::size_t slot = run.fluid_slot(i);
        expect_near(plain.density_rate, i, data.gradient.density_rate, slot, "density rate");
        expect_near(plain.diffusion, i, data.gradient.diffusion, slot, "diffusion");
        expect_near(plain.zeroth, i, data.filter.zeroth, slot, "zeroth moment");
        expect_near(plain.mass, i, data.filter.mass, slot, "mass moment");
        for (std::size_t k = 0; k < 2; ++k) {
            expect_near(plain.tensor[k], i, data.force.tensor[k], slot, "tensor force");
            expect_near(plain.viscous[k], i, data.force.viscous[k], slot, "viscous force");
            expect_near(plain.wall[k], i, data.force.wall[k], slot, "wall force");
            expect_near(plain.first[k], i, data.filter.first[k], slot, "first moment");
            expect_near(plain.velocity[k], i, data.filter.velocity[k], slot, "smoothed velocity");
        }
        for (std::size_t k = 0; k < 3; ++k) {
            expect_near(plain.second[k], i, data.filter.second[k], slot, "second moment");
        }

        // M_total, its smallest eigenvalue, and B = (I - M_wall)(M_fluid + M_continued)^-1 where it is not
        // blended.
        const auto at = [&](const auto& sums, std::size_t k) { return sums[k][i].value; };
        std::array<double, 3> free{};
        std::array<double, 3> total{};
        for (std::size_t k = 0; k < 3; ++k) {
            free[k] = at(plain.m_fluid, k) + at(plain.m_continued, k);
            total[k] = free[k] + at(plain.m_wall, k);
        }
        const double half = 0.5 * (total[0] - total[2]);
        const double smallest = 0.5 * (total[0] + total[2]) - std::sqrt(half * half + total[1] * total[1]);
        const double rounding = 200.0 * static_cast<double>(std::numeric_limits<Real>::epsilon()) + 5e-12;
        EXPECT_NEAR(static_cast<double>(data.gradient.regularity[slot]), smallest, rounding);
        if (smallest > 0.901) {
            EXPECT_NEAR(static_cast<double>(data.gradient.viscosity_factor[slot]),
                        2.0 / (total[0] + total[2]), rounding);
            const double det = free[0] * free[2] - free[1] * free[1];
            const std::array<double, 4> inverse = {free[2] / det, -free[1] / det, -free[1] / det,
                                                   free[0] / det};
            const std::array<double, 4> rest = {1.0 - at(plain.m_wall, 0), -at(plain.m_wall, 1),
                                                -at(plain.m_wall, 1), 1.0 - at(plain.m_wall, 2)};
            for (std::size_t k = 0; k < 2; ++k) {
                for (std::size_t l = 0; l < 2; ++l) {
                    const double exact = rest[2 * k] * inverse[l] + rest[2 * k + 1] * inverse[2 + l];
                    EXPECT_NEAR(correction[i][2 * k + l], exact, 4.0 * rounding);
                }
            }
        }
        // The velocity gradient is corrected by M_fluid alone.
        const double det =
            at(plain.m_fluid, 0) * at(plain.m_fluid, 2) - at(plain.m_fluid, 1) * at(plain.m_fluid, 1);
        const double fluid_half = 0.5 * (at(plain.m_fluid, 0) - at(plain.m_fluid, 2));
        const double fluid_smallest =
            0.5 * (at(plain.m_fluid, 0) + at(plain.m_fluid, 2)) -
            std::sqrt(fluid_half * fluid_half + at(plain.m_fluid, 1) * at(plain.m_fluid, 1));
        if (fluid_smallest > 0.301) {
            const std::array<double, 4> inverse = {at(plain.m_fluid, 2) / det, -at(plain.m_fluid, 1) / det,
                                                   -at(plain.m_fluid, 1) / det, at(plain.m_fluid, 0) / det};
            for (std::size_t k = 0; k < 2; ++k) {
                for (std::size_t l = 0; l < 2; ++l) {
                    const double exact = at(plain.gradient, 2 * k) * inverse[l] +
                                         at(plain.gradient, 2 * k + 1) * inverse[2 + l];
                    const double magnitude =
                        plain.gradient[2 * k][i].magnitude + plain.gradient[2 * k + 1][i].magnitude;
                    EXPECT_NEAR(static_cast<double>(data.gradient.velocity_gradient[2 * k + l][slot]), exact,
                                4.0 * rounding * magnitude);
                }
            }
        }
    }
    for (std::size_t i = 0; i < sample.wall.size(); ++i) {
        const std::size_t slot = run.wall_slot(i);
        expect_near(plain.wall_weight, i, data.wall.weight, slot, "wall weight");
        expect_near(plain.wall_pressure, i, data.wall.pressure, slot, "wall pressure");
        expect_near(plain.wall_density_rate, i, data.wall.density_rate, slot, "wall density rate");
        for (std::size_t k = 0; k < 2; ++k) {
            expect_near(plain.wall_offset[k], i, data.wall.offset[k], slot, "wall offset");
            expect_near(plain.wall_velocity[k], i, data.wall.velocity[k], slot, "wall velocity");
        }
    }
}

std::string name_of(const testing::TestParamInfo<Option>& info) {
    return instruction_set_name(info.param.set) +
           (info.param.kernel == KernelKind::wendland_c2 ? "_wendland" : "_cubic") +
           (info.param.viscosity == ViscosityForm::morris ? "_morris" : "_gingold") +
           (info.param.layers > 0 ? "_walls" : "_periodic");
}

std::vector<Option> all_options() {
    std::vector<Option> options;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        for (const KernelKind kernel : {KernelKind::wendland_c2, KernelKind::cubic_spline}) {
            for (const ViscosityForm viscosity : {ViscosityForm::morris, ViscosityForm::monaghan_gingold}) {
                for (const int layers : {0, 3}) {
                    options.push_back({set, kernel, viscosity, layers});
                }
            }
        }
    }
    return options;
}

class PairLoopsTest : public testing::TestWithParam<Option> {};

TEST_P(PairLoopsTest, SingleEqualsPlainSums) { compare_with_plain_sums<float>(GetParam()); }
TEST_P(PairLoopsTest, DoubleEqualsPlainSums) { compare_with_plain_sums<double>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, PairLoopsTest, testing::ValuesIn(all_options()), name_of);

TEST(PairLoops, ActiveSetIsOffered) {
    const PairLoops<2, float> loops = pair_loops<2, float>({});
    EXPECT_NE(loops.gradient, nullptr);
    EXPECT_NE(loops.force, nullptr);
    EXPECT_NE(loops.wall, nullptr);
    EXPECT_NE(loops.filter, nullptr);
    EXPECT_EQ(instruction_set_name(InstructionSet::baseline), "baseline");
}

}  // namespace
}  // namespace riffle
