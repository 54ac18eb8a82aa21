#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact_flows.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

using std::numbers::pi;

/// Free-surface flow of depth H on a no-slip bed, started with the uniform velocity U.
double start_up_channel(double force, double nu, double depth, double start, double z, double t) {
    double u = force / (2.0 * nu) * z * (2.0 * depth - z);
    for (int n = 0; n < 200; ++n) {
        const double k = pi * (2 * n + 1) / (2.0 * depth);
        const double coefficient = 2.0 / (k * depth) * (start - force / (nu * k * k));
        u += coefficient * std::sin(k * z) * std::exp(-nu * k * k * t);
    }
    return u;
}

void check_channel(const std::string& name, const std::string& label,
                   const std::vector<Override>& overrides) {
    CheckRun run(name, overrides);
    const Case& c = run.parameters();
    const double force = c.streamwise_gravity();
    const double nu = c.fluid.kinematic_viscosity;
    const double depth = c.total_depth();
    const double start = *c.start.velocity;
    const double largest_velocity = force * depth * depth / (2.0 * nu);
    const double relaxation = 4.0 * depth * depth / (pi * pi * nu);
    const auto exact = [&](double z) { return start_up_channel(force, nu, depth, start, z, run.time()); };

    // The start has a jump of velocity at the bed, which no grid resolves: the transient counts from the time
    // at which the momentum has diffused over a tenth of the depth.
    double transient = 0.0;
    run.advance_to(0.01 * depth * depth / nu);
    for (int sample = 1; sample <= 100; ++sample) {
        run.advance_to(3.0 * relaxation * sample / 100.0);
        transient = std::max(transient, profile_error(run, exact).profile);
    }
    expect_below(label, "rms of the profile u(z), whole transient / U_max", 0.01,
                 transient / largest_velocity);

    // Steady flow: what the start still contributes is the series' first term, 0.9 % of U_max, so u is
    // compared with the series here too; the surface velocity at the topmost particles.
    double surface = 0.0;
    double surface_exact = 0.0;
    double mean_exact = 0.0;
    double top = 0.0;
    for (std::size_t i = 0; i < run.particles().size(); ++i) {
        top = std::max(top, run.particles().position[1][i]);
    }
    int rows = 0;
    for (std::size_t i = 0; i < run.particles().size(); ++i) {
        const double z = run.particles().position[1][i];
        mean_exact += exact(z) / static_cast<double>(run.particles().size());
        if (z > top - 0.5 * c.numerics.spacing) {
            surface += run.particles().velocity[0][i];
            surface_exact += exact(z);
            ++rows;
        }
    }
    const double mean =
        mass_mean(run.particles(), [&](std::size_t i) { return run.particles().velocity[0][i]; });
    EXPECT_GT(rows, 0);
    expect_below(label, "surface velocity", 0.01, std::abs(surface / surface_exact - 1.0));
    expect_below(label, "mean velocity", 0.01, std::abs(mean / mean_exact - 1.0));
}

}  // namespace

// Every particle, every 0.01 L^2/nu from the first step on to 1 L^2/nu (the profile is then steady to 5e-5).
TEST(Poiseuille, StartUpFollowsTheSeries) {
    CheckRun run("poiseuille");
    const Case& c = run.parameters();
    const double nu = c.fluid.kinematic_viscosity;
    const double width = c.total_depth();
    const double force = c.streamwise_gravity();
    const double largest_velocity = force * width * width / (8.0 * nu);
    double largest = 0.0;
    for (int sample = 1; sample <= 100; ++sample) {
        run.advance_to(0.01 * sample * width * width / nu);
        const ProfileError error = profile_error(
            run, [&](double z) { return start_up_poiseuille(force, nu, width, z, run.time()); });
        largest = std::max(largest, error.largest);
    }
    expect_below("start-up Poiseuille", "largest error of u, whole transient / U_max", 0.01,
                 largest / largest_velocity);
}

TEST(LaminarChannel, Reynolds10) { check_channel("laminar-re10", "laminar channel Re 10", {}); }

TEST(LaminarChannel, Reynolds100) { check_channel("laminar-re100", "laminar channel Re 100", {}); }
