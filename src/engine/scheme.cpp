#include "engine/scheme.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "boundary/wall_motion.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "ends/end_extremes.hpp"
#include "ends/end_input.hpp"
#include "engine/energy_spectrum.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline engine {

namespace {

/// Half the speed at which free bodies that start in the air reach the bed, m/s: the sound is then five times
/// as fast, as of water that falls.
double largest_free_speed(const Case& c) {
    double fall = 0.0;
    for (const Solid& solid : c.solids) {
        const auto z = solid.is_free() ? extent_of(c, solid, 2) : std::nullopt;
        if (z && z->low > c.total_depth()) fall = std::max(fall, z->low);
    }
    return std::sqrt(0.5 * c.fluid.gravity * fall);
}

double expected_velocity(const Case& c, const ColumnResult* column, const EndExtremes& ends) {
    if (c.start.kind == StartKind::standing_wave) {
        return c.start.amplitude * std::sqrt(c.fluid.gravity / c.total_depth());
    }
    if (c.start.kind == StartKind::isotropic) {
        // Of a hundred thousand particles the fastest has four times the root mean square.
        return 4.0 * EnergySpectrum(c.start.file).velocity_rms(std::numbers::pi / c.numerics.spacing);
    }
    double velocity =
        std::max({c.start.velocity.value_or(0.0), largest_wall_speed(c), largest_free_speed(c)});
    if (!c.start.water_z.empty()) {
        // Half the speed of Ritter's front, 2 sqrt(g h): the sound is ten times as fast as that. Water that
        // stands above the bed falls on it.
        const double high = *std::max_element(c.start.water_z.begin(), c.start.water_z.end());
        velocity = std::max(velocity, std::sqrt(c.fluid.gravity * high));
    }
    velocity = std::max(velocity, ends.velocity);
    if (column != nullptr) {
        for (const double u : column->profile.velocity) velocity = std::max(velocity, std::abs(u));
    }
    return velocity;
}

/// What the case gives at open ends; of others its own depth alone.
EndExtremes extremes_of(const Case& c) {
    return c.channel.ends == Ends::open ? end_extremes(c, read_end_input(c))
                                        : EndExtremes{.depth = c.total_depth(), .velocity = 0.0};
}

/// Ten times the speed of long waves, and twenty times that of the water. Below a wall at the top there are
/// no waves, but bodies fall as fast, and water that nothing moves needs some speed of sound as well. Throws
/// InputError where nothing tells one.
double usual_sound_speed(const Case& c, const Scheme& scheme, double depth) {
    const double of_flow = 20.0 * scheme.maximum_velocity;
    const bool bodies = std::any_of(c.solids.begin(), c.solids.end(), std::mem_fn(&Solid::is_free));
    const double gravity = bodies || of_flow <= 0.0 ? c.normal_gravity() : scheme.normal_gravity;
    const double speed = std::max(of_flow, 10.0 * std::sqrt(gravity * depth));
    if (speed <= 0.0) {
        throw InputError(
            "nothing in the case moves its water or presses on it, so that no speed of sound follows: give "
            "numerics.sound_speed, ten times the largest velocity that is expected or more");
    }
    return speed;
}

}  // namespace

double Scheme::hydrostatic_deviation(double z) const { return state.deviation(normal_gravity * (depth - z)); }

Scheme make_scheme(const Case& c, const ColumnResult* column) {
    const Lattice lattice = lattice_of(c);
    Scheme scheme;
    scheme.spacing = lattice.dx;
    scheme.smoothing_length = c.numerics.smoothing_ratio * c.numerics.spacing;
    scheme.depth = c.total_depth();
    scheme.density = c.fluid.density;
    scheme.viscosity = c.fluid.kinematic_viscosity;
    const bool fully_periodic = c.channel.top == Top::periodic;
    scheme.streamwise_gravity = fully_periodic ? 0.0 : c.streamwise_gravity();
    // Between two plates and in a periodic box gravity normal to the bed only adds a hydrostatic pressure.
    scheme.normal_gravity = c.channel.top == Top::free_surface ? c.normal_gravity() : 0.0;
    const EndExtremes ends = extremes_of(c);
    scheme.maximum_velocity = expected_velocity(c, column, ends);
    scheme.state.kind = c.numerics.equation_of_state;
    scheme.state.sound_speed = c.numerics.sound_speed.value_or(usual_sound_speed(c, scheme, ends.depth));
    scheme.acoustic_step = c.numerics.courant_number * scheme.smoothing_length / scheme.state.sound_speed;
    // Explicit diffusion of momentum: of a laminar case or, over hundreds of rows, of a mixing length, with
    // twice the twin's eddy viscosity, for the water shears itself more here and there than its mean flow.
    const double h = scheme.smoothing_length;
    double stiffness = scheme.viscosity;
    if (column != nullptr && !column->profile.eddy_viscosity.empty()) {
        const auto& eddy = column->profile.eddy_viscosity;
        stiffness += 2.0 * *std::max_element(eddy.begin(), eddy.end());
    }
    if (c.numerics.viscosity == ViscosityForm::monaghan_gingold) {
        stiffness *= c.channel.dimensions + 2.0;  // its force along a line of centres is as much stronger
    }
    scheme.acoustic_step = std::min(scheme.acoustic_step, 0.125 * h * h / stiffness);
    scheme.bulk_viscosity = c.numerics.acoustic_damping * h * scheme.state.sound_speed;
    if (scheme.bulk_viscosity > 0.0) {
        scheme.acoustic_step = std::min(scheme.acoustic_step, 0.25 * h * h / scheme.bulk_viscosity);
    }
    if (c.numerics.viscosity == ViscosityForm::artificial) {
        const double viscosity = c.numerics.artificial_viscosity * h * scheme.state.sound_speed /
                                 (2.0 * (c.channel.dimensions + 2.0));
        scheme.acoustic_step = std::min(scheme.acoustic_step, 0.125 * h * h / viscosity);
    }
    return scheme;
}

double largest_step(const Case& c, const Scheme& scheme) {
    return c.numerics.time_step.value_or(scheme.acoustic_step);
}

int midway_interval(const Case& c) {
    const bool falls = c.channel.ends == Ends::walls || bed_ends(c);
    const bool layered =
        !falls && c.solids.empty() && !resolves_eddies(c) && c.numerics.impact_dissipation == 0.0;
    return layered ? 2 : 1;
}

double force_limited_step(const Scheme& scheme, double largest_acceleration) {
    return largest_acceleration > 0.0 ? 0.25 * std::sqrt(scheme.smoothing_length / largest_acceleration)
                                      : std::numeric_limits<double>::infinity();
}

double monaghan_kos_step(const Scheme& scheme, double courant_number, double largest_acceleration,
                         double approach) {
    const double h = scheme.smoothing_length;
    const double acoustic = h / (scheme.state.sound_speed + approach);
    return courant_number *
           (largest_acceleration > 0.0 ? std::min(acoustic, std::sqrt(h / largest_acceleration)) : acoustic);
}

}  // namespace riffle::inline engine
