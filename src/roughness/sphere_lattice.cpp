#include "roughness/sphere_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/sphere_tiling.hpp"

namespace riffle::inline roughness {

SphereLattice::SphereLattice(const Case& c)
    : hexagonal_(c.bed.packing == Packing::hexagonal),
      radius_(0.5 * c.bed.sphere_diameter),
      ramp_(c.sphere_ramp()),
      centre_z_(c.bed.roughness_height - radius_),
      origin_y_(c.channel.centreline()) {
    const LatticePeriods periods = lattice_periods(c.bed);
    const auto fitted = [](bool periodic, double length, double period) {
        return periodic ? length / whole_periods(length, period) : period;
    };
    period_x_ = fitted(c.channel.ends == Ends::periodic, c.channel.length, periods.x);
    period_y_ = fitted(c.channel.sides == Sides::periodic, c.channel.width, periods.y);
}

double SphereLattice::shape_factor(double x, double y, double z) const {
    const double reach = radius_ + 0.5 * ramp_;
    const double inner = std::max(0.0, radius_ - 0.5 * ramp_);
    const double dz = z - centre_z_;
    if (std::abs(dz) >= reach) return 0.0;
    // The rows around the point, and in each the two spheres around it.
    const double row_distance = hexagonal_ ? 0.5 * period_y_ : period_y_;
    const double row_y = (y - origin_y_) / row_distance;
    const auto below = static_cast<long long>(std::floor(row_y));
    double sum = 0.0;
    for (long long row = below - 1; row <= below + 2; ++row) {
        const double dy = (row_y - static_cast<double>(row)) * row_distance;
        const double flat = dy * dy + dz * dz;
        if (flat >= reach * reach) continue;
        const double shift = hexagonal_ && row % 2 != 0 ? 0.5 : 0.0;
        const double place = x / period_x_ - shift;
        const double left = std::floor(place);
        for (const double sphere : {left, left + 1.0}) {
            const double dx = (place - sphere) * period_x_;
            const double squared = flat + dx * dx;
            if (squared < reach * reach) {
                sum += squared <= inner * inner ? 1.0 : (reach - std::sqrt(squared)) / ramp_;
            }
        }
    }
    return sum;
}

std::vector<std::array<double, 3>> SphereLattice::centres(double length, double width) const {
    const double row_distance = hexagonal_ ? 0.5 * period_y_ : period_y_;
    const auto first = static_cast<long long>(std::ceil((-radius_ - origin_y_) / row_distance));
    const auto last = static_cast<long long>(std::floor((width + radius_ - origin_y_) / row_distance));
    std::vector<std::array<double, 3>> result;
    for (long long row = first; row <= last; ++row) {
        const double shift = hexagonal_ && row % 2 != 0 ? 0.5 : 0.0;
        const double y = origin_y_ + static_cast<double>(row) * row_distance;
        // A hair off the end, so that rounding sets no sphere on both sides of a periodic channel.
        for (double place = shift; place * period_x_ < length * (1.0 - 1e-9); place += 1.0) {
            result.push_back({place * period_x_, y, centre_z_});
        }
    }
    return result;
}

double SphereLattice::plan_mean(double z) const {
    // Over the plane at distance d from the centres, r dr = rho d rho: the integral of phi(r) 2 pi r dr from
    // d.
    const double inner = radius_ - 0.5 * ramp_;
    const double outer = radius_ + 0.5 * ramp_;
    const double d = std::abs(z - centre_z_);
    if (d >= outer) return 0.0;
    const auto ramp_integral = [&](double from) {
        const auto primitive = [&](double r) { return (0.5 * outer - r / 3.0) * r * r; };
        return (primitive(outer) - primitive(from)) / ramp_;
    };
    const double integral =
        d < inner ? 0.5 * (inner * inner - d * d) + ramp_integral(inner) : ramp_integral(d);
    return spheres_per_area() * 2.0 * std::numbers::pi * integral;
}

}  // namespace riffle::inline roughness
