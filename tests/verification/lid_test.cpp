// Flows that a moving wall at the top drives.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "centre_lines.hpp"
#include "check_run.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

using std::numbers::pi;

/// Flow between plates at rest, the upper of which moves at V from t = 0 on (Morris, Fox & Zhu 1997, eq. 23).
double start_up_couette(double lid, double nu, double width, double z, double t) {
    double u = lid * z / width;
    for (int n = 1; n < 400; ++n) {
        const double k = n * pi / width;
        u += 2.0 * lid / (n * pi) * (n % 2 == 0 ? 1.0 : -1.0) * std::sin(k * z) * std::exp(-nu * k * k * t);
    }
    return u;
}

}  // namespace

// The jump of velocity at t = 0 is resolved by no grid: the transient counts from the time at which the
// momentum has diffused over a tenth of the width, as in the laminar channels; every particle, to 1 L^2/nu.
TEST(Couette, StartUpFollowsTheSeries) {
    CheckRun run("couette");
    const Case& c = run.parameters();
    const double nu = c.fluid.kinematic_viscosity;
    const double width = c.total_depth();
    const double lid = c.channel.lid_velocity;
    double largest = 0.0;
    for (int sample = 1; sample <= 100; ++sample) {
        run.advance_to(0.01 * sample * width * width / nu);
        const ProfileError error =
            profile_error(run, [&](double z) { return start_up_couette(lid, nu, width, z, run.time()); });
        largest = std::max(largest, error.largest);
    }
    expect_below("start-up Couette", "largest error of u, from 0.01 L^2/nu on / V0", 0.01, largest / lid);
}

// Re 100, 50 particles a side: the centre lines averaged over the last two seconds of twenty.
TEST(LidDrivenCavity, Reynolds100) {
    CheckRun run("lid-driven-cavity");
    const double error = cavity_error(run, ghia_reynolds_100(), 20.0, 2.0);
    expect_below("lid-driven cavity, Re 100", "largest error on the centre lines / U", 0.03, error);
}
