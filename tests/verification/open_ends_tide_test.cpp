#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "check_run.hpp"
#include "solver/start.hpp"
#include "temporary_folder.hpp"

// Tailwaters that change, in channels small enough for seconds.

namespace riffle::open_ends_tide_test {
namespace {

/// A level channel without friction whose tailwater rises by 16 mm in eight seconds.
Case rising_channel(const std::filesystem::path& folder) {
    std::ofstream(folder / "tide.csv") << "time [s],depth [mm]\n0,40\n1,40\n9,56\n";
    return parse_case(
        "[channel]\nslope = 0\ndepth = 0.04\nlength = 0.6\nends = \"open\"\n[bed]\nkind = \"slip\"\n"
        "[turbulence]\nclosure = \"none\"\n[inflow]\nunit_discharge = 5e-4\nprofile = \"uniform\"\n[outflow]\nkind = "
        "\"depth\"\ndepth_file = \"" +
            (folder / "tide.csv").string() +
            "\"\n[numerics]\nspacing = 0.004\n[start]\nkind = \"uniform\"\n[run]\nuntil = \"10 s\"\n",
        "tide");
}

// The water that comes in makes no waves: before, each new row over the others was filled from the end on,
// and a wave half a row high ran up the channel (0.083 where the bar is 0.07).
TEST(OpenEndsTide, ATailwaterThatRisesFillsAChannelWithoutWaves) {
    set_thread_count(1);
    const test::TemporaryFolder folder;
    const Case c = rising_channel(folder.path());
    const Scheme scheme = make_scheme(c, nullptr);
    const auto run = make_simulation<2>(c, nullptr, initial_particles<2>(c, scheme, nullptr));
    double squares = 0.0;
    double samples = 0.0;
    double head = 0.0;
    double head_squares = 0.0;
    double fastest_back = 0.0;
    while (run->clock().time < 9.0) {
        run->step();
        const double time = run->clock().time;
        const EndState& end = run->clock().open_ends.downstream;
        fastest_back = std::min(fastest_back, end.velocity);
        if (time < 1.5) continue;
        const double departure = end.watched_depth - (0.04 + 0.002 * (time - 1.0));
        const double higher = run->clock().open_ends.upstream.watched_depth - end.watched_depth;
        head += higher;
        head_squares += higher * higher;
        squares += departure * departure;
        samples += 1.0;
    }
    EXPECT_LT(fastest_back, -0.02);  // what fills the channel enters through its outflow
    verification::expect_below("tailwater that rises", "depth before the outflow, rms departure / dx", 0.07,
                               std::sqrt(squares / samples) / c.numerics.spacing);
    verification::expect_below("tailwater that rises", "depth at the inflow against that, mean / dx", 0.1,
                               std::abs(head / samples) / c.numerics.spacing);
    // The rise begins at once, so the channel swings by what the tailwater rises while a wave runs through
    // it.
    const double swing = 0.002 * 0.6 / std::sqrt(9.81 * 0.048);
    verification::expect_below("tailwater that rises",
                               "depth at the inflow against that, rms over its free swing's", 1.1,
                               std::sqrt(2.0 * head_squares / samples) / swing);
}

}  // namespace
}  // namespace riffle::open_ends_tide_test
