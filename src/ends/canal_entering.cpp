#include "ends/canal_entering.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "base/interpolation.hpp"
#include "case/cross_section.hpp"
#include "column/canal_channel.hpp"
#include "ends/end_lattice.hpp"
#include "hydraulics/lateral_profile.hpp"

namespace riffle::inline ends {

namespace {

constexpr int strips_across = 120;

/// ln(1 + z/z0) over its mean from the bed to a depth.
double logarithmic(double height, double depth, double zero_height) {
    const double r = depth / zero_height;
    const double mean = ((1.0 + r) * std::log1p(r) - r) / r;
    return std::log1p(std::max(0.0, height) / zero_height) / mean;
}

/// The law of the log law over the roughness of a place, in water with a friction velocity: a smooth bed has
/// a height of 0.11 nu/u_* of its own.
CanalFlowProfile::Law log_law_over(double viscosity, double friction_velocity) {
    const double smooth = friction_velocity > 0.0 ? 0.11 * viscosity / friction_velocity : 0.0;
    static constexpr double least = 1e-9;
    return [smooth](double height, double depth, double roughness) {
        return depth > 0.0 ? logarithmic(height, depth, std::max(least, roughness / 30.0 + smooth)) : 0.0;
    };
}

}  // namespace

CanalFlowProfile::CanalFlowProfile(double width, double depth, double least_height, std::vector<double> bed,
                                   std::vector<double> velocity, std::vector<double> roughness, Law law)
    : width_(width),
      depth_(depth),
      least_height_(least_height),
      bed_(std::move(bed)),
      velocity_(std::move(velocity)),
      roughness_(std::move(roughness)),
      law_(std::move(law)) {
    double area = 0.0;
    double discharge = 0.0;
    for (std::size_t i = 0; i < bed_.size(); ++i) {
        const double water = std::max(0.0, depth_ - bed_[i]);
        area += water;
        discharge += water * velocity_[i];
    }
    largest_ = 0.0;
    for (std::size_t i = 0; i < bed_.size(); ++i) {
        velocity_[i] *= discharge > 0.0 ? area / discharge : 1.0;
        const double water = depth_ - bed_[i];
        if (water > 0.0) largest_ = std::max(largest_, velocity_[i] * law_(water, water, roughness_[i]));
    }
}

double CanalFlowProfile::mean_at(double y, double place) const {
    const auto count = static_cast<double>(bed_.size());
    const TablePlace strip = place_among(y / width_ * count - 0.5, bed_.size());
    const double bed = strip.in(bed_);
    const double water = std::max(depth_ - bed, least_height_);
    return strip.in(velocity_)*law_(std::max(place * depth_ - bed, least_height_), water,
                                    strip.in(roughness_));
}

namespace {

/// The bed across the channel at the inflow and the depth-mean velocities over it, as far as their ratio
/// goes.
struct AcrossInflow {
    std::vector<double> bed;        ///< over where depths count from, m
    std::vector<double> velocity;   ///< m/s
    std::vector<double> roughness;  ///< k_s, m
    double friction_velocity = 0.0;
};

/// Over measured heights nothing tells the friction of uniform flow; the ratio of the velocities is that of a
/// slope of one in a thousand over the roughness of the law that enters.
AcrossInflow over_heights(const Case& c, double depth) {
    const Lattice lattice = lattice_of(c);
    const EndLattice places(c, lattice, place_of_end(c, true));
    AcrossInflow across;
    std::vector<LateralStrip> strips;
    for (int file = 0; file < lattice.files; ++file) {
        across.bed.push_back(places.floor_of(file));
        strips.push_back({std::max(0.0, depth - across.bed.back()), 1.0, c.inflow.equivalent_roughness});
        across.roughness.push_back(c.inflow.equivalent_roughness);
    }
    constexpr double slope = 1e-3;
    across.velocity =
        lateral_profile(strips, lattice.dy, c.fluid.gravity * slope, c.fluid.kinematic_viscosity);
    return across;
}

AcrossInflow over_section(const Case& c, double unit_discharge, double depth) {
    SectionStrips strips = section_strips(c, *section_of(c), depth, strips_across);
    AcrossInflow across{std::move(strips.bed), std::vector<double>(strips_across, 1.0), {}, 0.0};
    for (const LateralStrip& strip : strips.strips) across.roughness.push_back(strip.equivalent_roughness);
    if (canal_of(c) == nullptr || !(unit_discharge > 0.0)) return across;
    const SteadyChannel channel = canal_channel(c, unit_discharge);
    const double slope = channel.state(std::max(depth, channel.least_depth)).friction_slope;
    across.velocity = canal_velocities(c, strips, slope);
    across.friction_velocity = std::sqrt(c.fluid.gravity * slope * channel.section->hydraulic_radius(depth));
    return across;
}

}  // namespace

std::shared_ptr<const EnteringFlow> canal_entering(const Case& c, double unit_discharge, double depth) {
    const double width = c.channel.simulated_width();
    const Inflow& inflow = c.inflow;
    if (inflow.profile == InflowProfile::uniform) return std::make_shared<const ProfileFlow>(VelocityShape{});
    AcrossInflow across =
        section_of(c) != nullptr ? over_section(c, unit_discharge, depth) : over_heights(c, depth);
    CanalFlowProfile::Law law;
    switch (inflow.profile) {
        case InflowProfile::power_law:
            law = [m = inflow.exponent](double height, double of, double) {
                return of > 0.0 ? (1.0 + 1.0 / m) * std::pow(std::max(0.0, height / of), 1.0 / m) : 0.0;
            };
            break;
        case InflowProfile::log_law:
            across.roughness.assign(across.bed.size(), inflow.equivalent_roughness);
            law = log_law_over(0.0, 0.0);
            break;
        case InflowProfile::twin:
        case InflowProfile::column:
        case InflowProfile::file:
        case InflowProfile::results:
        case InflowProfile::uniform:
            law = log_law_over(c.fluid.kinematic_viscosity, across.friction_velocity);
            break;
    }
    constexpr double least = 0.25;  // of a row
    return std::make_shared<const CanalFlowProfile>(width, depth, least * c.numerics.spacing,
                                                    std::move(across.bed), std::move(across.velocity),
                                                    std::move(across.roughness), std::move(law));
}

}  // namespace riffle::inline ends
