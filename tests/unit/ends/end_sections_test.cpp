#include "ends/end_sections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ends/leaving_profile.hpp"

namespace riffle::end_sections_test {
namespace {

constexpr double gravity = 9.81;
constexpr double sound_speed = 40.0;
constexpr double least_depth = 0.01;

EndInput input_of(TimeTable unit_discharge, double relaxation_time) {
    EndInput input;
    input.unit_discharge = std::move(unit_discharge);
    input.inflow_relaxation_time = relaxation_time;
    return input;
}

/// Let an inflow follow a long reach, whose only wave is the one that the inflow sends, in steps of dt:
/// after_step(time, unit discharge).
template <class AfterStep>
void follow_a_long_reach(const EndSections& sections, EndState& end, double until, double dt,
                         const AfterStep& after_step) {
    const double coming = end.coming;
    for (double time = dt; time < until; time += dt) {
        const Section reach =
            outflow_between(gravity, end.velocity + 2.0 * wave_speed(gravity, end.depth), coming);
        end.watched_depth = reach.depth;
        end.watched_velocity = reach.velocity;
        sections.follow_upstream(end, time, dt);
        after_step(time, end.depth * end.velocity);
    }
}

// A hydrograph enters without delay, whatever the relaxation time: that is for the waves.
TEST(EndSections, AHydrographEntersWithoutDelay) {
    const EndSections sections(input_of(TimeTable({0.0, 10.0}, {0.05, 0.1}), 5.0), gravity, sound_speed,
                               least_depth);
    EndState end = sections.start(0.4, 0.05);
    follow_a_long_reach(sections, end, 10.0, 0.01, [](double time, double unit_discharge) {
        ASSERT_NEAR(unit_discharge / (0.05 + 0.005 * time), 1.0, 1e-3) << time;
    });
}

// Nor does a tide at the outflow wait for its relaxation time.
TEST(EndSections, ATideIsFollowedWithoutDelay) {
    EndInput input;
    input.outflow_table = TimeTable({0.0, 2.0, 12.0, 20.0}, {0.4, 0.4, 0.46, 0.42});
    input.outflow_depth = [table = *input.outflow_table](double, double time) { return table.at(time); };
    input.relaxation_time = 5.0;
    const EndSections sections(input, gravity, sound_speed, least_depth);
    EndState end = sections.start(0.4, 0.05);
    const double going = end.velocity + 2.0 * wave_speed(gravity, end.depth);
    const double dt = 0.005;
    for (double time = dt; time < 20.0; time += dt) {
        // A long reach takes out what the end sends up it.
        const Section reach =
            outflow_between(gravity, going, end.velocity - 2.0 * wave_speed(gravity, end.depth));
        end.watched_depth = reach.depth;
        end.watched_velocity = reach.velocity;
        sections.follow_downstream(end, time, dt);
        ASSERT_NEAR(end.depth, input.outflow_table->at(time), 2e-4) << time;
    }
}

// Where the start has another depth than supercritical water that enters, the section goes to it at the speed
// of its waves, not at once; then it follows what is given without delay.
TEST(EndSections, ShootingWaterComesToItsDepthAtTheSpeedOfWaves) {
    for (const double depth_of_start : {0.07, 0.02, 0.012}) {
        EndInput input = input_of(TimeTable(0.0266), 0.0);
        input.inflow_depth = TimeTable({0.0, 1.0}, {0.02, 0.03});
        const EndSections sections(input, gravity, sound_speed, least_depth);
        EndState end = sections.start(depth_of_start, 0.0);
        const double dt = 1e-4;
        for (double time = dt; time < 1.0; time += dt) {
            sections.follow_upstream(end, time, dt);
            ASSERT_LE(std::abs(end.depth_rate), 1.001 * wave_speed(gravity, std::max(0.03, depth_of_start)));
            ASSERT_NEAR(end.depth * end.velocity, 0.0266, 1e-12);
            if (time > 0.15) {
                ASSERT_NEAR(end.depth, 0.02 + 0.01 * time, 1e-9) << time;
            }
        }
    }
}

// Of a pool at rest the discharge grows home within some relaxation times, and then stands.
TEST(EndSections, ADischargeComesHome) {
    for (const double relaxation_time : {0.0, 0.5}) {
        const EndSections sections(input_of(TimeTable(0.06), relaxation_time), gravity, sound_speed,
                                   least_depth);
        EndState end = sections.start(0.4, 0.0);
        double last = 0.0;
        follow_a_long_reach(sections, end, 5.0, 0.001,
                            [&](double, double unit_discharge) { last = unit_discharge; });
        EXPECT_NEAR(last / 0.06, 1.0, 1e-3) << relaxation_time;
    }
}

// Beyond an outflow that is dry nothing stands; thin and fast water leaves as it comes.
TEST(EndSections, ADryOutflowStaysDryUntilWaterComes) {
    EndInput input;
    const EndSections sections(input, gravity, sound_speed, least_depth);
    EndState end = sections.start(0.0, 0.06);
    EXPECT_EQ(end.velocity, 0.0);
    sections.follow_downstream(end, 0.0, 0.001);
    EXPECT_EQ(end.depth, 0.0);
    end.watched_depth = 0.02;
    end.watched_velocity = 2.0;
    sections.follow_downstream(end, 0.0, 0.001);
    EXPECT_NEAR(end.depth, 0.02, 1e-12);
    EXPECT_NEAR(end.velocity, 2.0, 1e-12);
}

// Water that is too slow to leave by itself does not pond at an outflow that nothing rules, and none comes
// in.
TEST(EndSections, SlowWaterLeavesAFreeOutflowAtTheCriticalDepth) {
    const EndSections sections(input_of(TimeTable(0.02), 0.0), gravity, sound_speed, least_depth);
    for (const double velocity : {-0.3, 0.0, 0.3}) {
        EndState end = sections.start(0.05, 0.05 * velocity);
        end.watched_depth = 0.05;
        end.watched_velocity = velocity;
        sections.follow_downstream(end, 0.0, 1e-3);
        EXPECT_NEAR(end.velocity, wave_speed(gravity, end.depth), 1e-12) << velocity;
        EXPECT_NEAR(end.velocity + 2.0 * wave_speed(gravity, end.depth),
                    velocity + 2.0 * wave_speed(gravity, 0.05), 1e-12)
            << velocity;
    }
    EndState thrown_back = sections.start(0.05, -0.1);
    thrown_back.watched_velocity = -2.0;
    sections.follow_downstream(thrown_back, 0.0, 1e-3);
    EXPECT_EQ(thrown_back.velocity, 0.0);
}

// Supercritical flow leaves as it comes below a tailwater that it could jump to, and is driven back by a
// deeper one.
TEST(EndSections, ATailwaterAboveTheSequentDepthDrivesAJumpUpTheChannel) {
    const Section shooting{0.02, 3.0 * wave_speed(gravity, 0.02)};
    const double sequent = sequent_depth(gravity, shooting);
    EXPECT_NEAR(sequent / 0.02, 0.5 * (std::sqrt(73.0) - 1.0), 1e-12);
    for (const double tailwater : {0.95 * sequent, 1.05 * sequent}) {
        EndInput input;
        input.outflow_depth = [tailwater](double, double) { return tailwater; };
        input.relaxation_time = 1.0;
        const EndSections sections(input, gravity, sound_speed, least_depth);
        EndState end = sections.start(shooting.depth, shooting.depth * shooting.velocity);
        for (int step = 0; step < 100; ++step) {
            end.watched_depth = shooting.depth;
            end.watched_velocity = shooting.velocity;
            sections.follow_downstream(end, 0.001 * step, 0.001);
        }
        if (tailwater < sequent) {
            EXPECT_NEAR(end.depth, shooting.depth, 1e-12);
            EXPECT_NEAR(end.velocity, shooting.velocity, 1e-12);
        } else {
            EXPECT_GT(end.depth, 1.1 * shooting.depth);
            EXPECT_LT(end.velocity, 0.99 * shooting.velocity);
        }
    }
}

OpenEndsState state_with(double depth, double velocity, double section_velocity) {
    OpenEndsState state;
    state.downstream.watched_depth = depth;
    state.downstream.velocity = section_velocity;
    state.leaving.assign(10, velocity);
    return state;
}

double mean_of(const LeavingProfile& profile, const OpenEndsState& state) {
    double mean = 0.0;
    for (int i = 0; i < 1000; ++i) mean += profile.at(state, (i + 0.5) / 1000.0, 1.0) / 1000.0;
    return mean;
}

// Each particle row is watched once: the profile goes over to theirs, and its mean is that of the section.
TEST(LeavingProfile, GoesOverToTheWaterThatComes) {
    OpenEndsState state = state_with(0.1, 0.5, 0.6);
    LeavingProfile profile(least_depth);
    for (int step = 0; step < 2000; ++step) {
        profile.clear(state);
        for (int i = 0; i < 10; ++i) profile.add(state, (i + 0.5) * 0.01, 1.0, 0.1 * (i + 0.5));
        profile.finish(state, wave_speed(gravity, 0.05), 0.001);
    }
    EXPECT_NEAR(mean_of(profile, state), 0.6, 1e-3);
    EXPECT_NEAR(profile.at(state, 0.95, 1.0) / profile.at(state, 0.05, 1.0), 19.0, 0.01);
}

TEST(LeavingProfile, NoneComesBackWhileTheFlowLeaves) {
    OpenEndsState state = state_with(0.1, 0.5, 0.2);
    state.leaving[0] = -0.5;
    LeavingProfile profile(least_depth);
    profile.clear(state);
    profile.finish(state, wave_speed(gravity, 0.05), 0.001);
    EXPECT_EQ(profile.at(state, 0.0, 1.0), 0.0);
    state.downstream.velocity = -0.2;  // the flow has turned
    profile.clear(state);
    profile.finish(state, wave_speed(gravity, 0.05), 0.001);
    EXPECT_LT(profile.at(state, 0.0, 1.0), 0.0);
    EXPECT_NEAR(mean_of(profile, state), -0.2, 0.01);
}

// After a restore it is the one that it was.
TEST(LeavingProfile, GoesOnFromAState) {
    OpenEndsState state = state_with(0.1, 0.5, 0.6);
    state.leaving[0] = 0.2;
    for (const double of_section : {0.6, -0.2}) {
        state.downstream.velocity = of_section;
        LeavingProfile profile(least_depth);
        profile.clear(state);
        profile.finish(state, wave_speed(gravity, 0.05), 0.001);
        LeavingProfile restored(least_depth);
        restored.go_on(state);
        EXPECT_NE(profile.at(state, 0.5, 1.0), LeavingProfile(least_depth).at(state, 0.5, 1.0));
        for (const double place : {0.0, 0.03, 0.5, 1.0}) {
            EXPECT_EQ(restored.at(state, place, 1.0), profile.at(state, place, 1.0));
        }
    }
}

// No water before the outflow: nothing is divided by its depth.
TEST(LeavingProfile, KnowsNoProfileOfADryBed) {
    OpenEndsState state = state_with(0.0, 0.0, 0.0);
    LeavingProfile profile(least_depth);
    profile.clear(state);
    profile.finish(state, wave_speed(gravity, 0.05), 0.001);
    EXPECT_EQ(profile.at(state, 0.5, 1.0), 0.0);
}

}  // namespace
}  // namespace riffle::end_sections_test
