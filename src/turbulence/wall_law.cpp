#include "turbulence/wall_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "case/bed_patch.hpp"
#include "case/bed_traits.hpp"
#include "turbulence/closure.hpp"

namespace riffle::inline turbulence {

namespace {

/// The value between `low` and `high` at which an increasing function is zero.
template <class F>
double root_of_increasing(double low, double high, const F& f) {
    constexpr int halvings = 44;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Gradient of the velocity over u_* under a stress (over that of the bed).
double gradient_under(double stress, double mixing_length, double viscous_length) {
    const double carried = viscous_length + std::sqrt(viscous_length * viscous_length +
                                                      4.0 * mixing_length * mixing_length * stress);
    return carried > 0.0 ? 2.0 * stress / carried : 0.0;
}

/// Velocity over u_* at a great height, in viscous lengths, of the law under a constant stress.
double velocity_far_above(const WallLaw& law, double far) {
    constexpr int steps = 400;
    const double first = std::log(1e-3);
    const double step = (std::log(far) - first) / steps;
    double sum = std::exp(first);
    for (int i = 0; i <= steps; ++i) {
        const double z = std::exp(first + i * step);
        const double weight = i == 0 || i == steps ? 0.5 : 1.0;
        sum += weight * step * z * gradient_under(1.0, law.mixing_length(z, law.kappa * z), 1.0);
    }
    return sum;
}

/// A+ of van Driest with which a smooth wall has its log law: 26.06 with kappa = 0.41.
double damping_constant(double kappa) {
    constexpr double far = 1e5;
    const double wanted = std::log1p(far * std::exp(smooth_wall_constant * kappa)) / kappa;
    return root_of_increasing(1.0, 200.0, [&](double damping) {
        const WallLaw law{kappa, 0.0, 0.0, damping, 1.0};
        return velocity_far_above(law, far) - wanted;
    });
}

/// Mixing lengths of the case's closure over a plane bed, without the wall's part.
std::function<double(double)> closure_lengths(const Case& c) {
    Case plane = c;
    plane.bed.kind = BedKind::no_slip;
    const std::shared_ptr<const Closure> closure = make_closure(plane);
    if (!closure) {
        throw InputError("a wall law needs the mixing length of a closure: give turbulence.closure");
    }
    return [closure](double z) { return closure->mixing_length(z); };
}

/// Slope of the closure's mixing length at the bed.
double slope_at_bed(const std::function<double(double)>& lengths, double depth) {
    const double near = 1e-6 * depth;
    return lengths(near) / near;
}

double mean_velocity(const std::function<double(double)>& lengths, const WallLaw& law, double depth) {
    const UniformProfile profile([&](double z) { return law.mixing_length(z, lengths(z)); }, law, depth);
    return profile.mean(depth);
}

double roughness_of_manning(const Case& c) {
    const double depth = c.total_depth();
    const double wanted = velocity_ratio_of_manning(*c.bed.manning, depth, c.fluid.gravity);
    const auto lengths = closure_lengths(c);
    const double kappa = slope_at_bed(lengths, depth);
    const double viscous =
        c.channel.slope > 0.0 ? c.fluid.kinematic_viscosity / reference_friction_velocity(c) : 0.0;
    const auto excess = [&](double log_roughness) {
        const double rough = zero_height_of_roughness(depth * std::exp(log_roughness), kappa);
        return wanted - mean_velocity(lengths, make_wall_law(kappa, rough, viscous), depth);
    };
    const double least = std::log(1e-8);
    const double most = 0.0;
    if (excess(least) > 0.0 || excess(most) < 0.0) {
        throw InputError(fmt::format(
            "[bed] manning = {:g}: no bed has it at a depth of {:.4g} m, it would be {}; give another n, or "
            "equivalent_roughness",
            *c.bed.manning, depth, excess(least) > 0.0 ? "smoother than a smooth one" : "rougher than deep"));
    }
    return depth * std::exp(root_of_increasing(least, most, excess));
}

}  // namespace

WallLaw make_wall_law(double kappa, double rough_zero_height, double viscous_length) {
    const double smooth = zero_height_of_smooth_wall(viscous_length, kappa);
    WallLaw law{kappa, rough_zero_height + smooth, rough_zero_height, 0.0, viscous_length};
    if (viscous_length <= 0.0) return law;
    WallLaw in_viscous_lengths{kappa, law.zero_height / viscous_length, 0.0, damping_constant(kappa), 1.0};
    law.damping = in_viscous_lengths.damping * viscous_length;
    if (rough_zero_height > 0.0) {
        // The more the origin is shifted, the slower the flow.
        const double zero = in_viscous_lengths.zero_height;
        const double far = 1e5 * std::max(1.0, zero);
        const double wanted = std::log1p(far / zero) / kappa;
        law.shift = viscous_length * root_of_increasing(0.0, 2.0 * zero + 20.0, [&](double shift) {
                        in_viscous_lengths.shift = shift;
                        return wanted - velocity_far_above(in_viscous_lengths, far);
                    });
    }
    return law;
}

double equivalent_roughness(const Case& c) {
    if (!has_roughness(c.bed)) return 0.0;
    return c.bed.equivalent_roughness ? *c.bed.equivalent_roughness : roughness_of_manning(c);
}

Case with_fixed_roughness(Case c) {
    if (has_roughness(c.bed)) {
        c.bed.equivalent_roughness = equivalent_roughness(c);
        c.bed.manning.reset();
    }
    for (BedPatch& patch : c.bed_patches) {
        if (has_roughness(patch)) {
            patch.equivalent_roughness = equivalent_roughness(with_bed_of(c, patch));
            patch.manning.reset();
        }
    }
    return c;
}

std::optional<WallLaw> bed_wall_law(const Case& c) { return bed_wall_law(c, reference_friction_velocity(c)); }

std::optional<WallLaw> bed_wall_law(const Case& c, double friction_velocity) {
    if (!has_wall_law(c)) return std::nullopt;
    const double kappa = slope_at_bed(closure_lengths(c), c.total_depth());
    return make_wall_law(kappa, zero_height_of_roughness(equivalent_roughness(c), kappa),
                         c.fluid.kinematic_viscosity / friction_velocity);
}

UniformProfile::UniformProfile(const std::function<double(double)>& mixing_length, const WallLaw& law,
                               double depth) {
    constexpr int steps = 2000;
    constexpr double below_surface = 1.0 - 1e-9;
    const double first = 1e-3 * std::max({law.shift, law.viscous_length, 1e-7 * depth});
    const double ratio = std::log(below_surface * depth / first) / steps;
    const auto gradient_at = [&](double z) {
        return gradient_under(1.0 - z / depth, mixing_length(z), law.viscous_length);
    };
    z_ = {0.0};
    velocity_ = {0.0};
    flow_ = {0.0};
    gradient_ = {gradient_at(0.0)};
    for (int i = 0; i <= steps; ++i) {
        const double z = first * std::exp(i * ratio);
        const double gradient = gradient_at(z);
        const double step = z - z_.back();
        const double velocity = velocity_.back() + 0.5 * step * (gradient + gradient_.back());
        flow_.push_back(flow_.back() + 0.5 * step * (velocity + velocity_.back()));
        z_.push_back(z);
        velocity_.push_back(velocity);
        gradient_.push_back(gradient);
    }
}

double UniformProfile::at(const std::vector<double>& values, double z) const {
    return place_in(z_, z).in(values);
}

}  // namespace riffle::inline turbulence
