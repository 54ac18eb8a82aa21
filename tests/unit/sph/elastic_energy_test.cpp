// The elastic energy against the work of the pressure, integrated by Simpson's rule.

#include "sph/elastic_energy.hpp"

#include <gtest/gtest.h>

namespace riffle::elastic_energy_test {
namespace {

double work_of_pressure(const StateEquation& state, double s) {
    const auto integrand = [&](double x) { return state.pressure(x) / ((1.0 + x) * (1.0 + x)); };
    constexpr int steps = 200;
    const double width = s / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += width / 6.0 *
               (integrand(i * width) + 4.0 * integrand((i + 0.5) * width) + integrand((i + 1) * width));
    }
    return sum;
}

TEST(ElasticEnergy, IsTheWorkOfThePressure) {
    for (const EquationOfState kind : {EquationOfState::linear, EquationOfState::tait}) {
        const StateEquation state{kind, 20.0};
        for (const double s : {-0.02, -1e-4, 1e-4, 0.01, 0.03}) {
            // The first term left out is of the order of s^3 (Tait: 20 s^3) against the first.
            const double expected = work_of_pressure(state, s);
            EXPECT_NEAR(elastic_energy(state, s) / expected, 1.0, 1e-9 + 40.0 * std::abs(s * s * s)) << s;
        }
        EXPECT_EQ(elastic_energy(state, 0.0), 0.0);
    }
}

}  // namespace
}  // namespace riffle::elastic_energy_test
