// The options of the pair sums in flows with exact solutions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "case/words.hpp"
#include "exact_flows.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

using std::numbers::pi;

/// Largest error of u of any particle, 50 times up to L^2/nu, over U_max.
double poiseuille_error(const std::vector<Override>& overrides) {
    CheckRun run("poiseuille", overrides);
    const Case& c = run.parameters();
    const double nu = c.fluid.kinematic_viscosity;
    const double width = c.total_depth();
    const double force = c.streamwise_gravity();
    const auto exact = [&](double z) { return start_up_poiseuille(force, nu, width, z, run.time()); };
    double largest = 0.0;
    for (int sample = 1; sample <= 50; ++sample) {
        run.advance_to(0.02 * sample * width * width / nu);
        largest = std::max(largest, profile_error(run, exact).largest);
    }
    return largest / (force * width * width / (8.0 * nu));
}

struct Decay {
    double rate = 0.0;           ///< of the vortices from 0.2 to 1 s over 2 nu k^2
    double smallest_gap = 0.0;   ///< distance of the nearest two particles at 1 s, in spacings
    double largest_speed = 0.0;  ///< at 1 s, m/s
};

/// Decay of the vortices of the check case; of those of the viscosity `nu` where it is given.
Decay taylor_green(const std::vector<Override>& overrides, double nu = 0.0) {
    CheckRun run("taylor-green", overrides);
    const Case& c = run.parameters();
    const double k = 2.0 * pi / c.channel.length;
    const Particles<2>& p = run.particles();
    run.advance_to(0.2);
    const double first_time = run.time();
    const double first = vortex_amplitude(run);
    run.advance_to(1.0);
    const double exact = 2.0 * (nu > 0.0 ? nu : c.fluid.kinematic_viscosity) * k * k;
    Decay decay;
    decay.rate = std::log(first / vortex_amplitude(run)) / (run.time() - first_time) / exact;
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = i + 1; j < p.size(); ++j) {
            const double x = std::remainder(p.position[0][i] - p.position[0][j], c.channel.length);
            const double z = std::remainder(p.position[1][i] - p.position[1][j], c.total_depth());
            squared = std::min(squared, x * x + z * z);
        }
    }
    decay.smallest_gap = std::sqrt(squared) / c.numerics.spacing;
    decay.largest_speed = largest_speed(p);
    return decay;
}

/// Change of the level of still water in a channel within 4 s over its depth.
double change_of_level(const std::vector<Override>& overrides) {
    std::vector<Override> all{{"channel.ends", "periodic"}};
    all.insert(all.end(), overrides.begin(), overrides.end());
    CheckRun run("hydrostatic-tank", all);
    run.advance_to(4.0);
    const double level =
        2.0 * mass_mean(run.particles(), [&](std::size_t i) { return run.particles().position[1][i]; });
    return level / run.parameters().total_depth() - 1.0;
}

class EveryKernel : public testing::TestWithParam<Word> {};

}  // namespace

// Both widths of the envelope; walls of as many layers as the support needs.
TEST_P(EveryKernel, FollowsPoiseuille) {
    const std::string kernel(GetParam().name);
    expect_below("Poiseuille, " + kernel + ", h = 1.5 dx", "largest error of u / U_max", 0.01,
                 poiseuille_error({{"numerics.kernel", kernel}}));
    expect_below(
        "Poiseuille, " + kernel + ", h = 2 dx", "largest error of u / U_max", 0.01,
        poiseuille_error(
            {{"numerics.kernel", kernel}, {"numerics.smoothing_ratio", "2"}, {"numerics.wall_layers", "4"}}));
}

TEST_P(EveryKernel, LetsVorticesDecay) {
    const std::string kernel(GetParam().name);
    const Decay decay = taylor_green({{"numerics.kernel", kernel}, {"numerics.smoothing_ratio", "2"}});
    expect_below("Taylor-Green, " + kernel + ", h = 2 dx", "rate of decay against 2 nu k^2", 0.03,
                 std::abs(decay.rate - 1.0));
}

