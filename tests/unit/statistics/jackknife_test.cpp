#include "statistics/jackknife.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace riffle::jackknife_test {
namespace {

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

TEST(Jackknife, OfAMeanIsTheTextbookInterval) {
    // Of a mean the jackknife is exact: s/sqrt(n) times Student's t (2.776 for 4 degrees of freedom).
    const std::vector<double> blocks = {1.0, 4.0, 2.0, 5.0, 3.0};
    std::vector<double> without;
    for (std::size_t b = 0; b < blocks.size(); ++b) without.push_back(mean_without(blocks, 1, b)[0]);
    EXPECT_NEAR(jackknife_half_width(without), 2.776445 * std::sqrt(2.5 / 5.0), 1e-5);
}

TEST(Jackknife, CoversARatioOfMeans) {
    // 400 trials of a 95 % interval scatter by 1.1 %: 91.7-98.3 % is three standard deviations.
    std::normal_distribution<double> normal;
    int covered = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(trial));
        std::vector<double> blocks;
        for (int b = 0; b < 20; ++b) {
            const double common = normal(generator);
            blocks.push_back(3.0 + common + 0.2 * normal(generator));
            blocks.push_back(6.0 + common);
        }
        const auto ratio = [](const std::vector<double>& m) { return m[0] / m[1]; };
        std::vector<double> without;
        for (std::size_t b = 0; b < 20; ++b) without.push_back(ratio(mean_without(blocks, 2, b)));
        covered +=
            std::abs(ratio(mean_without(blocks, 2, all)) - 0.5) <= jackknife_half_width(without) ? 1 : 0;
    }
    EXPECT_GE(covered, 367);
    EXPECT_LE(covered, 393);
}

TEST(Jackknife, LeavesOutWhatIsNotThere) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> blocks = {1.0, nan, 3.0, 10.0, 5.0, 20.0};
    EXPECT_EQ(mean_without(blocks, 2, all), (std::vector<double>{3.0, 15.0}));
    EXPECT_EQ(mean_without(blocks, 2, 0), (std::vector<double>{4.0, 15.0}));
}

TEST(Jackknife, WithoutTwoFiniteValuesThereIsNoInterval) {
    EXPECT_TRUE(std::isinf(jackknife_half_width(std::vector<double>{1.0})));
    EXPECT_TRUE(std::isinf(jackknife_half_width(std::vector<double>{1.0, std::nan("")})));
}

}  // namespace
}  // namespace riffle::jackknife_test
