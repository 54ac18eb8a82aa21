#include "solver/stirring.hpp"

#include <cmath>
#include <numbers>

namespace riffle {

Stirring2D::Stirring2D(const Case& c, double celerity) : celerity_(celerity) {
    if (c.stirring.acceleration == 0.0) {
        return;
    }
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

}  // namespace riffle
