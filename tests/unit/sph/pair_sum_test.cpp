// The sums beside the pair loops: density diffusion of Antuono et al. and Shepard's correction.

#include "sph/pair_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "loop_run.hpp"

namespace riffle::pair_sum_test {
namespace {

/// f(slot, sums, lane) for all particles of a run; the sums start from `initial`.
template <int D, class F>
void complete_all(PairSum<D, double>& sweep, const LoopRun<D, double>& run,
                  const GradientResult<D, double>& initial, const F& f) {
    sweep.begin(run.data, run.clusters);
    const auto sums = std::make_unique<GradientResult<D, double>>();
    for (std::size_t begin = 0; begin < run.clusters.size(); begin += block_clusters) {
        const std::size_t end = std::min(run.clusters.size(), begin + block_clusters);
        *sums = initial;
        sweep.complete(run.data, run.clusters, begin, end, *sums);
        for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
            if (run.clusters.particle_of(slot) >= 0) f(slot, *sums, slot - begin * cluster_size);
        }
    }
}

template <int D>
PairSumConstants<D> constants_of(const PairSample<D>& sample) {
    return {sample.fixed_point, KernelKind::wendland_c2, sample.h};
}

/// ds/dt of Antuono's diffusion of coefficient 1, by fluid particle.
template <int D>
std::vector<double> antuono(const PairSample<D>& sample) {
    LoopRun<D, double> run(sample, {});
    const auto sweep = make_antuono_diffusion<D, double>(constants_of(sample), 1.0);
    std::vector<double> by_slot(run.clusters.slots());
    const auto initial = std::make_unique<GradientResult<D, double>>();
    complete_all<D>(*sweep, run, *initial, [&](std::size_t slot, const auto& sums, std::size_t lane) {
        by_slot[slot] = sums.diffusion[lane];
    });
    std::vector<double> rate;
    for (const std::size_t slot : run.fluid_slot) rate.push_back(by_slot[slot]);
    return rate;
}

template <int D>
bool far_from_all_seams(const PairSample<D>& sample, const typename PairSample<D>::Particle& p) {
    bool far = true;
    for (std::size_t k = 0; k + 1 < D; ++k) {
        far = far && p.x[k] > sample.domain.lower[k] + 4.0 * sample.h &&
              p.x[k] < sample.domain.upper[k] - 4.0 * sample.h;
    }
    return far;
}

template <class Dimension>
class PairSumIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PairSumIn, Dimensions);

// In disordered water between wall and free surface; the gradients of its neighbours count too, so functions
// that jump at the periodic seams are looked at 4h from them. In three dimensions, 8 spacings wide, the
// density varies with height alone.
TYPED_TEST(PairSumIn, AntuonoLeavesALinearDensityAlone) {
    constexpr int D = TypeParam::value;
    PairSample<D> sample = disordered_sample<D>(0.2, 3, 1);
    double largest = 0.0;
    for (auto& p : sample.fluid) p.s = 0.01 * p.x[D - 1] + (D == 2 ? 0.004 * p.x[0] : 0.0);
    const std::vector<double> rate = antuono<D>(sample);
    int looked_at = 0;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        if (D == 3 || far_from_all_seams(sample, sample.fluid[i])) {
            largest = std::max(largest, std::abs(rate[i]));
            ++looked_at;
        }
    }
    EXPECT_GT(looked_at, 20);
    // Of the sums of the differences alone each would be about s'/h at wall and surface.
    EXPECT_LT(largest, 1e-10 * 0.01 / sample.h);
}

// Each pair takes from the one what it gives to the other, and evens out.
TYPED_TEST(PairSumIn, AntuonoKeepsTheVolumeAndEvensOut) {
    constexpr int D = TypeParam::value;
    const PairSample<D> sample = disordered_sample<D>(0.2, 3, 2);
    const std::vector<double> rate = antuono<D>(sample);
    double sum = 0.0;
    double sum_of_sizes = 0.0;
    double growth = 0.0;
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const auto& p = sample.fluid[i];
        sum += p.volume * rate[i];
        sum_of_sizes += p.volume * std::abs(rate[i]);
        growth += p.volume * p.s * rate[i];
    }
    EXPECT_GT(sum_of_sizes, 0.0);
    EXPECT_LT(std::abs(sum), 1e-12 * sum_of_sizes);
    EXPECT_LT(growth, 0.0);
}

TYPED_TEST(PairSumIn, ShepardIsTheInverseSumOfTheKernel) {
    constexpr int D = TypeParam::value;
    const PairSample<D> sample = disordered_sample<D>(0.2, 3, 3);
    LoopRun<D, double> run(sample, {});
    const auto sweep = make_shepard_correction<D, double>(constants_of(sample), true, true);
    const auto initial = std::make_unique<GradientResult<D, double>>();
    initial->regularity.fill(1.0);
    for (auto& component : initial->velocity_gradient) component.fill(2.0);
    std::vector<double> factor(run.clusters.slots());
    std::vector<double> gradient(run.clusters.slots());
    complete_all<D>(*sweep, run, *initial, [&](std::size_t slot, const auto& sums, std::size_t lane) {
        factor[slot] = sums.correction[0][lane];
        gradient[slot] = sums.velocity_gradient[1][lane];
        EXPECT_EQ(sums.correction[1][lane], 0.0);
        EXPECT_EQ(sums.correction[D * D - 1][lane], factor[slot]);
        EXPECT_EQ(sums.viscosity_factor[lane], factor[slot]);
    });
    const ScalarKernel kernel = scalar_kernel<D>(KernelKind::wendland_c2);
    for (std::size_t i = 0; i < sample.fluid.size(); ++i) {
        const auto sum_over = [&](const auto& particles) {
            double sum = 0.0;
            for (const auto& p : particles) {
                double squared = 0.0;
                for (const double r : sample.difference(sample.fluid[i].x, p.x)) squared += r * r;
                sum += p.volume * kernel.value(std::sqrt(squared) / sample.h) / std::pow(sample.h, D);
            }
            return sum;
        };
        const double fluid = sum_over(sample.fluid);
        EXPECT_NEAR(gradient[run.fluid_slot[i]], 2.0 / fluid, 1e-12 / fluid);
        EXPECT_NEAR(factor[run.fluid_slot[i]], 1.0 / (fluid + sum_over(sample.wall)), 1e-12 / fluid);
    }
}

// Where the kernel reaches out of the water the correction fades out.
TEST(ShepardCorrection, FadesOutAtTheSurface) {
    const PairSample<2> sample = disordered_sample<2>(0.1, 3, 4);
    LoopRun<2, double> run(sample, {});
    const auto sweep = make_shepard_correction<2, double>(constants_of(sample), true, false);
    const auto initial = std::make_unique<GradientResult<2, double>>();
    initial->regularity.fill(0.6);
    initial->velocity_gradient[0].fill(2.0);
    complete_all<2>(*sweep, run, *initial, [&](std::size_t, const auto& sums, std::size_t lane) {
        EXPECT_EQ(sums.correction[0][lane], 1.0);
        EXPECT_EQ(sums.correction[3][lane], 1.0);
        EXPECT_EQ(sums.velocity_gradient[0][lane], 2.0) << "not asked for";
    });
}

}  // namespace
}  // namespace riffle::pair_sum_test
