#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/depth_correlation.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/velocity_spectra.hpp"
#include "base/error.hpp"
#include "case/flow_conditions.hpp"
#include "synthetic.hpp"

namespace riffle::depth_test {
namespace {

using synthetic::autoregressive;

constexpr double interval = 0.02;

/// Records that share with the reference a part r(z) = 1 - (1 - z)/0.4, z from 0.6 to 1; constant at 0.5.
struct Shared {
    std::vector<double> reference;
    std::vector<HeightRecord> records;

    explicit Shared(std::uint64_t seed, std::size_t n = 1500) {
        std::mt19937_64 generator(seed);
        reference = autoregressive(n, 0.8, generator);
        for (int i = 0; i <= 8; ++i) {
            const double z = 0.6 + 0.05 * i;
            const double r = 1.0 - (1.0 - z) / 0.4;
            const std::vector<double> own = autoregressive(n, 0.8, generator);
            records.push_back({z, {}});
            for (std::size_t j = 0; j < n; ++j) {
                records.back().values.push_back(r * reference[j] + std::sqrt(1 - r * r) * own[j]);
            }
        }
        records.push_back({0.5, std::vector<double>(n, 0.0)});
    }
};

TEST(DepthCorrelation, FindsTheSharedPartAndTheInfluenceDepth) {
    // r = 0.5 at z = 0.8. In 100 trials of a 95 % interval: three standard deviations are 6.5 %.
    int covered = 0;
    double mean = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Shared data(seed);
        const auto correlations = depth_correlation(data.records, data.reference, interval, 0.2);
        ASSERT_EQ(correlations.size(), 9U);  // the constant one is left out
        EXPECT_NEAR(correlations.back().correlation.value, 1.0, 1e-12);
        const auto depth = influence_depth(correlations, 1.0);
        ASSERT_TRUE(depth);
        EXPECT_LE(depth->lower, depth->z);
        EXPECT_GE(depth->upper, depth->z);
        covered += depth->lower <= 0.8 && depth->upper >= 0.8;
        mean += depth->z / 100;
    }
    std::printf("influence depth: covered %d %%, mean %.4f\n", covered, mean);
    EXPECT_GE(covered, 89);
    EXPECT_NEAR(mean, 0.8, 0.005);
}

TEST(DepthCorrelation, LagTellsWhichFollows) {
    std::mt19937_64 generator(3);
    const std::vector<double> all = autoregressive(4010, 0.9, generator);
    const std::vector<double> reference(all.begin() + 10, all.end());
    // What passes the reference appears 10 samples later at the height.
    const std::vector<HeightRecord> later = {{0.5, std::vector<double>(all.begin(), all.end() - 10)}};
    const auto c = depth_correlation(later, reference, interval, 0.5);
    ASSERT_TRUE(c.front().extreme);
    EXPECT_NEAR(c.front().extreme->lag, 10 * interval, interval);
    EXPECT_NEAR(c.front().extreme->correlation, 1.0, 0.02);
}

TEST(DepthCorrelation, WithoutCrossingThereIsNoDepth) {
    const Shared data(1);
    const auto correlations = depth_correlation(data.records, data.reference, interval, 0.2);
    EXPECT_FALSE(influence_depth(correlations, 0.7));        // below the threshold from the start
    EXPECT_FALSE(influence_depth(correlations, 1.0, -0.9));  // nowhere
    const std::vector<double> shorter(10, 1.0);
    EXPECT_TRUE(depth_correlation(data.records, std::vector<double>(1500, 1.0), interval, 0.2).empty());
    std::vector<double> other = {1.0, 2.0};
    EXPECT_THROW((void)depth_correlation(data.records, other, interval, 0.2), InputError);
}

/// Noise whose spectrum falls with -5/3 from `from` Hz on, by the sum of waves of random phase.
std::vector<double> inertial_record(std::size_t n, double from, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    std::vector<Complex> spectrum(n / 2 + 1);
    for (std::size_t m = 1; m < spectrum.size(); ++m) {
        const double f = static_cast<double>(m) / (static_cast<double>(n) * interval);
        const double amplitude = std::sqrt(std::pow(std::max(f, from), -5.0 / 3.0));
        spectrum[m] = Complex(amplitude * normal(generator), amplitude * normal(generator));
    }
    return inverse_fourier_transform(spectrum, n);
}

TEST(VelocitySpectra, FindTheFiveThirdsSlope) {
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        std::mt19937_64 generator(seed);
        const std::vector<HeightRecord> records = {{0.03, inertial_record(8192, 1.0, generator)}};
        const VelocitySpectrum s = velocity_spectra(records, interval, FrequencyBand{2.0, 15.0}).front();
        ASSERT_TRUE(s.slope);
        covered += std::abs(s.slope->slope.value + 5.0 / 3.0) <= s.slope->slope.half_width;
        // The line of slope -5/3 passes the density where the band has its middle.
        const double middle = std::sqrt(2.0 * 15.0);
        const double fitted = s.slope->coefficient * std::pow(middle, s.slope->slope.value);
        EXPECT_NEAR(std::log(*s.five_thirds_level * std::pow(middle, -5.0 / 3.0) / fitted), 0.0, 0.15);
    }
    std::printf("slope -5/3 covered %d %%\n", covered);
    EXPECT_GE(covered, 89);
}

