// The instruments: what they record, when, and that a restored one goes on as if it had not stopped.

#include "instruments/instrument.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "instruments/probe_set.hpp"
#include "instruments/standard_probes.hpp"
#include "water.hpp"
#include "written_checkpoint.hpp"

namespace riffle::instrument_test {
namespace {

using test::small_water;
using test::values_of;
using test::Water;
using testing::HasSubstr;

Water shear_flow() {
    return Water(small_water(), 0.3)
        .with_velocity([](double, double z) { return 10.0 * z; }, [](double, double z) { return -z; });
}

Probe probe(ProbeKind kind, double frequency = 100.0) {
    Probe p;
    p.name = "p";
    p.kind = kind;
    p.sampling_frequency = frequency;
    return p;
}

TEST(VelocityPoints, OfOnePositionAndManyHeightsAreAProfile) {
    const Water water = shear_flow();
    Probe p = probe(ProbeKind::velocity);
    p.x = {0.05};
    p.z = {0.01, 0.02, 0.05};
    const auto instrument = make_instrument(p, water.parameters);
    water.sample(*instrument, 0.25);
    EXPECT_EQ(values_of(*instrument, "time"), std::vector<double>{0.25});
    const auto u = values_of(*instrument, "velocity");
    ASSERT_EQ(u.size(), 3U);
    EXPECT_NEAR(u[0], 0.1, 1e-7);  // single precision
    EXPECT_NEAR(u[1], 0.2, 1e-7);
    EXPECT_TRUE(std::isnan(u[2]));
    EXPECT_NEAR(values_of(*instrument, "vertical_velocity")[1], -0.02, 1e-8);
    EXPECT_EQ(instrument->row_bytes(), 8U + 2 * 3 * 4);
}

TEST(VelocityPoints, AverageOverTheMeasuringVolume) {
    const Water water = Water(small_water())
                            .with_velocity([](double, double z) { return 100.0 * z * z; },
                                           [](double, double) { return 0.0; });
    Probe p = probe(ProbeKind::velocity);
    p.x = {0.05};
    p.z = {0.02};
    const auto point = make_instrument(p, water.parameters);
    p.sampling_length = 0.009;
    const auto volume = make_instrument(p, water.parameters);
    water.sample(*point);
    water.sample(*volume);
    // The mean of c z^2 over a height L is c L^2/12 above its middle value; nine midpoints miss 1/81 of it.
    const double expected = 100.0 * 0.009 * 0.009 / 12.0;
    EXPECT_NEAR(values_of(*volume, "velocity")[0] - values_of(*point, "velocity")[0], expected,
                0.03 * expected);
}

TEST(BedForce, SumsTheForcesOnTheParticles) {
    const Water water = shear_flow();
    const std::size_t n = water.particles.size();
    const auto instrument = make_instrument(probe(ProbeKind::force), water.parameters);
    SparseValues drag;
    SparseValues wall;
    SparseValues normal;
    for (auto [values, value] : {std::pair(&drag, -0.03), {&wall, -0.01}, {&normal, 9.81}}) {
        values->reset(n);
        for (std::size_t i = 0; i < n; ++i) values->set(i, value);
    }
    instrument->sample({.time = 0.5,
                        .streamwise_gravity = 0.04,
                        .mass = water.particles.mass,
                        .drag_x = &drag,
                        .wall_x = &wall,
                        .wall_z = &normal});
    const double mass = 1000.0 * 0.1 * 0.04;
    EXPECT_NEAR(values_of(*instrument, "bed_drag")[0], 0.03 * mass, 1e-12 * mass);
    EXPECT_NEAR(values_of(*instrument, "wall_force")[0], 0.01 * mass, 1e-12 * mass);
    EXPECT_NEAR(values_of(*instrument, "wall_normal_force")[0], 9.81 * mass, 1e-11 * mass);
    EXPECT_NEAR(values_of(*instrument, "weight_component")[0], 0.04 * mass, 1e-12 * mass);
}

Probe grid() {
    Probe p = probe(ProbeKind::grid, 10.0);
    p.spacing = 0.01;
    p.x_from = 0.02;
    p.x_to = 0.05;
    p.z_from = 0.01;
    p.z_to = 0.05;
    p.averaging_time = 0.4;
    return p;
}

/// Uniform flow that fluctuates between samples: u = 1 +- 0.1, w = -+ 0.05.
Water fluctuating(int sample) {
    const double sign = sample % 2 == 0 ? 1.0 : -1.0;
    return Water(small_water())
        .with_velocity([=](double, double) { return 1.0 + 0.1 * sign; },
                       [=](double, double) { return -0.05 * sign; });
}

TEST(VelocityGrid, GivesMeansAndMomentsOfEachWindow) {
    const auto instrument = make_instrument(grid(), small_water());
    EXPECT_EQ(instrument->points(), 20U);  // 4 columns, 5 rows
    for (int k = 1; k <= 9; ++k) fluctuating(k).sample(*instrument, 0.1 * k + 1e-4);
    EXPECT_EQ(instrument->rows(), 2U);  // the windows to 0.4 and 0.8 s; the ninth sample waits
    const auto time = values_of(*instrument, "time");
    EXPECT_NEAR(time[0], 0.4, 1e-12);
    EXPECT_NEAR(time[1], 0.8, 1e-12);
    EXPECT_EQ(values_of(*instrument, "samples"), (std::vector<double>{4.0, 4.0}));
    const auto u = values_of(*instrument, "velocity");
    ASSERT_EQ(u.size(), 40U);
    for (const std::size_t i : {0U, 7U, 25U}) {
        EXPECT_NEAR(u[i], 1.0, 1e-6);
        EXPECT_NEAR(values_of(*instrument, "vertical_velocity")[i], 0.0, 1e-6);
        EXPECT_NEAR(values_of(*instrument, "velocity_variance")[i], 0.01, 1e-6);
        EXPECT_NEAR(values_of(*instrument, "vertical_velocity_variance")[i], 0.0025, 1e-6);
        EXPECT_NEAR(values_of(*instrument, "velocity_covariance")[i], -0.005, 1e-6);
    }
    EXPECT_TRUE(std::isnan(u[19]));  // the top row, at 50 mm, is dry
}

TEST(VelocityGrid, GivesMeansOfPressureAndShearStress) {
    const auto instrument = make_instrument(grid(), small_water());
    Water water = shear_flow();
    for (int k = 1; k <= 4; ++k) {
        water.pressure = [k](double, double z) { return 9810.0 * (0.04 - z) + k; };
        water.shear_stress = [k](double x, double z) { return 1.5 * (1.0 - z / 0.04) + 0.1 * k * x; };
        water.sample(*instrument, 0.1 * k + 1e-4);
    }
    const auto pressure = values_of(*instrument, "pressure");
    const auto stress = values_of(*instrument, "shear_stress");
    ASSERT_EQ(pressure.size(), 20U);
    // Linear fields are met exactly (single precision); the mean of k is 2.5. Point 5: x = 30 mm, z = 20 mm.
    EXPECT_NEAR(pressure[5], 9810.0 * 0.02 + 2.5, 1e-4);
    EXPECT_NEAR(stress[5], 0.75 + 0.25 * 0.03, 1e-6);
    EXPECT_TRUE(std::isnan(pressure[19]));
    EXPECT_TRUE(instrument->needs_fields());
    Case laminar = small_water();
    laminar.turbulence.closure = ClosureKind::none;
    EXPECT_THROW((void)values_of(*make_instrument(grid(), laminar), "shear_stress"), std::logic_error);
}

TEST(VelocityPlane, GivesTheVelocitiesOfEachSample) {
    Probe p = grid();
    p.averaging_time = 0.0;
    const auto instrument = make_instrument(p, small_water());
    EXPECT_EQ(instrument->points(), 20U);
    const Water water = shear_flow();
    water.sample(*instrument, 0.1);
    water.sample(*instrument, 0.2);
    EXPECT_EQ(values_of(*instrument, "time"), (std::vector<double>{0.1, 0.2}));
    const auto u = values_of(*instrument, "velocity");
    ASSERT_EQ(u.size(), 40U);
    EXPECT_NEAR(u[5], 0.2, 1e-7);  // row by row: z = 20 mm, x = 30 mm
    EXPECT_NEAR(u[25], 0.2, 1e-7);
    EXPECT_NEAR(values_of(*instrument, "vertical_velocity")[8], -0.03, 1e-8);
    EXPECT_TRUE(std::isnan(u[19]));
}

TEST(VelocityGrid, GoesOnFromASavedWindow) {
    const auto straight = make_instrument(grid(), small_water());
    const auto first = make_instrument(grid(), small_water());
    const auto second = make_instrument(grid(), small_water());
    for (int k = 1; k <= 8; ++k) {
        const Water water = shear_flow();
        water.sample(*straight, 0.1 * k + 1e-4);
        water.sample(k <= 6 ? *first : *second, 0.1 * k + 1e-4);
        if (k == 6) second->restore_unfinished(first->unfinished());
    }
    EXPECT_EQ(values_of(*straight, "velocity_covariance")[25], values_of(*second, "velocity_covariance")[5]);
    EXPECT_EQ(values_of(*straight, "time")[1], values_of(*second, "time")[0]);
    EXPECT_EQ(values_of(*straight, "samples")[1], values_of(*second, "samples")[0]);
}

TEST(ProbeSet, SamplesAtTheFirstStepBehindEachMultiple) {
    Case c = small_water();
    c.output.standard_probes = false;
    c.probes = {probe(ProbeKind::flow_rate, 20.0)};
    c.probes[0].x = {0.05};
    c.probes[0].start = 0.1;
    const Water water = shear_flow();
    ProbeSet set(c, 1e-3);
    const double step = 0.0007;
    for (int k = 0; k * step < 0.5; ++k) {
        const double time = k * step;
        if (set.due_for_fluid(time)) {
            const FluidViewIn<2> fluid = water.view();
            set.record({.time = time, .mass = water.particles.mass, .fluid = &fluid}, true);
        }
    }
    const auto time = values_of(*set.members()[0].instrument, "time");
    ASSERT_EQ(time.size(), 7U);  // 0.15, 0.2, ... 0.45
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double due = 0.15 + 0.05 * static_cast<double>(i);
        EXPECT_GE(time[i], due - 1e-12);
        EXPECT_LT(time[i], due + step);
    }
    EXPECT_EQ(recorded_rows(*set.members()[0].instrument, 0.5 - step), 7.0);
}

TEST(ProbeSet, RefusesWhatTheTimeStepCannotGive) {
    Case c = small_water();
    c.probes = {probe(ProbeKind::force, 600.0)};
    c.probe_places = {"case.toml:9:1"};
    EXPECT_NO_THROW(ProbeSet(c, 0.0008));
    try {
        const ProbeSet set(c, 0.001);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("case.toml:9:1: [[probe]] sampling_frequency of \"p\" is 600 Hz"));
        EXPECT_THAT(error.what(), HasSubstr("expected at most 500 Hz"));
    }
}

