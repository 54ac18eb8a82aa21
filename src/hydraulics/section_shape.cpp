#include "hydraulics/section_shape.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/interpolation.hpp"
#include "statistics/root.hpp"

namespace riffle::inline hydraulics {

SectionShape::SectionShape(std::vector<double> depth, std::vector<double> width,
                           std::vector<double> perimeter)
    : depth_(std::move(depth)), width_(std::move(width)), perimeter_(std::move(perimeter)) {
    const std::size_t count = depth_.size();
    if (count < 2 || width_.size() != count || perimeter_.size() != count || depth_.front() != 0.0 ||
        !(width_[0] + width_[1] > 0.0) || !(width_.back() > 0.0)) {
        throw std::invalid_argument("a cross-section without water");
    }
    area_.assign(count, 0.0);
    pressure_.assign(count, 0.0);
    wave_.assign(count, 0.0);
    for (std::size_t i = 1; i < count; ++i) {
        const double rise = depth_[i] - depth_[i - 1];
        if (!(rise > 0.0)) throw std::invalid_argument("the depths of a cross-section do not rise");
        const double slope = slope_in(i - 1);
        area_[i] = area_[i - 1] + rise * (width_[i - 1] + 0.5 * slope * rise);
        pressure_[i] =
            pressure_[i - 1] + rise * (area_[i - 1] + rise * (0.5 * width_[i - 1] + slope * rise / 6.0));
    }
    for (std::size_t i = 1; i < count; ++i) {
        wave_[i] = wave_[i - 1] + wave_integral_between(depth_[i - 1], depth_[i]);
    }
}

SectionShape::Place SectionShape::place_of(double depth) const {
    const auto above = std::upper_bound(depth_.begin(), depth_.end(), depth);
    const auto interval = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, above - depth_.begin() - 1));
    return {interval, depth - depth_[interval]};
}

double SectionShape::slope_in(std::size_t interval) const {
    if (interval + 1 >= depth_.size()) return 0.0;
    return (width_[interval + 1] - width_[interval]) / (depth_[interval + 1] - depth_[interval]);
}

double SectionShape::top_width(double depth) const {
    const auto [i, over] = place_of(std::max(0.0, depth));
    return width_[i] + slope_in(i) * over;
}

double SectionShape::area(double depth) const {
    if (depth <= 0.0) return 0.0;
    const auto [i, over] = place_of(depth);
    return area_[i] + over * (width_[i] + 0.5 * slope_in(i) * over);
}

double SectionShape::pressure_integral(double depth) const {
    if (depth <= 0.0) return 0.0;
    const auto [i, over] = place_of(depth);
    return pressure_[i] + over * (area_[i] + over * (0.5 * width_[i] + slope_in(i) * over / 6.0));
}

double SectionShape::hydraulic_radius(double depth) const {
    return area(depth) / place_in(depth_, depth).in(perimeter_);
}

double SectionShape::depth_of_area(double area) const {
    if (area <= 0.0) return 0.0;
    const auto above = std::upper_bound(area_.begin(), area_.end(), area);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, above - area_.begin() - 1));
    const double over = area - area_[i];
    // The root of width over + slope over^2/2, in the form that holds without slope or width.
    const double discriminant = std::max(0.0, width_[i] * width_[i] + 2.0 * slope_in(i) * over);
    const double sum = width_[i] + std::sqrt(discriminant);
    return depth_[i] + (sum > 0.0 ? 2.0 * over / sum : 0.0);
}

double SectionShape::wave_integral_between(double from, double to) const {
    // By the root of the depth, in which the integrand is bounded where the water ends.
    const auto integrand = [this](double root) {
        const double depth = root * root;
        return 2.0 * root * std::sqrt(top_width(depth) / area(depth));
    };
    constexpr unsigned points = 15;
    return boost::math::quadrature::gauss<double, points>::integrate(integrand, std::sqrt(from),
                                                                     std::sqrt(to));
}

double SectionShape::wave_integral(double depth) const {
    if (depth <= 0.0) return 0.0;
    const auto [i, over] = place_of(depth);
    return wave_[i] + (over > 0.0 ? wave_integral_between(depth_[i], depth) : 0.0);
}

double SectionShape::depth_of_wave_integral(double integral) const {
    if (integral <= 0.0) return 0.0;
    const auto above = std::upper_bound(wave_.begin(), wave_.end(), integral);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, above - wave_.begin() - 1));
    const auto surplus = [&](double depth) { return wave_integral(depth) - integral; };
    double high = above == wave_.end() ? 2.0 * depth_.back() : depth_[i + 1];
    while (surplus(high) < 0.0) high *= 2.0;
    return root_between(surplus, depth_[i], high);
}

double critical_depth(const SectionShape& section, double gravity, double unit_discharge) {
    if (!(unit_discharge > 0.0)) return 0.0;
    // Above the largest of them all flow is subcritical: sought downwards from such a depth.
    const auto surplus = [&](double depth) {
        const double area = section.area(depth);
        return area * area * area * gravity - unit_discharge * unit_discharge * section.top_width(depth);
    };
    double high = std::cbrt(unit_discharge * unit_discharge / gravity);
    while (surplus(high) <= 0.0) high *= 2.0;
    constexpr double ratio = 0.98;
    double low = high;
    while (surplus(low) > 0.0) {
        high = low;
        low *= ratio;
    }
    return root_between(surplus, low, high);
}

double sequent_depth(const SectionShape& section, double gravity, double depth, double velocity) {
    const double area = section.area(depth);
    const double unit_discharge = velocity * area;
    const auto momentum = [&](double h) {
        return unit_discharge * unit_discharge / section.area(h) + gravity * section.pressure_integral(h);
    };
    const double before = momentum(depth);
    const double critical = critical_depth(section, gravity, std::abs(unit_discharge));
    if (depth >= critical) return depth;
    double high = 2.0 * critical;
    while (momentum(high) < before) high *= 2.0;
    return root_between([&](double h) { return momentum(h) - before; }, critical, high);
}

}  // namespace riffle::inline hydraulics