INSTANTIATE_TEST_SUITE_P(PairOptions, EveryKernel, testing::ValuesIn(Words<KernelKind>::list),
                         [](const auto& instance) {
                             std::string name(instance.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// The softening eta^2 = 0.01 h^2 takes r^2/(r^2 + eta^2), 2.2 % from the nearest neighbours at h = 1.5 dx:
// the viscosity is too small by about as much, and the steady velocity too large.
TEST(PairOptions, LoShaoFollowsPoiseuille) {
    expect_below("Poiseuille, lo-shao", "largest error of u / U_max", 0.03,
                 poiseuille_error({{"numerics.viscosity", "lo-shao"}}));
}

// Between approaching particles alone, half of all: nu = alpha h c0/(4 (D + 2)). Along the line of centres
// vortices decay 7 % too slowly (docs/verification.md), the softening takes 2 %, and which half of the pairs
// approach depends on the flow: 15 % are allowed.
TEST(PairOptions, ArtificialViscosityOfVortices) {
    constexpr double alpha = 0.2;
    const double h = 1.5 * 0.015625;
    const double sound_speed = 20.0;
    const Decay decay =
        taylor_green({{"numerics.viscosity", "artificial"}, {"numerics.artificial_viscosity", "0.2"}},
                     alpha * h * sound_speed / 16.0);
    expect_below("Taylor-Green, artificial, alpha 0.2", "rate of decay against alpha h c0/16", 0.15,
                 std::abs(decay.rate - 1.0));
}

// The dissipation of the Riemann problem comes on top of the viscosity.
TEST(PairOptions, RiemannDampsVortices) {
    const Decay decay = taylor_green({{"numerics.pressure_form", "riemann"}});
    const Decay plain = taylor_green({{"numerics.pressure_form", "symmetric"}});
    expect_below("Taylor-Green, riemann", "rate of decay over 2 nu k^2", 2.0, decay.rate);
    expect_below("Taylor-Green, symmetric", "rate of decay over 2 nu k^2", 2.0, plain.rate);
    EXPECT_GT(decay.rate, plain.rate);
}

// Nothing at uniform pressure, so no spurious stress of disordered particles; but nothing evens them out
// either, and momentum is not kept. Asked is that it damps no more than the conservative form, by 10 %.
TEST(PairOptions, RiemannNonConservativeLetsVorticesDecay) {
    const Decay decay = taylor_green({{"numerics.pressure_form", "riemann-non-conservative"}});
    expect_below("Taylor-Green, riemann-non-conservative", "rate of decay against 2 nu k^2", 0.1,
                 std::abs(decay.rate - 1.0));
}

// Molteni's diffusion takes density from the bed to the surface, and the spacing follows: the level misses
// the bar of the tank; that of Fourtakas vanishes in still water and keeps it.
TEST(PairOptions, MolteniMovesTheLevel) {
    const double molteni = change_of_level({{"numerics.density_diffusion", "molteni"}});
    const double fourtakas = change_of_level({{"numerics.density_diffusion", "fourtakas"}});
    expect_below("still water 4 s, molteni", "change of level / H", 0.1, std::abs(molteni));
    expect_below("still water 4 s, fourtakas", "change of level / H", 5e-3, std::abs(fourtakas));
    EXPECT_GT(std::abs(molteni), 5e-3);
}

// Antuono's diffusion takes the linear part of the density out, whatever the water rests on: it keeps the
// level like that of Fourtakas, and the vortices.
TEST(PairOptions, AntuonoKeepsTheLevel) {
    expect_below("still water 4 s, antuono", "change of level / H", 5e-3,
                 std::abs(change_of_level({{"numerics.density_diffusion", "antuono"}})));
}

TEST(PairOptions, AntuonoLetsVorticesDecay) {
    const Decay decay = taylor_green({{"numerics.density_diffusion", "antuono"}});
    expect_below("Taylor-Green, antuono", "rate of decay against 2 nu k^2", 0.03, std::abs(decay.rate - 1.0));
}

// The kernel over its sum in place of the inverse first moments: right in layered flow, but disordered
// particles make the stress of the symmetric form, by which vortices decay 7 % too fast.
TEST(PairOptions, KernelCorrectionFollowsPoiseuille) {
    expect_below("Poiseuille, kernel correction", "largest error of u / U_max", 0.01,
                 poiseuille_error({{"numerics.kernel_correction", "kernel"}}));
}

TEST(PairOptions, KernelCorrectionDampsVortices) {
    const Decay decay = taylor_green({{"numerics.kernel_correction", "kernel"}});
    expect_below("Taylor-Green, kernel correction", "rate of decay against 2 nu k^2", 0.1,
                 std::abs(decay.rate - 1.0));
}

// What the correction is for: the cubic spline lets particles clump in pairs.
TEST(PairOptions, TensileCorrectionKeepsParticlesApart) {
    const std::vector<Override> scheme{{"numerics.kernel", "cubic-spline"},
                                       {"numerics.smoothing_ratio", "1.5"},
                                       {"numerics.pressure_form", "symmetric"}};
    std::vector<Override> corrected = scheme;
    corrected.push_back({"numerics.tensile_correction", "0.2"});
    const Decay without = taylor_green(scheme);
    const Decay with = taylor_green(corrected);
    std::printf("nearest particles, spacings: %.3f without, %.3f with tensile correction; rates %.3f, %.3f\n",
                without.smallest_gap, with.smallest_gap, without.rate, with.rate);
    EXPECT_GT(with.smallest_gap, without.smallest_gap);
}
