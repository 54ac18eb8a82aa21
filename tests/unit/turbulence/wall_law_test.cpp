// Plane beds by a wall law: the log laws far from the bed, and the layer in which particles meet it.

#include "turbulence/wall_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "turbulence/closure.hpp"
#include "turbulence/wall_layer.hpp"

namespace riffle::wall_law_test {
namespace {

constexpr double kappa = 0.41;

/// A wide channel whose flow with this closure is the log law itself.
Case gravel_bed(double roughness_over_depth) {
    Case c;
    c.channel.depth = 1.0;
    c.channel.slope = 0.001;
    c.bed.kind = BedKind::roughness;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.bed.equivalent_roughness = roughness_over_depth * c.channel.depth;
    c.turbulence.closure = ClosureKind::nezu_rodi;
    return c;
}

Case smooth_bed() {
    Case c = gravel_bed(0.01);
    c.bed.kind = BedKind::smooth;
    c.bed.equivalent_roughness.reset();
    return c;
}

UniformProfile profile_of(const Case& c) {
    const WallLaw law = *bed_wall_law(c);
    const auto closure = make_closure(c);
    return {[&](double z) { return closure->mixing_length(z); }, law, c.total_depth()};
}

TEST(WallLaw, RoughBedHasTheRoughLogLaw) {
    for (const double roughness : {0.002, 0.01, 0.05, 0.3}) {
        const Case c = gravel_bed(roughness);
        const UniformProfile profile = profile_of(c);
        // k_s+ is 200 and more here: nothing of the smooth wall's zero is left but its share in z0.
        const WallLaw law = *bed_wall_law(c);
        for (const double z : {0.2, 0.5, 0.9}) {
            EXPECT_NEAR(profile.velocity(z), std::log1p(z / law.zero_height) / kappa, 0.02) << roughness;
        }
        const double nikuradse = std::log(0.5 / roughness) / kappa + 8.5;
        const double above_bed = std::log1p(0.5 / zero_height_of_roughness(roughness, kappa)) / kappa;
        EXPECT_NEAR(above_bed, nikuradse, roughness);  // ln(1 + z0/z)/kappa, z0 = k_s/33
        EXPECT_NEAR(profile.mean(1.0), log_law_mean(1.0, law.zero_height, kappa), 2e-3 * profile.mean(1.0));
    }
}

TEST(WallLaw, SmoothBedHasTheSmoothLogLaw) {
    const Case c = smooth_bed();
    const double viscous = c.fluid.kinematic_viscosity / reference_friction_velocity(c);
    const UniformProfile profile = profile_of(c);
    for (const double z : {100.0, 1000.0, 10000.0}) {
        EXPECT_NEAR(profile.velocity(z * viscous), std::log(z) / kappa + smooth_wall_constant, 0.1) << z;
    }
    EXPECT_NEAR(profile.velocity(viscous), 1.0, 0.02);  // u+ = z+ in the viscous layer
    // Van Driest's constant is what the log law asks for.
    EXPECT_NEAR(bed_wall_law(c)->damping / viscous, 26.0, 0.5);
}

TEST(WallLaw, BedsBetweenSmoothAndRoughAreSlowerThanBoth) {
    const double viscous = 1e-5;
    double before = 0.0;
    for (const double roughness : {0.0, 1.0, 5.0, 20.0, 70.0, 1000.0}) {  // k_s+
        const WallLaw law =
            make_wall_law(kappa, zero_height_of_roughness(roughness * viscous, kappa), viscous);
        EXPECT_GE(law.shift, before);
        EXPECT_GE(law.zero_height, zero_height_of_smooth_wall(viscous, kappa));
        before = law.shift;
        // Far up, under a constant stress, the law is the log law of its z0.
        const double far = 1e4 * std::max(viscous, law.zero_height);
        const UniformProfile profile([&](double z) { return law.mixing_length(z, kappa * z); }, law,
                                     1e4 * far);
        EXPECT_NEAR(profile.velocity(far), std::log1p(far / law.zero_height) / kappa, 0.01) << roughness;
    }
}

TEST(WallLaw, ManningIsThatOfTheUniformFlow) {
    for (const ClosureKind closure : {ClosureKind::ramp, ClosureKind::nezu_rodi, ClosureKind::nikuradse}) {
        Case c = gravel_bed(0.01);
        c.turbulence.closure = closure;
        c.bed.equivalent_roughness.reset();
        c.bed.manning = 0.02;
        const double ratio = velocity_ratio_of_manning(0.02, c.total_depth(), c.fluid.gravity);
        EXPECT_NEAR(profile_of(c).mean(c.total_depth()), ratio, 1e-4 * ratio);
        EXPECT_EQ(with_fixed_roughness(c).bed.equivalent_roughness, equivalent_roughness(c));
    }
    Case c = gravel_bed(0.01);
    c.bed.equivalent_roughness.reset();
    c.bed.manning = 0.5;
    EXPECT_THROW(static_cast<void>(make_closure(c)), InputError);
}

TEST(WallLayer, JoinsTheLawAndCarriesItsDischarge) {
    for (const ClosureKind closure : {ClosureKind::ramp, ClosureKind::nezu_rodi}) {
        for (const double roughness : {0.002, 0.3}) {
            Case c = gravel_bed(roughness);
            c.turbulence.closure = closure;
            const UniformProfile profile = profile_of(c);
            const double friction_velocity = reference_friction_velocity(c);
            const WallLayer layer(c, 1.0 / 20.0);
            const double top = layer.height();
            EXPECT_NEAR(layer.velocity(top), friction_velocity * profile.velocity(top), 1e-9);
            double flow = 0.0;
            double drag = 0.0;
            constexpr int parts = 3000;
            for (int i = 0; i < parts; ++i) {
                const double u = layer.velocity((i + 0.5) * top / parts);
                EXPECT_GT(u, 0.0);
                flow += u / parts;
                drag += layer.drag_coefficient((i + 0.5) * top / parts) * u * u * top / parts;
            }
            EXPECT_NEAR(flow, friction_velocity * profile.mean(top), 1e-5 * flow);
            // The drag of the layer carries the weight of the whole water.
            const double weight = friction_velocity * friction_velocity;
            EXPECT_NEAR(drag, weight, 5e-3 * weight);
            // The mixing length goes on without a jump.
            const auto particles = make_particle_closure(c, 1.0 / 20.0);
            EXPECT_NEAR(particles->mixing_length(0.999 * top), particles->mixing_length(1.001 * top),
                        0.02 * particles->mixing_length(top));
            // Nowhere in the layer do the rows lose their eddy viscosity, nu_t/(u_* dz) = l^2 u'/(u_* dz).
            for (const double row : {0.5, 1.5, 2.5, 3.5}) {
                const double z = row / 20.0;
                const double shear = (layer.velocity(z + 1e-6) - layer.velocity(z - 1e-6)) / 2e-6;
                const double length = layer.mixing_length(z);
                EXPECT_GT(length * length * shear, 0.2 * friction_velocity / 20.0) << row;
            }
        }
    }
}

TEST(WallLayer, FollowsTheSpeedWhereViscosityCounts) {
    Case rough = gravel_bed(0.05);
    rough.fluid.kinematic_viscosity = 0.0;
    EXPECT_EQ(WallLayer(rough, 0.05).speed_factor(0.02, 3.0), 1.0);
    const WallLayer layer(smooth_bed(), 0.05);
    const double speed = layer.velocity(0.02);
    EXPECT_NEAR(layer.speed_factor(0.02, speed), 1.0, 1e-9);
    EXPECT_LT(layer.speed_factor(0.02, 2.0 * speed), layer.speed_factor(0.02, speed));
    // At another friction velocity it is the layer made for that.
    Case faster = smooth_bed();
    faster.channel.slope *= 4.0;
    const WallLayer other(faster, 0.05);
    EXPECT_NEAR(layer.drag_coefficient(0.0) * layer.speed_factor(0.02, other.velocity(0.02)),
                other.drag_coefficient(0.0), 2e-3 * other.drag_coefficient(0.0));
}

TEST(WallLaw, OtherBedsHaveNone) {
    Case c;
    c.channel.depth = 0.05;
    c.bed.roughness_height = 0.010;
    EXPECT_FALSE(bed_wall_law(c));
    const auto closure = make_closure(c);
    const auto particles = make_particle_closure(c, 0.002);
    for (const double z : {0.001, 0.02, 0.05}) {
        EXPECT_EQ(particles->mixing_length(z), closure->mixing_length(z));
        EXPECT_EQ(closure->mixing_length_in(z, c.total_depth()), closure->mixing_length(z));
        // In deeper water the lengths are those of the same shares of the depth.
        EXPECT_NEAR(closure->mixing_length_in(2.0 * z, 2.0 * c.total_depth()),
                    2.0 * closure->mixing_length(z), 1e-15);
    }
}

}  // namespace
}  // namespace riffle::wall_law_test
