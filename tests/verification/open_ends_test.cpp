#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <set>
#include <vector>

#include "base/parallel.hpp"
#include "case/end_levels.hpp"
#include "drifting_log.hpp"
#include "ends/end_input.hpp"
#include "ends/section_state.hpp"
#include "open_run.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"
#include "temporary_folder.hpp"

// Channels with open ends, small enough for seconds. Laminar: U(z) is the parabola of the discharge.

namespace riffle {
namespace {

constexpr double depth = 0.02;
constexpr double viscosity = 1e-4;
constexpr double slope = 0.002;

std::string laminar_channel(const std::string& more, int dimensions = 2, double spacing = 0.002,
                            const std::string& numerics = "") {
    return "[channel]\nslope = " + std::to_string(slope) + "\ndepth = " + std::to_string(depth) +
           "\nlength = 0.1\nends = \"open\"\ndimensions = " + std::to_string(dimensions) +
           "\nwidth = 0.016\n"
           "[bed]\nkind = \"no-slip\"\n[turbulence]\nclosure = \"none\"\n[fluid]\nkinematic_viscosity = " +
           std::to_string(viscosity) + "\n[numerics]\nspacing = " + std::to_string(spacing) + "\n" +
           numerics + "[run]\nuntil = \"1 s\"\n" + more;
}

/// g S0 H^3/(3 nu).
double laminar_discharge() {
    return 9.81 * std::sin(std::atan(slope)) * depth * depth * depth / (3.0 * viscosity);
}

using test::OpenRun;

std::string inflow(double unit_discharge) {
    return "[inflow]\nunit_discharge = " + std::to_string(unit_discharge) + "\n";
}

/// Particles before the first step, those that wait beyond the ends included: none of them has entered or
/// left.
template <int D>
std::size_t particles_at_start(const OpenRun<D>& run) {
    const OpenRun<D> again(run.c);
    again.simulation->step();
    EXPECT_EQ(again.ends().ledger, EndsLedger{});
    return again.simulation->particles().size();
}

/// Particles at the start and those made and taken out since are those that are there: each by its number.
template <int D>
void expect_account_closes(const OpenRun<D>& run, std::size_t at_start) {
    const auto& particles = run.simulation->particles();
    const EndsLedger& ledger = run.ends().ledger;
    EXPECT_EQ(static_cast<std::int64_t>(particles.size() + particles.lost.size()),
              static_cast<std::int64_t>(at_start) + ledger.entered - ledger.left);
    EXPECT_TRUE(particles.lost.empty());
    const std::set<std::int32_t> numbers(particles.id.begin(), particles.id.end());
    EXPECT_EQ(numbers.size(), particles.size());  // each once
    EXPECT_LT(*numbers.rbegin(), particles.created);
}

/// The laminar channel at its normal depth, with a reference pressure or without.
struct UniformFlow {
    double departure = 0.0;  ///< of U(z) from the parabola, rms over its mean
    double level = 0.0;      ///< mean, over H
    // Mean powers over that of the weight.
    double weight = 0.0;
    double pressure = 0.0;
    double viscosity_and_diffusion = 0.0;

    explicit UniformFlow(const std::string& reference) {
        OpenRun<2> run(laminar_channel(inflow(laminar_discharge()) + "[outflow]\nkind = \"normal-depth\"\n",
                                       2, 0.00125, "reference_pressure = \"" + reference + "\"\n"));
        const std::size_t at_start = particles_at_start(run);
        const double exact = 1000.0 * 9.81 * std::sin(std::atan(slope)) * laminar_discharge() * 0.1;
        EnergyRates power;
        double samples = 0.0;
        for (double time = 1.0; time < 3.0;
             time += 0.05) {  // the slow water at the bed is renewed within 3 s
            run.advance_to(time);
            add_profile(run);
            power = power + run.simulation->energy_rates();
            samples += 1.0;
        }
        double squares = 0.0;
        for (std::size_t layer = 0; layer < layers; ++layer) {
            squares += std::pow(departures_[layer] / count_[layer], 2) / layers;
        }
        departure = std::sqrt(squares) / mean;
        level /= samples * depth;
        weight = power.gravity / (samples * exact);
        pressure = power.pressure / (samples * exact);
        viscosity_and_diffusion = (power.viscosity + power.density_diffusion) / (samples * exact);
        expect_account_closes(run, at_start);
    }

  private:
    static constexpr std::size_t layers = 16;
    const double mean = laminar_discharge() / depth;
    std::array<double, layers> count_{};
    std::array<double, layers> departures_{};

