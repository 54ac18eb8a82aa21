// The pressure corrected by the mean of the correction over a time.

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::slow_correction_test {
namespace {

/// A closed tank of disordered water.
Case disordered_tank() {
    Case c = test::still_water();
    c.channel.length = 0.1;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.0025;
    c.start.jitter = 0.2;
    c.start.packed = true;
    return c;
}

double rms_speed(const Particles<2>& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum += p.velocity[0][i] * p.velocity[0][i] + p.velocity[1][i] * p.velocity[1][i];
    }
    return std::sqrt(sum / static_cast<double>(p.size()));
}

double rms_speed_after(const Case& c, double time) {
    const test::Channel tank(c);
    while (tank.simulation->clock().time < time) {
        tank.advance(1);
    }
    return rms_speed(tank.simulation->particles());
}

TEST(SlowCorrection, LetsDisorderedWaterComeToRest) {
    Case c = disordered_tank();
    const double at_once = rms_speed_after(c, 1.5);
    c.numerics.pressure_correction_time = 10.0;
    const double slow = rms_speed_after(c, 1.5);
    EXPECT_LT(slow, 0.4 * at_once);
}

TEST(SlowCorrection, IsAPartOfTheState) {
    Case c = disordered_tank();
    c.numerics.pressure_correction_time = 0.1;
    for (const Stepping stepping : {Stepping::leapfrog, Stepping::predictor_corrector}) {
        c.numerics.stepping = stepping;
        const test::Channel whole(c);
        whole.advance(60);
        const test::Channel resumed(c);
        resumed.simulation->restore(test::saved_particles(*whole.simulation), whole.simulation->clock(),
                                    whole.simulation->wall_density_deviation());
        set_thread_count(2);
        whole.advance(60);
        set_thread_count(1);
        resumed.advance(60);
        set_thread_count(0);
        test::expect_same_bits(whole.simulation->particles(), resumed.simulation->particles());
    }
}

}  // namespace
}  // namespace riffle::slow_correction_test
