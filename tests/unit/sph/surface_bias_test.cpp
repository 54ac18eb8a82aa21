// How far the ways to find a free surface are off, on particles that fill water of a known surface exactly.
// docs/free-surface.md shows the table that this prints.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "sph/free_surface.hpp"
#include "sph/kernel.hpp"

namespace riffle::surface_bias_test {
namespace {

using std::numbers::pi;
constexpr double dx = 0.002;
constexpr int columns = 60;
constexpr int rows = 20;
constexpr double length = columns * dx;
constexpr double depth = rows * dx;

/// A lattice stretched from the bed to a surface of elevation(x), each particle with its share of the water.
struct Arrangement {
    std::string name;
    bool hexagonal = false;
    double jitter = 0.0;      ///< standard deviation of the displacements, dx
    double row_height = 1.0;  ///< of the undisturbed rows, dx
    double amplitude = 0.0;   ///< of the surface, dx
    int waves = 1;            ///< on the length

    [[nodiscard]] double elevation(double x) const {
        return depth * row_height + amplitude * dx * std::cos(2.0 * pi * waves * x / length);
    }
};

struct Water {
    std::vector<double> x, z, volume;

    Water(const Arrangement& a, double shift) {
        std::mt19937_64 generator(7);
        std::normal_distribution<double> normal(0.0, a.jitter * dx);
        // Rows of a hexagonal lattice are closer, so that a particle has the same area.
        const int count = a.hexagonal ? static_cast<int>(std::lround(rows * 2.0 / std::sqrt(3.0))) : rows;
        for (int k = 0; k < count; ++k) {
            for (int i = 0; i < columns; ++i) {
                const double offset = a.hexagonal ? (k % 2 == 0 ? 0.25 : 0.75) : 0.5;
                const double px = (i + offset) * dx;
                const double row = a.elevation(px) / count;
                x.push_back(std::fmod(px + shift * dx + normal(generator) + length, length));
                z.push_back((k + 0.5) * row + normal(generator));
                volume.push_back(dx * row);
            }
        }
    }

    [[nodiscard]] FluidParticles<2> fluid(KernelKind kernel, double h_over_dx) const {
        Domain<2> domain;
        domain.lower = {0.0, -0.01};
        domain.upper = {length, 0.1};
        domain.periodic = {true, false};
        return {domain, {x, z}, volume, kernel, h_over_dx * dx};
    }
};

using Method = std::function<std::vector<double>(const FluidParticles<2>&, std::span<const Vec<1>>)>;
struct NamedMethod {
    std::string name;
    Method find;
};

const std::vector<NamedMethod>& methods() {
    static const std::vector<NamedMethod> all = {
        {"position divergence, 1",
         [](const auto& f, auto at) { return surface_by_position_divergence<2>(f, at, 1.0); }},
        {"position divergence, 1.4",
         [](const auto& f, auto at) { return surface_by_position_divergence<2>(f, at, 1.4); }},
        {"volume fraction, 0.5",
         [](const auto& f, auto at) { return surface_by_volume_fraction<2>(f, at, 0.5); }},
        {"volume fraction, 0.9",
         [](const auto& f, auto at) { return surface_by_volume_fraction<2>(f, at, 0.9); }},
        {"density ratio, 0.9",
         [](const auto& f, auto at) { return surface_by_density_ratio<2>(f, at, 0.9); }},
        {"depth sum", [](const auto& f, auto at) { return surface_by_depth_sum<2>(f, at); }},
    };
    return all;
}

/// Mean and standard deviation of found less true elevation, in dx; over places and shifts of the lattice.
struct Deviation {
    double bias = 0.0, scatter = 0.0;
};

Deviation deviation(const NamedMethod& method, const Arrangement& arrangement, KernelKind kernel,
                    double h_over_dx) {
    std::vector<double> off;
    for (const double shift : {0.0, 0.3, 0.7}) {
        const Water water(arrangement, shift);
        std::vector<Vec<1>> at;
        for (int i = 0; i < 180; ++i) at.push_back({(i + 0.5) * length / 180});
        const std::vector<double> found = method.find(water.fluid(kernel, h_over_dx), at);
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double true_x = at[i][0] - shift * dx;
            off.push_back((found[i] - arrangement.elevation(true_x)) / dx);
        }
    }
    Deviation d;
    for (const double v : off) d.bias += v / static_cast<double>(off.size());
    for (const double v : off) d.scatter += (v - d.bias) * (v - d.bias) / static_cast<double>(off.size());
    d.scatter = std::sqrt(d.scatter);
    return d;
}

/// Amplitude of the found surface over that of the true wave, by projection.
double amplitude_ratio(const NamedMethod& method, const Arrangement& wave, KernelKind kernel,
                       double h_over_dx) {
    const Water water(wave, 0.0);
    std::vector<Vec<1>> at;
    for (int i = 0; i < 180; ++i) at.push_back({(i + 0.5) * length / 180});
    const std::vector<double> found = method.find(water.fluid(kernel, h_over_dx), at);
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        sum += 2.0 / 180.0 * found[i] * std::cos(2.0 * pi * wave.waves * at[i][0] / length);
    }
    return sum / (wave.amplitude * dx);
}