TEST(ProbeSet, OfACheckpointWithoutItsProbesIsRefused) {
    Case c = small_water();
    ProbeSet set(c, 1e-3);
    Content checkpoint;
    set.save(checkpoint);
    const test::WrittenCheckpoint written(checkpoint);
    EXPECT_NO_THROW(set.restore(written.reader()));
    c.probes = {probe(ProbeKind::force)};
    ProbeSet other(c, 1e-3);
    EXPECT_THROW(other.restore(written.reader()), FileError);
}

std::vector<std::string> names(const StandardProbes& set) {
    std::vector<std::string> list;
    for (const Probe& p : set.probes) list.push_back(p.name);
    return list;
}

TEST(StandardProbes, SuitTheCase) {
    using testing::ElementsAre;
    Case c = small_water();
    c.bed.kind = BedKind::spheres;
    c.bed.roughness_height = 0.01;
    c.bed.datum_below_crest = 0.004;
    const StandardProbes channel = standard_probes(c, 1e-3);
    EXPECT_THAT(names(channel),
                ElementsAre("standard_velocity", "standard_wave", "standard_flow_rate", "standard_force"));
    EXPECT_EQ(channel.probes[0].z.size(), 16U);
    EXPECT_DOUBLE_EQ(channel.probes[0].z.front(), 0.01);
    EXPECT_DOUBLE_EQ(channel.probes[0].z.back(), 0.95 * c.total_depth());
    EXPECT_DOUBLE_EQ(channel.probes[0].sampling_frequency, 100.0);
    EXPECT_THAT(channel.probes[1].x, ElementsAre(0.0, 0.028));
    ASSERT_EQ(channel.notes.size(), 2U);
    EXPECT_THAT(channel.notes[0], HasSubstr("x = 120.3 mm is left out"));

    c.channel.ends = Ends::walls;
    EXPECT_THAT(names(standard_probes(c, 1e-3)),
                ElementsAre("standard_velocity", "standard_wave", "standard_force"));
    c.channel.top = Top::periodic;
    EXPECT_THAT(names(standard_probes(c, 1e-3)), ElementsAre("standard_velocity"));
    EXPECT_DOUBLE_EQ(standard_probes(c, 0.01).probes[0].sampling_frequency, 25.0);
    c.output.standard_probes = false;
    EXPECT_TRUE(standard_probes(c, 1e-3).probes.empty());
}

}  // namespace
}  // namespace riffle::instrument_test
