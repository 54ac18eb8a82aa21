#include "statistics/grid_convergence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/error.hpp"

namespace riffle::grid_convergence_test {
namespace {

std::vector<RefinedValue> power_sequence(double limit, double factor, double order,
                                         const std::vector<double>& sizes) {
    std::vector<RefinedValue> values;
    for (const double size : sizes) {
        values.push_back({size, limit + factor * std::pow(size, order)});
    }
    return values;
}

double in(double low, double high, int thousandths) { return low + (high - low) * thousandths / 1000.0; }

RC_GTEST_PROP(GridConvergence, FindsOrderAndLimitOfExactSequencesAtAnyRatios, ()) {
    const double order = in(0.3, 4.0, *rc::gen::inRange(0, 1001));
    const double r21 = in(1.15, 3.0, *rc::gen::inRange(0, 1001));
    const double r32 = *rc::gen::arbitrary<bool>() ? r21 : in(1.15, 3.0, *rc::gen::inRange(0, 1001));
    const double limit = in(-5.0, 5.0, *rc::gen::inRange(0, 1001));
    const double factor = *rc::gen::arbitrary<bool>() ? 0.7 : -0.7;
    std::vector<RefinedValue> values = power_sequence(limit, factor, order, {1.0, r21, r21 * r32});
    if (*rc::gen::arbitrary<bool>()) std::reverse(values.begin(), values.end());
    const GridConvergence found = grid_convergence(values);
    RC_ASSERT(found.refinement == Refinement::monotone);
    RC_ASSERT(std::abs(*found.order - order) < 1e-6);
    RC_ASSERT(std::abs(*found.limit - limit) < 1e-6);
    RC_ASSERT(!found.order_half_width);
    // 1.25 times the true error of the finest value.
    RC_ASSERT(std::abs(*found.finest_uncertainty - 1.25 * 0.7) < 1e-5);
}

TEST(GridConvergence, UsesTheThreeFinestOfMoreValues) {
    std::vector<RefinedValue> values = power_sequence(2.0, 0.1, 2.0, {1.0, 1.5, 2.0});
    values.push_back({4.0, -100.0});
    EXPECT_NEAR(*grid_convergence(values).order, 2.0, 1e-9);
}

TEST(GridConvergence, ReproducesAnExampleOfTheProcedure) {
    // Celik et al. 2008, Table 1, first column: cells 18 000, 8000, 4500 in two dimensions.
    const auto size = [](double cells) { return 1.0 / std::sqrt(cells); };
    const GridConvergence found = grid_convergence(
        std::vector<RefinedValue>{{size(18000), 6.063}, {size(8000), 5.972}, {size(4500), 5.863}});
    EXPECT_EQ(found.refinement, Refinement::monotone);
    EXPECT_NEAR(*found.order, 1.53, 0.01);
    EXPECT_NEAR(*found.limit, 6.1685, 0.001);
    EXPECT_NEAR(*found.fine_grid_index, 0.022, 0.0005);
}

TEST(GridConvergence, SaysThatASequenceOscillatesAndExtrapolatesNothing) {
    const GridConvergence found =
        grid_convergence(std::vector<RefinedValue>{{1.0, 1.01}, {2.0, 0.98}, {4.0, 1.10}});
    EXPECT_EQ(found.refinement, Refinement::oscillating);
    EXPECT_FALSE(found.limit);
    EXPECT_NEAR(*found.order, 2.0, 1e-9);  // by magnitude: 0.12/0.03 = 2^2
    EXPECT_NE(found.finding.find("oscillating"), std::string::npos);
}

TEST(GridConvergence, SaysThatDifferencesDoNotDiminish) {
    for (const double coarsest : {1.15, 1.05}) {  // equal differences; growing ones
        const GridConvergence found =
            grid_convergence(std::vector<RefinedValue>{{1.0, 1.0 - 0.1}, {2.0, 1.0}, {4.0, coarsest - 0.05}});
        EXPECT_EQ(found.refinement, Refinement::diverging) << coarsest;
        EXPECT_FALSE(found.order);
        EXPECT_FALSE(found.limit);
    }
    // Back and forth, further each time.
    EXPECT_EQ(grid_convergence(std::vector<RefinedValue>{{1.0, 2.0}, {2.0, 0.0}, {4.0, 1.0}}).refinement,
              Refinement::diverging);
}

RC_GTEST_PROP(GridConvergence, RefusesOrdersThatTheMethodDoesNotHave, ()) {
    const double order = in(0.1, 12.0, *rc::gen::inRange(0, 1001));
    RC_PRE(std::abs(order - 0.5) > 1e-3 && std::abs(order - 4.0) > 1e-3);
    const bool negative = *rc::gen::arbitrary<bool>();  // differences of both signs
    const auto found = grid_convergence(power_sequence(1.0, negative ? -0.2 : 0.2, order, {1.0, 1.5, 2.0}),
                                        {0.5, 4.0, false});
    if (order > 0.5 && order < 4.0) {
        RC_ASSERT(found.refinement == Refinement::monotone);
        RC_ASSERT(found.limit.has_value());
    } else {
        RC_ASSERT(found.refinement == Refinement::not_asymptotic);
        RC_ASSERT(!found.order && !found.limit && !found.fine_grid_index && !found.finest_uncertainty);
        RC_ASSERT(found.finding.find("not in the asymptotic range") != std::string::npos);
    }
}

RC_GTEST_PROP(GridConvergence, GivesAMagnitudeNoNegativeLimit, ()) {
    const double limit = in(-0.5, 0.5, *rc::gen::inRange(0, 1001));
    RC_PRE(std::abs(limit) > 1e-6);
    // An rms that falls through a value that is still positive at the finest size.
    const auto values = power_sequence(limit, 0.6, 1.0, {1.0, 1.5, 2.0});
    const auto found = grid_convergence(values, {0.5, 4.0, true});
    RC_ASSERT(found.limit.has_value() == (limit > 0.0));
    RC_ASSERT(grid_convergence(values, {0.5, 4.0, false}).limit.has_value());
}

TEST(GridConvergence, ConcludesNothingFromDifferencesWithinTheSamplingError) {
    std::vector<RefinedValue> values =
        power_sequence(1.0, 0.01, 1.0, {1.0, 2.0, 4.0});  // differ by 0.01, 0.02
    for (RefinedValue& value : values) value.half_width = 0.009;
    const GridConvergence found = grid_convergence(values);
    EXPECT_EQ(found.refinement, Refinement::within_noise);
    EXPECT_FALSE(found.order);
    EXPECT_NE(found.finding.find("within the sampling error"), std::string::npos);
    for (RefinedValue& value : values) value.half_width = 0.001;
    EXPECT_EQ(grid_convergence(values).refinement, Refinement::monotone);
}

TEST(GridConvergence, IntervalsHoldTheTruthAsOftenAsTheyShould) {
    constexpr double deviation = 1e-3;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, deviation);
    int holds_order = 0;
    int holds_limit = 0;
    constexpr int tries = 2000;
    for (int i = 0; i < tries; ++i) {
        std::vector<RefinedValue> values = power_sequence(1.0, 0.1, 1.5, {1.0, 1.5, 2.4});
        for (RefinedValue& value : values) {
            value.value += noise(random);
            value.half_width = 1.96 * deviation;
        }
        const GridConvergence found = grid_convergence(values);
        ASSERT_TRUE(found.order && found.order_half_width && found.limit && found.limit_half_width);
        holds_order += std::abs(*found.order - 1.5) <= *found.order_half_width ? 1 : 0;
        holds_limit += std::abs(*found.limit - 1.0) <= *found.limit_half_width ? 1 : 0;
    }
    // 95 %, to four standard errors of that share and a point for the curvature that linear propagation
    // leaves out.
    const double allowed = 0.01 + 4.0 * std::sqrt(0.95 * 0.05 / tries);
    EXPECT_NEAR(holds_order / static_cast<double>(tries), 0.95, allowed);
    EXPECT_NEAR(holds_limit / static_cast<double>(tries), 0.95, allowed);
}

TEST(GridConvergence, EqualFinestValuesTellNoOrder) {
    EXPECT_EQ(grid_convergence(std::vector<RefinedValue>{{1.0, 3.0}, {2.0, 3.0}, {4.0, 3.5}}).refinement,
              Refinement::unchanged);
}

TEST(GridConvergence, RefusesWhatIsNoSequence) {
    EXPECT_THROW((void)grid_convergence(std::vector<RefinedValue>{{1.0, 1.0}, {2.0, 2.0}}), InputError);
    EXPECT_THROW((void)grid_convergence(std::vector<RefinedValue>{{1.0, 1.0}, {1.0, 2.0}, {2.0, 4.0}}),
                 InputError);
    EXPECT_THROW((void)grid_convergence(std::vector<RefinedValue>{{0.0, 1.0}, {1.0, 2.0}, {2.0, 4.0}}),
                 InputError);
    EXPECT_THROW((void)grid_convergence(std::vector<RefinedValue>{{1.0, NAN}, {2.0, 2.0}, {4.0, 4.0}}),
                 InputError);
}

RC_GTEST_PROP(PowerLawFit, FindsTheExponentOfMagnitudes, ()) {
    const double exponent = in(-4.0, 4.0, *rc::gen::inRange(0, 1001));
    std::vector<RefinedValue> values = power_sequence(0.0, 0.3, exponent, {1.0, 1.5, 2.0, 4.0});
    values[1].value = -values[1].value;
    const std::optional<PowerLaw> law = fit_power_law(values);
    RC_ASSERT(law.has_value());
    RC_ASSERT(std::abs(law->exponent - exponent) < 1e-9);
    RC_ASSERT(std::abs(law->factor - 0.3) < 1e-9);
    values.resize(2);
    RC_ASSERT(std::abs(fit_power_law(values)->exponent - exponent) < 1e-9);
}

TEST(PowerLawFit, NeedsTwoSizesAndNoZero) {
    EXPECT_FALSE(fit_power_law(std::vector<RefinedValue>{{1.0, 1.0}}));
    EXPECT_FALSE(fit_power_law(std::vector<RefinedValue>{{1.0, 1.0}, {2.0, 0.0}, {4.0, 1.0}}));
    EXPECT_FALSE(fit_power_law(std::vector<RefinedValue>{{1.0, 1.0}, {1.0, 2.0}}));
}

}  // namespace
}  // namespace riffle::grid_convergence_test
