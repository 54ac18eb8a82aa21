#include "case/presets.hpp"

namespace riffle {

namespace {

/// The default scheme with what impacts ask for: a density that follows the motion exactly, and dissipation
/// of what collides and of sound.
Numerics violent_numerics() {
    Numerics n;
    n.preset = Preset::violent;
    n.stepping = Stepping::leapfrog;
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

}  // namespace riffle