    void add_profile(const OpenRun<2>& run) {
        const auto& p = run.simulation->particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = p.position[0][i];
            if (x < 0.0 || x >= 0.1) continue;
            level += p.mass[i] / (1000.0 * (1.0 + p.density_deviation[i])) / 0.1;
            const double place = p.position[1][i] / depth;
            const auto layer = static_cast<std::size_t>(std::clamp(place * layers, 0.0, layers - 0.5));
            count_[layer] += 1.0;
            departures_[layer] += p.velocity[0][i] - 1.5 * mean * place * (2.0 - place);
        }
    }
};

// U(z) within 1 % rms of its mean, the level within 0.5 % of H. Along a uniform channel the ends give
// nothing, the weight drives all of the water between them, and the viscosity takes it, with what the
// pressure of the scheme feeds to the disorder of the particles, a tenth of it here: the budget of energy
// counts no particle beyond an end, and closes. With a reference pressure the pairs carry less of the
// pressure, and so feed less.
TEST(OpenEnds, UniformFlowStaysUniformAndItsEnergyIsBooked) {
    std::vector<double> fed;
    for (const std::string reference : {"none", "hydrostatic"}) {
        const UniformFlow flow(reference);
        EXPECT_LT(flow.departure, 0.01) << reference;
        EXPECT_NEAR(flow.level, 1.0, 0.005) << reference;
        EXPECT_NEAR(flow.weight, 1.0, 0.01) << reference;
        EXPECT_NEAR(flow.weight + flow.pressure + flow.viscosity_and_diffusion, 0.0, 0.03) << reference;
        EXPECT_LT(std::abs(flow.pressure), 0.2) << reference;
        fed.push_back(flow.pressure);
    }
    EXPECT_LT(fed[1], 0.6 * fed[0]);
}

TEST(OpenEnds, TheDischargeIsThatOfTheCase) {
    const double q = 1.3 * laminar_discharge();
    OpenRun<2> run(laminar_channel(inflow(q) + "[outflow]\nkind = \"depth\"\ndepth = 0.02\n"));
    run.advance_to(0.2);
    const double before = run.ends().ledger.mass_entered;
    const double from = run.simulation->clock().time;
    run.advance_to(2.2);
    // Water is made particle by particle, ten streams of them.
    const double particle = 1000.0 * 0.002 * 0.002;
    EXPECT_NEAR(run.ends().ledger.mass_entered - before, 1000.0 * q * (run.simulation->clock().time - from),
                15 * particle);
}

TEST(OpenEnds, SupercriticalFlowPasses) {
    const double h = 0.02;
    const double q = 2.0 * std::sqrt(9.81 * h) * h;  // Fr = 2
    const std::string text =
        laminar_channel("[inflow]\nunit_discharge = " + std::to_string(q) +
                        "\ndepth = 0.02\nprofile = \"uniform\"\n[outflow]\nkind = \"free\"\n");
    std::string slip = text;
    slip.replace(slip.find("no-slip"), 7, "slip");
    OpenRun<2> run(slip);
    const std::size_t at_start = particles_at_start(run);
    run.advance_to(0.5);  // the water passes four times
    expect_account_closes(run, at_start);
    EXPECT_NEAR(run.ends().downstream.depth, h, 0.01 * h);
    EXPECT_NEAR(run.ends().downstream.velocity, q / h, 0.02 * q / h);  // the slope adds 1 %
}

/// Mean from one time to another of the depth within `half` of a place along the channel, m, sampled each
/// 0.02 s, and the discharge that enters in these moments, m2/s.
struct Watched {
    double depth = 0.0;
    std::vector<double> entering;

    Watched(OpenRun<2>& run, double place, double half, double from, double to) {
        double area = 0.0;
        for (double time = from; time < to; time += 0.02) {
            run.advance_to(time);
            const auto& p = run.simulation->particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                area += std::abs(p.position[0][i] - place) < half ? p.mass[i] / 1000.0 : 0.0;
            }
            entering.push_back(run.ends().upstream.velocity * run.ends().upstream.depth);
        }
        depth = area / static_cast<double>(entering.size()) / (2.0 * half);
    }

    /// Standard deviation of the discharge over its mean.
    [[nodiscard]] double swing() const {
        double sum = 0.0;
        double squares = 0.0;
        for (const double q : entering) {
            sum += q;
            squares += q * q;
        }
        const auto n = static_cast<double>(entering.size());
        return std::sqrt(std::max(0.0, squares * n / (sum * sum) - 1.0));
    }
};

