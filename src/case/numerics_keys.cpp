#include "case/numerics_keys.hpp"

#include <utility>

#include "case/closure_traits.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

SectionKeys numerics_keys() {
    using enum Dimension;
    SectionKeys s{"numerics", "The numerical scheme. `preset` sets the defaults of the other keys.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("numerics", name, &Case::numerics, member, meaning);
    };
    s.keys.push_back(
        key("preset", &Numerics::preset, "Scheme that the other keys of this section start from."));
    s.keys.push_back(
        key("spacing", &Numerics::spacing, "Particle spacing dx.")
            .measured_in(length)
            .greater_than(0)
            .with_default_note(
                "over spheres the smallest of 0.06 diameters, 1/5 of the roughness height "
                "and 1/30 of the depth; twice that in three dimensions; over beds by roughness and smooth "
                "ones 1/20 of the depth"));
    s.keys.push_back(key("kernel", &Numerics::kernel, "Smoothing kernel."));
    s.keys.push_back(
        key("smoothing_ratio", &Numerics::smoothing_ratio,
            "Smoothing length over spacing, h / dx; the kernel reaches 2 h.")
            .at_least(1)
            .at_most(4)
            .with_default_note(
                "2 in two dimensions over spheres, beds by roughness and smooth ones, and with patches of the bed or vegetation; with porous "
                "zones 2.5 in two dimensions and 2 in three; 1.83 and 1.65 in basins beside inclined faces or at rest (see "
                "`pressure_correction_time`)")
            .because("fewer neighbours do not sum up, more are not worth their time"));
    s.keys.push_back(
        key("sound_speed", &Numerics::sound_speed, "Artificial speed of sound c0.")
            .measured_in(velocity)
            .greater_than(0)
            .unset_by("auto",
                      "max(20 U_max, 10 sqrt(g H)); U_max of water that starts with an outline: that of its "
                      "fall over half of its height, of isotropic turbulence four times its rms"));
    s.keys.push_back(key("equation_of_state", &Numerics::equation_of_state, "Pressure from density."));
    s.keys.push_back(key("pressure_form", &Numerics::pressure_form, "Form of the pressure force."));
    s.keys.push_back(
        key("reference_pressure", &Numerics::reference_pressure,
            "Part of the pressure that acts as a function of the height instead of through the pairs.")
            .applies_with("numerics.pressure_form", {"corrected"}));
    s.keys.push_back(
        key("reference_depth_ratio", &Numerics::reference_depth_ratio,
            "Depth below the still surface, over the spacing, whose weight the pairs still carry.")
            .at_least(2)
            .at_most(1000)
            .because("nearer to the surface its onset stiffens waves, and the surface must stay above it")
            .applies_with("numerics.reference_pressure", {"hydrostatic"}));
    s.keys.push_back(key("velocity_gradient", &Numerics::velocity_gradient,
                         "Velocity gradient that the closure is given."));
    s.keys.push_back(key("kernel_correction", &Numerics::kernel_correction,
                         "What corrects the corrected forms of pressure and velocity gradient."));
    s.keys.push_back(
        key("pressure_correction_time", &Numerics::pressure_correction_time,
            "Time over which the correction of the pressure form is averaged for each particle; "
            "0: the correction of each moment, which keeps disordered water in motion.")
            .measured_in(time)
            .at_least(0)
            .with_default_note(
                "0; in basins without slope beside inclined faces, where nothing turns, "
                "goes one way or is free, and in plane ones where nothing moves the water, 100 s or three times the run")
            .applies_with("numerics.pressure_form", {"corrected"}));
    s.keys.push_back(key("density_diffusion", &Numerics::density_diffusion,
                         "Diffusion in the continuity equation, against noise in the pressure."));
    s.keys.push_back(key("density_diffusion_coefficient", &Numerics::density_diffusion_coefficient,
                         "Its coefficient delta.")
                         .at_least(1e-4)
                         .at_most(1)
                         .because("0.1 is usual")
                         .applies_with("numerics.density_diffusion", {"fourtakas", "molteni", "antuono"}));
    s.keys.push_back(
        key("density_relaxation", &Numerics::density_relaxation,
            "Rate, over the strain rate, at which the density that a particle carries goes to what the "
            "kernel's sum over the particles makes of it, so that water that is sheared long stays even; "
            "in three dimensions not near a free surface. 0: it does not.")
            .at_least(0)
            .at_most(1)
            .because("it is for departures that grow over many turns"));
    s.keys.push_back(key("density_filter", &Numerics::density_filter, "Renormalisation of the density."));
    s.keys.push_back(key("density_filter_interval", &Numerics::density_filter_interval,
                         "Steps from one density filter to the next.")
                         .at_least(1)
                         .at_most(1000000)
                         .because("30 is usual; a run has some 1e5 steps")
                         .applies_with("numerics.density_filter", {"shepard", "mls"}));
    s.keys.push_back(key("viscosity", &Numerics::viscosity, "Form of the pair viscosity."));
    s.keys.push_back(key("eddy_stress", &Numerics::eddy_stress, "How the stress of the closure acts.")
                         .applies_with("turbulence.closure", closures_where([](const ClosureTraits& t) {
                                           return t.family != ClosureFamily::none;
                                       })));
    s.keys.push_back(
        key("drag_sampling", &Numerics::drag_sampling, "Where a particle takes the drag of the bed.")
            .applies_with("bed.kind", {"spheres"}));
    s.keys.push_back(
        key("artificial_viscosity", &Numerics::artificial_viscosity, "alpha of the artificial viscosity.")
            .at_least(1e-4)
            .at_most(2)
            .because("used: 0.01 to 0.5")
            .applies_with("numerics.viscosity", {"artificial"}));
    s.keys.push_back(key("tensile_correction", &Numerics::tensile_correction,
                         "Monaghan's repulsion against clumping, its coefficient; 0: none.")
                         .at_least(0)
                         .at_most(1)
                         .because("0.2 is usual")
                         .applies_with("numerics.kernel", {"cubic-spline"}));
    s.keys.push_back(
        key("impact_dissipation", &Numerics::impact_dissipation,
            "Dissipation between particles that approach each other, that of a Riemann problem, with "
            "this factor of its limiter; 0: none. 3 in impacts; the Riemann forms have it. Above 0, "
            "particles that an impact has driven to one place are parted too.")
            .at_least(0)
            .at_most(20));
    s.keys.push_back(
        key("acoustic_damping", &Numerics::acoustic_damping,
            "Bulk viscosity over h c0, which damps sound and leaves flow without divergence alone; 0: "
            "none. 0.2 in impacts.")
            .at_least(0)
            .at_most(2));
    s.keys.push_back(key("xsph", &Numerics::xsph, "Smoothing of the particles' transport velocity; 0: none.")
                         .at_least(0)
                         .at_most(1)
                         .because("1 is the mean over the neighbours"));
    s.keys.push_back(key("stepping", &Numerics::stepping, "Time stepping."));
    s.keys.push_back(key("step_rule", &Numerics::step_rule, "What the time step follows from.")
                         .applies_with("numerics.time_step", {"auto"}));
    s.keys.push_back(key("courant_number", &Numerics::courant_number, "Courant number, dt c0 / h.")
                         .at_least(1e-3)
                         .at_most(2)
                         .because("above 2 no scheme is stable"));
    s.keys.push_back(key("time_step", &Numerics::time_step, "Fixed time step.")
                         .measured_in(time)
                         .greater_than(0)
                         .unset_by("auto", "from the Courant number, the viscosity and the forces"));
    s.keys.push_back(key("wall", &Numerics::wall, "Kind of the wall particles."));
    s.keys.push_back(key("wall_layers", &Numerics::wall_layers, "Layers of wall particles.")
                         .at_least(1)
                         .at_most(10)
                         .because("no kernel reaches farther")
                         .with_default_note("as deep as the kernel reaches")
                         .applies_with("numerics.wall", {"dummy", "dynamic", "modified-dynamic"}));
    s.keys.push_back(key("precision", &Numerics::precision, "Precision of the pair arithmetic."));
    s.keys.push_back(
        key("skin", &Numerics::skin, "Reach of the neighbour lists beyond the kernel, in units of h.")
            .at_least(0.01)
            .at_most(1)
            .because("thinner, the lists are built anew at every step")
            .unset_by("auto", "0.3; in three dimensions 0.1"));
    return s;
}

SectionKeys stirring_keys() {
    using enum Dimension;
    SectionKeys s{
        "stirring",
        "A body force of travelling vortex modes of zero mean, which disorders the particles: a test of the "
        "scheme, no part of the flow.",
        {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("stirring", name, &Case::stirring, member, meaning);
    };
    s.keys.push_back(key("acceleration", &Stirring::acceleration, "Amplitude F of the force; 0: none.")
                         .measured_in(acceleration)
                         .at_least(0));
    s.keys.push_back(key("modes", &Stirring::modes, "Number of modes.")
                         .at_least(1)
                         .at_most(100)
                         .because("waves of less than a hundredth of the channel are not resolved"));
    s.keys.push_back(key("celerity", &Stirring::celerity, "Speed at which the modes travel downstream.")
                         .measured_in(velocity)
                         .unset_by("auto",
                                   "the mean velocity of the column twin over the whole depth, from the bed "
                                   "level; 0 without a twin"));
    return s;
}

}  // namespace riffle::inline case_file
