// The budget of energy: its parts are those of the flow, and add up to the change of the energy.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "boundary/wall.hpp"
#include "column/column.hpp"
#include "small_case.hpp"
#include "sph/elastic_energy.hpp"

namespace riffle::energy_budget_test {
namespace {

template <int D>
struct Energies {
    double kinetic = 0.0;
    double elastic = 0.0;

    explicit Energies(const SimulationIn<D>& simulation) {
        const Particles<D>& p = simulation.particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            for (std::size_t k = 0; k < D; ++k) {
                kinetic += 0.5 * p.mass[i] * p.velocity[k][i] * p.velocity[k][i];
            }
            elastic += p.mass[i] * elastic_energy(simulation.scheme().state, p.density_deviation[i]);
        }
    }
};

/// A channel over spheres whose particles move against each other in a way without order.
template <int D>
std::unique_ptr<SimulationIn<D>> disturbed_channel(Case c) {
    c.numerics.precision = Precision::double_precision;
    c.stirring.acceleration = 0.3;
    const ColumnResult column = solve_column(c);
    Particles<D> p = initial_particles<D>(c, make_scheme(c, &column), &column);
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            p.velocity[k][i] += 0.02 * std::sin(static_cast<double>((7 * k + 13) * i % 101));
        }
    }
    auto simulation = make_simulation<D>(c, &column, std::move(p));
    for (int step = 0; step < 5; ++step) simulation->step();
    return simulation;
}

template <int D>
void expect_powers_to_be_the_change(Stepping stepping,
                                    ReferencePressure reference = ReferencePressure::none) {
    Case c = test::small_channel(D);
    c.numerics.stepping = stepping;
    c.numerics.reference_pressure = reference;
    const auto simulation = disturbed_channel<D>(c);
    const Energies<D> before(*simulation);
    const double last_step = simulation->clock().time_step;
    simulation->step();
    const double step = simulation->clock().time_step;
    const Energies<D> after(*simulation);
    const EnergyRates& rates = simulation->energy_rates();
    const bool staggered = stepping == Stepping::leapfrog;
    const double kick = staggered ? 0.5 * (last_step + step) : step;
    const double largest = std::abs(rates.gravity) + std::abs(rates.bed_drag) + std::abs(rates.closure) +
                           std::abs(rates.further_forces);
    ASSERT_GT(largest, 0.0);
    // Rounding of the sum of the kinetic energies, some joules, over a step of some tenths of a millisecond.
    EXPECT_NEAR(rates.kinetic * kick, after.kinetic - before.kinetic, 1e-13 * before.kinetic);
    // To the third order of the step's change of density.
    const double compressed = staggered ? last_step : step;
    const double change = (rates.compression + rates.density_diffusion) * compressed;
    EXPECT_NEAR(change, after.elastic - before.elastic, 1e-4 * std::abs(change));
}

TEST(EnergyBudget, AddsUpToTheChangeOfTheEnergy) {
    expect_powers_to_be_the_change<2>(Stepping::leapfrog);
    expect_powers_to_be_the_change<2>(Stepping::semi_implicit_euler);
    expect_powers_to_be_the_change<3>(Stepping::leapfrog);
    expect_powers_to_be_the_change<3>(Stepping::leapfrog, ReferencePressure::hydrostatic);
}

/// Vortices of Taylor & Green of 1 m/s in a box that repeats itself upward and along.
Case box_of_vortices(double side, double viscosity) {
    Case c;
    c.channel.length = side;
    c.channel.depth = side;
    c.channel.slope = 0.0;
    c.channel.top = Top::periodic;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.fluid.gravity = 0.0;
    c.fluid.kinematic_viscosity = viscosity;
    c.turbulence.closure = ClosureKind::none;
    c.start.kind = StartKind::taylor_green;
    c.start.velocity = 1.0;
    c.numerics.precision = Precision::double_precision;
    return c;
}

/// Vortices without pressure, whose forces are those of viscosity and closure alone, after a very short step.
EnergyRates rates_of_vortices(ClosureKind closure, EddyStress stress, double molecular) {
    Case c = box_of_vortices(1.0, molecular);
    c.turbulence.closure = closure;
    c.turbulence.smagorinsky_constant = 0.15;
    c.numerics.spacing = 0.025;
    c.numerics.sound_speed = 20.0;
    c.numerics.eddy_stress = stress;
    c.numerics.time_step = 1e-9;
    const Scheme scheme = make_scheme(c, nullptr);
    Particles<2> p = initial_particles<2>(c, scheme, nullptr);
    for (double& s : p.density_deviation) s = 0.0;
    const auto simulation = make_simulation<2>(c, nullptr, std::move(p));
    simulation->step();
    return simulation->energy_rates();
}

/// Work of the eddy stresses on the vortices per area: of rho nu_t grad u, which the two-point form is, and
/// of 2 rho nu_t S.
struct EddyWork {
    double two_point = 0.0;
    double tensor = 0.0;
};

EddyWork eddy_work_of_vortices(double k) {
    const double length = 0.15 * 0.025 / std::numbers::sqrt2;  // C_s times the filter's width
    EddyWork work;
    constexpr int points = 200;
    for (int i = 0; i < points; ++i) {
        for (int j = 0; j < points; ++j) {
            const double x = k * i / points;
            const double z = k * j / points;
            const double stretching = k * std::cos(x) * std::cos(z);  // du/dx = -dw/dz
            const double turning = -k * std::sin(x) * std::sin(z);    // du/dz = -dw/dx: no shear
            const double strain = 4.0 * stretching * stretching;      // 2 S:S
            const double gradient = 2.0 * (stretching * stretching + turning * turning);
            const double nu_t = length * length * std::sqrt(strain);
            work.two_point += 1000.0 * nu_t * gradient / (points * points);
            work.tensor += 1000.0 * nu_t * strain / (points * points);
        }
    }
    return work;
}

