#include "sph/pair_terms.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <array>
#include <cmath>

#include "sph/equation_of_state.hpp"
#include "sph/pair_form.hpp"

namespace riffle::pair_terms_test {
namespace {

constexpr std::array viscosities = {ViscosityForm::morris, ViscosityForm::monaghan_gingold,
                                    ViscosityForm::lo_shao, ViscosityForm::artificial};

/// A number in [-1, 1] with 40 bits.
double number() {
    return std::ldexp(static_cast<double>(*rc::gen::inRange<std::int64_t>(-(1LL << 40), (1LL << 40) + 1)),
                      -40);
}

template <int D>
Components<double, D> vector() {
    Components<double, D> v{};
    for (double& x : v) x = number();
    return v;
}

template <std::size_t N>
std::array<double, N> minus(std::array<double, N> v) {
    for (double& x : v) x = -x;
    return v;
}

/// The force that j exerts on i is minus the force that i exerts on j, bit for bit. The pair is swapped as
/// the loops do it: r and u change sign, sums of i and j change their order; the force is the term times V_i,
/// V_j its weight.
template <int D>
void check_antisymmetry() {
    const Components<double, D> r = vector<D>();
    const Components<double, D> u = vector<D>();
    const Components<double, D* D> q_i = vector<D * D>();
    const Components<double, D* D> q_j = vector<D * D>();
    Components<double, D * D> sum_ij{};
    Components<double, D * D> sum_ji{};
    for (std::size_t k = 0; k < D * D; ++k) {
        sum_ij[k] = q_i[k] + q_j[k];
        sum_ji[k] = q_j[k] + q_i[k];
    }
    const double weight = number();  // V_i V_j F
    RC_ASSERT((tensor_force<double, D>(weight, sum_ij, r)) ==
              minus(tensor_force<double, D>(weight, sum_ji, minus(r))));

    const double root_i = std::abs(number());
    const double root_j = std::abs(number());
    const double viscosity_ij = pair_viscosity_sum<double>(root_i, root_j);
    const double viscosity_ji = pair_viscosity_sum<double>(root_j, root_i);
    const double squared = dot<double, D>(r, r);
    RC_ASSERT((MorrisViscosity::force<double, D>(weight, viscosity_ij, u, r, squared)) ==
              minus(MorrisViscosity::force<double, D>(weight, viscosity_ji, minus(u), minus(r), squared)));
    for (const ViscosityForm choice : viscosities) {
        const PairForm<double> form = viscosity_form<D, double>(choice);
        RC_ASSERT((form.template force<double, D>(weight, viscosity_ij, u, r, squared)) ==
                  minus(form.template force<double, D>(weight, viscosity_ji, minus(u), minus(r), squared)));
    }
    if constexpr (D == 3) {
        const DirectionalViscosity<double> directional{
            .slope = number(), .level = number(), .level_across = number(), .molecular = number()};
        RC_ASSERT((directional.force<double, D>(weight, viscosity_ij, u, r, squared)) ==
                  minus(directional.force<double, D>(weight, viscosity_ji, minus(u), minus(r), squared)));
    }

    // What the density diffusion takes from one particle the other gets; the continuity rate is the same for
    // both.
    const double s = number();
    RC_ASSERT(density_diffusion(weight, s, r[D - 1], 0.3) == -density_diffusion(weight, -s, -r[D - 1], 0.3));
    RC_ASSERT((continuity<double, D>(weight, u, r)) == (continuity<double, D>(weight, minus(u), minus(r))));
}

TEST(PairTerms, AreAntisymmetric2D) {
    EXPECT_TRUE(rc::check("in 2D", [] { check_antisymmetry<2>(); }));
}
TEST(PairTerms, AreAntisymmetric3D) {
    EXPECT_TRUE(rc::check("in 3D", [] { check_antisymmetry<3>(); }));
}

TEST(PairTerms, ViscosityTakesEnergy) {
    EXPECT_TRUE(rc::check("the pair force never accelerates the relative motion (F < 0)", [] {
        const Components<double, 2> r = vector<2>();
        const Components<double, 2> u = vector<2>();
        const double squared = dot<double, 2>(r, r);
        RC_ASSERT((dot<double, 2>(MorrisViscosity::force<double, 2>(-1.0, 0.5, u, r, squared), u)) <= 0.0);
        for (const ViscosityForm choice : viscosities) {
            const PairForm<double> form = viscosity_form<2, double>(choice);
            const auto force = form.force<double, 2>(-1.0, 0.5, u, r, squared);
            RC_ASSERT((dot<double, 2>(force, u)) <= 0.0);
            // Along the line of centres there is no torque.
            if (choice == ViscosityForm::monaghan_gingold || choice == ViscosityForm::artificial) {
                RC_ASSERT(std::abs(force[0] * r[1] - force[1] * r[0]) <= 1e-15);
            }
        }
    }));
}

TEST(PairTerms, PairViscosityIsTheSquareOfTheMeanRoot) {
    const auto twice = [](double mu_i, double mu_j) {
        return pair_viscosity_sum<double>(viscosity_root(mu_i), viscosity_root(mu_j));
    };
    EXPECT_DOUBLE_EQ(twice(0.09, 0.09), 2.0 * 0.09);
    // Mixing lengths z_i and z_j under one strain rate: the viscosity of the mean length.
    EXPECT_DOUBLE_EQ(twice(0.01, 0.09), 2.0 * 0.04);
}

TEST(PairTerms, DiffusionVanishesInStillWater) {
    EXPECT_TRUE(rc::check("the hydrostatic difference of density is no difference", [] {
        const double z_i = number();
        const double z_j = number();
        const double gradient = 0.02;
        const double s_i = gradient * (1.0 - z_i);
        const double s_j = gradient * (1.0 - z_j);
        RC_ASSERT(std::abs(density_diffusion(-1.0, s_i - s_j, z_i - z_j, gradient)) < 1e-16);
    }));
}

TEST(EquationOfState, DeviationInvertsPressure) {
    EXPECT_TRUE(rc::check("linear and Tait, for deviations of up to 10 %", [] {
        const StateEquation state{.kind = *rc::gen::element(EquationOfState::linear, EquationOfState::tait),
                                  .sound_speed = 9.0};
        const double s = 0.1 * number();
        // Rounding: log1p and expm1 are good to about one unit, and the exponent 7 amplifies it.
        RC_ASSERT(std::abs(state.deviation(state.pressure(s)) - s) <= 2e-16 * 20.0 * (std::abs(s) + 1e-300));
    }));
}

TEST(EquationOfState, HasItsSoundSpeedAtRest) {
    for (const EquationOfState kind : {EquationOfState::linear, EquationOfState::tait}) {
        const StateEquation state{.kind = kind, .sound_speed = 9.0};
        constexpr double s = 1e-6;
        EXPECT_EQ(state.pressure(0.0), 0.0);
        EXPECT_NEAR((state.pressure(s) - state.pressure(-s)) / (2.0 * s), 81.0, 1e-8);
    }
    // Tait at 1 %: c0^2/7 (1.01^7 - 1).
    const StateEquation tait{.kind = EquationOfState::tait, .sound_speed = 9.0};
    EXPECT_NEAR(tait.pressure(0.01), 81.0 / 7.0 * (std::pow(1.01, 7.0) - 1.0), 1e-13);
}

}  // namespace
}  // namespace riffle::pair_terms_test