double mean_depth(OpenRun<2>& run, double place, double half, double from, double to) {
    return Watched(run, place, half, from, to).depth;
}

// A tailwater deeper than the depth that the flow can jump to drives a jump up the channel, and the flow
// leaves at its depth.
TEST(OpenEnds, ATailwaterDrivesAJumpUpTheChannel) {
    const double h = 0.02;
    const double q = 2.0 * std::sqrt(9.81 * h) * h;  // Fr = 2: it can jump to 47 mm
    OpenRun<2> run(
        "[channel]\nslope = 0\ndepth = 0.055\nlength = 0.4\nends = \"open\"\n[bed]\nkind = \"slip\"\n[turbulence]\n"
        "closure = \"none\"\n" +
        inflow(q) +
        "depth = 0.02\nprofile = \"uniform\"\n[outflow]\nkind = \"depth\"\ndepth = 0.055\nrelaxation_time = 0.2\n[numerics]\n"
        "preset = \"violent\"\nspacing = 0.0025\n[start]\nkind = \"uniform\"\nwater_x = [0, 0.4, 0.4, 0]\nwater_z = "
        "[0, 0, 0.02, 0.02]\n[run]\nuntil = \"1 s\"\n");
    const std::size_t at_start = particles_at_start(run);
    EXPECT_GT(run.ends().downstream.velocity, wave_speed(9.81, run.ends().downstream.depth));
    const double depth_before_end = mean_depth(run, 0.35, 0.03, 1.8, 2.4);
    expect_account_closes(run, at_start);
    EXPECT_NEAR(depth_before_end / 0.055, 1.0, 0.1);
    EXPECT_LT(run.ends().downstream.velocity, wave_speed(9.81, run.ends().downstream.depth));
}

// Shooting water meets a channel that the start fills deeper: at the inflow the surface falls as water does,
// and all of it stays in the account.
TEST(OpenEnds, ShootingWaterMeetsADeeperStart) {
    for (const std::string start : {"rest", "uniform"}) {
        const double h = 0.02;
        const double q = 3.0 * std::sqrt(9.81 * h) * h;
        OpenRun<2> run(
            "[channel]\nslope = 0\ndepth = 0.07\nlength = 0.3\nends = \"open\"\n[bed]\nkind = \"slip\"\n[turbulence]\n"
            "closure = \"none\"\n" +
            inflow(q) +
            "depth = 0.02\nprofile = \"uniform\"\n[outflow]\nkind = \"depth\"\ndepth = 0.07\n[numerics]\npreset = "
            "\"violent\"\nspacing = 0.004\n[start]\nkind = \"" +
            start + "\"\n[run]\nuntil = \"1 s\"\n");
        const std::size_t at_start = particles_at_start(run);
        double fastest = 0.0;
        for (double time = 0.02; time < 0.5; time += 0.02) {
            run.advance_to(time);
            const auto& p = run.simulation->particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                fastest = std::max(fastest, std::hypot(p.velocity[0][i], p.velocity[1][i]));
            }
        }
        expect_account_closes(run, at_start);
        EXPECT_NEAR(run.ends().upstream.depth, h, 1e-9) << start;
        EXPECT_LT(fastest, 2.0 * q / h + std::sqrt(9.81 * 0.07)) << start;
    }
}

// The depth at the outflow rises by a tenth in a second: the water must come back from there, and the buffer
// stay full.
TEST(OpenEnds, AFlowThatTurnsRoundFillsTheChannelFromItsOutflow) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "tide.csv") << "time,depth\n0,0.02\n1,0.022\n";
    const std::string text =
        laminar_channel(inflow(0.0) + "[outflow]\nkind = \"depth\"\nrelaxation_time = 0.1\ndepth_file = \"" +
                        (folder / "tide.csv").string() + "\"\n[start]\nkind = \"rest\"\n");
    OpenRun<2> run(text);
    const std::size_t at_start = particles_at_start(run);
    double fastest_back = 0.0;
    double inside = 0.0;
    double beyond = 0.0;
    double samples = 0.0;
    for (double time = 0.05; time < 3.0; time += 0.05) {
        run.advance_to(time);
        fastest_back = std::min(fastest_back, run.ends().downstream.velocity);
        if (time < 2.0) {  // the water still swings
            continue;
        }
        const auto& p = run.simulation->particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = p.position[0][i];
            const double area = p.mass[i] / (1000.0 * (1.0 + p.density_deviation[i]));
            inside += x >= 0.0 && x < 0.1 ? area : 0.0;
            beyond += x >= 0.1 ? area : 0.0;
        }
        samples += 1.0;
    }
    inside /= samples;
    beyond /= samples;
    EXPECT_LT(fastest_back, 0.0);
    expect_account_closes(run, at_start);
    // Still water is as much shallower in the middle as the bed is higher there.
    EXPECT_NEAR(inside / 0.1 / (0.022 - slope * 0.05), 1.0, 0.01);
    EXPECT_GT(beyond, 0.7 * 4.0 * 1.5 * 0.002 * 0.022);
}