TEST(EnergyBudget, TakesTheEddyStressOutOfTheTensorPairByPair) {
    const EnergyRates rates = rates_of_vortices(ClosureKind::sps, EddyStress::stress_divergence, 0.01);
    EXPECT_LT(rates.closure, 0.0);
    // The pressure that a nanosecond's compression makes does the rest.
    EXPECT_NEAR(rates.pressure, 0.0, 1e-6 * std::abs(rates.closure));
}

TEST(EnergyBudget, TellsTheMolecularViscosityFromTheEddies) {
    const EnergyRates plain = rates_of_vortices(ClosureKind::none, EddyStress::two_point, 0.01);
    const EnergyRates both = rates_of_vortices(ClosureKind::sps, EddyStress::two_point, 0.01);
    const EnergyRates tensor = rates_of_vortices(ClosureKind::sps, EddyStress::stress_divergence, 0.01);
    EXPECT_EQ(plain.closure, 0.0);
    EXPECT_NEAR(both.viscosity, plain.viscosity, 1e-6 * std::abs(plain.viscosity));
    EXPECT_NEAR(tensor.viscosity, plain.viscosity, 1e-6 * std::abs(plain.viscosity));
    // rho nu u0^2 k^2 of the vortices per area.
    const double k = 2.0 * std::numbers::pi;
    const double exact = 1000.0 * 0.01 * k * k;
    EXPECT_NEAR(-plain.viscosity, exact, 0.05 * exact);
    const EddyWork eddies = eddy_work_of_vortices(k);
    // The kernel smoothes the gradients by some (k h)^2, 5.5 %.
    EXPECT_NEAR(-both.closure, eddies.two_point, 0.055 * eddies.two_point);
    EXPECT_NEAR(-tensor.closure, eddies.tensor, 0.055 * eddies.tensor);
}

// A box that repeats itself in all directions: no walls, and the vortices of Taylor & Green lose nu times the
// mean of |grad u|^2 = 3/4 u0^2 k^2.
TEST(EnergyBudget, OfVorticesInSpaceIsThatOfTheirGradients) {
    constexpr double side = 2.0 * std::numbers::pi;
    Case c = box_of_vortices(side, 0.01);
    c.channel.dimensions = 3;
    c.channel.width = side;
    c.channel.sides = Sides::periodic;
    c.fluid.density = 1.0;
    c.numerics.spacing = side / 24.0;
    c.numerics.sound_speed = 10.0;
    EXPECT_EQ(wall_particles<3>(c).size(), 0U);
    const auto simulation =
        make_simulation<3>(c, nullptr, initial_particles<3>(c, make_scheme(c, nullptr), nullptr));
    for (int step = 0; step < 3; ++step) simulation->step();
    const double volume = std::pow(side, 3);
    EXPECT_NEAR(simulation->energy_rates().viscosity, -0.01 * 0.75 * volume, 0.05 * 0.01 * 0.75 * volume);
    const Particles<3>& p = simulation->particles();
    for (std::size_t k = 0; k < 3; ++k) {
        double momentum = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) momentum += p.mass[i] * p.velocity[k][i];
        EXPECT_NEAR(momentum, 0.0, 1e-12 * volume);
    }
}

TEST(EnergyBudget, OfAChannelIsThatOfItsColumn) {
    Case c = test::small_channel();
    c.numerics.spacing = 0.001;
    c.channel.length = 0.03;
    c.start.perturbation = 0.0;
    const ColumnResult column = solve_column(c);
    const auto simulation =
        make_simulation<2>(c, &column, initial_particles<2>(c, make_scheme(c, &column), &column));
    for (int step = 0; step < 3; ++step) simulation->step();
    const EnergyRates& rates = simulation->energy_rates();
    const ColumnProfile& profile = column.profile;
    double closure = 0.0;
    double viscosity = 0.0;
    double gravity = 0.0;
    const double length = c.channel.length * c.fluid.density;
    for (std::size_t i = 1; i < profile.z.size(); ++i) {
        const double dz = profile.z[i] - profile.z[i - 1];
        const double u = 0.5 * (profile.velocity[i] + profile.velocity[i - 1]);
        const double shear = (profile.velocity[i] - profile.velocity[i - 1]) / dz;
        const double nu_t = 0.5 * (profile.eddy_viscosity[i] + profile.eddy_viscosity[i - 1]);
        gravity += length * c.streamwise_gravity() * u * dz;
        closure -= length * nu_t * shear * shear * dz;
        viscosity -= length * c.fluid.kinematic_viscosity * shear * shear * dz;
    }
    const double drag = -gravity - closure - viscosity;
    EXPECT_NEAR(rates.gravity, gravity, 0.01 * gravity);
    EXPECT_NEAR(rates.bed_drag, drag, 0.03 * std::abs(drag));
    EXPECT_NEAR(rates.closure, closure, 0.03 * std::abs(closure));
    EXPECT_NEAR(rates.viscosity, viscosity, 0.1 * std::abs(viscosity));
}

}  // namespace
}  // namespace riffle::energy_budget_test
