#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"
#include "temporary_folder.hpp"

// Whatever a user puts together of starts, inflows and outflows either is refused, with the key, or runs.

namespace riffle {
namespace {

std::string channel(const std::string& inflow, const std::string& outflow, const std::string& start) {
    return "[channel]\nslope = 0.004\ndepth = \"60 mm\"\nlength = \"0.3 m\"\nends = \"open\"\n[inflow]\n" +
           inflow + "\n[outflow]\n" + outflow +
           "\n[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n[numerics]\npreset = \"violent\"\nspacing "
           "= \"6 mm\"\n[start]\n" +
           start + "\n[run]\nuntil = \"1 s\"\n";
}

TEST(OpenEndsTogether, EveryStartMeetsEveryInflowAndOutflow) {
    const std::map<std::string, std::string> starts{
        {"uniform", "kind = \"uniform\""},
        {"rest", "kind = \"rest\""},
        {"backwater", "kind = \"backwater\""},
        {"half dry", "kind = \"rest\"\nwater_x = [0, 0.15, 0.15, 0]\nwater_z = [0, 0, 0.06, 0.06]"},
        {"dry at the inflow",
         "kind = \"rest\"\nwater_x = [0.15, 0.3, 0.3, 0.15]\nwater_z = [0, 0, 0.06, 0.06]"}};
    const std::map<std::string, std::string> inflows{{"subcritical", "unit_discharge = 0.02"},
                                                     {"deep", "unit_discharge = 0.06"},
                                                     {"by depth", "depth = \"70 mm\""},
                                                     {"shooting", "unit_discharge = 0.05\ndepth = \"24 mm\""},
                                                     {"none", "unit_discharge = 0"}};
    const std::map<std::string, std::string> outflows{{"depth", "kind = \"depth\"\ndepth = \"75 mm\""},
                                                      {"free", "kind = \"free\""},
                                                      {"weir", "kind = \"weir\"\nweir_height = \"30 mm\""},
                                                      {"critical", "kind = \"critical-depth\""},
                                                      {"fall", "kind = \"free-fall\""},
                                                      {"normal", "kind = \"normal-depth\""}};
    int refused = 0;
    for (const auto& [start_name, start] : starts) {
        for (const auto& [inflow_name, inflow] : inflows) {
            for (const auto& [outflow_name, outflow] : outflows) {
                std::string together = start_name;
                together.append(", ").append(inflow_name).append(", ").append(outflow_name);
                SCOPED_TRACE(together);
                std::unique_ptr<Case> c;
                try {
                    c = std::make_unique<Case>(parse_case(channel(inflow, outflow, start), "ends.toml"));
                } catch (const InputError& e) {
                    EXPECT_EQ(std::string(e.what()).rfind("ends.toml:", 0), 0U) << e.what();
                    ++refused;
                    continue;
                }
                const auto simulation = make_simulation<2>(
                    *c, nullptr, initial_particles<2>(*c, make_scheme(*c, nullptr), nullptr));
                while (simulation->clock().time < 0.06) ASSERT_NO_THROW(simulation->step());
                const auto& particles = simulation->particles();
                ASSERT_GT(particles.size(), 0U);
                EXPECT_TRUE(particles.lost.empty());
                // No water is thrown: three times what a fall of all depths that are named gives.
                for (std::size_t i = 0; i < particles.size(); ++i) {
                    ASSERT_LT(std::hypot(particles.velocity[0][i], particles.velocity[1][i]),
                              3.0 * std::sqrt(2.0 * 9.81 * 0.075) + 0.05 / 0.024);
                }
            }
        }
    }
    // The normal depth of a discharge of nothing, and starts by varied flow without a discharge, one of them
    // both.
    EXPECT_EQ(refused, 5 + 2 * 6 - 1);
}

// A hydrograph that ends: the water that waits before the inflow sinks with the depth and does not go in;
// pressed together it once blew up.
TEST(OpenEndsTogether, AChannelWhoseInflowDriesUpDrains) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "off.csv") << "time,unit_discharge\n0,0.02\n0.5,0\n";
    const std::string inflow = "discharge_file = \"" + (folder.path() / "off.csv").string() + "\"";
    for (const std::string outflow : {"critical-depth", "free"}) {
        for (const std::string preset : {"riffle", "violent"}) {
            SCOPED_TRACE(outflow + ", " + preset);
            Case c =
                parse_case(channel(inflow, "kind = \"" + outflow + "\"", "kind = \"uniform\""), "ends.toml");
            if (preset == "riffle") {
                c.numerics.impact_dissipation = 0.0;
                c.numerics.acoustic_damping = 0.0;
            }
            const auto simulation =
                make_simulation<2>(c, nullptr, initial_particles<2>(c, make_scheme(c, nullptr), nullptr));
            simulation->step();
            const std::size_t before = simulation->particles().size();
            while (simulation->clock().time < 4.5) ASSERT_NO_THROW(simulation->step());
            EXPECT_LT(simulation->particles().size(), before / 2);
            EXPECT_NEAR(simulation->clock().open_ends.upstream.velocity, 0.0, 0.1);
            const EndsLedger& ledger = simulation->clock().open_ends.ledger;
            EXPECT_EQ(static_cast<std::int64_t>(simulation->particles().size() +
                                                simulation->particles().lost.size()),
                      static_cast<std::int64_t>(before) + ledger.entered - ledger.left);
        }
    }
}

// A surge of disordered water without friction between side walls: in 2 s the edges beside the bed held half
// as much water again as there is room, and the run failed (docs/theory.md, Crowds).
TEST(OpenEndsTogether, ASurgeBetweenSideWallsDoesNotCrowdTheEdges) {
    const Case c = parse_case(
        "[channel]\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"0.5 m\"\nwidth = \"80 mm\"\ndimensions = 3\n"
        "ends = \"open\"\nsides = \"walls\"\n[inflow]\nunit_discharge = 0.02\nprofile = \"uniform\"\n"
        "[outflow]\nkind = \"depth\"\ndepth = \"140 mm\"\nrelaxation_time = \"0.5 s\"\n[bed]\nkind = \"slip\"\n"
        "[turbulence]\nclosure = \"none\"\n[numerics]\nspacing = \"10 mm\"\n[run]\nuntil = \"3 s\"\n",
        "ends.toml");
    const auto simulation =
        make_simulation<3>(c, nullptr, initial_particles<3>(c, make_scheme(c, nullptr), nullptr));
    const double dx = c.numerics.spacing;
    double in_edges = 0.0, in_places = 0.0;
    for (int n = 0; n < 20; ++n) {
        const double until = simulation->clock().time + 0.1;
        while (simulation->clock().time < until) ASSERT_NO_THROW(simulation->step());
        if (simulation->clock().time > 1.0) {
            const Particles<3>& p = simulation->particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                const double beside = std::min(p.position[1][i], c.channel.width - p.position[1][i]);
                if (beside < dx && p.position[2][i] < dx && p.position[0][i] > 0.1 &&
                    p.position[0][i] < 0.4) {
                    in_edges += 1.0;
                }
            }
            in_places += 2.0 * 0.3 / dx;
        }
    }
    EXPECT_GT(in_places, 0.0);
    EXPECT_NEAR(in_edges / in_places, 1.0, 0.2);
}

}  // namespace
}  // namespace riffle
