// Single against double precision of the pair arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_case.hpp"

namespace riffle::precision_test {
namespace {

constexpr double velocity = 1.0;  // U, m/s

/// Water 1 m deep over rough ground, at 1 m/s on the surface; from a disordered hydrostatic state.
Case deep_channel(double sound_speed_ratio, int dimensions) {
    Case c;
    c.channel.dimensions = dimensions;
    if (dimensions == 3) c.bed.drag_form = DragForm::plan_mean;
    c.channel.slope = 0.001;
    c.channel.depth = 0.94;
    c.bed.sphere_diameter = 0.1;
    c.bed.roughness_height = 0.1;
    c.bed.datum_below_crest = 0.04;
    c.numerics.spacing = dimensions == 2 ? 1.0 / 40.0 : 1.0 / 20.0;
    c.numerics.sound_speed = sound_speed_ratio * velocity;
    c.channel.length = dimensions == 2 ? 1.0 : 0.4;
    c.channel.width = 0.4;
    c.start.kind = StartKind::power_law;
    c.start.velocity = velocity;
    c.start.jitter = 0.2;
    return c;
}

/// Accelerations, by axis and particle id: the change of the velocities in one step, over the step.
template <int D>
std::array<std::vector<double>, 3> accelerations(Case c, Precision precision, const Particles<D>& start) {
    c.numerics.precision = precision;
    const auto simulation = make_simulation<D>(c, nullptr, start);
    const Particles<D> before = simulation->particles();
    simulation->step();
    const Particles<D>& after = simulation->particles();
    EXPECT_EQ(before.id, after.id);
    const auto place = test::places_by_id<D>(after);
    std::array<std::vector<double>, 3> result;
    for (std::size_t k = 0; k < D; ++k) {
        for (const std::size_t i : place) {
            result[k].push_back((after.velocity[k][i] - before.velocity[k][i]) /
                                simulation->clock().time_step);
        }
    }
    return result;
}

/// Largest difference between the precisions in units of g.
template <int D>
double difference(const Case& c, const Particles<D>& start) {
    const auto in_single = accelerations<D>(c, Precision::single_precision, start);
    const auto in_double = accelerations<D>(c, Precision::double_precision, start);
    double largest = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i) {
        double squared = 0.0;
        for (std::size_t k = 0; k < D; ++k) squared += std::pow(in_single[k][i] - in_double[k][i], 2);
        largest = std::max(largest, std::sqrt(squared));
    }
    // Zero would mean that both were computed in the same precision.
    EXPECT_GT(largest, 0.0);
    return largest / c.fluid.gravity;
}

/// The bar of the core: accelerations differ by less than 1e-3 g, at once and through the density of a whole
/// step, on a disordered lattice and in the flow's own disorder. Rounding is 6e-8 of pressures of up to g H
/// over an h of H/27 and H/13, so some 1e-5 g is expected, and found.
template <int D>
void check_precision(double ratio) {
    Case c = deep_channel(ratio, D);
    const Particles<D> start = initial_particles<D>(c, make_scheme(c, nullptr), nullptr);
    EXPECT_LT(difference<D>(c, start), 1e-3) << "in a whole step from the disordered lattice";
    Case instant = c;
    instant.numerics.time_step = 1e-7;  // the density changes by less than 1e-6 in it
    EXPECT_LT(difference<D>(instant, start), 1e-3) << "at once, on the disordered lattice";
    Case exact = c;
    exact.numerics.precision = Precision::double_precision;
    const auto simulation = make_simulation<D>(exact, nullptr, start);
    for (int i = 0; i < 50; ++i) simulation->step();
    EXPECT_LT(difference<D>(c, simulation->particles()), 1e-3) << "in a whole step of the flow";
    EXPECT_LT(difference<D>(instant, simulation->particles()), 1e-3) << "at once, in the flow";
}

TEST(Precision, SingleIsNearDoubleInAPlane) {
    check_precision<2>(20.0);
    check_precision<2>(150.0);
}
TEST(Precision, SingleIsNearDoubleInSpace) {
    check_precision<3>(20.0);
    check_precision<3>(150.0);
}

}  // namespace
}  // namespace riffle::precision_test
