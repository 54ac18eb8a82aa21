#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "check_run.hpp"

using namespace riffle;
using namespace riffle::verification;

// Parasitic velocity: the largest speed of any particle after 5 s, and still over the second that follows (no
// lucky moment of an oscillation). Level: twice the height of the centre of mass, so that every particle
// counts; the bar is the depth drift that numerics.md allows a channel in 60 s. It is lower than H by the
// start's settling: rows under the surface come 0.1 spacings closer, as their pressure is not corrected
// there.
TEST(HydrostaticTank, StaysAtRest) {
    CheckRun run("hydrostatic-tank");
    const double depth = run.parameters().total_depth();
    const double speed = std::sqrt(run.parameters().fluid.gravity * depth);
    run.advance_to(5.0);
    const double largest = largest_speed(run.particles());
    double later = 0.0;
    run.advance_to(6.0, [&] { later = std::max(later, largest_speed(run.particles())); });
    const double level =
        2.0 * mass_mean(run.particles(), [&](std::size_t i) { return run.particles().position[1][i]; });
    expect_below("hydrostatic tank", "largest velocity at 5 s / sqrt(gH)", 1e-4, largest / speed);
    expect_below("hydrostatic tank", "largest velocity from 5 to 6 s / sqrt(gH)", 1e-4, later / speed);
    expect_below("hydrostatic tank", "change of level / H", 5e-3, std::abs(level / depth - 1.0));
}

// The same over a bed that goes on in x, with the viscosity of water and the density diffusion of the default
// scheme.
TEST(HydrostaticTank, WaterStaysAtRestInAChannel) {
    CheckRun run("hydrostatic-tank", {{"channel.ends", "periodic"},
                                      {"fluid.kinematic_viscosity", "1e-6"},
                                      {"numerics.density_diffusion", "fourtakas"}});
    const double speed = std::sqrt(run.parameters().fluid.gravity * run.parameters().total_depth());
    run.advance_to(5.0);
    expect_below("still water, periodic", "largest velocity at 5 s / sqrt(gH)", 1e-4,
                 largest_speed(run.particles()) / speed);
}

// The pressure of still water is hydrostatic: rms over the particles more than 2h below the surface.
TEST(HydrostaticTank, PressureIsHydrostatic) {
    CheckRun run("hydrostatic-tank");
    run.advance_to(5.0);
    expect_below("hydrostatic tank", "rms of p - rho g (H - z) / (rho g H)", 0.01, hydrostatic_error(run));
}
