#include "ends/long_waves.hpp"

#include <algorithm>
#include <cmath>

#include "case/end_levels.hpp"

namespace riffle::inline ends {

double LongWaves::speed(double depth) const {
    if (!section_) return std::sqrt(gravity_ * std::max(0.0, depth));
    const double area = section_->area(depth - lowest_);
    return area > 0.0 ? std::sqrt(gravity_ * area / section_->top_width(depth - lowest_)) : 0.0;
}

double LongWaves::invariant(double depth) const {
    return section_ ? std::sqrt(gravity_) * section_->wave_integral(depth - lowest_) : 2.0 * speed(depth);
}

double LongWaves::depth_of_invariant(double invariant) const {
    if (section_) return lowest_ + section_->depth_of_wave_integral(invariant / std::sqrt(gravity_));
    const double c = std::max(0.0, 0.5 * invariant);
    return c * c / gravity_;
}

double LongWaves::invariant_by_depth(double depth) const {
    return section_ ? gravity_ / speed(depth) : std::sqrt(gravity_ / depth);
}

double LongWaves::critical_depth(double unit_discharge) const {
    return section_ ? lowest_ + hydraulics::critical_depth(*section_, gravity_, unit_discharge)
                    : critical_depth_of(gravity_, unit_discharge);
}

double LongWaves::sequent_depth(double depth, double velocity) const {
    const double water = depth - lowest_;
    if (section_) return lowest_ + hydraulics::sequent_depth(*section_, gravity_, water, velocity);
    const double c = speed(depth);
    const double froude = c > 0.0 ? velocity / c : 0.0;
    return 0.5 * depth * (std::sqrt(1.0 + 8.0 * froude * froude) - 1.0);
}

}  // namespace riffle::inline ends
