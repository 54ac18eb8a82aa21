#include "hydraulics/friction_parts.hpp"

#include <cstddef>

#include "base/error.hpp"

namespace riffle::inline hydraulics {

double friction_factor_of_stress(std::span<const double> height, std::span<const double> stress,
                                 double crests, double surface, double density, double velocity) {
    if (!(surface > crests) || !(density > 0.0) || !(velocity > 0.0) || height.size() < 2 ||
        stress.size() != height.size()) {
        throw InputError(
            "friction factor of a stress: expected a surface above the crests, a density and a "
            "velocity greater than 0, and as many stresses as heights, at least two");
    }
    // Integrals of (1 - xi) tau over stretches on which tau is linear, exactly: Simpson's rule.
    const double depth = surface - crests;
    double sum = 0.0;
    double low = crests;
    const auto at_crests = [&] {
        std::size_t above = 1;
        while (above + 1 < height.size() && height[above] < crests) ++above;
        const double share = (crests - height[above - 1]) / (height[above] - height[above - 1]);
        return stress[above - 1] + share * (stress[above] - stress[above - 1]);
    };
    double tau_low = at_crests();
    const auto add_up_to = [&](double high, double tau_high) {
        const auto weighted = [&](double z, double tau) { return (surface - z) / depth * tau; };
        const double middle = weighted(0.5 * (low + high), 0.5 * (tau_low + tau_high));
        sum += (high - low) / 6.0 * (weighted(low, tau_low) + 4.0 * middle + weighted(high, tau_high));
        low = high;
        tau_low = tau_high;
    };
    for (std::size_t i = 0; i < height.size(); ++i) {
        if (height[i] > crests && height[i] < surface) add_up_to(height[i], stress[i]);
    }
    add_up_to(surface, 0.0);
    return 24.0 / (density * velocity * velocity * depth) * sum;
}

}  // namespace riffle::inline hydraulics
