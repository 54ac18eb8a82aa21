#include "engine/pair_setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "case/velocity_gradient.hpp"
#include "particles/lattice.hpp"
#include "roughness/side_wall_partition.hpp"
#include "sph/correction.hpp"
#include "sph/kernel_registry.hpp"
#include "sph/pair_terms.hpp"
#include "turbulence/closure.hpp"
#include "turbulence/czernuszenko_rylov.hpp"

namespace riffle::inline engine {

namespace {

/// What the closure of a case makes of the velocity gradient.
StrainMeasure strain_measure(const Case& c) {
    switch (c.turbulence.closure) {
        case ClosureKind::wale:
            return StrainMeasure::wale;
        case ClosureKind::vreman:
            return StrainMeasure::vreman;
        case ClosureKind::none:
        case ClosureKind::ramp:
        case ClosureKind::nezu_rodi:
        case ClosureKind::nikuradse:
        case ClosureKind::sps:
        case ClosureKind::czernuszenko_rylov:
        case ClosureKind::smagorinsky:
            break;
    }
    switch (c.turbulence.eddy_rate) {
        case EddyRate::rotation:
            return StrainMeasure::rotation;
        case EddyRate::strain_and_rotation:
            return StrainMeasure::strain_and_rotation;
        case EddyRate::strain:
            break;
    }
    return StrainMeasure::strain_rate;
}

/// l_y/l_x of the closure of a case.
double spanwise_ratio(const Case& c) {
    const auto closure = make_closure(c);
    return closure && c.channel.dimensions == 3 ? closure->spanwise_ratio() : 1.0;
}

}  // namespace

bool has_directional_viscosity(const Case& c) {
    return spanwise_ratio(c) != 1.0 && c.numerics.eddy_stress == EddyStress::two_point &&
           c.numerics.viscosity == ViscosityForm::morris;
}

bool weighs_by_volume(const Case& c) { return c.numerics.pressure_form != PressureForm::symmetric; }

LoopOptions loop_options(const Case& c) {
    const Numerics& n = c.numerics;
    return {
        .kernel = n.kernel,
        .viscosity = n.viscosity,
        .gradients = needs_gradients(c),
        .directional = has_directional_viscosity(c),
        .pair_pressure = n.has_riemann_problem() || n.impact_dissipation > 0.0 || n.tensile_correction > 0.0};
}

double pair_viscosity(const Case& c, const Scheme& scheme) {
    return c.numerics.viscosity == ViscosityForm::artificial
               ? 0.5 * c.numerics.artificial_viscosity * scheme.smoothing_length * scheme.state.sound_speed
               : scheme.viscosity;
}

double pair_pressure(const Case& c, const Scheme& scheme, double deviation) {
    const double ratio = weighs_by_volume(c) ? 1.0 : 1.0 + deviation;
    return scheme.state.pressure(deviation) / (ratio * ratio);
}

namespace {

/// The terms of the pairs where they have no loops of their own.
template <int D, class Real>
PairForm<Real> pair_form(const Case& c, const Scheme& scheme, const DirectionalViscosity<Real>& directional) {
    const Numerics& n = c.numerics;
    PairForm<Real> form = viscosity_form<D, Real>(n.viscosity);
    form.by_direction = has_directional_viscosity(c);
    form.direction = directional;
    if (n.has_riemann_problem()) {
        form.non_conservative = Real(n.pressure_form == PressureForm::riemann_non_conservative ? 2 : 0);
        form.impact = Real(3);
        form.impact_bound = static_cast<Real>(scheme.state.sound_speed);
    } else {
        form.impact = static_cast<Real>(n.impact_dissipation);
        // With a factor of 3 it acts from an approach at c0/10 on, above the largest speed expected. By c0
        // a drop between others may be thrown back faster than it came: the dissipation is explicit, and
        // c0 dt is most of a smoothing length.
        form.impact_bound = static_cast<Real>(0.3 * scheme.state.sound_speed);
    }
    if (n.tensile_correction > 0.0) {
        form.tensile = static_cast<Real>(n.tensile_correction);
        form.tensile_scale = static_cast<Real>(visit_kernel<D>(
            n.kernel, [&](auto kernel) { return 1.0 / decltype(kernel)::value(1.0 / n.smoothing_ratio); }));
    }
    return form;
}

}  // namespace

template <int D>
double list_reach(const Case& c, const Scheme& scheme) {
    return (2.0 + c.numerics.skin_in(D)) * scheme.smoothing_length;
}

template <int D, class Real>
PairConstants<D, Real> pair_constants(const Case& c, const Scheme& scheme, const FixedPoint<D>& fixed_point) {
    const double h = scheme.smoothing_length;
    const double c0 = scheme.state.sound_speed;
    const DensityDiffusion diffusion = c.numerics.density_diffusion;
    // That of Antuono et al. is a sum of its own (pair_sum.hpp), as is Shepard's correction below.
    const bool in_loops = diffusion != DensityDiffusion::none && diffusion != DensityDiffusion::antuono;
    const bool by_gradient = c.numerics.kernel_correction == KernelCorrection::kernel_gradient;
    PairConstants<D, Real> constants{};
    for (std::size_t k = 0; k < D; ++k) constants.unit[k] = static_cast<Real>(fixed_point.unit(k) / h);
    constants.h = static_cast<Real>(h);
    constants.gradient_scale = static_cast<Real>(std::pow(h, -(D + 2)));
    constants.diffusion =
        static_cast<Real>(in_loops ? c.numerics.density_diffusion_coefficient * h * c0 : 0.0);
    // Molteni's diffusion acts on the hydrostatic difference too.
    constants.hydrostatic_gradient =
        static_cast<Real>(diffusion == DensityDiffusion::molteni ? 0.0 : scheme.normal_gravity / (c0 * c0));
    constants.correct_pressure = by_gradient && c.numerics.pressure_form == PressureForm::corrected;
    constants.correct_gradient = by_gradient && c.numerics.velocity_gradient == VelocityGradient::corrected;
    if (has_directional_viscosity(c)) {
        const auto weights = pair_direction_weights(static_cast<Real>(spanwise_ratio(c)));
        constants.directional = {.slope = weights.slope,
                                 .level = weights.level,
                                 .level_across = weights.level_across,
                                 .molecular = static_cast<Real>(2.0 * scheme.viscosity)};
    }
    constants.form = pair_form<D, Real>(c, scheme, constants.directional);
    constants.table = &kernel_table<D, Real>(c.numerics.kernel);
    return constants;
}

template <int D, class Real>
std::vector<std::unique_ptr<PairSum<D, Real>>> make_pair_sums(const Case& c, const Scheme& scheme,
                                                              const FixedPoint<D>& fixed_point) {
    const Numerics& n = c.numerics;
    const double h = scheme.smoothing_length;
    const PairSumConstants<D> constants(fixed_point, n.kernel, h);
    std::vector<std::unique_ptr<PairSum<D, Real>>> sums;
    if (n.density_diffusion == DensityDiffusion::antuono) {
        sums.push_back(make_antuono_diffusion<D, Real>(
            constants, n.density_diffusion_coefficient * h * scheme.state.sound_speed));
    }
    if (n.kernel_correction == KernelCorrection::kernel && needs_gradients(c)) {
        sums.push_back(make_shepard_correction<D, Real>(constants, n.pressure_form == PressureForm::corrected,
                                                        n.velocity_gradient == VelocityGradient::corrected));
    }
    return sums;
}

HydrostaticReference hydrostatic_reference(const Case& c, const Scheme& scheme) {
    HydrostaticReference reference;
    if (c.numerics.reference_pressure == ReferencePressure::hydrostatic) {
        const std::vector<double>& corners = c.start.water_z;
        const double surface =
            corners.empty() ? scheme.depth : *std::max_element(corners.begin(), corners.end());
        reference.level = surface - (c.numerics.reference_depth_ratio - 1.0) * scheme.spacing;
        reference.fade = 2.0 * scheme.spacing;
        reference.gravity = scheme.normal_gravity;
    }
    return reference;
}

template <int D>
ParticleData<D> particle_constants(const Case& c, const Scheme& scheme, const Domain<D>& domain) {
    ParticleData<D> data;
    data.domain = domain;
    data.fixed_point = FixedPoint<D>(domain);
    for (std::size_t k = 0; k < D; ++k) {
        // Taken out while it still has an integer position: no step moves a particle by a smoothing length.
        const double edge = domain.periodic[k] ? 0.0 : scheme.smoothing_length;
        data.stay_from[k] = data.fixed_point.lowest(k) + edge;
        data.stay_to[k] = data.fixed_point.highest(k) - edge;
    }
    data.state = scheme.state;
    data.density = scheme.density;
    data.viscosity = pair_viscosity(c, scheme);
    data.bulk_viscosity = scheme.bulk_viscosity;
    data.sound_rate = scheme.state.sound_speed / scheme.smoothing_length;
    data.gravity[0] = scheme.streamwise_gravity;
    data.gravity[D - 1] = -scheme.normal_gravity;
    data.reference_pressure = hydrostatic_reference(c, scheme);
    data.corrected = weighs_by_volume(c);
    data.closure = c.turbulence.closure != ClosureKind::none;
    data.two_point = !data.closure || c.numerics.eddy_stress == EddyStress::two_point;
    data.strain_measure = strain_measure(c);
    data.shear_only = c.turbulence.stress_terms == StressTerms::shear;
    if constexpr (D == 3) {
        data.shear_weight_across = stress_weight(false, true, spanwise_ratio(c));
        data.normal_weight_across = stress_weight(true, true, spanwise_ratio(c));
        if (c.has_side_wall_drag()) {
            data.layer_below = c.side_layer();
            if (c.channel.ends == Ends::open) {
                data.layer_from = 0.0;
                data.layer_to = c.channel.length;
            }
            if (c.channel.sides == Sides::walls) data.layer_above = c.channel.width - c.side_layer();
        }
    }
    return data;
}

template double list_reach<2>(const Case&, const Scheme&);
template double list_reach<3>(const Case&, const Scheme&);
template PairConstants<2, float> pair_constants(const Case&, const Scheme&, const FixedPoint<2>&);
template PairConstants<2, double> pair_constants(const Case&, const Scheme&, const FixedPoint<2>&);
template PairConstants<3, float> pair_constants(const Case&, const Scheme&, const FixedPoint<3>&);
template PairConstants<3, double> pair_constants(const Case&, const Scheme&, const FixedPoint<3>&);
template std::vector<std::unique_ptr<PairSum<2, float>>> make_pair_sums(const Case&, const Scheme&,
                                                                        const FixedPoint<2>&);
template std::vector<std::unique_ptr<PairSum<2, double>>> make_pair_sums(const Case&, const Scheme&,
                                                                         const FixedPoint<2>&);
template std::vector<std::unique_ptr<PairSum<3, float>>> make_pair_sums(const Case&, const Scheme&,
                                                                        const FixedPoint<3>&);
template std::vector<std::unique_ptr<PairSum<3, double>>> make_pair_sums(const Case&, const Scheme&,
                                                                         const FixedPoint<3>&);
template ParticleData<2> particle_constants(const Case&, const Scheme&, const Domain<2>&);
template ParticleData<3> particle_constants(const Case&, const Scheme&, const Domain<3>&);

}  // namespace riffle::inline engine
