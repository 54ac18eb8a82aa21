#include "exact_flows.hpp"

#include <cmath>
#include <numbers>

namespace riffle::verification {

double start_up_poiseuille(double force, double nu, double width, double z, double t) {
    double u = force / (2.0 * nu) * z * (width - z);
    for (int n = 0; n < 200; ++n) {
        const double k = std::numbers::pi * (2 * n + 1) / width;
        u -= 4.0 * force / (nu * width * k * k * k) * std::sin(k * z) * std::exp(-nu * k * k * t);
    }
    return u;
}

double vortex_amplitude(const CheckRun& run) {
    const Particles<2>& p = run.particles();
    const double k = 2.0 * std::numbers::pi / run.parameters().channel.length;
    return 2.0 * mass_mean(p, [&](std::size_t i) {
               const double x = k * p.position[0][i];
               const double z = k * p.position[1][i];
               return p.velocity[0][i] * std::sin(x) * std::cos(z) -
                      p.velocity[1][i] * std::cos(x) * std::sin(z);
           });
}

}  // namespace riffle::verification
