#include "hydraulics/steady_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"
#include "statistics/root.hpp"

namespace riffle::inline hydraulics {

namespace {

double square(double x) { return x * x; }

/// What stands for none in laws that divide by it, m2/s.
constexpr double least_viscosity = 1e-12;

/// Where a rising function of the depth is zero, sought from the critical depth of even flow; none where it
/// is positive down to `least`.
template <class Function>
std::optional<double> depth_of_zero(const SteadyChannel& channel, Function rising, double least) {
    double low = std::max(least, std::cbrt(square(channel.unit_discharge) / channel.normal_gravity()));
    double high = low;
    constexpr double most = 1e12;  // beyond all that is called a depth, m
    while (rising(low) > 0.0) {
        if (low <= least) return std::nullopt;
        high = low;
        low = std::max(0.5 * low, least);
    }
    while (!(rising(high) > 0.0)) {
        if (high > most) return std::nullopt;
        low = high;
        high *= 2.0;
    }
    return root_between(rising, low, high);
}

}  // namespace

double SteadyChannel::sine() const { return std::sin(std::atan(slope)); }

double SteadyChannel::cosine() const { return std::cos(std::atan(slope)); }

double SteadyChannel::area(double depth) const {
    const double total = total_depth(depth);
    return section ? section->area(total) : total;
}

double SteadyChannel::momentum_coefficient(double depth) const {
    return state(std::max(depth, least_depth)).momentum_coefficient;
}

double SteadyChannel::momentum(double depth) const {
    const double total = total_depth(depth);
    const double force = section ? normal_gravity() * section->pressure_integral(total)
                                 : 0.5 * normal_gravity() * square(total);
    return momentum_coefficient(depth) * square(unit_discharge) / area(depth) + force;
}

double SteadyChannel::momentum_gradient(double depth) const {
    // beta changes little: central differences of it are exact enough, and its share of the flux stays exact.
    constexpr double step = 1e-3;
    const double beta_gradient =
        (momentum_coefficient(depth * (1.0 + step)) - momentum_coefficient(depth * (1.0 - step))) /
        (2.0 * step * depth);
    const double all = area(depth);
    const double width = section ? section->top_width(total_depth(depth)) : 1.0;
    return square(unit_discharge) / all * (beta_gradient - momentum_coefficient(depth) * width / all) +
           normal_gravity() * all;
}

double SteadyChannel::froude_number(double depth) const {
    return std::sqrt(std::max(0.0, 1.0 - momentum_gradient(depth) / (normal_gravity() * area(depth))));
}

double SteadyChannel::energy_head(double depth) const {
    const double velocity = unit_discharge / area(depth);
    return depth * cosine() + state(depth).energy_coefficient * square(velocity) / (2.0 * gravity);
}

double SteadyChannel::surplus_slope(double depth) const { return sine() - state(depth).friction_slope; }

double SteadyChannel::manning(double depth) const {
    const SectionState now = state(depth);
    return manning_coefficient(now.friction_slope, section ? section->hydraulic_radius(depth) : depth,
                               now.mean_velocity);
}

double critical_depth(const SteadyChannel& channel) {
    // Water that stands among the spheres alone may be deep enough: then no depth over the datum is critical.
    const double least = 1e-9 * std::cbrt(square(channel.unit_discharge) / channel.normal_gravity());
    return depth_of_zero(
               channel, [&](double h) { return channel.momentum_gradient(h); }, least)
        .value_or(0.0);
}

std::optional<double> normal_depth(const SteadyChannel& channel) {
    if (channel.slope <= 0.0) return std::nullopt;
    const auto depth = depth_of_zero(
        channel, [&](double h) { return channel.surplus_slope(h); }, channel.least_depth);
    if (!depth) {
        throw InputError(fmt::format(
            "the normal depth of {:.4g} m2/s on a slope of {:.4g} is less than {:.3g} m, below which the friction of the "
            "bed is not known: give a larger discharge, or another friction",
            channel.unit_discharge, channel.slope, channel.least_depth));
    }
    return depth;
}

std::optional<double> sequent_depth(const SteadyChannel& channel, double depth, double critical_depth) {
    const double momentum = channel.momentum(depth);
    const auto surplus = [&](double h) { return channel.momentum(h) - momentum; };
    if (depth < critical_depth) {
        double high = 2.0 * critical_depth;
        while (surplus(high) < 0.0) high *= 2.0;
        return root_between(surplus, critical_depth, high);
    }
    double low = critical_depth;
    constexpr double least = 1e-9;
    while (surplus(low) <= 0.0) {
        if (low < least * depth) return std::nullopt;
        low *= 0.5;
    }
    return root_between(surplus, low, critical_depth);
}

SteadyChannel manning_channel(double slope, double gravity, double unit_discharge, double n,
                              const std::shared_ptr<const SectionShape>& section) {
    SteadyChannel channel{.slope = slope,
                          .gravity = gravity,
                          .unit_discharge = unit_discharge,
                          .state = {},
                          .section = section};
    channel.state = [=](double depth) {
        const double velocity = unit_discharge / (section ? section->area(depth) : depth);
        const double radius = section ? section->hydraulic_radius(depth) : depth;
        return SectionState{.friction_slope = square(n * velocity) / std::pow(radius, 4.0 / 3.0),
                            .mean_velocity = velocity};
    };
    return channel;
}

SteadyChannel rough_channel(double slope, double gravity, double unit_discharge,
                            double equivalent_roughness) {
    SteadyChannel channel{.slope = slope,
                          .gravity = gravity,
                          .unit_discharge = unit_discharge,
                          .least_depth = equivalent_roughness,
                          .state = {}};
    channel.state = [=](double depth) {
        const double velocity = unit_discharge / depth;
        const double friction_velocity =
            velocity / rough_log_law_depth_mean(depth, 1.0, equivalent_roughness);
        return SectionState{.friction_slope = square(friction_velocity) / (gravity * depth),
                            .mean_velocity = velocity};
    };
    return channel;
}

SteadyChannel colebrook_channel(double slope, double gravity, double unit_discharge,
                                double equivalent_roughness, double kinematic_viscosity,
                                const std::shared_ptr<const SectionShape>& section) {
    const auto surplus_radius = [&](double depth) {
        return section->hydraulic_radius(depth) - equivalent_roughness;
    };
    double deep = 2.0 * equivalent_roughness;
    while (surplus_radius(deep) < 0.0) deep *= 2.0;
    const double shallow = 1e-6 * deep;
    SteadyChannel channel{
        .slope = slope,
        .gravity = gravity,
        .unit_discharge = unit_discharge,
        .least_depth = equivalent_roughness > 0.0 ? root_between(surplus_radius, shallow, deep) : 0.0,
        .state = {},
        .section = section};
    channel.state = [=](double depth) {
        const double velocity = unit_discharge / section->area(depth);
        const double radius = section->hydraulic_radius(depth);
        const double reynolds =
            reynolds_number(velocity, 4.0 * radius, std::max(kinematic_viscosity, least_viscosity));
        const double f = colebrook_white_friction_factor(equivalent_roughness, radius, reynolds, full_pipe);
        return SectionState{.friction_slope = f * square(velocity) / (8.0 * gravity * radius),
                            .mean_velocity = velocity};
    };
    return channel;
}

double manning_unit_discharge(double slope, double depth, double n, const SectionShape* section) {
    const double carried = section != nullptr
                               ? section->area(depth) * std::pow(section->hydraulic_radius(depth), 2.0 / 3.0)
                               : std::pow(depth, 5.0 / 3.0);
    return carried * std::sqrt(std::sin(std::atan(slope))) / n;
}

double rough_unit_discharge(double slope, double gravity, double depth, double equivalent_roughness) {
    const double friction_velocity = std::sqrt(gravity * std::sin(std::atan(slope)) * depth);
    return depth * rough_log_law_depth_mean(depth, friction_velocity, equivalent_roughness);
}

}  // namespace riffle::inline hydraulics
