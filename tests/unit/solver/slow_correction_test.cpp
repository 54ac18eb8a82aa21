// The pressure corrected by the mean of the correction over a time.

#include <gtest/gtest.h>

#include "same_bits.hpp"
#include "small_case.hpp"

namespace riffle::slow_correction_test {
namespace {

double rms_speed_after(const Case& c, double time) {
    const test::Channel tank(c);
    tank.advance_to(time);
    return test::rms_speed(tank.simulation->particles());
}

TEST(SlowCorrection, LetsDisorderedWaterComeToRest) {
    Case c = test::disordered_tank();
    const double at_once = rms_speed_after(c, 1.5);
    c.numerics.pressure_correction_time = 10.0;
    const double slow = rms_speed_after(c, 1.5);
    EXPECT_LT(slow, 0.4 * at_once);
}

TEST(SlowCorrection, IsAPartOfTheState) {
    Case c = test::disordered_tank();
    c.numerics.pressure_correction_time = 0.1;
    for (const Stepping stepping : {Stepping::leapfrog, Stepping::predictor_corrector}) {
        c.numerics.stepping = stepping;
        test::expect_same_bits_after_resume(c, 60, 60);
    }
}

}  // namespace
}  // namespace riffle::slow_correction_test
