#include "case/presets.hpp"

#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/bed_traits.hpp"

namespace riffle::inline case_file {

namespace {

/// The default scheme with what impacts ask for: dissipation of what collides and of sound.
Numerics violent_numerics() {
    Numerics n;
    n.preset = Preset::violent;
    n.impact_dissipation = 3.0;
    n.acoustic_damping = 0.2;
    return n;
}

/// The set-up of the thesis.
Numerics thesis_numerics(int dimensions) {
    Numerics n;
    n.preset = Preset::thesis;
    n.spacing = 0.0015;
    n.kernel = KernelKind::cubic_spline;
    n.smoothing_ratio = 1.5;
    n.sound_speed = dimensions == 3 ? 20.0 : 60.0;
    n.equation_of_state = EquationOfState::tait;
    n.pressure_form = PressureForm::symmetric;
    n.velocity_gradient = VelocityGradient::plain;
    n.density_diffusion = DensityDiffusion::none;
    n.density_filter = DensityFilter::mls;
    n.density_filter_interval = 30;
    n.eddy_stress = EddyStress::stress_divergence;
    n.drag_sampling = DragSampling::point;
    n.stepping = Stepping::predictor_corrector;
    n.courant_number = 0.15;
    n.wall = WallKind::dynamic;
    n.wall_layers = 2;
    return n;
}

/// The paper states spacing, equation of state and sound speed; the rest is taken from the thesis.
Numerics paper_numerics(int dimensions) {
    Numerics n = thesis_numerics(dimensions);
    n.preset = Preset::paper;
    n.spacing = 0.002;
    n.equation_of_state = EquationOfState::linear;
    n.sound_speed = 16.0;
    return n;
}

}  // namespace

Numerics preset_numerics(Preset preset, int dimensions) {
    switch (preset) {
        case Preset::riffle:
            return {};
        case Preset::violent:
            return violent_numerics();
        case Preset::thesis:
            return thesis_numerics(dimensions);
        case Preset::paper:
            return paper_numerics(dimensions);
    }
    return {};
}

void choose_for_resolved_eddies(Case& c) {
    c.turbulence.closure = ClosureKind::wale;
    c.turbulence.smagorinsky_constant = 0.1;
    c.numerics.reference_pressure = ReferencePressure::hydrostatic;
    c.numerics.reference_depth_ratio = 2.0;
    c.numerics.pressure_correction_time = 0.2;
    c.numerics.density_relaxation = 0.2;
}

namespace {

/// A length rounded down to a tenth of a millimetre, or two digits.
double rounded_down(double length) {
    const double digits = std::max(1e4, std::pow(10.0, 1.0 - std::floor(std::log10(length))));
    return std::floor(length * digits * (1.0 + 1e-9)) / digits;
}

}  // namespace

int layers_of_kernel(double smoothing_ratio) {
    return static_cast<int>(std::ceil(2.0 * smoothing_ratio - 1e-9));
}

void choose_resolution(Case& c, const GivenNumerics& given) {
    Numerics& n = c.numerics;
    if (n.preset != Preset::riffle && n.preset != Preset::violent) return;
    const bool space = c.channel.dimensions == 3;
    if (has_spheres(c.bed) && n.preset == Preset::riffle) {
        // Five rows below the crests and thirty over the depth at least; in space, where each halving costs
        // sixteen times as much, half as many.
        const double rows = space ? 0.5 : 1.0;
        const double finest =
            std::min({0.06 * c.bed.sphere_diameter, 0.2 * c.bed.roughness_height, c.total_depth() / 30.0}) /
            rows;
        if (!given.spacing && finest > 0.0) n.spacing = rounded_down(finest);
        if (!given.smoothing_ratio && !space) n.smoothing_ratio = 2.0;
    }
    // The friction of a plane bed holds at any spacing: the one that the flow over it needs.
    constexpr double rows_over_plane_bed = 20.0;
    if (has_wall_law(c) && !given.spacing && c.total_depth() > 0.0) {
        n.spacing = rounded_down(c.total_depth() / rows_over_plane_bed);
    }
    // Among stems and over patches as over rough beds: with fewer neighbours the rows leave their order.
    const bool rough = (!c.vegetation.empty() || !c.bed_patches.empty()) && n.preset == Preset::riffle;
    if ((has_wall_law(c) || rough) && !given.smoothing_ratio && !space) n.smoothing_ratio = 2.0;
    // The particles of water that flows into a medium stand farther apart there, along its way.
    if (!c.porous.empty() && !given.smoothing_ratio) n.smoothing_ratio = space ? 2.0 : 2.5;
    if (!given.wall_layers) n.wall_layers = layers_of_kernel(n.smoothing_ratio);
}

}  // namespace riffle::inline case_file
