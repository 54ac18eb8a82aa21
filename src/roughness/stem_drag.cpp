#include "roughness/stem_drag.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace riffle::inline roughness {

double StemDrag::deceleration_slope(double u) const {
    const double speed = std::max(std::abs(u), least_speed);
    const double coefficient = drag_coefficient(speed);
    double slope_over_speed = 2.0 * coefficient;  // of C_D u^2, over u
    if (!constant_) {
        const double reynolds = reynolds_per_speed_ * speed;
        const double factor = streamlines(speed) ? std::pow(speed / reference_, exponent_) : 1.0;
        // Re dC_D/dRe.
        slope_over_speed += factor * (-0.43 * 50.0 * std::pow(reynolds, -0.43) +
                                      0.7 * reynolds / 15000.0 * std::exp(-reynolds / 15000.0));
    }
    if (streamlines(speed)) slope_over_speed += exponent_ * coefficient;
    return per_coefficient_ * slope_over_speed * speed;
}

double StemDrag::deceleration_integral(double u) const {
    const double speed = std::abs(u);
    if (constant_ && !streamlines(speed)) return per_coefficient_ * *constant_ * speed * speed * speed / 3.0;
    // Gauss-Legendre quadrature on both sides of the reference velocity, with u = u_end t^2, which makes the
    // powers of u smooth at rest.
    constexpr std::array<double, 4> place{0.183434642495649805, 0.525532409916328986, 0.796666477413626740,
                                          0.960289856497536232};
    constexpr std::array<double, 4> weight{0.362683783378361983, 0.313706645877887287, 0.222381034453374471,
                                           0.101228536290376259};
    const auto over = [&](double from, double to) {
        const double low = std::sqrt(from);
        const double half = 0.5 * (std::sqrt(to) - low);
        double sum = 0.0;
        for (std::size_t k = 0; k < place.size(); ++k) {
            for (const double side : {-1.0, 1.0}) {
                const double root = low + half * (1.0 + side * place[k]);
                sum += weight[k] * 2.0 * root * deceleration(root * root);
            }
        }
        return half * sum;
    };
    return streamlines(speed) ? over(0.0, reference_) + over(reference_, speed) : over(0.0, speed);
}

double StemDrag::speed_at(double acceleration) const {
    if (constant_ && exponent_ == 0.0) return std::sqrt(acceleration / (per_coefficient_ * *constant_));
    // The deceleration rises with the speed: bisection of its logarithm.
    double low = std::log(least_speed);
    double high = std::log(1e4);
    constexpr int halvings = 100;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (deceleration(std::exp(middle)) < acceleration ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

}  // namespace riffle::inline roughness
