// Drops and sheets thinner than two particles: they bear no suction, and what they had of pressure fades.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_case.hpp"
#include "sph/spray.hpp"

namespace riffle::spray_test {
namespace {

/// Still water and a drop high above it: particles on a ring and one in its middle, half a spacing and more
/// apart, that spin about the middle by so much, 1/s.
template <int D>
struct WaterWithSpinningDrop {
    static constexpr std::size_t members = 5;
    Case parameters = test::still_water(D);
    std::size_t water = 0;
    std::unique_ptr<SimulationIn<D>> simulation;

    explicit WaterWithSpinningDrop(Stepping stepping, double spin = 250.0, double deviation = 0.0) {
        Case& c = parameters;
        c.numerics.stepping = stepping;
        c.numerics.sound_speed = 20.0;
        const double x = 0.5 * c.channel.length;
        const double z = c.total_depth() + 8.0 * c.numerics.spacing;
        std::vector<Vec<D>> places;
        for (std::size_t n = 0; n < members; ++n) {
            const double radius = n == 0 ? 0.0 : 0.6 * c.numerics.spacing;
            const double angle = 2.0 * 3.141592653589793 * static_cast<double>(n) / (members - 1);
            places.push_back(test::place<D>(x + radius * std::cos(angle), 0.5 * c.channel.width,
                                            z + radius * std::sin(angle)));
        }
        Particles<D> p = test::water_and<D>(c, places);
        water = p.size() - members;
        for (std::size_t i = water; i < p.size(); ++i) {
            p.density_deviation[i] = deviation;
            p.velocity[0][i] = -spin * (p.position[D - 1][i] - z);
            p.velocity[D - 1][i] = spin * (p.position[0][i] - x);
        }
        simulation = make_simulation<D>(c, nullptr, p);
    }
    /// Energy of the drop's motion about its mean, per mass.
    [[nodiscard]] double energy() const {
        const Particles<D>& p = simulation->particles();
        double sum = 0.0;
        for (std::size_t k = 0; k < D; ++k) {
            double mean = 0.0;
            double square = 0.0;
            for (const std::size_t i : drop()) {
                mean += p.velocity[k][i] / members;
                square += 0.5 * p.velocity[k][i] * p.velocity[k][i] / members;
            }
            sum += square - 0.5 * mean * mean;
        }
        return sum;
    }
    [[nodiscard]] std::vector<std::size_t> drop() const {
        std::vector<std::size_t> places;
        const auto& id = simulation->particles().id;
        for (std::size_t i = 0; i < id.size(); ++i) {
            if (id[i] >= static_cast<std::int32_t>(water)) places.push_back(i);
        }
        return places;
    }
};

// Held together by suction the drop would shrink and spin ever faster: the semi-implicit Euler method takes
// the turning for a growth in volume. Nothing feeds it, so its energy must not grow.
template <int D>
void check_spin(Stepping stepping) {
    const WaterWithSpinningDrop<D> water(stepping);
    const double before = water.energy();
    double largest = 0.0;
    for (int i = 0; i < 150; ++i) {
        water.simulation->step();
        largest = std::max(largest, water.energy());
    }
    EXPECT_LT(largest, 1.02 * before);
    for (const double s : water.simulation->particles().density_deviation) EXPECT_LT(std::abs(s), 0.05);
}

TEST(Spray, OfASpinningDropGainsNoEnergy2D) { check_spin<2>(Stepping::semi_implicit_euler); }
TEST(Spray, OfASpinningDropGainsNoEnergy3D) { check_spin<3>(Stepping::semi_implicit_euler); }
TEST(Spray, OfASpinningDropGainsNoEnergyWithLeapfrog) { check_spin<2>(Stepping::leapfrog); }

// Of single drops the pressure fades within some h/c0.
TEST(Spray, LosesItsPressure) {
    for (const double deviation : {-0.02, 0.02}) {
        const WaterWithSpinningDrop<2> water(Stepping::semi_implicit_euler, 0.0, deviation);
        for (int i = 0; i < 30; ++i) water.simulation->step();
        for (const std::size_t i : water.drop()) {
            EXPECT_LT(std::abs(water.simulation->particles().density_deviation[i]), 0.1 * 0.02);
        }
    }
}

// A flat surface is water: of no kernel and lattice may its top row count as spray.
TEST(Spray, IsNoPartOfAFlatSurface) {
    for (const KernelKind kernel :
         {KernelKind::wendland_c2, KernelKind::cubic_spline, KernelKind::quintic_spline}) {
        for (const StartLattice lattice : {StartLattice::square, StartLattice::hexagonal}) {
            Case c = test::small_channel();
            c.numerics.kernel = kernel;
            c.numerics.smoothing_ratio = kernel == KernelKind::quintic_spline ? 2.0 : 1.5;
            c.numerics.wall_layers = 4;
            c.start.lattice = lattice;
            c.start.jitter = 0.1;
            const test::Channel channel(c);
            channel.advance(20);
            const auto& regularity = channel.simulation->fields().regularity;
            for (std::size_t i = 0; i < regularity.size(); ++i) EXPECT_GT(regularity[i], spray_end);
        }
    }
    EXPECT_EQ(share_of_water(0.11), 0.0);
    EXPECT_EQ(share_of_water(0.5), 1.0);
    EXPECT_NEAR(share_of_water(0.145), 0.5, 1e-12);
}

}  // namespace
}  // namespace riffle::spray_test
