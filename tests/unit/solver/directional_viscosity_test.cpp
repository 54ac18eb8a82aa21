// The two-point viscosity of the closure of Czernuszenko & Rylov: the weights of turbulence/ in the pair term
// of sph/.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sph/kernel.hpp"
#include "sph/pair_terms.hpp"
#include "turbulence/czernuszenko_rylov.hpp"

namespace riffle::directional_viscosity_test {
namespace {

using Vector = Components<double, 3>;

DirectionalViscosity<double> weights(double spanwise_ratio, double molecular = 0.0) {
    const auto w = pair_direction_weights(spanwise_ratio);
    return {.slope = w.slope, .level = w.level, .level_across = w.level_across, .molecular = molecular};
}

/// Sum of the force over the lattice of `spacing` (in smoothing lengths) around a point, 2 nu = 1: u(r) is
/// the velocity of the point less that of its neighbour at -r.
template <class F>
Vector lattice_sum(const DirectionalViscosity<double>& viscosity, double viscosity_sum, double spacing,
                   const F& u) {
    const int reach = static_cast<int>(std::ceil(2.0 / spacing));
    const double volume = spacing * spacing * spacing;
    Vector sum{};
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            for (int k = -reach; k <= reach; ++k) {
                const Vector r{i * spacing, j * spacing, k * spacing};
                const double squared = dot<double, 3>(r, r);
                const double weight = volume * WendlandC2<3>::gradient_constant<double>() *
                                      WendlandC2<3>::gradient_shape(std::sqrt(squared));
                const Vector force = viscosity.force<double, 3>(weight, viscosity_sum, u(r), r, squared);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += force[c];
            }
        }
    }
    return sum;
}

/// nu A_kl of the second derivative of u_k along l: u_k = -r_l^2/2 less nothing, of which d2/dx_l2 is 1 at
/// the neighbours' side.
double weight_of(const DirectionalViscosity<double>& viscosity, double spacing, std::size_t k,
                 std::size_t l) {
    return lattice_sum(viscosity, 2.0, spacing, [&](const Vector& r) {
        Vector u{};
        u[k] = -0.5 * r[l] * r[l];
        return u;
    })[k];
}

// On a fine lattice the sums are the integrals of the derivation. The fourth moments of the cubic lattice of
// the particles are not isotropic (at h = 1.5 dx a weight departs by up to 0.034, times 1 - ratio^2), and
// where all weights are one (ratio 1) it is Morris' form, whose sums are .997.
TEST(DirectionalViscosity, GivesTheWeightsOfTheStresses) {
    for (const double ratio : {0.25, 0.5, 1.0}) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t l = 0; l < 3; ++l) {
                const double exact = stress_weight(k == 1, l == 1, ratio);
                EXPECT_NEAR(weight_of(weights(ratio), 0.125, k, l), exact, 2e-3) << ratio << k << l;
                EXPECT_NEAR(weight_of(weights(ratio), 1.0 / 1.5, k, l), exact, 0.035) << ratio << k << l;
            }
        }
    }
}

TEST(DirectionalViscosity, LeavesTheMolecularViscosityIsotropic) {
    const double nu = 0.3;
    for (std::size_t l = 0; l < 3; ++l) {
        const auto quadratic = [&](const Vector& r) {
            const double u = -0.5 * r[l] * r[l];
            return Vector{u, u, u};
        };
        // Of the sum 2 nu all is molecular, of 2 (nu + 1) the rest is eddy viscosity.
        const Vector molecular = lattice_sum(weights(0.5, 2.0 * nu), 2.0 * nu, 0.125, quadratic);
        const Vector both = lattice_sum(weights(0.5, 2.0 * nu), 2.0 * (nu + 1.0), 0.125, quadratic);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(molecular[k], nu, 1e-3);
            EXPECT_NEAR(both[k], nu + stress_weight(k == 1, l == 1, 0.5), 3e-3);
        }
    }
}

// The weight of v in pairs across the channel is negative at l_y = l_x/2. Still no wave of any direction that
// the particles can carry grows.
TEST(DirectionalViscosity, DampsAllWaves) {
    const double spacing = 1.0 / 1.5;
    constexpr int parts = 6;
    for (int i = 0; i <= parts; ++i) {
        for (int j = 0; j <= parts; ++j) {
            for (int k = 0; k <= parts; ++k) {
                if (i + j + k == 0) continue;
                const double wave = std::numbers::pi / (spacing * parts);
                const Vector damping = lattice_sum(weights(0.5), 2.0, spacing, [&](const Vector& r) {
                    const double u = 1.0 - std::cos(wave * (i * r[0] + j * r[1] + k * r[2]));
                    return Vector{u, u, u};
                });
                for (const double a : damping) EXPECT_LT(a, 0.0) << i << " " << j << " " << k;
            }
        }
    }
}

}  // namespace
}  // namespace riffle::directional_viscosity_test