const std::vector<Arrangement> arrangements = {
    {.name = "square"},
    {.name = "rows 0.95", .row_height = 0.95},
    {.name = "rows 1.05", .row_height = 1.05},
    {.name = "hexagonal", .hexagonal = true},
    {.name = "jitter 0.1", .jitter = 0.1},
    {.name = "jitter 0.2", .jitter = 0.2},
    {.name = "wave of 60 dx", .amplitude = 2.0, .waves = 1},
    {.name = "wave of 12 dx", .amplitude = 1.0, .waves = 5},
};

TEST(FreeSurfaceBias, Table) {
    struct Setting {
        KernelKind kernel;
        const char* name;
        double h_over_dx;
    };
    for (const Setting& setting : {Setting{KernelKind::wendland_c2, "Wendland C2", 2.0},
                                   Setting{KernelKind::wendland_c2, "Wendland C2", 1.5},
                                   Setting{KernelKind::cubic_spline, "cubic spline", 1.5}}) {
        std::printf("%s, h = %.1f dx\n| method |", setting.name, setting.h_over_dx);
        for (const Arrangement& a : arrangements) std::printf(" %s |", a.name.c_str());
        std::printf("\n");
        for (const NamedMethod& m : methods()) {
            std::printf("| %s |", m.name.c_str());
            for (const Arrangement& a : arrangements) {
                const Deviation d = deviation(m, a, setting.kernel, setting.h_over_dx);
                EXPECT_TRUE(std::isfinite(d.bias)) << m.name << ", " << a.name;
                std::printf(" %+.2f ± %.2f |", d.bias, d.scatter);
            }
            std::printf("\n");
        }
    }
}

TEST(FreeSurfaceBias, TableOfAmplitudes) {
    const std::vector<int> counts = {1, 2, 3, 5, 6, 10};
    for (const double h_over_dx : {2.0, 1.5}) {
        std::printf(
            "amplitude of waves of half a spacing, found over true (Wendland C2, h = %.1f dx)\n| method |",
            h_over_dx);
        for (const int waves : counts) std::printf(" %d dx |", columns / waves);
        std::printf("\n");
        for (const NamedMethod& m : methods()) {
            std::printf("| %s |", m.name.c_str());
            for (const int waves : counts) {
                const Arrangement wave{.name = "wave", .amplitude = 0.5, .waves = waves};
                std::printf(" %.2f |", amplitude_ratio(m, wave, KernelKind::wendland_c2, h_over_dx));
            }
            std::printf("\n");
        }
    }
    // Long waves are found as they are: the contours are parallel to the surface where it is straight.
    for (const std::size_t method : {0UL, 2UL}) {
        const Arrangement wave{.name = "wave", .amplitude = 0.5, .waves = 1};
        EXPECT_NEAR(amplitude_ratio(methods()[method], wave, KernelKind::wendland_c2, 1.5), 1.0, 0.02);
    }
}

TEST(FreeSurfaceBias, DepthSumSmoothsAsItsKernel) {
    // The amplitude falls to the transform of the one-dimensional kernel at the wavenumber.
    constexpr double h = 1.5 * dx;
    for (const int waves : {2, 5}) {
        double transform = 0.0;
        constexpr int steps = 2000;
        for (int i = 0; i < steps; ++i) {
            const double q = -2.0 + 4.0 * (i + 0.5) / steps;
            transform +=
                WendlandC2<1>::value(std::abs(q)) * std::cos(2.0 * pi * waves * q * h / length) * 4.0 / steps;
        }
        const Arrangement wave{.name = "wave", .amplitude = 0.5, .waves = waves};
        EXPECT_NEAR(amplitude_ratio(methods()[5], wave, KernelKind::wendland_c2, 1.5), transform, 0.01);
    }
}

/// Distance of the contour from the surface in the continuum, in h (negative: below): a lattice of 24 rows in
/// h.
double continuum_offset(KernelKind kernel, double threshold, bool divergence) {
    constexpr int fine = 24;
    const double spacing = 1.0 / fine;  // h = 1
    std::vector<double> x, z, volume;
    for (int k = 0; k < 4 * fine; ++k) {
        for (int i = 0; i < 8 * fine; ++i) {
            x.push_back((i + 0.5) * spacing);
            z.push_back((k + 0.5) * spacing);
            volume.push_back(spacing * spacing);
        }
    }
    Domain<2> domain;
    domain.lower = {0.0, -1.0};
    domain.upper = {8.0, 8.0};
    domain.periodic = {true, false};
    const FluidParticles<2> fluid{domain, {x, z}, volume, kernel, 1.0};
    const std::vector<Vec<1>> at = {{4.0}};
    return (divergence ? surface_by_position_divergence<2>(fluid, at, threshold)
                       : surface_by_volume_fraction<2>(fluid, at, threshold))[0] -
           4.0;
}