/// A weir between open ends, a sixth of a laboratory's: at rest, and dry behind it.
std::string weir(double unit_discharge, double level) {
    const std::string at = std::to_string(level);
    return "[channel]\nslope = 0\ndepth = " + at +
           "\nlength = 0.5\nends = \"open\"\n[bed]\nkind = \"slip\"\n[turbulence]\nclosure = \"none\"\n" +
           inflow(unit_discharge) +
           "profile = \"uniform\"\n[outflow]\nkind = \"free\"\n[numerics]\npreset = \"violent\"\nspacing = 0.004\n"
           "[start]\nkind = \"rest\"\nwater_x = [0, 0.21, 0.21, 0]\nwater_z = [0, 0, " +
           at + ", " + at +
           "]\n[[solid]]\nname = \"weir\"\nx = [0.2, 0.26, 0.2]\nz = [0, 0, 0.1]\nsurface = \"slip\"\n[run]\nuntil = "
           "\"1 s\"\n";
}

std::string overfall(double unit_discharge) {
    return "[channel]\nslope = 0.001\ndepth = 0.1\nlength = 0.6\nends = \"open\"\n[bed]\nkind = "
           "\"roughness\"\nequivalent_roughness = 0.002\n" +
           inflow(unit_discharge) +
           "[outflow]\nkind = \"free-fall\"\n[numerics]\nspacing = 0.01\n[start]\nkind = \"backwater\"\n"
           "[run]\nuntil = \"1 s\"\n";
}

// Over the edge of a bed that ends the depth is 0.715 of the critical one (Rouse 1936).
TEST(OpenEnds, AnOverfallHasItsDepthOverTheEdge) {
    const double q = 0.06;
    OpenRun<2> run(overfall(q));
    const std::size_t at_start = particles_at_start(run);
    const double depth_over_edge = mean_depth(run, 0.6, 0.015, 2.0, 4.0);
    expect_account_closes(run, at_start);
    const double critical = critical_depth_of(9.81, q);
    EXPECT_NEAR(depth_over_edge / critical / 0.715, 1.0, 0.03);
    EXPECT_GT(run.ends().ledger.left, 0);
}

// Water at rest behind a weir, a dry bed beyond: what comes in goes over it, at the head of its rating
// (Kindsvater & Carter 1957), and leaves. 15 rows over the crest: see verify.py open_sharp_weir for its bar.
// What comes in does not swing: in the pool of 40 rows it did, by 4.6 %, where the water beside the inflow
// was watched over six spacings, and in one of 84 rows by 70 %.
TEST(OpenEnds, WaterGoesOverAWeirAndLeavesOverADryBed) {
    const double head = 0.06;
    const auto rating = [](double h) {
        return (0.602 + 0.075 * h / 0.1) * 2.0 / 3.0 * std::sqrt(2.0 * 9.81) * std::pow(h + 0.001, 1.5);
    };
    OpenRun<2> run(weir(rating(head), 0.1 + head));
    const std::size_t at_start = particles_at_start(run);
    EXPECT_EQ(run.ends().downstream.depth, 0.0);
    run.advance_to(3.0);
    const EndsLedger before = run.ends().ledger;
    const double from = run.simulation->clock().time;
    const Watched pool(run, 0.1, 0.03, 3.0, 4.5);
    expect_account_closes(run, at_start);
    const EndsLedger& after = run.ends().ledger;
    const double seconds = run.simulation->clock().time - from;
    const double came = (after.mass_entered - before.mass_entered) / 1000.0 / seconds;
    const double went = (after.mass_left - before.mass_left) / 1000.0 / seconds;
    EXPECT_NEAR(came / rating(head), 1.0, 0.02);
    EXPECT_NEAR(went / came, 1.0, 0.05);
    EXPECT_NEAR(came / rating(pool.depth - 0.1), 1.0, 0.05);
    EXPECT_LT(pool.swing(), 0.01);
}

