#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/parallel.hpp"
#include "case/case.hpp"
#include "column/canal_channel.hpp"
#include "ends/end_lattice.hpp"
#include "open_run.hpp"
#include "particles/lattice.hpp"
#include "temporary_folder.hpp"

// Canals with open ends, coarse enough for seconds: six rows over the depth.

namespace riffle::open_canal_test {
namespace {

constexpr double depth = 0.045;

/// Bottom 60 mm, banks 1:1, in a channel of 180 mm; `section`: of another shape.
std::string canal(
    const std::string& outflow,
    const std::string& section = "shape = \"trapezoid\"\nbottom_width = 0.06\nbank_slope = 1\n") {
    return "[channel]\ndimensions = 3\nsides = \"walls\"\nends = \"open\"\nslope = 0.002\ndepth = " +
           std::to_string(depth) +
           "\nwidth = 0.18\nlength = 0.45\n[bed]\nkind = \"slip\"\n[side_walls]\ndrag_form = \"none\"\n"
           "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = 0.0075\n[start]\nkind = \"column\"\n"
           "[run]\nuntil = 5\n[[solid]]\nname = \"canal\"\n" +
           section + "surface = \"log-law\"\nequivalent_roughness = 0.001\n" + outflow;
}

using CanalRun = test::OpenRun<3>;

/// Discharge of uniform flow over the width of that canal, m2/s.
double uniform_discharge(const std::string& text) {
    Case c = parse_case(text + "[inflow]\ndischarge = 1e-3\n", "canal");
    return canal_uniform_discharge(c, depth);
}

std::string inflow(double unit_discharge) {
    return "[inflow]\nunit_discharge = " + std::to_string(unit_discharge) + "\n";
}

TEST(OpenCanal, UniformFlowStaysUniform) {
    const double q = uniform_discharge(canal(""));
    CanalRun run(canal("[outflow]\nkind = \"normal-depth\"\n" + inflow(q)));
    run.simulation->step();
    const auto at_start = static_cast<std::int64_t>(run.simulation->particles().size());
    const LongWaves waves = waves_of_lattice(run.c);
    run.advance_to(1.0);
    double level = 0.0;
    double discharge = 0.0;
    int samples = 0;
    for (double time = 1.0; time < 1.6; time += 0.02) {
        run.advance_to(time);
        const EndState& out = run.ends().downstream;
        level += out.depth / depth;
        discharge += waves.area(out.depth) * out.velocity / q;
        ++samples;
    }
    EXPECT_NEAR(level / samples, 1.0, 0.01);
    EXPECT_NEAR(discharge / samples, 1.0, 0.02);
    // Each particle by its number.
    const EndsLedger& ledger = run.ends().ledger;
    EXPECT_EQ(static_cast<std::int64_t>(run.simulation->particles().size()),
              at_start + ledger.entered - ledger.left);
    EXPECT_TRUE(run.simulation->particles().lost.empty());
    // What entered is the discharge to the particles that wait.
    const double particle = lattice_of(run.c).volume();
    const double entered =
        static_cast<double>(ledger.entered) * particle / (q * 0.18 * run.simulation->clock().time);
    EXPECT_NEAR(entered, 1.0, 0.05);
}

TEST(OpenCanal, HasTheSameBitsForAnyNumberOfThreadsAndAfterARestore) {
    const std::string text =
        canal("[outflow]\nkind = \"depth\"\ndepth = 0.05\n" + inflow(0.6 * uniform_discharge(canal(""))),
              "shape = \"compound\"\nbottom_width = 0.06\nbank_slope = 1\nbank_height = 0.02\n");
    const int threads = thread_count();
    set_thread_count(1);
    CanalRun one(text);
    one.advance_to(0.12);
    set_thread_count(2);
    CanalRun two(text);
    two.advance_to(0.06);
    CanalRun resumed(text);
    resumed.restore_from(two);
    two.advance_to(0.12);
    resumed.advance_to(0.12);
    set_thread_count(threads);
    expect_same_bits(one, two);
    expect_same_bits(one, resumed);
}

/// A valley of a sinuous bottom 60 mm wide with banks of one in one, 4 mm of waves in the middle of its
/// length, and the bottom 6 mm over z = 0 upstream and 3 mm downstream, as a grid of 5 mm.
std::string valley(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "valley.asc";
    std::ofstream grid(file);
    constexpr int columns = 95;
    constexpr int rows = 40;
    constexpr double cell = 0.005;
    grid << "ncols " << columns << "\nnrows " << rows << "\nxllcenter -0.01\nyllcenter -0.01\ncellsize "
         << cell << "\nNODATA_value -9999\n";
    for (int row = rows; row-- > 0;) {
        for (int column = 0; column < columns; ++column) {
            const double x = -0.01 + cell * column;
            const double y = -0.01 + cell * row;
            const double bank = std::max(0.0, std::abs(y - 0.09) - 0.03);
            const double waves =
                0.004 * std::sin(52.0 * x) * std::cos(70.0 * y) * std::exp(-std::pow((x - 0.22) / 0.1, 2));
            grid << std::max(0.0, bank + waves + 0.006 - 0.003 * std::clamp(x / 0.45, 0.0, 1.0)) << " ";
        }
        grid << "\n";
    }
    return file.string();
}

TEST(OpenCanal, ARiverFromMeasuredHeightsCarriesItsDischarge) {
    const test::TemporaryFolder folder;
    const double q = 0.0065;
    CanalRun run(canal("heights = \"" + valley(folder.path()) +
                           "\"\n[outflow]\nkind = \"depth\"\ndepth = 0.045\n" + inflow(q) +
                           "profile = \"log-law\"\nequivalent_roughness = 0.001\n",
                       "shape = \"bed\"\n"));
    run.simulation->step();
    const auto at_start = static_cast<std::int64_t>(run.simulation->particles().size());
    const LongWaves up = waves_of_lattice(run.c, true);
    const LongWaves down = waves_of_lattice(run.c, false);
    EXPECT_GT(up.lowest(), 0.0);
    EXPECT_GE(up.lowest(), down.lowest());
    double entering = 0.0;
    double leaving = 0.0;
    int samples = 0;
    for (double time = 0.6; time < 1.2; time += 0.02) {
        run.advance_to(time);
        const OpenEndsState& ends = run.ends();
        entering += up.area(ends.upstream.depth) * ends.upstream.velocity / q;
        leaving += down.area(ends.downstream.depth) * ends.downstream.velocity / q;
        ++samples;
    }
    EXPECT_NEAR(entering / samples, 1.0, 0.01);
    EXPECT_NEAR(leaving / samples, 1.0, 0.04);
    EXPECT_NEAR(run.ends().downstream.depth, depth, 0.001);
    const EndsLedger& ledger = run.ends().ledger;
    EXPECT_EQ(static_cast<std::int64_t>(run.simulation->particles().size()),
              at_start + ledger.entered - ledger.left);
    EXPECT_TRUE(run.simulation->particles().lost.empty());
}

}  // namespace
}  // namespace riffle::open_canal_test
