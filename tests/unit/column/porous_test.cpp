// The twins in and over porous layers, against exact solutions.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "column/column.hpp"
#include "column/section.hpp"
#include "column/twin_channel.hpp"
#include "roughness/porous_resistance.hpp"

namespace riffle::porous_column_test {
namespace {

/// Laminar flow over a layer of a porous medium, all of it where the layer is as deep as the water.
Case over_layer(double layer, double edge) {
    Case c;
    c.channel.slope = 0.01;
    c.channel.depth = 0.1;
    c.channel.length = 0.1;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.kinematic_viscosity = 1e-3;
    Porous medium;
    medium.name = "layer";
    medium.porosity = 0.6;
    medium.permeability = 6e-5;
    medium.z_to = layer;
    medium.edge = edge;
    c.porous = {medium};
    return c;
}

/// Neale & Nader (1974) with a continuous shear stress of the water.
struct Brinkman {
    explicit Brinkman(const Case& c)
        : gravity(c.streamwise_gravity()),
          viscosity(c.fluid.kinematic_viscosity),
          depth(c.channel.depth),
          top(*c.porous.front().z_to),
          ratio(c.porous.front().viscosity_ratio),
          far(gravity * *c.porous.front().permeability / viscosity),
          reach(std::sqrt(ratio * *c.porous.front().permeability / c.porous.front().porosity)) {}

    [[nodiscard]] double discharge(double z) const {
        const double gradient = gravity * (depth - top) / viscosity;
        const double factor = gradient * reach / (ratio * std::sinh(top / reach));
        if (z < top) return far + factor * std::cosh(z / reach);
        const double slip = far + factor * std::cosh(top / reach);
        return slip + gravity / viscosity * ((depth - top) * (z - top) - 0.5 * (z - top) * (z - top));
    }

    double gravity, viscosity, depth, top, ratio, far, reach;
};

double worst_departure(const Case& c) {
    const ColumnResult column = solve_column(c);
    const Brinkman exact(c);
    double worst = 0.0;
    for (std::size_t i = 0; i < column.profile.z.size(); ++i) {
        const double z = column.profile.z[i];
        if (std::abs(z - exact.top) < *c.porous.front().edge) continue;  // of another porosity
        const double porosity = z < exact.top ? c.porous.front().porosity : 1.0;
        worst = std::max(worst, std::abs(porosity * column.profile.velocity[i] - exact.discharge(z)));
    }
    return worst / exact.discharge(c.channel.depth);
}

TEST(PorousColumn, HasTheFlowOfBrinkman) {
    // The edge is thin; what is left is that of the grid.
    EXPECT_LT(worst_departure(over_layer(0.04, 1e-5)), 1e-3);
    Case stiff = over_layer(0.04, 1e-5);
    stiff.porous.front().viscosity_ratio = 3.0;
    EXPECT_LT(worst_departure(stiff), 1e-3);
}

TEST(PorousColumn, CarriesItsWeight) {
    const ColumnResult column = solve_column(over_layer(0.04, 0.005));
    EXPECT_NEAR(column.porous_share, 1.0, 1e-6);
    EXPECT_EQ(column.drag_share, 0.0);
}

TEST(PorousColumn, OfAMediumAlonePassesForchheimersDischarge) {
    Case c = over_layer(1.0, 0.005);
    c.fluid.kinematic_viscosity = 1e-6;
    c.porous.front().permeability.reset();
    c.porous.front().grain_size = 0.01;
    const double q = PorousResistance(c.porous.front(), 1e-6).discharge_at(c.streamwise_gravity());
    EXPECT_NEAR(solve_column(c).total_mean_velocity, q / 0.6, 1e-6 * q);
}

TEST(PorousColumn, WithoutGrainsIsThatWithoutAZone) {
    Case c = over_layer(0.04, 0.005);
    c.bed.kind = BedKind::no_slip;
    c.porous.front().porosity = 1.0;
    c.porous.front().permeability.reset();
    c.porous.front().grain_size = 0.01;
    Case without = c;
    without.porous.clear();
    EXPECT_NEAR(solve_column(c).total_mean_velocity, solve_column(without).total_mean_velocity,
                1e-5 * solve_column(without).total_mean_velocity);
}

/// Between side walls that do not hold the water the section is the column.
TEST(PorousSection, IsTheColumnWhereNothingVariesAcross) {
    Case c = over_layer(0.04, 0.01);
    const ColumnResult column = solve_column(c);
    c.channel.dimensions = 3;
    c.channel.width = 0.4;
    c.channel.sides = Sides::walls;
    c.side_walls.drag_form = SideDragForm::none;
    const SectionResult section = solve_section(c);
    EXPECT_NEAR(section.bulk_velocity, column.total_mean_velocity, 5e-3 * column.total_mean_velocity);
    EXPECT_NEAR(section.porous_share, 1.0, 1e-6);
    EXPECT_NEAR(section.centreline_velocity, section.bulk_velocity, 1e-6 * section.bulk_velocity);
    // And so is what starts with the column's profile, from the first moment on.
    const SectionResult start = start_section(c, SectionStart::column);
    EXPECT_NEAR(start.bulk_velocity, section.bulk_velocity, 5e-3 * section.bulk_velocity);
    EXPECT_NEAR(start.centreline_velocity, section.bulk_velocity, 5e-3 * section.bulk_velocity);
}

TEST(PorousSection, PassesMoreWaterBesideThanWithinABank) {
    Case c = over_layer(1.0, 0.01);
    c.channel.dimensions = 3;
    c.channel.width = 0.4;
    c.channel.sides = Sides::half;
    c.side_walls.drag_form = SideDragForm::none;
    c.bed.kind = BedKind::no_slip;
    c.porous.front().y_to = 0.1;
    const SectionResult section = solve_section(c);
    const std::size_t columns = section.y.size();
    const std::vector<double> means = section.depth_means(0.0, c.channel.depth);
    EXPECT_GT(means[columns - 1], 3.0 * means[0]);
    EXPECT_GT(section.porous_share, 0.1);
    EXPECT_NEAR(section.porous_share + section.drag_share + section.side_wall_share, 1.0, 1e-6);
}

// Darcy's flow through the whole depth: the discharge is that of the water, K g S/nu h, and a wave in the
// pores meets water of the velocity q/(n h), so that the momentum and energy coefficients are those of it.
TEST(PorousColumn, CarriesTheDischargeOfTheWater) {
    Case c = over_layer(0.2, 0.0);
    c.bed.kind = BedKind::slip;
    c.porous.front().z_to.reset();
    c.fluid.kinematic_viscosity = 1e-4;
    c.porous.front().permeability = 1e-8;
    const double darcy = c.streamwise_gravity() * 1e-8 / 1e-4;
    EXPECT_NEAR(uniform_unit_discharge(c), darcy * c.channel.depth, 1e-6 * darcy);
    const SteadyChannel channel = twin_channel(c, uniform_unit_discharge(c));
    EXPECT_NEAR(*normal_depth(channel), c.channel.depth, 1e-5);
    const double squared = 0.6 * 0.6;
    EXPECT_NEAR(channel.momentum_coefficient(c.channel.depth), 1.0 / squared, 1e-3);
    EXPECT_NEAR(channel.state(c.channel.depth).energy_coefficient, 1.0 / squared, 1e-3);
    const ColumnResult column = solve_column(c);
    EXPECT_NEAR(column.surface_velocity, darcy / 0.6, 1e-3 * darcy);
}

}  // namespace
}  // namespace riffle::porous_column_test