TEST(FreeSurfaceBias, HalfTheBulkValueIsTheSurface) {
    for (const KernelKind kernel : {KernelKind::wendland_c2, KernelKind::cubic_spline}) {
        // Symmetry: half of any kernel lies in the water. The lattice errs by less than its spacing squared.
        EXPECT_NEAR(continuum_offset(kernel, 1.0, true), 0.0, 0.01);
        EXPECT_NEAR(continuum_offset(kernel, 0.5, false), 0.0, 0.01);
        // Sums of h = 1.5 dx have an error of a tenth of a spacing (the bound of free_surface_test.cpp).
        for (const std::size_t half : {0UL, 2UL}) {
            EXPECT_LT(std::abs(deviation(methods()[half], arrangements[0], kernel, 1.5).bias), 0.1);
        }
    }
}

TEST(FreeSurfaceBias, ThresholdOfTheThesisLiesHalfASmoothingLengthBelow) {
    EXPECT_NEAR(continuum_offset(KernelKind::wendland_c2, 1.4, true), -0.49, 0.01);
    EXPECT_NEAR(continuum_offset(KernelKind::cubic_spline, 1.4, true), -0.54, 0.01);
    for (const KernelKind kernel : {KernelKind::wendland_c2, KernelKind::cubic_spline}) {
        EXPECT_NEAR(deviation(methods()[1], arrangements[0], kernel, 1.5).bias,
                    1.5 * continuum_offset(kernel, 1.4, true), 0.1);
    }
}

TEST(FreeSurfaceBias, DepthSumHoldsTheVolume) {
    // The mean of the sum over x is the volume over the length; of the places here to the kernel's sum, 1 %.
    for (const Arrangement& a : arrangements) {
        EXPECT_NEAR(deviation(methods()[5], a, KernelKind::wendland_c2, 1.5).bias, 0.0, 0.01 * depth / dx)
            << a.name;
    }
}

TEST(FreeSurfaceBias, DensityRatioMarksTheTopParticles) {
    const Deviation d = deviation(methods()[4], arrangements[0], KernelKind::wendland_c2, 1.5);
    EXPECT_NEAR(d.bias, -0.5, 1e-12);
    EXPECT_NEAR(d.scatter, 0.0, 1e-12);
}

TEST(FreeSurfaceBias, InThreeDimensions) {
    std::vector<double> x, y, z;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 10; ++j) {
            for (int k = 0; k < 8; ++k) {
                x.push_back((i + 0.5) * dx);
                y.push_back((j + 0.5) * dx);
                z.push_back((k + 0.5) * dx);
            }
        }
    }
    const std::vector<double> volume(x.size(), dx * dx * dx);
    Domain<3> domain;
    domain.lower = {0.0, 0.0, -0.01};
    domain.upper = {12 * dx, 10 * dx, 0.1};
    domain.periodic = {true, true, false};
    const FluidParticles<3> fluid{domain, {x, y, z}, volume, KernelKind::wendland_c2, 1.5 * dx};
    const std::vector<Vec<2>> at = {{0.0, 0.0}, {0.0131, 0.0077}, {12 * dx - 1e-9, 0.004}};
    for (std::size_t n = 0; n < at.size(); ++n) {
        EXPECT_NEAR(surface_by_position_divergence<3>(fluid, at, 1.5)[n], 8 * dx, 0.1 * dx);
        EXPECT_NEAR(surface_by_volume_fraction<3>(fluid, at, 0.5)[n], 8 * dx, 0.1 * dx);
        EXPECT_NEAR(surface_by_density_ratio<3>(fluid, at, 0.9)[n], 7.5 * dx, 1e-12);
        EXPECT_NEAR(surface_by_depth_sum<3>(fluid, at)[n], 8 * dx, 0.02 * 8 * dx);
    }
}

TEST(FreeSurfaceBias, WithoutWaterIsNotANumber) {
    const std::vector<double> none;
    Domain<2> domain;
    domain.lower = {0.0, 0.0};
    domain.upper = {1.0, 1.0};
    const FluidParticles<2> fluid{domain, {none, none}, none, KernelKind::wendland_c2, 0.1};
    const std::vector<Vec<1>> at = {{0.5}};
    for (const NamedMethod& m : methods()) EXPECT_TRUE(std::isnan(m.find(fluid, at)[0])) << m.name;
}

}  // namespace
}  // namespace riffle::surface_bias_test
