// What a surface is made of, of surfaces made of known patterns.

#include "analysis/surface_families.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "base/error.hpp"

namespace riffle::surface_families_test {
namespace {

using std::numbers::pi;

constexpr double current = 0.4;  // m/s, of the water at the surface

GravityCapillaryWaves waves() {
    GravityCapillaryWaves w;
    w.depth = 0.05;
    w.velocity = current;
    return w;
}

SurfacePlan empty_plan(std::size_t times, double interval = 0.05) {
    SurfacePlan plan;
    plan.columns = 24;
    plan.rows = 12;
    plan.spacing_x = 0.15 / 24.0;
    plan.spacing_y = 0.0866 / 12.0;
    plan.interval = interval;
    plan.elevation.assign(times * 24 * 12, 0.0);
    return plan;
}

/// Add waves of random amplitude and phase of all wavenumbers that fit up to a few periods, with the
/// frequencies that `omega` gives them, of so much variance in all.
template <class Frequency>
void add(SurfacePlan& plan, double variance, unsigned seed, const Frequency& omega) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    struct Wave {
        double kx, ky, omega, phase, amplitude;
    };
    std::vector<Wave> all;
    double sum = 0.0;
    for (int m = 1; m <= 4; ++m) {
        for (int n = -2; n <= 2; ++n) {
            const double kx = 2.0 * pi * m / 0.15;
            const double ky = 2.0 * pi * n / 0.0866;
            all.push_back({kx, ky, omega(kx, ky), pi * normal(generator), 1.0 + 0.3 * normal(generator)});
            sum += 0.5 * all.back().amplitude * all.back().amplitude;
        }
    }
    const double scale = std::sqrt(variance / sum);
    const std::size_t points = plan.rows * plan.columns;
    for (std::size_t at = 0; at < plan.elevation.size(); ++at) {
        const double x = plan.spacing_x * static_cast<double>(at % plan.columns);
        const double y = plan.spacing_y * static_cast<double>(at / plan.columns % plan.rows);
        const double t = plan.interval * static_cast<double>(at / points);
        for (const Wave& w : all) {
            plan.elevation[at] += scale * w.amplitude * std::cos(w.kx * x + w.ky * y - w.omega * t + w.phase);
        }
    }
}

double own(double kx, double ky) { return waves().intrinsic_frequency(std::hypot(kx, ky)); }

TEST(SurfaceFamilies, AreToldApartByTheWayTheyMove) {
    for (const double interval : {0.02, 0.05}) {
        SurfacePlan plan = empty_plan(600, interval);
        add(plan, 1e-8, 1, [](double, double) { return 0.0; });
        add(plan, 4e-8, 2, [](double kx, double) { return kx * current; });
        add(plan, 2e-8, 3, [](double kx, double ky) { return kx * current + own(kx, ky); });
        add(plan, 3e-8, 4, [](double kx, double ky) { return kx * current - own(kx, ky); });
        const SurfaceMakeup makeup = surface_makeup(plan, waves(), 0.38, 0.42, 200);
        EXPECT_EQ(makeup.segments, 5U);
        // Upstream waves that stand over the bed count as locked to it, so those two can be a little off; the
        // patterns of one wavenumber beat with each other over a segment.
        EXPECT_NEAR(makeup.whole(), 1e-7, 5e-9);
        EXPECT_NEAR(makeup.share(SurfaceFamily::advected), 0.4, 0.03);
        EXPECT_NEAR(makeup.share(SurfaceFamily::waves_downstream), 0.2, 0.03);
        EXPECT_NEAR(makeup.share(SurfaceFamily::waves_upstream), 0.3, 0.04);
        EXPECT_NEAR(makeup.share(SurfaceFamily::bed_locked), 0.1, 0.04);
        EXPECT_LT(makeup.share(SurfaceFamily::other), 0.01);
    }
}

TEST(SurfaceFamilies, DensitiesHaveTheVarianceAsIntegral) {
    SurfacePlan plan = empty_plan(400);
    add(plan, 1e-8, 5, [](double kx, double) { return kx * current; });
    const SurfaceMakeup makeup = surface_makeup(plan, waves(), 0.38, 0.42, 100);
    double sum = 0.0;
    const double band = makeup.wavenumber[1] - makeup.wavenumber[0];
    for (const std::vector<double>& density : makeup.density) {
        for (const double value : density) sum += value * band;
    }
    EXPECT_NEAR(sum, makeup.whole(), 1e-3 * makeup.whole());
}

// Noise belongs to no family: it counts by the share of the frequencies that the families cover.
TEST(SurfaceFamilies, NoiseIsMostlyOther) {
    SurfacePlan plan = empty_plan(600, 0.02);
    std::mt19937_64 generator(9);
    std::normal_distribution<double> normal;
    for (double& z : plan.elevation) z = 1e-4 * normal(generator);
    const SurfaceMakeup makeup = surface_makeup(plan, waves(), 0.38, 0.42, 200);
    EXPECT_NEAR(makeup.whole(), 1e-8, 3e-10);
    EXPECT_GT(makeup.share(SurfaceFamily::other), 0.6);
    for (std::size_t k = 0; k < surface_families; ++k) {
        const auto family = static_cast<SurfaceFamily>(k);
        EXPECT_NEAR(makeup.share(family), makeup.share_of_noise(family), 0.01) << k;
    }
}

// Waves straight across go neither downstream nor upstream.
TEST(SurfaceFamilies, WavesAcrossAreAFamilyOfTheirOwn) {
    SurfacePlan plan = empty_plan(600, 0.02);
    const double k = 2.0 * pi / 0.0866;
    for (std::size_t at = 0; at < plan.elevation.size(); ++at) {
        const double y = plan.spacing_y * static_cast<double>(at / plan.columns % plan.rows);
        const double t = plan.interval * static_cast<double>(at / (plan.rows * plan.columns));
        plan.elevation[at] = 1e-4 * std::cos(k * y - own(0.0, k) * t);
    }
    const SurfaceMakeup makeup = surface_makeup(plan, waves(), 0.38, 0.42, 200);
    EXPECT_GT(makeup.share(SurfaceFamily::waves_across), 0.98);
}

TEST(SurfaceFamilies, RefuseWhatIsNoRecord) {
    SurfacePlan plan = empty_plan(40);
    EXPECT_THROW((void)surface_makeup(plan, waves(), 0.3, 0.4, 4), InputError);
    EXPECT_THROW((void)surface_makeup(plan, waves(), 0.3, 0.4, 80), InputError);
    plan.elevation[17] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)surface_makeup(plan, waves(), 0.3, 0.4, 20), InputError);
}

}  // namespace
}  // namespace riffle::surface_families_test
