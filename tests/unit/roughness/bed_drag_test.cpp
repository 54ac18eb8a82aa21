#include "roughness/bed_drag.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "roughness/row_mean_drag.hpp"
#include "roughness/sphere_bed.hpp"
#include "roughness/sphere_drag.hpp"

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

// Rows of particles meet the whole drag of the bed wherever they stand; at their centres they do not.
TEST_P(EveryForm, SumsOverRowsToTheWholeDragWhereverTheRowsStand) {
    Case c = sphere_bed();
    c.bed.drag_form = GetParam();
    constexpr double row = 0.0015;
    const double whole = integral(*make_bed_drag(c), c.bed.roughness_height);
    const auto mean = row_mean_drag(make_bed_drag(c), row);
    EXPECT_NEAR(mean->top(), c.bed.roughness_height + 0.5 * row, 1e-12);
    for (const double shift : {0.0, 0.2, 0.35, 0.5, 0.81}) {
        double sum = 0.0;
        for (int i = -1; i < 10; ++i) sum += mean->coefficient((i + shift) * row) * row;
        EXPECT_NEAR(sum / whole, 1.0, 1e-5) << shift;
    }
}

TEST_P(EveryForm, IsThatOfThePointWhereRowsAreThin) {
    Case c = sphere_bed();
    c.bed.drag_form = GetParam();
    const auto point = make_bed_drag(c);
    const auto mean = row_mean_drag(make_bed_drag(c), 1e-4);
    for (const double z : {0.001, 0.004, 0.0075}) {
        EXPECT_NEAR(mean->coefficient(z) / point->coefficient(z), 1.0, 1e-4);
    }
}

// Of spheres at their places: over a row above one place it is the mean of what many points find there.
TEST(RowMeanDrag, OfSpheresAtTheirPlacesIsTheirMeanOverTheRow) {
    Case c = sphere_bed();
    c.channel.dimensions = 3;
    const auto point = make_bed_drag(c);
    constexpr double row = 0.003;
    const auto mean = row_mean_drag(make_bed_drag(c), row);
    ASSERT_TRUE(mean->varies_in_plan());
    const double inside = volume_drag_coefficient(c.bed.drag_coefficient, c.bed.sphere_diameter);
    for (const double x : {0.0, 0.004, 0.009}) {
        for (const double z : {0.002, 0.006, 0.009}) {
            double sum = 0.0;
            for (int k = 0; k < 1000; ++k) {
                sum += 1e-3 * point->coefficient_at(x, 0.003, z + row * (1e-3 * (k + 0.5) - 0.5));
            }
            EXPECT_NEAR(mean->coefficient_at(x, 0.003, z), sum, 0.01 * inside) << x << ' ' << z;
        }
    }
}

}  // namespace
}  // namespace riffle::bed_drag_test
