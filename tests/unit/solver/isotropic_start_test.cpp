// A start from isotropic turbulence: energy, divergence and pressure of its field, the same eddies at each
// spacing.

#include "solver/isotropic_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "engine/energy_spectrum.hpp"
#include "small_case.hpp"
#include "statistics/fourier.hpp"
#include "temporary_folder.hpp"

namespace riffle::isotropic_start_test {
namespace {

constexpr double side = 2.0;
constexpr double wave = 2.0 * std::numbers::pi / side;  ///< wave number of one wave over the side

class IsotropicStart : public ::testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path written(const std::string& table) const {
        auto path = folder_.path() / "spectrum.csv";
        std::ofstream(path) << table;
        return path;
    }
    /// A cube of so many particles a side, with energy between `low` and `high` waves over the side.
    [[nodiscard]] Case cube(int points, double low, double high) const {
        Case c = test::still_water(3);
        c.channel.length = c.channel.width = c.channel.depth = side;
        c.channel.top = Top::periodic;
        c.fluid.gravity = 0.0;
        c.numerics.spacing = side / points;
        c.start.kind = StartKind::isotropic;
        c.start.file = written("wavenumber [1/m], energy [m3/s2]\n" + std::to_string(low * wave) +
                               ", 0.01\n" + std::to_string(high * wave) + ", 0.01\n");
        return c;
    }

