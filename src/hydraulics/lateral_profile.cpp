#include "hydraulics/lateral_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hydraulics/channel_laws.hpp"

namespace riffle::inline hydraulics {

namespace {

constexpr double lambda = 0.07;

/// f of a strip by the velocity of uniform flow of its depth, which hardly changes it.
double friction_of(double depth, double gravity_component, double equivalent_roughness,
                   double kinematic_viscosity) {
    // In water no deeper than its roughness the law ends.
    const double radius = std::max(depth, equivalent_roughness);
    const double velocity =
        colebrook_white_velocity(gravity_component, equivalent_roughness, radius, kinematic_viscosity);
    return friction_factor(gravity_component, radius, velocity);
}

}  // namespace

std::vector<double> lateral_profile(const std::vector<LateralStrip>& strips, double width,
                                    double gravity_component, double kinematic_viscosity) {
    const std::size_t count = strips.size();
    std::vector<double> friction(count, 0.0);
    std::vector<double> exchange(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        if (strips[i].depth <= 0.0) continue;
        friction[i] = friction_of(strips[i].depth, gravity_component, strips[i].equivalent_roughness,
                                  kinematic_viscosity);
        exchange[i] = 0.5 * lambda * strips[i].depth * strips[i].depth * std::sqrt(friction[i] / 8.0);
    }
    // Linear in U^2, for U dU/dy is half of its gradient; three diagonals, solved from one side and back.
    const auto between = [&](std::size_t i) {  // of a strip and the next one
        const bool dry = strips[i].depth <= 0.0 || strips[i + 1].depth <= 0.0;
        return dry ? 0.0 : 0.5 * (exchange[i] + exchange[i + 1]) / (width * width);
    };
    std::vector<double> square(count, 0.0);
    std::vector<double> upper(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double before = i > 0 ? between(i - 1) : 0.0;
        const double behind = i + 1 < count ? between(i) : 0.0;
        const double own = strips[i].depth > 0.0 ? friction[i] / 8.0 * strips[i].perimeter : 1.0;
        const double pivot = own + behind + before * (i > 0 ? 1.0 - upper[i - 1] : 1.0);
        upper[i] = behind / pivot;
        square[i] =
            (gravity_component * std::max(0.0, strips[i].depth) + before * (i > 0 ? square[i - 1] : 0.0)) /
            pivot;
    }
    for (std::size_t i = count; i-- > 1;) square[i - 1] += upper[i - 1] * square[i];
    std::vector<double> velocity(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) velocity[i] = std::sqrt(std::max(0.0, square[i]));
    return velocity;
}

}  // namespace riffle::inline hydraulics
