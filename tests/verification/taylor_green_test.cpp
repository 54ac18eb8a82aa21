#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "exact_flows.hpp"

using namespace riffle;
using namespace riffle::verification;

// The rate is taken from t = 0.2 s, when the particles
// have settled, to 1 s, where half of the velocity is gone; the amplitude at 1 s includes the settling.
TEST(TaylorGreen, DecaysAtTheViscousRate) {
    CheckRun run("taylor-green");
    const Case& c = run.parameters();
    const double k = 2.0 * std::numbers::pi / c.channel.length;
    const double exact = 2.0 * c.fluid.kinematic_viscosity * k * k;
    run.advance_to(0.2);
    const double first_time = run.time();
    const double first = vortex_amplitude(run);
    run.advance_to(1.0);
    const double last = vortex_amplitude(run);
    const double rate = std::log(first / last) / (run.time() - first_time);
    expect_below("Taylor-Green", "rate of decay against 2 nu k^2", 0.03, std::abs(rate / exact - 1.0));
    expect_below("Taylor-Green", "amplitude at 1 s", 0.03,
                 std::abs(last / (*c.start.velocity * std::exp(-exact * run.time())) - 1.0));
}

// Pair forces are antisymmetric: the momentum of the vortices, none at the start, stays none. Bound: each
// pair adds the same single-precision number with both signs, but the sums of the two particles round apart,
// each by 2^-24 of the largest partial sum (about c0^2 s / h = 30 m/s2): at random over N particles and the
// steps this is 30 * 6e-8 * dt * sqrt(steps / N), under 1e-10 U; a systematic part of the rounding is allowed
// 1e-6 U.
TEST(TaylorGreen, KeepsItsMomentum) {
    CheckRun run("taylor-green");
    const Particles<2>& p = run.particles();
    const auto momentum = [&](std::size_t axis) {
        return mass_mean(p, [&](std::size_t i) { return p.velocity[axis][i]; });
    };
    const double start_x = momentum(0);
    const double start_z = momentum(1);
    run.advance_to(1.0);
    const double change = std::hypot(momentum(0) - start_x, momentum(1) - start_z);
    expect_below("Taylor-Green", "change of momentum / (M U), single precision", 1e-6, change);
}

TEST(TaylorGreen, KeepsItsMomentumInDoublePrecision) {
    CheckRun run("taylor-green", {{"numerics.precision", "double"}});
    const Particles<2>& p = run.particles();
    const auto momentum = [&](std::size_t axis) {
        return mass_mean(p, [&](std::size_t i) { return p.velocity[axis][i]; });
    };
    const double start_x = momentum(0);
    const double start_z = momentum(1);
    run.advance_to(0.3);
    const double change = std::hypot(momentum(0) - start_x, momentum(1) - start_z);
    expect_below("Taylor-Green", "change of momentum / (M U), double precision", 1e-14, change);
}
