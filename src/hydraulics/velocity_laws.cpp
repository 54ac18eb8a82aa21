#include "hydraulics/velocity_laws.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace riffle::inline hydraulics {

namespace {
using std::numbers::pi;
}  // namespace

double smooth_log_law(double z, double friction_velocity, double kinematic_viscosity, double kappa,
                      double constant) {
    return friction_velocity * (std::log(z * friction_velocity / kinematic_viscosity) / kappa + constant);
}

double coles_wake(double z, double depth, double wake_strength, double kappa) {
    const double sine = std::sin(0.5 * pi * z / depth);
    return 2.0 * wake_strength / kappa * sine * sine;
}

double rough_log_wake_law(double z, double depth, double friction_velocity, double equivalent_roughness,
                          double wake_strength, double kappa) {
    return rough_log_law(z, friction_velocity, equivalent_roughness, kappa) +
           friction_velocity * coles_wake(z, depth, wake_strength, kappa);
}

double power_law(double z, double depth, double maximum_velocity, double m) {
    return maximum_velocity * std::pow(z / depth, 1.0 / m);
}

double dip_modified_log_law(double z, double depth, double friction_velocity, double zero_velocity_height,
                            double dip, double kappa) {
    return friction_velocity / kappa * (std::log(z / zero_velocity_height) + dip * std::log1p(-z / depth));
}

double dip_parameter_near_wall(double wall_distance, double depth) {
    return 1.3 * std::exp(-wall_distance / depth);
}

double dip_parameter_of_maximum(double height_of_maximum, double depth) {
    return depth / height_of_maximum - 1.0;
}

double total_dip_log_wake_law(double z, double depth, double friction_velocity, double zero_velocity_height,
                              double dip, double wake_strength, double kappa) {
    const double xi = z / depth;
    const double xi0 = zero_velocity_height / depth;
    const double logarithms = std::log(xi / xi0) + dip * (std::log1p(-xi) - std::log1p(-xi0));
    const double wake = (1.0 + dip) * (std::cos(pi * xi0) - std::cos(pi * xi)) -
                        dip * pi * (sine_integral(pi * (1.0 - xi0)) - sine_integral(pi * (1.0 - xi)));
    return friction_velocity / kappa * (logarithms + wake_strength * wake);
}

double total_dip_log_wake_gradient(double z, double depth, double friction_velocity, double dip,
                                   double wake_strength, double kappa) {
    const double xi = z / depth;
    return friction_velocity / (kappa * depth) * (1.0 / xi - dip / (1.0 - xi)) *
           (1.0 + pi * wake_strength * xi * std::sin(pi * xi));
}

double sine_integral(double x) {
    if (!(std::abs(x) <= 10.0)) throw InputError("the sine integral is implemented for |x| <= 10");
    // Sum of (-1)^k x^(2k+1)/((2k+1) (2k+1)!). Its largest term is below 300 here, so that cancellation costs
    // at most 300 units in the last place of a result of order 1.
    double power = x;
    double sum = x;
    for (int k = 1; k < 60; ++k) {
        power *= -x * x / (2.0 * k * (2.0 * k + 1.0));
        sum += power / (2.0 * k + 1.0);
    }
    return sum;
}

}  // namespace riffle::inline hydraulics
