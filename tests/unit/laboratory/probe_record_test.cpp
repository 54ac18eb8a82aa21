#include "laboratory/probe_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "laboratory_file.hpp"

namespace riffle::probe_record_test {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::LaboratoryFile;
using testing::message_of;

TEST(ProbeCalibration, IntervalsHoldTheTruthInNinetyFiveOfAHundred) {
    // 3.3 standard deviations of the binomial distribution.
    constexpr int trials = 600;
    const double band = 3.3 * std::sqrt(0.95 * 0.05 * trials);
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    int offset = 0;
    int gain = 0;
    int elevation = 0;
    for (int i = 0; i < trials; ++i) {
        std::vector<double> volts;
        std::vector<double> levels;
        for (int j = 0; j < 9; ++j) {
            volts.push_back(4.0 + 0.25 * j);
            levels.push_back(-0.041 + 0.0182 * volts.back() + 5e-5 * normal(generator));
        }
        const ProbeCalibration c = fit_probe_calibration(volts, levels);
        offset += std::abs(c.offset + 0.041) <= c.offset_half_width;
        gain += std::abs(c.gain - 0.0182) <= c.gain_half_width;
        elevation += std::abs(c.elevation(5.1) - (-0.041 + 0.0182 * 5.1)) <= c.elevation_half_width(5.1);
    }
    EXPECT_NEAR(offset, 0.95 * trials, band);
    EXPECT_NEAR(gain, 0.95 * trials, band);
    EXPECT_NEAR(elevation, 0.95 * trials, band);
}

TEST(ProbeCalibration, ReadsDescriptions) {
    const ProbeDescription p = parse_probe_description(" P1 : x = 28 mm, offset=-12.3 mm; gain = 20.4 mm/V");
    EXPECT_EQ(p.name, "P1");
    EXPECT_EQ(p.x, std::optional<double>(0.028));
    EXPECT_FALSE(p.y);
    EXPECT_DOUBLE_EQ(p.gain.value(), 0.0204);
    EXPECT_EQ(parse_probe_description("P2").name, "P2");
    const auto message = [](const char* text) {
        return message_of([text] { return parse_probe_description(text); });
    };
    EXPECT_THAT(message("P1: x = 28 V"), HasSubstr("\"28 V\" is no number with a unit like m"));
    EXPECT_THAT(message("P1: z = 28 mm"), HasSubstr("\"z\" is not known"));
    EXPECT_THAT(message("P1: x = 1, x = 2"), HasSubstr("twice"));
    EXPECT_THAT(message("P1: gain 3"), HasSubstr("key = value"));
    EXPECT_THAT(message("P1: gain = 0"), HasSubstr("gain of 0"));
    EXPECT_THAT(message(": x = 1"), HasSubstr("no name"));
}

/// Mean and standard deviation of the values that there are.
std::pair<double, double> moments(std::vector<double> x) {
    std::erase_if(x, [](double v) { return std::isnan(v); });
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    double sum = 0;
    for (const double v : x) sum += (v - mean) * (v - mean);
    return {mean, std::sqrt(sum / static_cast<double>(x.size()))};
}

/// Lag (samples) of the largest correlation of b behind a.
int lag_of_maximum(const std::vector<double>& a, const std::vector<double>& b, int longest) {
    const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / static_cast<double>(a.size());
    const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / static_cast<double>(b.size());
    int best = 0;
    double largest = -1;
    for (int lag = 0; lag <= longest; ++lag) {
        double sum = 0;
        for (std::size_t i = 0; i + static_cast<std::size_t>(lag) < a.size(); ++i) {
            sum += (a[i] - mean_a) * (b[i + static_cast<std::size_t>(lag)] - mean_b);
        }
        if (sum > largest) {
            largest = sum;
            best = lag;
        }
    }
    return best;
}

TEST(ProbeRecord, ExampleHasItsKnownAnswer) {
    const ProbeRecord record = read_probe_record(example("wave-probes.csv"));
    ASSERT_EQ(record.probes.size(), 4U);
    EXPECT_NEAR(record.sampling_frequency, 100.0, 1e-6);
    EXPECT_EQ(record.samples(), 4000U);
    const double x[] = {0.0, 0.028, 0.1203, 0.3003};
    // Of the sample, in the comments of the file; noise of 0.01 mm adds in squares.
    const double deviation[] = {0.3724e-3, 0.3718e-3, 0.3703e-3, 0.3692e-3};
    for (std::size_t i = 0; i < 4; ++i) {
        const WaveProbe& probe = record.probes[i];
        EXPECT_DOUBLE_EQ(probe.x, x[i]);
        EXPECT_EQ(probe.quality.left, i == 1 ? 7U : 0U);  // the gap of P2 that is too long to be interpolated
        const auto [mean, standard_deviation] = moments(probe.elevation);
        EXPECT_NEAR(standard_deviation, std::hypot(deviation[i], 0.01e-3), 2e-6) << probe.name;
        EXPECT_NEAR(mean, 0.05, 1e-4);
    }
    EXPECT_EQ(record.probes[0].quality.missing, 2U);  // the lost rows
    EXPECT_EQ(record.probes[1].quality.missing, 14U);
    EXPECT_EQ(record.probes[1].quality.gaps, 4U);
    EXPECT_EQ(record.probes[1].quality.longest_gap, 7U);
    // Eight spikes were put into P3; of clean records about three samples are taken for spikes, at most 12.
    EXPECT_GE(record.probes[2].quality.spikes, 8U);
    EXPECT_LE(record.probes[2].quality.spikes, 20U);
    EXPECT_LE(record.probes[0].quality.spikes, 12U);
    EXPECT_EQ(record.warnings.size(), 4U);  // one sentence for each probe
    // Celerity 0.36 m/s: the pattern needs 83.4 samples from P1 to P4; the largest correlation is found to a
    // sample.
    EXPECT_NEAR(lag_of_maximum(record.probes[0].elevation, record.probes[3].elevation, 150), 83.4, 1.0);
}

TEST(ProbeRecord, TakesCalibrationsFromAFile) {
    ProbeRecordOptions options;
    options.calibrations = read_probe_calibrations(example("probe-calibration.csv"));
    ASSERT_EQ(options.calibrations.size(), 4U);
    const double offset[] = {-41.0e-3, -38.5e-3, -40.2e-3, -39.7e-3};
    const double gain[] = {18.2e-3, 17.6e-3, 18.9e-3, 18.4e-3};
    for (std::size_t i = 0; i < 4; ++i) {
        const ProbeCalibration& c = options.calibrations[i].calibration;
        // A fixed sample of eight intervals: each misses in one of twenty, twice its width in one of a
        // thousand.
        EXPECT_NEAR(c.offset, offset[i], 2 * c.offset_half_width);
        EXPECT_NEAR(c.gain, gain[i], 2 * c.gain_half_width);
        EXPECT_LT(c.gain_half_width, 0.01 * gain[i]);
        EXPECT_EQ(c.points, 11U);
    }
    const ProbeRecord plain = read_probe_record(example("wave-probes.csv"));
    const ProbeRecord fitted = read_probe_record(example("wave-probes.csv"), options);
    ASSERT_TRUE(fitted.probes[0].calibration->fit);
    EXPECT_NEAR(fitted.probes[0].elevation[10], plain.probes[0].elevation[10],
                2 * fitted.probes[0].calibration->elevation_half_width(5.0));
}

TEST(ProbeRecord, TakesElevationsAndOptions) {
    const LaboratoryFile file("A [mm],B [mm]\n50,51\n52,53\n51,52\n");
    ProbeRecordOptions options;
    options.sampling_frequency = 50.0;
    options.probes = {parse_probe_description("B: x = 12 mm, y = 5 mm")};
    const ProbeRecord record = read_probe_record(file.path(), options);
    EXPECT_EQ(record.probes[1].elevation, (std::vector<double>{0.051, 0.053, 0.052}));
    EXPECT_EQ(record.probes[1].x, 0.012);
    EXPECT_EQ(record.probes[1].y, 0.005);
    EXPECT_TRUE(std::isnan(record.probes[0].x));
    EXPECT_DOUBLE_EQ(record.time(2), 0.04);
    ASSERT_EQ(record.warnings.size(), 1U);
    EXPECT_THAT(record.warnings[0], HasSubstr("A: its position x is not known"));
}

TEST(ProbeRecord, WarnsOfVoltagesOutsideOfTheCalibration) {
    const LaboratoryFile calibration("level [mm],A [V],Z [V]\n40,4,1\n50,5,2\n61,6,3\n");
    const LaboratoryFile file("# sampling_frequency: 10 Hz\n# probe A: x = 0 mm\nA [V]\n5\n6.5\n5.5\n");
    ProbeRecordOptions options;
    options.calibrations = read_probe_calibrations(calibration.path());
    const ProbeRecord record = read_probe_record(file.path(), options);
    ASSERT_EQ(record.warnings.size(), 2U);
    EXPECT_THAT(record.warnings[0], HasSubstr("calibration of Z is not used"));
    EXPECT_THAT(record.warnings[1], HasSubstr("1 samples lie outside of the calibrated 4 to 6 V"));
}

TEST(ProbeRecord, SaysWhatIsMissing) {
    const auto message = [](const char* text, const ProbeRecordOptions& options = {}) {
        const LaboratoryFile file(text);
        return message_of([&] { return read_probe_record(file.path(), options); });
    };
    EXPECT_THAT(message("t [s],A [V]\n0,1\n1,2\n"),
                HasSubstr("column 2 (A) holds voltages: expected a calibration"));
    EXPECT_THAT(message("A [mm]\n1\n2\n"), HasSubstr("# sampling_frequency"));
    EXPECT_THAT(message("t [s],A\n0,1\n1,2\n"),
                HasSubstr(":1: expected a unit of voltage or length for column 2 (A)"));
    EXPECT_THAT(message("0,1\n1,2\n"), HasSubstr("expected a header line"));
    EXPECT_THAT(message("# probe B: x = 0\nt [s],A [mm]\n0,1\n1,2\n"), HasSubstr("probe \"B\" is described"));
    EXPECT_THAT(message("# probe A: x == 0\nt [s],A [mm]\n0,1\n1,2\n"), HasSubstr(":1: probe"));
    EXPECT_THAT(message("# probe A: gain = 1 mm/V\nt [s],A [mm]\n0,1\n1,2\n"),
                HasSubstr("take no calibration"));
    EXPECT_THAT(message("# sampling_frequency: often\nA [mm]\n1\n2\n"), HasSubstr("got \"often\""));
    EXPECT_THAT(message("t [s],A [mm]\n0,1\n0.1,2\n0.25,2\n0.3,2\n0.4,2\n"),
                HasSubstr(":4: the times are not evenly"));
    ProbeRecordOptions options;
    options.probes = {parse_probe_description("C: x = 1 m")};
    EXPECT_THAT(message("t [s],A [mm]\n0,1\n1,2\n", options),
                HasSubstr("there is no probe \"C\"; the columns are A"));
}

}  // namespace
}  // namespace riffle::probe_record_test