/// A laminar duct that doubles its height in a step, which reaches through the inflow.
std::string duct(const std::string& step) {
    return "[channel]\nslope = 0\ndepth = 0.02\nlength = 0.12\nends = \"open\"\ntop = \"wall\"\n[bed]\nkind = "
           "\"no-slip\"\n[turbulence]\nclosure = \"none\"\n[fluid]\nkinematic_viscosity = 1e-4\n" +
           inflow(2e-3) +
           "[outflow]\nkind = \"pressure\"\n[numerics]\nspacing = 0.00125\n[start]\nkind = \"uniform\"\n" +
           step + "[run]\nuntil = \"1 s\"\n";
}

const std::string step_through_inflow =
    "[[solid]]\nname = \"step\"\nx = [-0.05, 0.04, 0.04, -0.05]\nz = [0, 0, 0.01, 0.01]\n";

// Through a duct the discharge goes with the parabola of its height, and the pressure falls by 12 nu q/H^3.
TEST(OpenEnds, ADuctHasThePressureOfPoiseuille) {
    OpenRun<2> run(duct(""));
    const std::size_t at_start = particles_at_start(run);
    const double height = 0.02;
    const double mean = 2e-3 / height;
    double squares = 0.0;
    double count = 0.0;
    double slope_sum = 0.0;
    double weight = 0.0;
    for (double time = 1.0; time < 2.0; time += 0.05) {
        run.advance_to(time);
        const auto& p = run.simulation->particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = p.position[0][i];
            if (x < 0.02 || x > 0.1) continue;
            const double place = p.position[1][i] / height;
            squares += std::pow(p.velocity[0][i] / mean - 6.0 * place * (1.0 - place), 2);
            count += 1.0;
            const double pressure = run.simulation->scheme().state.pressure(p.density_deviation[i]);
            slope_sum -= (x - 0.06) * pressure;
            weight += (x - 0.06) * (x - 0.06);
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.02);
    EXPECT_NEAR(slope_sum / weight / (12.0 * 1e-4 * 2e-3 / std::pow(height, 3)), 1.0, 0.05);
    expect_account_closes(run, at_start);
}

// Whatever enters a duct leaves it, and the water that comes over a step parts from it: it runs back at the
// bed behind it.
TEST(OpenEnds, WaterPartsFromAStepThroughTheInflow) {
    OpenRun<2> run(duct(step_through_inflow));
    const std::size_t at_start = particles_at_start(run);
    run.advance_to(1.0);
    expect_account_closes(run, at_start);
    EXPECT_NEAR(run.ends().upstream.velocity * run.ends().upstream.depth / 2e-3, 1.0, 0.01);
    EXPECT_NEAR(run.ends().downstream.velocity * run.ends().downstream.depth / 2e-3, 1.0, 0.02);
    const auto& p = run.simulation->particles();
    double back = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = p.position[0][i];
        const double z = p.position[1][i];
        EXPECT_FALSE(x < 0.04 && z < 0.01 - 2e-4) << "in the step at x = " << x << ", z = " << z;
        back += x > 0.042 && x < 0.05 && z < 0.003 ? p.velocity[0][i] : 0.0;
    }
    EXPECT_LT(back, 0.0);
}

// A solid through both ends is a bed: supercritical flow passes over it as it does over the bed.
TEST(OpenEnds, ASolidThroughBothEndsIsABed) {
    const double h = 0.02;
    const double q = 2.0 * std::sqrt(9.81 * h) * h;
    const std::string text =
        "[channel]\nslope = 0\ndepth = 0.03\nlength = 0.1\nends = \"open\"\n[bed]\nkind = \"slip\"\n"
        "[turbulence]\nclosure = \"none\"\n" +
        inflow(q) +
        "depth = 0.03\nprofile = \"uniform\"\n[outflow]\nkind = \"free\"\n[numerics]\nspacing = 0.002\n"
        "[start]\nkind = \"uniform\"\n[[solid]]\nname = \"bed\"\nx = [-0.1, 0.2, 0.2, -0.1]\n"
        "z = [0, 0, 0.01, 0.01]\nsurface = \"slip\"\n[run]\nuntil = \"1 s\"\n";
    OpenRun<2> run(text);
    const std::size_t at_start = particles_at_start(run);
    run.advance_to(0.5);
    expect_account_closes(run, at_start);
    EXPECT_NEAR(run.ends().upstream.depth, h, 1e-9);
    EXPECT_NEAR(run.ends().downstream.depth, h, 0.01 * h);
    EXPECT_NEAR(run.ends().downstream.velocity, q / h, 0.01 * q / h);
}

