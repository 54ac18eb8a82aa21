#include "components/stirring_modes.hpp"

#include <cmath>
#include <numbers>

namespace riffle::inline components {

Stirring2D::Stirring2D(const Case& c, double celerity) : celerity_(celerity) {
    if (c.stirring.acceleration == 0.0) return;
    for (int m = 1; m <= c.stirring.modes; ++m) {
        Mode mode;
        mode.kx = 2.0 * std::numbers::pi * m / c.channel.length;
        mode.kz = std::numbers::pi * m / c.total_depth();
        mode.amplitude = c.stirring.acceleration / std::sqrt(static_cast<double>(c.stirring.modes)) /
                         std::hypot(mode.kx, mode.kz);
        // Golden-angle phases: no two modes peak at the same place.
        mode.phase = std::numbers::pi * (3.0 - std::sqrt(5.0)) * m;
        modes_.push_back(mode);
    }
}

void Stirring2D::add(double x, double z, double t, double& ax, double& az) const {
    for (const Mode& mode : modes_) {
        const double angle = mode.kx * (x - celerity_ * t) + mode.phase;
        ax += mode.amplitude * mode.kz * std::sin(2.0 * mode.kz * z) * std::cos(angle);
        const double sine = std::sin(mode.kz * z);
        az += mode.amplitude * mode.kx * sine * sine * std::sin(angle);
    }
}

Stirring3D::Stirring3D(const Case& c, double celerity) : plane_(c, celerity), celerity_(celerity) {
    if (!plane_.active()) return;
    const bool periodic = c.channel.sides == Sides::periodic;
    const double width = c.channel.simulated_width();
    for (int m = 1; m <= c.stirring.modes; ++m) {
        Roll roll;
        roll.kx = 2.0 * std::numbers::pi * m / c.channel.length;
        roll.ky = (periodic ? 2.0 : 1.0) * std::numbers::pi * m / width;
        roll.kz = std::numbers::pi * m / c.total_depth();
        roll.amplitude = c.stirring.acceleration / std::sqrt(static_cast<double>(c.stirring.modes)) /
                         std::hypot(roll.ky, roll.kz);
        const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
        roll.phase_x = golden * (m + 0.5);
        roll.phase_y = periodic ? golden * m : -0.5 * std::numbers::pi;
        rolls_.push_back(roll);
    }
}

void Stirring3D::add(const Vec<3>& x, double t, Vec<3>& a) const {
    plane_.add(x[0], x[2], t, a[0], a[2]);
    for (const Roll& roll : rolls_) {
        const double along = roll.amplitude * std::cos(roll.kx * (x[0] - celerity_ * t) + roll.phase_x);
        const double across = roll.ky * x[1] + roll.phase_y;
        const double sine = std::sin(roll.kz * x[2]);
        a[1] += along * roll.kz * std::sin(2.0 * roll.kz * x[2]) * std::cos(across);
        a[2] += along * roll.ky * sine * sine * std::sin(across);
    }
}

}  // namespace riffle::inline components
