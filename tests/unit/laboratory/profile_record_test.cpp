#include "laboratory/profile_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hydraulics/law_fits.hpp"
#include "hydraulics/log_law.hpp"
#include "laboratory/velocity_series.hpp"
#include "laboratory_file.hpp"

namespace riffle::profile_record_test {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::LaboratoryFile;
using testing::message_of;
using Q = ProfileQuantity;

TEST(ProfileRecord, ExampleHasItsKnownAnswer) {
    const ProfileRecord record = read_profile_record(example("adv-profile.csv"));
    EXPECT_EQ(record.z.size(), 21U);
    EXPECT_DOUBLE_EQ(record.z.front(), 0.005);
    EXPECT_TRUE(record.warnings.empty());
    const ProfileColumn* u = record.find(Q::velocity);
    ASSERT_NE(u, nullptr);
    EXPECT_EQ(u->uncertainty.size(), 21U);
    const LogLawFit fit = fit_log_law({record.z, u->values, u->uncertainty}, log_law_kappa);
    ASSERT_TRUE(fit.valid);
    // One sample: its intervals miss in one of twenty, twice their width in one of a thousand.
    EXPECT_NEAR(fit.friction_velocity, 0.044, 2 * fit.friction_velocity_half_width);
    EXPECT_NEAR(fit.equivalent_roughness, 0.035, 2 * fit.equivalent_roughness_half_width);
    EXPECT_NEAR(fit.residual_rms, 0.003, 0.0015);
    ASSERT_NE(record.find(Q::reynolds_stress), nullptr);
    EXPECT_DOUBLE_EQ(record.find(Q::reynolds_stress)->values.front(), 17.178e-4);
    EXPECT_EQ(record.find(Q::spanwise_velocity), nullptr);
}

TEST(ProfileRecord, SortsTurnsSignsAndTellsWhatItLeaves) {
    const LaboratoryFile file(
        "Height [cm];U_mean [cm/s];u'w' [cm2/s2];SNR [1]\n2;30;-10;15\n1;20;-12;15\n3;;-8;15\n");
    const ProfileRecord record = read_profile_record(file.path());
    EXPECT_EQ(record.z, (std::vector<double>{0.01, 0.02, 0.03}));
    EXPECT_EQ(record.find(Q::velocity)->values[0], 0.2);
    EXPECT_DOUBLE_EQ(record.find(Q::reynolds_stress)->values[2], 8e-4);
    EXPECT_EQ(record.lines, (std::vector<int>{3, 2, 4}));
    ASSERT_EQ(record.warnings.size(), 2U);
    EXPECT_THAT(record.warnings[0], HasSubstr("column 4 (SNR) is not used"));
    EXPECT_THAT(record.warnings[1], HasSubstr("u: 1 of 3 points have no value"));
}

TEST(ProfileRecord, TakesFilesWithoutNamesAsHeightVelocityUncertainty) {
    const LaboratoryFile file("0.01,0.3,0.01\n0.02,0.35,0.02\n");
    const ProfileRecord record = read_profile_record(file.path());
    EXPECT_EQ(record.find(Q::velocity)->values[1], 0.35);
    EXPECT_EQ(record.find(Q::velocity)->uncertainty[0], 0.01);
}

TEST(ProfileRecord, SaysWhatIsWrong) {
    const auto message = [](const char* text) {
        const LaboratoryFile file(text);
        return message_of([&] { return read_profile_record(file.path()); });
    };
    EXPECT_THAT(message("z,u\n1,2\n1,3\n"), HasSubstr(":3: expected one point for each height"));
    EXPECT_THAT(message("u,w\n1,2\n"), HasSubstr(":1: expected a column z"));
    EXPECT_THAT(message("z,u,U\n1,2,3\n"), HasSubstr(":1: column 3 (U) is there twice"));
    EXPECT_THAT(message("z,u,u_uncertainty\n1,2,0.1\n2,3,-0.1\n"),
                HasSubstr(":3: expected an uncertainty greater"));
    EXPECT_THAT(message("z,w_uncertainty\n1,2\n"), HasSubstr("but not w"));
    EXPECT_THAT(message("1,2,3,4\n"), HasSubstr("got 4 columns"));
    // Velocities must not become heights because nobody knows the names of the columns.
    EXPECT_THAT(message("speed,elevation\n0.2,0.01\n"), HasSubstr(":1: expected the columns z, u"));
    EXPECT_THAT(message("z [s],u\n1,2\n"), HasSubstr("expected a unit like [m]"));
}

TEST(VelocitySeries, ExampleHasItsKnownAnswer) {
    const VelocitySeries series = read_velocity_series(example("adv-point.csv"));
    EXPECT_EQ(series.z, 0.020);
    EXPECT_EQ(series.sampling_frequency, 25.0);
    EXPECT_EQ(series.u.quality.refused, 10U);
    EXPECT_GE(series.u.quality.spikes, 12U);  // those put in, and about three by chance
    EXPECT_LE(series.u.quality.spikes, 24U);
    EXPECT_EQ(series.u.quality.left, 0U);
    const PointStatistics s = point_statistics(series);
    EXPECT_EQ(s.samples, 2500U);
    // A fixed sample of seven 95 % intervals: each misses in one of twenty, twice its width in one of ten
    // thousand.
    const auto expect = [](const Estimate& statistic, double truth) {
        EXPECT_NEAR(statistic.value, truth, 2 * statistic.half_width);
    };
    expect(s.u, 0.28);
    expect(s.v, 0.0);
    expect(s.w, 0.0);
    expect(s.u_rms, 0.080);
    expect(s.v_rms, 0.060);
    expect(s.w_rms, 0.045);
    expect(s.reynolds_stress, 0.00144);
    // The integral time of memory 0.8 is (1 + 0.8)/(2 (1 - 0.8)) = 4.5 samples, so that 2500 samples are
    // worth 278.
    EXPECT_NEAR(s.u.half_width, 1.96 * 0.080 / std::sqrt(2500 / 9.0), 0.3 * 0.0094);
}

TEST(VelocitySeries, MakeAProfile) {
    const LaboratoryFile upper(
        "# z: 30 mm\n# sampling_frequency: 10 Hz\nu [cm/s],w [cm/s]\n30,1\n32,-1\n30,1\n32,-1\n");
    const LaboratoryFile lower(
        "# z: 10 mm\nt [s],u [cm/s],w [cm/s]\n0,20,2\n0.1,22,-2\n0.2,20,2\n0.3,22,-2\n");
    const std::vector<VelocitySeries> series{read_velocity_series(upper.path()),
                                             read_velocity_series(lower.path())};
    const ProfileRecord profile = profile_of_series(series);
    EXPECT_EQ(profile.z, (std::vector<double>{0.01, 0.03}));
    EXPECT_NEAR(profile.find(Q::velocity)->values[0], 0.21, 1e-15);
    const PointStatistics point = point_statistics(series[1]);  // of the lower point
    EXPECT_GT(point.u_rms.value, 0.0);
    EXPECT_EQ(profile.find(Q::streamwise_rms)->values[0], point.u_rms.value);
    EXPECT_GT(point.reynolds_stress.value, 0.0);  // u' and w' are opposed
    EXPECT_EQ(profile.find(Q::reynolds_stress)->values[0], point.reynolds_stress.value);
    EXPECT_DOUBLE_EQ(profile.find(Q::velocity)->uncertainty[0], point.u.half_width / 1.96);
    EXPECT_EQ(profile.find(Q::spanwise_velocity), nullptr);
    const std::vector<VelocitySeries> same{series[0], series[0]};
    EXPECT_THAT(message_of([&] { return profile_of_series(same); }), HasSubstr("the same height"));
    const LaboratoryFile nowhere("# sampling_frequency: 10 Hz\nu [m/s]\n1\n2\n");
    const std::vector<VelocitySeries> unknown{read_velocity_series(nowhere.path())};
    EXPECT_THAT(message_of([&] { return profile_of_series(unknown); }), HasSubstr("# z: 12 mm"));
}

}  // namespace
}  // namespace riffle::profile_record_test
