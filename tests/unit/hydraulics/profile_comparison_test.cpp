#include "hydraulics/profile_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/error.hpp"

namespace riffle::profile_comparison_test {
namespace {

using Values = std::vector<double>;

TEST(ProfileComparison, MsepOfTheThesis) {
    // model.md: 0.5 % MSEP is 7 % relative, 2.5 % is 16 %, 4.5 % is 21 %.
    EXPECT_NEAR(squared_error_percentage(1.0, 1.0 + std::sqrt(0.005)), 0.5, 1e-12);
    EXPECT_NEAR(squared_error_percentage(0.3, 0.3 * 0.84), 2.56, 1e-12);
    EXPECT_TRUE(std::isinf(squared_error_percentage(0.0, 0.1)));
}

TEST(ProfileComparison, InterpolatesAndMeasuresErrors) {
    const Values z{0.0, 1.0, 3.0};
    const Values u{0.0, 2.0, 4.0};
    const Values measured_z{0.5, 1.0, 2.0};
    const Values measured_u{1.25, 2.0, 2.0};
    const ProfileComparison c = compare_profiles({z, u}, {measured_z, measured_u});
    ASSERT_EQ(c.points.size(), 3U);
    EXPECT_DOUBLE_EQ(c.points[0].computed, 1.0);
    EXPECT_DOUBLE_EQ(c.points[0].relative_error, -0.2);
    EXPECT_DOUBLE_EQ(c.points[0].msep, 4.0);
    EXPECT_DOUBLE_EQ(c.points[1].computed, 2.0);
    EXPECT_DOUBLE_EQ(c.points[2].computed, 3.0);
    EXPECT_DOUBLE_EQ(c.errors.maximum_relative, 0.5);
    EXPECT_DOUBLE_EQ(c.errors.height_of_maximum, 2.0);
    EXPECT_NEAR(c.errors.mean_relative, 0.1, 1e-15);
    EXPECT_NEAR(c.errors.rms_relative, std::sqrt(0.29 / 3), 1e-15);
    EXPECT_NEAR(c.errors.mean_msep, 29.0 / 3, 1e-13);
    EXPECT_NEAR(c.errors.maximum_msep, 25.0, 1e-13);
    EXPECT_NEAR(c.errors.rms_difference, std::sqrt((0.0625 + 1.0) / 3), 1e-15);
    const ErrorMeasures lower = errors_between(c.points, 0.0, 1.5);
    EXPECT_EQ(lower.points, 2U);
    EXPECT_NEAR(lower.mean_relative, -0.1, 1e-15);
}

TEST(ProfileComparison, TellsWhatItLeavesOut) {
    const Values z{1.0, 2.0};
    const Values u{1.0, 2.0};
    const Values measured_z{0.9, 1.0, 1.5, 2.0, 2.1, std::nan("")};
    const Values measured_u{1.0, 1.0, 0.0, 2.0, 2.0, 1.0};
    const ProfileComparison c = compare_profiles({z, u}, {measured_z, measured_u});
    EXPECT_EQ(c.points.size(), 3U);  // the ends of the range belong to it
    EXPECT_EQ(c.errors.points, 3U);
    EXPECT_EQ(c.errors.measured_zero, 1U);
    EXPECT_EQ(c.errors.rms_relative, 0.0);
    ASSERT_EQ(c.left_out.size(), 3U);
    EXPECT_EQ(c.left_out[0].reason, LeftOut::below_computed);
    EXPECT_EQ(c.left_out[1].reason, LeftOut::above_computed);
    EXPECT_EQ(c.left_out[2].reason, LeftOut::unmeasured);
    EXPECT_EQ(c.left_out[1].z, 2.1);
    EXPECT_TRUE(std::isnan(errors_between(c.points, 5.0, 6.0).rms_relative));
}

TEST(ProfileComparison, GradientsOfTheSameFunctionAgreeWhateverTheirHeights) {
    // Quotients over the same heights: a fine computed profile leaves only its interpolation error,
    // dz^2 u''/8 at each end over the distance of the points.
    Values z;
    Values u;
    const double dz = 0.001;
    for (int i = 0; i <= 1000; ++i) {
        z.push_back(i * dz);
        u.push_back(std::sin(z.back()));
    }
    const Values measured_z{0.0503, 0.2, 0.41, 0.9, 1.5};
    Values measured_u;
    for (const double height : measured_z) measured_u.push_back(std::sin(height));
    const ProfileComparison c = compare_gradients({z, u}, {measured_z, measured_u});
    ASSERT_EQ(c.points.size(), 3U);
    EXPECT_DOUBLE_EQ(c.points[0].z, 0.5 * (0.0503 + 0.2));
    for (const ComparedPoint& p : c.points) EXPECT_NEAR(p.computed, p.measured, 2 * dz * dz / 8 / 0.1497);
    ASSERT_EQ(c.left_out.size(), 1U);
    EXPECT_EQ(c.left_out[0].reason, LeftOut::above_computed);
}

TEST(ProfileComparison, RefusesProfilesThatDoNotRise) {
    const Values falling{1.0, 0.5};
    const Values two{1.0, 2.0};
    const Values three{1.0, 2.0, 3.0};
    EXPECT_THROW((void)compare_profiles({falling, two}, {two, two}), InputError);
    EXPECT_THROW((void)compare_profiles({two, three}, {two, two}), InputError);
    EXPECT_THROW((void)compare_gradients({two, two}, {falling, two}), InputError);
}

}  // namespace
}  // namespace riffle::profile_comparison_test
