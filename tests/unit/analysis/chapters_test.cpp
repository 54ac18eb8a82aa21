// Whole analyses of made-up results files whose answers are known.

#include "analysis/chapters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "analysis/figure_keys.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/run_record.hpp"
#include "analysis/subsurface_parts.hpp"
#include "analysis_parts.hpp"
#include "base/error.hpp"
#include "sample_probes.hpp"
#include "sample_results.hpp"

namespace riffle::chapters_test {
namespace {

using testing::add_sample_probes;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using testing::figure;
using testing::finding;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::SampleOptions;
using testing::SampleProbes;
using testing::write_sample_results;

class Analyses : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path sample(const SampleOptions& options = {}, bool probes = true) {
        const std::filesystem::path path = folder_ / "results.h5";
        write_sample_results(path, options);
        if (probes) add_sample_probes(path);
        return path;
    }

    std::filesystem::path folder_;
};

void expect_sound(const Analysis& analysis) {
    std::set<std::string> chapters;
    for (const Chapter& chapter : analysis_chapters()) chapters.insert(chapter.name);
    std::set<std::string> keys;
    for (const Finding& each : analysis.findings) {
        EXPECT_TRUE(keys.insert(each.key).second) << "twice: " << each.key;
        EXPECT_TRUE(chapters.count(each.chapter)) << each.key << " in " << each.chapter;
        EXPECT_TRUE(std::isfinite(each.value)) << each.key;
        EXPECT_FALSE(each.label.empty() || each.unit.empty()) << each.key;
        EXPECT_GE(each.half_width.value_or(0.0), 0.0) << each.key;
        EXPECT_EQ(each.reference.has_value(), !each.reference_name.empty()) << each.key;
    }
    keys.clear();
    for (const Figure& each : analysis.figures) {
        EXPECT_TRUE(keys.insert(each.key).second) << "twice: " << each.key;
        EXPECT_TRUE(is_figure_key(each.key, each.chapter)) << each.key << " in " << each.chapter;
        EXPECT_EQ(each.missing.empty(), !each.curves.empty() || !each.maps.empty()) << each.key;
        EXPECT_FALSE(each.x.unit.empty() || each.y.unit.empty()) << each.key;
        for (const Curve& curve : each.curves) {
            EXPECT_EQ(curve.x.size(), curve.y.size()) << each.key << ": " << curve.name;
            for (std::size_t i = 0; i < curve.y_lower.size(); ++i) {
                EXPECT_LE(curve.y_lower[i], curve.y[i]) << each.key;
                EXPECT_GE(curve.y_upper[i], curve.y[i]) << each.key;
            }
            for (const auto& widths :
                 {curve.x_half_width, curve.y_half_width, curve.y_lower, curve.y_upper}) {
                EXPECT_TRUE(widths.empty() || widths.size() == curve.x.size())
                    << each.key << ": " << curve.name;
            }
        }
        for (const ColourMap& map : each.maps) {
            EXPECT_EQ(map.values.size(), map.x.size() * map.y.size()) << each.key;
        }
    }
}

void expect_within(const Finding& found, double truth) {
    ASSERT_TRUE(found.half_width) << found.key;
    // Fixed seeds; 1.5 half-widths are three standard errors.
    EXPECT_NEAR(found.value, truth, 1.5 * *found.half_width + 1e-12) << found.key;
}

TEST_F(Analyses, EveryChapterOfAWholeFileHasItsFindingsAndFigures) {
    const RunRecord record(sample());
    const Analysis analysis = analyse(record);
    expect_sound(analysis);
    for (const char* key : {"velocity_history",
                            "velocity_settling",
                            "velocity_autocorrelation",
                            "velocity_profile",
                            "velocity_gradient_profile",
                            "velocity_error_profile",
                            "msep_profile",
                            "stress_profile",
                            "pressure_profile",
                            "double_averaged_stress_profile",
                            "mean_velocity_map",
                            "mixing_length_profile",
                            "drag_profile",
                            "log_law",
                            "fitted_laws",
                            "friction_factor",
                            "surface_map",
                            "surface_probability_density",
                            "surface_wavenumber_spectrum",
                            "surface_frequency_spectrum",
                            "surface_wave_spectrum",
                            "surface_correlation",
                            "surface_cross_correlation",
                            "surface_station_lags",
                            "surface_extreme_correlation",
                            "surface_space_time_correlation",
                            "streamwise_correlation",
                            "fitted_stress",
                            "velocity_spectrum",
                            "vertical_velocity_spectrum",
                            "depth_correlation",
                            "quadrant_profile",
                            "quadrant_holes",
                            "integral_scale_profile",
                            "force_history",
                            "force_instruments"}) {
        EXPECT_THAT(figure(analysis, key).missing, IsEmpty()) << key;
    }
}

TEST_F(Analyses, FindsWhatTheFileWasMadeOf) {
    const RunRecord record(sample());
    const Analysis analysis = analyse(record);
    const double column = record.column()->depth_mean_velocity;
    EXPECT_NEAR(finding(analysis, "depth_mean_velocity").value, 1.002 * column, 0.002 * column);
    EXPECT_EQ(finding(analysis, "depth_mean_velocity").reference, 0.35);
    // The total stress follows the line of the column within its noise.
    const double crest = std::sqrt(record.flow()->streamwise_gravity() * 0.046);
    EXPECT_NEAR(finding(analysis, "friction_velocity").value, crest, 0.01 * crest);
    EXPECT_NEAR(finding(analysis, "bed_drag_share").value, 0.999, 1e-3);
    EXPECT_NEAR(finding(analysis, "momentum_balance").value, 1.0, 1e-9);
    // The drag is under the whole depth: a balanced flow has that of the column, not rho u*^2.
    const Finding& stress = finding(analysis, "bed_stress");
    EXPECT_NEAR(stress.value / stress.reference.value_or(0.0), 0.999 / record.column()->drag_share, 1e-2);
    EXPECT_NEAR(finding(analysis, "mean_water_depth").value, 0.05, 2e-5);
    // Two waves of 8 and 5 micrometres and noise of one: sqrt((64 + 25)/2 + 1) = 6.75 micrometres.
    EXPECT_NEAR(finding(analysis, "surface_standard_deviation").value, 6.75e-6, 0.1e-6);
    EXPECT_THAT(finding(analysis, "surface_standard_deviation").remark, HasSubstr("closure"));
    EXPECT_EQ(finding(analysis, "surface_standard_deviation").reference, 0.4e-3);
}

TEST_F(Analyses, FindsWhatTheInstrumentsMeasured) {
    const SampleProbes truth;
    SampleOptions options;
    options.without = {"/surface"};  // the wave probes then stand for themselves
    const RunRecord record(sample(options));
    const Analysis analysis = analyse(record);
    expect_within(finding(analysis, "point_velocity_deviation"), truth.u_deviation);
    expect_within(finding(analysis, "point_vertical_velocity_deviation"), truth.w_deviation);
    expect_within(finding(analysis, "point_covariance"),
                  truth.correlation * truth.u_deviation * truth.w_deviation);
    EXPECT_NEAR(finding(analysis, "dispersive_stress_largest").value, truth.dispersive_stress,
                1e-9 * truth.dispersive_stress);
    expect_within(finding(analysis, "forces_bed_drag"), truth.bed_drag);
    expect_within(finding(analysis, "surface_standard_deviation"),
                  truth.wave_amplitude / std::numbers::sqrt2);
    // The lag of a sine of period 0.29 s between probes 28 mm apart, to a tenth of a sample.
    EXPECT_NEAR(finding(analysis, "celerity_between_places_1").value, truth.celerity, 0.02 * truth.celerity);
    // u' and w' of correlation -0.4: ejections and sweeps carry more than the whole.
    EXPECT_GT(finding(analysis, "ejection_share").value + finding(analysis, "sweep_share").value, 1.0);
}

TEST_F(Analyses, DrawWhatAFileMeasuredOnceWithItsUncertainty) {
    std::ofstream(folder_ / "adv.csv") << "z [mm],u [m/s],u_uncertainty [m/s],u_rms [m/s],u_rms_uncertainty "
                                          "[m/s],w_rms [m/s],-u'w' [m2/s2],-u'w'_uncertainty [m2/s2]\n"
                                          "10,0.22,0.002,0.088,0.0044,0.044,0.0015,0.0001\n"
                                          "20,0.30,0.002,0.066,0.0022,0.033,0.0010,0.0002\n";
    RunRecordOptions options;
    options.measured = {folder_ / "adv.csv"};
    const RunRecord record(sample(), options);
    const Analysis analysis = analyse(record, "profiles");
    const auto measured = [&](const char* key, const char* name) {
        std::vector<Curve> found;
        for (const Curve& curve : figure(analysis, key).curves) {
            if (curve.origin == Origin::measured) found.push_back(curve);
        }
        std::set<std::string> names;
        for (const Curve& curve : found) EXPECT_TRUE(names.insert(curve.name).second) << curve.name;
        for (const Curve& curve : found) {
            if (curve.name == name) return curve;
        }
        ADD_FAILURE() << "no curve " << name << " in " << key;
        return Curve{};
    };
    // The heights are over the datum, 6 mm above the bed level; 95 % intervals.
    const Curve u = measured("velocity_profile", "measured");
    EXPECT_THAT(u.y, ElementsAre(DoubleNear(0.016, 1e-12), DoubleNear(0.026, 1e-12)));
    EXPECT_THAT(u.x_half_width, Each(DoubleNear(1.96 * 0.002, 1e-12)));
    // Over the measured friction velocity, 0.044 m/s, and the depth of 50 mm.
    const Curve rms = measured("turbulence_intensity_profile", "measured u'");
    EXPECT_THAT(rms.x, ElementsAre(DoubleNear(2.0, 1e-12), DoubleNear(1.5, 1e-12)));
    EXPECT_THAT(rms.y, ElementsAre(DoubleNear(0.2, 1e-12), DoubleNear(0.4, 1e-12)));
    EXPECT_THAT(rms.x_half_width, ElementsAre(DoubleNear(1.96 * 0.1, 1e-12), DoubleNear(1.96 * 0.05, 1e-12)));
    const Curve w_rms = measured("turbulence_intensity_profile", "measured w'");
    EXPECT_THAT(w_rms.x, ElementsAre(DoubleNear(1.0, 1e-12), DoubleNear(0.75, 1e-12)));
    EXPECT_THAT(w_rms.x_half_width, IsEmpty());
    const Curve stress = measured("stress_profile", "measured -rho u'w'");
    EXPECT_THAT(stress.x, ElementsAre(DoubleNear(1.5, 1e-9), DoubleNear(1.0, 1e-9)));
    EXPECT_THAT(stress.x_half_width, ElementsAre(DoubleNear(1.96 * 0.1, 1e-9), DoubleNear(1.96 * 0.2, 1e-9)));
}

TEST_F(Analyses, BoundsOfSpectraArePositive) {
    const RunRecord record(sample());
    const Analysis analysis = analyse(record);
    for (const char* key : {"velocity_spectrum", "surface_frequency_spectrum"}) {
        const Curve& curve = figure(analysis, key).curves.front();
        ASSERT_EQ(curve.y_lower.size(), curve.y.size()) << key;
        EXPECT_TRUE(curve.y_half_width.empty()) << key;
        for (const double lower : curve.y_lower) EXPECT_GT(lower, 0.0) << key;
    }
}

TEST_F(Analyses, LeaveOutAZeroPlaneOutsideOfTheBed) {
    const RunRecord record(sample());
    const Analysis analysis = analyse(record, "fits");
    const Finding* const plane = find_finding(analysis, "zero_plane");
    const Case& c = *record.flow();
    if (plane != nullptr) {
        EXPECT_GE(plane->value, -c.datum());
        EXPECT_LE(plane->value, c.crest() - c.datum());
    } else {
        EXPECT_EQ(find_finding(analysis, "zero_plane_friction_velocity"), nullptr);
        EXPECT_THAT(analysis.warnings, ::testing::Contains(HasSubstr("free zero plane")));
    }
}

TEST_F(Analyses, SplitTheFrictionFactorWithoutARest) {
    const Analysis analysis = analyse(RunRecord(sample()), "profiles");
    double sum = 0.0;
    for (const char* part : {"viscous", "closure", "turbulent", "pressure_of_pairs", "rest"}) {
        sum += finding(analysis, std::string("friction_factor_") + part).value;
    }
    const double whole = finding(analysis, "friction_factor_above_crests").value;
    EXPECT_GT(whole, 0.0);
    EXPECT_NEAR(sum, whole, 1e-12 * whole);
    EXPECT_EQ(figure(analysis, "friction_factor_parts").curves.size(), 5U);
}

// An upwelling a tenth of a second after each ejection, in a record of noise: the lag is found, and no other.
TEST_F(Analyses, FindTheLagOfUpwellingsAfterEjections) {
    const RunRecord record(sample());
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    constexpr std::size_t times = 4000;
    constexpr std::size_t delay = 10;
    VelocityProbe probe;
    probe.name = "adv";
    probe.z = {0.02, 0.03, 0.05};
    probe.x.assign(3, 0.1);
    std::vector<double> u(times);
    std::vector<double> w(times);
    for (std::size_t i = 0; i < times; ++i) {
        probe.time.push_back(0.01 * static_cast<double>(i));
        w[i] = 0.01 * normal(generator);
        u[i] = 0.02 * normal(generator) - w[i];
    }
    for (std::size_t i = 0; i < times; ++i) {
        const std::size_t before = i >= delay ? i - delay : 0;
        const double ejected = u[before] < 0.0 && w[before] > 0.0 ? -u[before] * w[before] : 0.0;
        probe.u.insert(probe.u.end(), {0.3 + u[i], 0.32 + 0.02 * normal(generator), 0.35});
        probe.w.insert(probe.w.end(),
                       {w[i], 0.01 * normal(generator), 30.0 * ejected + 0.002 * normal(generator)});
    }
    const VelocityInstrument instrument{&probe, probe_point_statistics(probe), 0.01};
    Analysis analysis;
    add_ejections_and_upwellings(record, instrument, analysis);
    const Finding& found = finding(analysis, "ejection_upwelling_correlation");
    EXPECT_GT(found.value, 0.8);
    EXPECT_THAT(found.remark, HasSubstr("at a lag of 0.1 s"));
    EXPECT_EQ(figure(analysis, "ejection_upwelling_correlation").curves.size(), 3U);
}

TEST_F(Analyses, SayWhyAFigureIsMissing) {
    for (const char* group : {"/time_series", "/profiles", "/surface", "/summary", "/column"}) {
        SampleOptions options;
        options.without = {group};
        const RunRecord record(sample(options, false));
        const Analysis analysis = analyse(record);
        expect_sound(analysis);
    }
    SampleOptions options;
    options.without = {"/profiles", "/surface", "/time_series"};
    const RunRecord record(sample(options, false));
    const Analysis analysis = analyse(record);
    EXPECT_THAT(figure(analysis, "velocity_profile").missing, HasSubstr("no profiles"));
    EXPECT_THAT(figure(analysis, "surface_map").missing, HasSubstr("no record of the surface"));
    EXPECT_THAT(figure(analysis, "velocity_history").missing, HasSubstr("no time series"));
    EXPECT_THAT(figure(analysis, "velocity_spectrum").missing, HasSubstr("no velocity probe"));
}

TEST_F(Analyses, MakeOneChapterAlone) {
    const RunRecord record(sample());
    const Analysis analysis = analyse(record, "forces");
    EXPECT_FALSE(analysis.findings.empty());
    for (const Finding& each : analysis.findings) EXPECT_EQ(each.chapter, "forces");
    for (const Figure& each : analysis.figures) EXPECT_EQ(each.chapter, "forces");
    try {
        static_cast<void>(analyse(record, "force"));
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("statistics, profiles, fits, surface, subsurface, forces"));
    }
}

}  // namespace
}  // namespace riffle::chapters_test