  private:
    test::TemporaryFolder folder_;
};

struct Field {
    std::size_t points = 0;
    std::array<std::vector<Complex>, 3> velocity;
    std::vector<Complex> pressure;  ///< over the density
};

/// The start of a cube, its particles on the lattice, x fastest.
Field field_of(const Case& c) {
    const Scheme scheme = make_scheme(c, nullptr);
    const Particles<3> p = initial_particles<3>(c, scheme, nullptr);
    Field field;
    field.points = static_cast<std::size_t>(std::lround(side / c.numerics.spacing));
    const std::size_t n = field.points;
    for (auto& component : field.velocity) component.resize(n * n * n);
    field.pressure.resize(n * n * n);
    for (std::size_t i = 0; i < p.size(); ++i) {
        std::size_t place = 0;
        for (std::size_t d = 3; d-- > 0;) {
            place = place * n + static_cast<std::size_t>(p.position[d][i] / c.numerics.spacing);
        }
        for (std::size_t d = 0; d < 3; ++d) field.velocity[d][place] = p.velocity[d][i];
        field.pressure[place] = scheme.state.pressure(p.density_deviation[i]);
    }
    return field;
}

/// The waves over each side of a mode of the transform.
std::array<double, 3> waves_of(std::size_t place, std::size_t n) {
    std::array<double, 3> result{};
    for (std::size_t d = 0; d < 3; ++d) {
        const auto at = static_cast<double>(place % n);
        result[d] = 2.0 * at < static_cast<double>(n) ? at : at - static_cast<double>(n);
        place /= n;
    }
    return result;
}

TEST_F(IsotropicStart, SpectrumIsStraightOnLogarithmicAxesAndEndsWithItsTable) {
    const EnergySpectrum spectrum(written("wavenumber [1/cm], energy [m3/s2]\n1, 4e-4\n4, 1e-4\n8, 0\n"));
    EXPECT_NEAR(spectrum.at(100.0), 4e-4, 1e-12);
    EXPECT_NEAR(spectrum.at(200.0), 2e-4, 1e-12);
    EXPECT_NEAR(spectrum.at(600.0), 0.5e-4, 1e-12);  // to zero it is straight as it stands
    EXPECT_EQ(spectrum.at(99.0), 0.0);
    EXPECT_EQ(spectrum.at(801.0), 0.0);
    // From 100 to 400 1/m it is 0.04 / k: its integral to 200 is 0.04 ln 2.
    EXPECT_NEAR(spectrum.velocity_rms(200.0), std::sqrt(2.0 / 3.0 * 0.04 * std::numbers::ln2), 1e-6);
    EXPECT_EQ(spectrum.velocity_rms(50.0), 0.0);
}

TEST_F(IsotropicStart, RefusesWhatIsNoSpectrum) {
    const auto message = [&](const std::string& table) {
        try {
            const EnergySpectrum spectrum(written(table));
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message("wavenumber, energy\n0, 1\n1, 1\n").find("wavenumber is 0 in the first row"),
              std::string::npos);
    EXPECT_NE(message("wavenumber, energy\n1, 1\n2, -1\n").find(":3: energy is -1"), std::string::npos);
    EXPECT_NE(message("wavenumber, energy\n2, 1\n1, 1\n").find(":3: wavenumber is 1"), std::string::npos);
    EXPECT_NE(message("k, energy\n1, 1\n").find("no column wavenumber"), std::string::npos);
}

TEST_F(IsotropicStart, EachModeHasItsShareOfTheEnergyAndNoDivergence) {
    Field field = field_of(cube(16, 1.5, 4.5));
    const std::size_t n = field.points;
    const double number = std::pow(static_cast<double>(n), 3);
    for (auto& component : field.velocity) fourier_transform_3d(component, n, n, n);
    // To the error of the cubic interpolation of waves of eight and more points of the grid.
    constexpr double tolerance = 0.02;
    for (std::size_t place = 0; place < field.pressure.size(); ++place) {
        const std::array<double, 3> m = waves_of(place, n);
        const double size = std::hypot(m[0], m[1], m[2]);
        double energy = 0.0;
        Complex along;
        for (std::size_t d = 0; d < 3; ++d) {
            const Complex u = field.velocity[d][place] / number;
            energy += 0.5 * std::norm(u);
            along += m[d] * u;
        }
        // E(k) over the area of its sphere, for the volume of a mode, (2 pi / side)^3.
        const double expected =
            size > 1.5 && size < 4.5 ? 0.01 * wave / (4.0 * std::numbers::pi * size * size) : 0.0;
        EXPECT_NEAR(energy, expected, tolerance * 0.01 * wave / (4.0 * std::numbers::pi)) << size;
        EXPECT_LE(std::abs(along), tolerance * size * std::sqrt(0.01 * wave)) << size;
        if (expected > 0.0) {
            EXPECT_NEAR(energy / expected, 1.0, 2.0 * tolerance) << size;
        }
    }
}

TEST_F(IsotropicStart, PressureKeepsTheFlowFreeOfDivergence) {
    // Waves so long that their products are waves of the lattice too.
    Field field = field_of(cube(16, 0.9, 2.1));
    const std::size_t n = field.points;
    std::vector<Complex> expected(field.pressure.size());
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            std::vector<Complex> product(expected.size());
            for (std::size_t i = 0; i < product.size(); ++i) {
                product[i] = field.velocity[a][i] * field.velocity[b][i];
            }
            fourier_transform_3d(product, n, n, n);
            for (std::size_t i = 1; i < product.size(); ++i) {
                const std::array<double, 3> m = waves_of(i, n);
                expected[i] -= m[a] * m[b] / (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) * product[i];
            }
        }
    }
    inverse_fourier_transform_3d(expected, n, n, n);
    double square = 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        square += std::norm(expected[i]);
        error += std::norm(field.pressure[i] - expected[i]);
    }
    EXPECT_LT(std::sqrt(error / square), 0.01);
}

TEST_F(IsotropicStart, AFinerSpacingHasTheSameEddies) {
    const Field coarse = field_of(cube(8, 0.9, 3.0));
    const Field fine = field_of(cube(24, 0.9, 3.0));
    double square = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < coarse.pressure.size(); ++i) {
        // The middle of three places of the fine lattice is a place of the coarse one.
        std::size_t place = 0;
        for (std::size_t d = 3, rest = 0; d-- > 0;) {
            rest = i / (d == 2 ? 64 : d == 1 ? 8 : 1) % 8;
            place = place * 24 + 3 * rest + 1;
        }
        for (std::size_t d = 0; d < 3; ++d) {
            square += std::norm(fine.velocity[d][place]);
            difference += std::norm(coarse.velocity[d][i] - fine.velocity[d][place]);
        }
    }
    // Waves of two and a half of the coarse spacing, five points of its grid: the cubic interpolation keeps
    // 95 %.
    EXPECT_LT(std::sqrt(difference / square), 0.05);
}

}  // namespace
}  // namespace riffle::isotropic_start_test
