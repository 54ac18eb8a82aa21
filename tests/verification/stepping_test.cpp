// Order of the time stepping: the equations of the particles are ordinary differential equations, and only
// the step is refined.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "check_run.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

/// The vortices of the check on 20 x 20 disordered particles, after 0.08 s in a number of equal steps. By id.
struct Vortices {
    std::vector<std::array<double, 2>> position;
    std::vector<std::array<double, 2>> velocity;
};

Vortices vortices(const std::string& stepping, int steps) {
    constexpr double time = 0.08;
    CheckRun run("taylor-green", {{"numerics.spacing", "50 mm"},
                                  {"numerics.precision", "double"},
                                  {"numerics.stepping", stepping},
                                  {"numerics.time_step", fmt::format("{:.17g} s", time / steps)}});
    run.advance_to(time * (1.0 - 0.5 / steps));
    const Particles<2>& p = run.particles();
    Vortices result{.position = std::vector<std::array<double, 2>>(p.size()),
                    .velocity = std::vector<std::array<double, 2>>(p.size())};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto id = static_cast<std::size_t>(p.id[i]);
        result.position[id] = {p.position[0][i], p.position[1][i]};
        result.velocity[id] = {p.velocity[0][i], p.velocity[1][i]};
    }
    return result;
}

/// Differences of two results: rms, in units of the velocity and of the spacing.
struct Difference {
    double velocity = 0.0;
    double position = 0.0;
};

Difference difference(const Vortices& a, const Vortices& b) {
    Difference d;
    for (std::size_t i = 0; i < a.position.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            const double u = a.velocity[i][k] - b.velocity[i][k];
            // The box is one metre wide.
            const double x = std::remainder(a.position[i][k] - b.position[i][k], 1.0) / 0.05;
            d.velocity += u * u;
            d.position += x * x;
        }
    }
    const auto n = static_cast<double>(a.position.size());
    return {std::sqrt(d.velocity / n), std::sqrt(d.position / n)};
}

const Vortices& reference() {
    static const Vortices result = vortices("beeman", 4096);
    return result;
}

/// Print the errors of a method against the reference with these numbers of steps, each twice the one before,
/// and expect its order between the last two.
void expect_order(const std::string& stepping, double order, double tolerance,
                  const std::vector<int>& numbers = {64, 128, 256, 512}) {
    Difference last;
    Difference seen;
    for (const int steps : numbers) {
        const Difference error = difference(vortices(stepping, steps), reference());
        seen = {std::log2(last.velocity / error.velocity), std::log2(last.position / error.position)};
        fmt::print("| {} | {} | {:.2e} | {:.2e} | orders {:.2f}, {:.2f}\n", stepping, steps, error.velocity,
                   error.position, seen.velocity, seen.position);
        last = error;
    }
    EXPECT_NEAR(seen.velocity, order, tolerance) << stepping;
    EXPECT_NEAR(seen.position, order, tolerance) << stepping;
}

}  // namespace

TEST(TimeStepping, SemiImplicitEulerIsOfFirstOrder) { expect_order("semi-implicit-euler", 1.0, 0.1); }

TEST(TimeStepping, PredictorCorrectorIsOfSecondOrder) { expect_order("predictor-corrector", 2.0, 0.1); }

TEST(TimeStepping, SymplecticIsOfSecondOrder) { expect_order("symplectic", 2.0, 0.1); }

// Its predictor and corrector are of third order.
TEST(TimeStepping, BeemanIsOfThirdOrder) { expect_order("beeman", 3.0, 0.1); }

// Each of Verlet's Euler steps splits its error in two, one part of which cancels the other at the next if
// the density diffusion, which the leapfrog amplifies, leaves it alone for 40 steps. So the second order is
// seen only with steps far below those of the other methods, and whole numbers of 40.
TEST(TimeStepping, VerletIsOfSecondOrderInSmallSteps) {
    expect_order("verlet", 2.0, 0.1, {320, 640, 1280, 2560});
}

TEST(TimeStepping, LeapfrogIsOfFirstOrderOnceFrictionCounts) { expect_order("leapfrog", 1.0, 0.1); }
