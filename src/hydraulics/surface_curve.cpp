#include "hydraulics/surface_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "statistics/root.hpp"

namespace riffle::inline hydraulics {

SurfaceCurve::SurfaceCurve(SteadyChannel channel, double place, double control, int direction, double reach,
                           double critical_depth, std::optional<double> normal_depth)
    : channel_(std::move(channel)), place_(place), direction_(direction) {
    constexpr double same = 1e-9;  // of the depth
    depth_.push_back(control);
    distance_.push_back(0.0);
    check_depth(control);
    if (normal_depth && std::abs(control - *normal_depth) <= same * *normal_depth) {
        uniform_ = true;
        length_ = reach;
        far_depth_ = *normal_depth;
        return;
    }
    // Downstream of the control the flow is supercritical, upstream of it subcritical; each comes to rest at
    // the normal depth of its own kind, else ends where it is critical.
    const bool supercritical = direction > 0;
    const bool critical_slope = normal_depth && *normal_depth == critical_depth;
    const bool approaches =
        normal_depth && !critical_slope && (*normal_depth < critical_depth) == supercritical;
    const bool rises_for_ever = !normal_depth && !supercritical;
    far_depth_ = approaches       ? *normal_depth
                 : rises_for_ever ? std::numeric_limits<double>::infinity()
                                  : critical_depth;
    // The integrand has its poles at the normal depth and, of the friction, at zero: nodes in a geometric row
    // towards the one and away from the other.
    constexpr double ratio = 0.85;
    constexpr double panels_to_critical = 40.0;
    const double panel = (critical_depth - control) / panels_to_critical;
    while (distance_.back() < reach) {
        const double from = depth_.back();
        if (approaches && std::abs(from - far_depth_) <= same * far_depth_) {
            length_ = reach;  // uniform from here on
            return;
        }
        double to = 0.0;
        if (normal_depth && !critical_slope) {
            to = *normal_depth + ratio * (from - *normal_depth);
        } else if (rises_for_ever) {
            to = from / ratio;
        } else {
            to = from + panel;
        }
        to = std::clamp(to, ratio * from, from / ratio);
        const bool last =
            std::isfinite(far_depth_) && !approaches &&
            (to - far_depth_) * (control - far_depth_) <= same * far_depth_ * std::abs(control - far_depth_);
        if (last) to = far_depth_;
        check_depth(to);
        depth_.push_back(to);
        distance_.push_back(distance_.back() + distance_between(from, to));
        if (!std::isfinite(distance_.back())) {
            throw InputError(fmt::format(
                "the surface cannot be followed beyond a depth of {:.4g} m: discharge, friction or length are beyond "
                "all measure",
                from));
        }
        if (last) {
            ends_critical_ = distance_.back() <= reach;
            break;
        }
    }
    length_ = std::min(distance_.back(), reach);
}

void SurfaceCurve::check_depth(double depth) const {
    if (depth < channel_.least_depth * (1.0 - 1e-9)) {
        throw InputError(fmt::format(
            "the water would be {:.4g} m deep over the datum, and the friction of the bed is known from {:.4g} m on: "
            "give another depth at the ends, a larger discharge, or another friction",
            depth, channel_.least_depth));
    }
}

double SurfaceCurve::distance_between(double from, double to) const {
    const auto slowness = [this](double h) {
        return std::abs(channel_.momentum_gradient(h) /
                        (channel_.gravity * channel_.area(h) * channel_.surplus_slope(h)));
    };
    constexpr unsigned points = 15;
    return boost::math::quadrature::gauss<double, points>::integrate(slowness, std::min(from, to),
                                                                     std::max(from, to));
}

bool SurfaceCurve::covers(double x) const {
    const double distance = static_cast<double>(direction_) * (x - place_);
    constexpr double hair = 1e-12;
    return distance >= -hair * length_ && distance <= length_ * (1.0 + hair);
}

double SurfaceCurve::depth_at(double x) const {
    const double distance = std::clamp(static_cast<double>(direction_) * (x - place_), 0.0, length_);
    const auto above = std::upper_bound(distance_.begin(), distance_.end(), distance);
    if (uniform_ || above == distance_.begin()) return depth_.front();
    if (above == distance_.end()) {
        return std::isfinite(far_depth_) && distance > distance_.back() ? far_depth_ : depth_.back();
    }
    const auto k = static_cast<std::size_t>(above - distance_.begin());
    return root_between(
        [&](double h) { return distance_[k - 1] + distance_between(depth_[k - 1], h) - distance; },
        depth_[k - 1], depth_[k]);
}

double SurfaceCurve::distance_within(double share) const {
    if (uniform_ || !std::isfinite(far_depth_)) return uniform_ ? 0.0 : length_;
    const auto near = [&](double h) { return std::abs(h - far_depth_) <= share * far_depth_; };
    if (near(depth_.front())) return 0.0;
    const double sign = depth_.front() > far_depth_ ? 1.0 : -1.0;
    const double wanted = far_depth_ * (1.0 + sign * share);
    for (std::size_t k = 1; k < depth_.size(); ++k) {
        if (near(depth_[k])) return distance_[k - 1] + distance_between(depth_[k - 1], wanted);
    }
    return length_;
}

}  // namespace riffle::inline hydraulics
