#include "hydraulics/channel_laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace riffle::inline hydraulics {

double friction_factor(double gravity_component, double hydraulic_radius, double velocity) {
    return 8.0 * gravity_component * hydraulic_radius / (velocity * velocity);
}

double manning_coefficient(double slope, double hydraulic_radius, double velocity) {
    return std::pow(hydraulic_radius, 2.0 / 3.0) * std::sqrt(slope) / velocity;
}

double chezy_coefficient(double slope, double hydraulic_radius, double velocity) {
    return velocity / std::sqrt(hydraulic_radius * slope);
}

double reynolds_number(double velocity, double length, double kinematic_viscosity) {
    return velocity * length / kinematic_viscosity;
}

double froude_number(double velocity, double gravity, double depth) {
    return velocity / std::sqrt(gravity * depth);
}

double hydraulic_radius(double depth, double width) { return width * depth / (width + 2.0 * depth); }

double friction_velocity_from_slope(double gravity_component, double depth) {
    return std::sqrt(gravity_component * depth);
}

double colebrook_white_friction_factor(double equivalent_roughness, double hydraulic_radius, double reynolds,
                                       const ColebrookWhiteConstants& constants) {
    if (!(equivalent_roughness >= 0.0) || !(hydraulic_radius > 0.0) || !(reynolds > 0.0)) {
        throw InputError("Colebrook-White needs k_s >= 0, a hydraulic radius > 0 and a Reynolds number > 0");
    }
    const double c1 = constants.c1;
    const double rough = equivalent_roughness / (constants.c2 * hydraulic_radius);
    const double smooth = constants.c3 / reynolds;
    if (!(rough < 1.0)) {
        throw InputError(
            fmt::format("Colebrook-White has no solution for k_s = {:.4g} times the hydraulic radius: needs "
                        "less than {:.4g}",
                        equivalent_roughness / hydraulic_radius, constants.c2));
    }
    // Newton on x = 1/sqrt(f): x + c1 log10(rough + smooth x) = 0, increasing and concave in x: from a point
    // left of the root every later iterate stays left of it and rises to it.
    double x = 1e-3;
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double argument = rough + smooth * x;
        const double residual = x + c1 * std::log10(argument);
        const double step = residual / (1.0 + c1 * smooth / (argument * std::numbers::ln10));
        x -= step;
        if (std::abs(step) <= 1e-14 * std::abs(x)) break;
    }
    return 1.0 / (x * x);
}

double colebrook_white_velocity(double gravity_component, double equivalent_roughness,
                                double hydraulic_radius, double kinematic_viscosity,
                                const ColebrookWhiteConstants& constants) {
    const double friction_velocity = friction_velocity_from_slope(gravity_component, hydraulic_radius);
    const double root8 = std::sqrt(8.0);
    const double viscous =
        constants.c3 * kinematic_viscosity / (4.0 * root8 * hydraulic_radius * friction_velocity);
    return -root8 * constants.c1 * friction_velocity *
           std::log10(equivalent_roughness / (constants.c2 * hydraulic_radius) + viscous);
}

double velocity_from_friction_factor(double gravity_component, double hydraulic_radius,
                                     double friction_factor) {
    return std::sqrt(8.0 * gravity_component * hydraulic_radius / friction_factor);
}

double velocity_ratio(double friction_factor) { return std::sqrt(8.0 / friction_factor); }

double roughness_reynolds_number(double equivalent_roughness, double friction_velocity,
                                 double kinematic_viscosity) {
    return equivalent_roughness * friction_velocity / kinematic_viscosity;
}

RoughnessClass roughness_class(double roughness_reynolds) {
    if (roughness_reynolds < 5.0) return RoughnessClass::smooth;
    return roughness_reynolds <= 70.0 ? RoughnessClass::transitional : RoughnessClass::rough;
}

double rough_log_law(double z, double friction_velocity, double equivalent_roughness, double kappa) {
    return friction_velocity * (std::log(z / equivalent_roughness) / kappa + rough_log_law_constant);
}

double rough_log_law_depth_mean(double depth, double friction_velocity, double equivalent_roughness,
                                double kappa) {
    // The mean of ln z over 0 < z < depth is ln(depth) - 1.
    return rough_log_law(depth, friction_velocity, equivalent_roughness, kappa) - friction_velocity / kappa;
}

double equivalent_roughness_from_mean(double depth, double friction_velocity, double velocity, double kappa) {
    return depth * std::exp(-1.0 - kappa * (velocity / friction_velocity - rough_log_law_constant));
}

}  // namespace riffle::inline hydraulics