TEST(VelocitySpectra, OwnBandLiesAboveTheEnergyContainingEddies) {
    std::mt19937_64 generator(2);
    const std::vector<HeightRecord> records = {{0.03, inertial_record(8192, 1.0, generator)}};
    const VelocitySpectrum s = velocity_spectra(records, interval).front();
    ASSERT_TRUE(s.slope);
    // f S is largest at 1 Hz, within the scatter of the bins.
    EXPECT_GT(s.band.from, 1.5);
    EXPECT_LT(s.band.from, 5.0);
    EXPECT_DOUBLE_EQ(s.band.to, 12.5);
}

TEST(VelocitySpectra, NamesTheHeightThatFellDry) {
    std::vector<HeightRecord> records = {{0.045, std::vector<double>(100, 0.1)}};
    records[0].values[7] = std::numeric_limits<double>::quiet_NaN();
    try {
        (void)velocity_spectra(records, interval);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("z = 0.045 m"), std::string::npos);
    }
    EXPECT_THROW((void)velocity_spectra(std::vector<HeightRecord>{{0.1, {1.0, 2.0}}}, interval), InputError);
}

/// A run with the velocities of two instruments.
class TwoInstruments : public FlowRecord {
  public:
    Case flow_case = builtin_case("condition-2");
    std::vector<VelocityProbe> probes;
    [[nodiscard]] std::string name() const override { return "run"; }
    [[nodiscard]] std::string source() const override { return "run"; }
    [[nodiscard]] Origin origin() const override { return Origin::simulated; }
    [[nodiscard]] const Case* flow() const override { return &flow_case; }
    [[nodiscard]] TimeWindow window() const override { return {0.0, 30.0}; }
    [[nodiscard]] const std::vector<VelocityProbe>& velocity_probes() const override { return probes; }
};

TEST(Subsurface, TakesTheUsersInstrumentAndNoDepthFromOneSpacing) {
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    const auto probe = [&](const char* name, std::size_t points) {
        VelocityProbe result;
        result.name = name;
        for (std::size_t i = 0; i < points; ++i) {
            result.x.push_back(0.1);
            result.z.push_back(0.01 + 0.004 * static_cast<double>(i));
        }
        for (int row = 0; row < 1500; ++row) {
            result.time.push_back(interval * row);
            for (std::size_t i = 0; i < points; ++i) {
                result.u.push_back(0.3 + 0.02 * normal(generator));
                result.w.push_back(0.01 * normal(generator));  // independent of its neighbours
            }
        }
        return result;
    };
    TwoInstruments record;
    record.probes = {probe("standard_velocity", 10), probe("adv", 1)};
    const Analysis analysis = analyse(record, "subsurface");
    EXPECT_EQ(find_finding(analysis, "influence_depth"), nullptr);
    std::string warnings;
    for (const std::string& each : analysis.warnings) warnings += each + "\n";
    EXPECT_NE(warnings.find("not resolved"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("standard_velocity are used for the correlation over the depth only"),
              std::string::npos)
        << warnings;
    // The single point of the user's instrument stands at 10 mm.
    const Finding* const deviation = find_finding(analysis, "point_velocity_deviation");
    ASSERT_NE(deviation, nullptr);
    EXPECT_NE(deviation->label.find("z = 10 mm"), std::string::npos) << deviation->label;
}

}  // namespace
}  // namespace riffle::depth_test
