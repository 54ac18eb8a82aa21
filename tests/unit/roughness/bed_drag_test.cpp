#include "roughness/bed_drag.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "roughness/sphere_bed.hpp"

namespace riffle::bed_drag_test {
namespace {

Case sphere_bed() {
    Case c;
    c.channel.depth = 0.050;
    c.bed.sphere_diameter = 0.025;
    c.bed.roughness_height = 0.010;
    c.bed.drag_coefficient = 0.8;
    return c;
}

double integral(const BedDrag& drag, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double z) { return drag.coefficient(z); }, 0.0, to, 15, 1e-10);
}

TEST(ConsistentDrag, CarriesTheFrontalAreaOfTheSpheres) {
    // A whole sphere (d_h = D) must give 1/2 C_d n_s pi D^2/4 over the height.
    Case c = sphere_bed();
    c.bed.roughness_height = c.bed.sphere_diameter;
    const double d = c.bed.sphere_diameter;
    const double disc = std::numbers::pi * d * d / 4;
    EXPECT_NEAR(integral(*make_bed_drag(c), d), 0.5 * 0.8 * 2 / (std::sqrt(3.0) * d * d) * disc, 1e-8);
    c.bed.packing = Packing::square;
    EXPECT_NEAR(integral(*make_bed_drag(c), d), 0.5 * 0.8 * std::numbers::pi / 4, 1e-8);
}

TEST(ConsistentDrag, IsTheChordOfTheExposedCapAndFreeOfTheSpacing) {
    Case c = sphere_bed();
    const auto drag = make_bed_drag(c);
    // At z = d_h - R + R sin(60 deg) ... the chord is R; here the centre lies 2.5 mm below the bed level.
    const double r = 0.0125;
    const double z = c.bed.roughness_height - r + r * std::sin(std::numbers::pi / 3);
    const double n = 2 / (std::sqrt(3.0) * 0.025 * 0.025);
    EXPECT_NEAR(drag->coefficient(z), 0.5 * 0.8 * 2 * n * r / 2, 1e-9);
    c.numerics.spacing = 0.001;
    EXPECT_EQ(make_bed_drag(c)->coefficient(z), drag->coefficient(z));
}

TEST(ThesisDrag, ScalesWithTheInverseSpacing) {
    Case c = sphere_bed();
    c.bed.drag_form = DragForm::thesis;
    c.numerics.spacing = 0.0015;
    const double coarse = make_bed_drag(c)->coefficient(0.005);
    EXPECT_NEAR(coarse, 0.8 * std::sqrt(0.0125 * 0.0125 - 0.0075 * 0.0075) / 0.0015, 1e-12);
    c.numerics.spacing = 0.00075;
    EXPECT_DOUBLE_EQ(make_bed_drag(c)->coefficient(0.005), 2 * coarse);
}

TEST(PaperDrag, IsConstantInTheRoughnessZone) {
    Case c = sphere_bed();
    c.bed.drag_form = DragForm::paper;
    c.bed.sphere_diameter = 0.024;
    c.bed.roughness_height = 0.012;
    c.bed.drag_coefficient = 0.5;
    const auto drag = make_bed_drag(c);
    for (const double z : {0.0, 0.006, 0.012}) EXPECT_DOUBLE_EQ(drag->coefficient(z), 0.5 / 0.048);
    EXPECT_EQ(drag->coefficient(0.0120001), 0.0);
}

TEST(BedDrag, SmoothBedsHaveNone) {
    Case c = sphere_bed();
    for (const BedKind kind : {BedKind::slip, BedKind::no_slip}) {
        c.bed.kind = kind;
        EXPECT_EQ(make_bed_drag(c), nullptr);
    }
}

class EveryForm : public testing::TestWithParam<DragForm> {};

TEST_P(EveryForm, IsZeroOutsideTheRoughnessZoneAndBatchAgrees) {
    Case c = sphere_bed();
    c.bed.drag_form = GetParam();
    const auto drag = make_bed_drag(c);
    EXPECT_EQ(drag->coefficient(-1e-9), 0.0);
    EXPECT_EQ(drag->coefficient(0.010 + 1e-9), 0.0);
    EXPECT_GT(drag->coefficient(0.0), 0.0);
    EXPECT_GT(drag->coefficient(0.0099), 0.0);
    std::vector<double> z;
    for (int i = -3; i < 60; ++i) z.push_back(0.00037 * i);
    std::vector<double> batch(z.size());
    drag->coefficients(z, batch);
    for (std::size_t i = 0; i < z.size(); ++i) EXPECT_EQ(batch[i], drag->coefficient(z[i]));
}

INSTANTIATE_TEST_SUITE_P(Forms, EveryForm,
                         testing::Values(DragForm::consistent, DragForm::thesis, DragForm::paper));

}  // namespace
}  // namespace riffle::bed_drag_test