/// The case of a text, in which `tide.csv` is a tailwater that rises fast enough for water to come in.
class OpenEndsBits : public ::testing::TestWithParam<std::string> {
  protected:
    [[nodiscard]] Case read() const {
        const std::filesystem::path file = folder_.path() / "tide.csv";
        std::ofstream(file) << "time [s],depth [mm]\n0,20\n0.5,26\n";
        std::string text = GetParam();
        if (const std::size_t at = text.find("tide.csv"); at != std::string::npos) {
            text.replace(at, std::string("tide.csv").size(), file.string());
        }
        return parse_case(text, "open ends");
    }

  private:
    test::TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(OpenEnds, OpenEndsBits,
                         ::testing::Values(laminar_channel(inflow(1.2 * laminar_discharge()) +
                                                           "[outflow]\nkind = \"critical-depth\"\n"),
                                           overfall(0.06), weir(0.03, 0.16), duct(step_through_inflow),
                                           test::drifting_log(0.3),
                                           laminar_channel(inflow(0.2 * laminar_discharge()) +
                                                           "[outflow]\nkind = \"depth\"\ndepth_file = "
                                                           "\"tide.csv\"\n")));

TEST_P(OpenEndsBits, TheSameForAnyNumberOfThreadsAndAfterARestore) {
    const Case c = read();
    const int threads = thread_count();
    set_thread_count(1);
    OpenRun<2> one(c);
    one.advance_to(0.3);
    if (tailwater_changes(c)) {
        EXPECT_LT(one.ends().downstream.velocity, 0.0);
    }
    set_thread_count(2);
    OpenRun<2> two(c);
    two.advance_to(0.15);
    // A state in the middle, as a checkpoint keeps it.
    OpenRun<2> resumed(c);
    resumed.restore_from(two);
    two.advance_to(0.3);
    resumed.advance_to(0.3);
    set_thread_count(threads);
    expect_same_bits(one, two);
    expect_same_bits(one, resumed);
}

// A drop that flies out of the domain, of water whose particles have come and gone since the last sample.
TEST(OpenEnds, ADropThatIsLostHasItsRowInTheAccount) {
    Case c = parse_case(laminar_channel(inflow(laminar_discharge()) + "[outflow]\nkind = \"normal-depth\"\n"),
                        "open ends");
    c.turbulence.closure = ClosureKind::sps;
    const Scheme scheme = make_scheme(c, nullptr);
    Particles<2> particles = initial_particles<2>(c, scheme, nullptr);
    const std::size_t drop = particles.append(1);
    particles.position[0][drop] = 0.05;
    particles.position[1][drop] = depth + 0.01;
    particles.velocity[1][drop] = 2.0;
    particles.mass[drop] = particles.mass[0];
    const auto simulation = make_simulation<2>(c, nullptr, particles);
    simulation->step(1e-9);  // a sample of all fields
    const std::size_t at_start = simulation->particles().size();
    EXPECT_EQ(simulation->clock().open_ends.ledger, EndsLedger{});
    while (simulation->clock().time < 0.5 && simulation->particles().lost.empty()) simulation->step();
    ASSERT_EQ(simulation->particles().lost.size(), 1U);
    const EndsLedger& ledger = simulation->clock().open_ends.ledger;
    EXPECT_EQ(static_cast<std::int64_t>(simulation->particles().size()) + 1,
              static_cast<std::int64_t>(at_start) + ledger.entered - ledger.left);
    simulation->step(simulation->clock().time + 1e-9);
    EXPECT_EQ(simulation->fields().pressure.size(), simulation->particles().size());
}

TEST(OpenEnds, SpaceIsLikeAPlane) {
    OpenRun<3> run(laminar_channel(inflow(laminar_discharge()) + "[outflow]\nkind = \"normal-depth\"\n", 3));
    const std::size_t at_start = particles_at_start(run);
    run.advance_to(0.5);
    expect_account_closes(run, at_start);
    const double mean = laminar_discharge() / depth;
    EXPECT_NEAR(run.ends().upstream.depth / depth, 1.0, 0.01);
    EXPECT_NEAR(run.ends().downstream.depth / depth, 1.0, 0.01);
    EXPECT_NEAR(run.ends().downstream.velocity / mean, 1.0, 0.02);
}

}  // namespace
}  // namespace riffle
