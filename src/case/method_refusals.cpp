#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/refusals.hpp"
#include "case/velocity_gradient.hpp"

namespace riffle::inline case_file {

namespace {

/// Largest Courant number at which Verlet's method held the channel of condition 2 with density diffusion.
constexpr double verlet_courant_number = 0.2;

bool repels(const Case& c) { return c.numerics.wall == WallKind::repulsive; }

}  // namespace

CheckList method_refusals() {
    return {{
        {{"numerics.tensile_correction", "numerics.pressure_form"},
         "`tensile_correction` above 0 without `pressure_form = \"symmetric\"`",
         "the correction cures the clumping of the symmetric form",
         "set it to 0 or choose pressure_form = \"symmetric\"",
         [](const Case& c) {
             return c.numerics.tensile_correction > 0.0 &&
                    c.numerics.pressure_form != PressureForm::symmetric;
         }},
        {{"turbulence.closure", "channel.dimensions"},
         R"(`closure = "wale"`, `"vreman"` or `"smagorinsky"` in two dimensions)",
         "eddies hand their energy down to smaller ones in three dimensions only",
         "set [channel] dimensions = 3, or choose a mixing length",
         [](const Case& c) { return resolves_eddies(c) && !in_space(c); }},
        {{"turbulence.eddy_rate", "turbulence.stress_terms", "turbulence.closure"},
         R"(an `eddy_rate` other than `"strain"` with `stress_terms = "shear"`)",
         "of |du/dz| alone there is neither a strain rate nor a rotation",
         "choose stress_terms = \"full\"",
         [](const Case& c) {
             return has_closure(c) && c.turbulence.eddy_rate != EddyRate::strain &&
                    c.turbulence.stress_terms == StressTerms::shear;
         }},
        {{"numerics.tensile_correction", "numerics.kernel"},
         "`tensile_correction` above 0 without `kernel = \"cubic-spline\"`",
         "it is made for the cubic spline, whose gradient vanishes at the centre faster than particles approach",
         "set it to 0 or choose kernel = \"cubic-spline\"",
         [](const Case& c) {
             return c.numerics.tensile_correction > 0.0 && c.numerics.kernel != KernelKind::cubic_spline;
         }},
        {{"numerics.kernel_correction", "numerics.pressure_form", "numerics.velocity_gradient",
          "turbulence.closure"},
         "`kernel_correction = \"kernel\"` without a corrected form",
         "there is nothing to correct: neither the pressure form is \"corrected\" nor does a closure use a corrected velocity gradient",
         "choose pressure_form = \"corrected\", or remove the key",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return n.kernel_correction == KernelCorrection::kernel &&
                    n.pressure_form != PressureForm::corrected &&
                    (n.velocity_gradient != VelocityGradient::corrected || !has_closure(c));
         }},
        {{"numerics.viscosity", "numerics.pressure_form"},
         "`viscosity = \"artificial\"` with a Riemann `pressure_form`",
         "both damp approaching particles, the one by alpha, the other by the Riemann problem",
         R"(choose viscosity = "morris" or pressure_form = "corrected")",
         [](const Case& c) {
             return c.numerics.viscosity == ViscosityForm::artificial && c.numerics.has_riemann_problem();
         }},
        {{"numerics.impact_dissipation", "numerics.pressure_form"},
         "`impact_dissipation` above 0 with a Riemann `pressure_form`",
         "the Riemann forms have this dissipation already",
         "set it to 0, or choose pressure_form = \"corrected\"",
         [](const Case& c) {
             return c.numerics.impact_dissipation > 0.0 && c.numerics.has_riemann_problem();
         }},
        {{"numerics.impact_dissipation", "numerics.viscosity"},
         "`impact_dissipation` above 0 with `viscosity = \"artificial\"`",
         "both damp approaching particles, and no viscosity of the water would be left",
         "set it to 0, or choose viscosity = \"morris\"",
         [](const Case& c) {
             return c.numerics.impact_dissipation > 0.0 && c.numerics.viscosity == ViscosityForm::artificial;
         }},
        {{"numerics.viscosity", "turbulence.closure", "numerics.eddy_stress"},
         R"(`viscosity = "artificial"` with a closure and `eddy_stress = "two-point"`)",
         "artificial viscosity acts between approaching particles alone, so the eddy viscosity cannot act through it",
         R"(set [numerics] eddy_stress = "stress-divergence", or [turbulence] closure = "none", or choose viscosity = "morris")",
         [](const Case& c) {
             return c.numerics.viscosity == ViscosityForm::artificial && has_closure(c) &&
                    c.numerics.eddy_stress == EddyStress::two_point;
         }},
        {{"numerics.density_relaxation", "numerics.pressure_form", "turbulence.closure"},
         "`density_relaxation` above 0 without a closure and without `pressure_form = \"corrected\"`",
         "its rate is a share of the strain rate, and such a run finds no velocity gradient",
         "set it to 0, or choose pressure_form = \"corrected\"",
         [](const Case& c) { return c.numerics.density_relaxation > 0.0 && !needs_gradients(c); }},
        {{"numerics.courant_number", "numerics.stepping", "numerics.density_diffusion"},
         "`stepping = \"verlet\"` with density diffusion and `courant_number` above 0.2",
         "the leap over two steps amplifies any diffusion of the density, and the run fails (docs/theory.md, section 10)",
         "make it 0.2 or less, set density_diffusion = \"none\", or choose another stepping",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return n.stepping == Stepping::verlet && n.density_diffusion != DensityDiffusion::none &&
                    !n.time_step && n.courant_number > verlet_courant_number;
         }},
        {{"numerics.stepping", "numerics.xsph"},
         "`stepping = \"leapfrog\"` with `xsph` above 0",
         "the leapfrog takes the way of the last step from the velocities, and XSPH moves the particles with others",
         "set xsph = 0, or stepping = \"semi-implicit-euler\"",
         [](const Case& c) { return c.numerics.stepping == Stepping::leapfrog && c.numerics.xsph > 0.0; }},
        {{"numerics.pressure_form", "channel.top"},
         "`pressure_form = \"riemann-non-conservative\"` with a free surface",
         "the difference of two pressures does not vanish where there is none, and the surface blows up (docs/theory.md, section 5)",
         R"(choose "riemann" or "corrected", or set [channel] top = "wall")",
         [](const Case& c) {
             return c.numerics.pressure_form == PressureForm::riemann_non_conservative && has_free_surface(c);
         }},
        {{"numerics.wall", "solid.name"},
         "a `wall` other than `\"dummy\"` with a `[[solid]]`",
         "a solid goes with [numerics] wall = \"dummy\": dynamic particles stand still in layers along the bed, the others are made for planes, at which the water has a mirror image",
         "choose wall = \"dummy\", or remove the solids",
         [](const Case& c) { return c.numerics.wall != WallKind::dummy && !c.solids.empty(); }},
        {{"numerics.wall", "bed.kind"},
         R"(`wall = "repulsive"` with `bed.kind = "no-slip"`)",
         "repulsive walls push along the normal alone, and nothing holds the water back along it",
         R"(choose [bed] kind = "slip" or "spheres", or wall = "dummy")",
         [](const Case& c) { return repels(c) && is_no_slip(c.bed); }},
        {{"numerics.wall", "channel.top"},
         "`wall = \"repulsive\"` without a free surface",
         "their force scales with the depth below a free surface, which must be there",
         R"(set [channel] top = "free-surface", or choose wall = "dummy")",
         [](const Case& c) { return repels(c) && !has_free_surface(c); }},
        {{"numerics.wall", "numerics.pressure_form"},
         R"(`wall = "repulsive"` with `pressure_form = "corrected"`)",
         "repulsive walls have no particles that complete the kernel, and the correction would take them for a free surface",
         R"(choose pressure_form = "symmetric" or "riemann", or wall = "dummy")",
         [](const Case& c) { return repels(c) && c.numerics.pressure_form == PressureForm::corrected; }},
        {{"numerics.wall", "channel.sides"},
         R"(`wall = "repulsive"` or `"dynamic"` with `channel.sides = "half"`)",
         "a plane of symmetry must mirror the water and neither push nor hold it",
         R"(choose [channel] sides = "walls" or "periodic", or wall = "dummy")",
         [](const Case& c) {
             return (repels(c) || c.numerics.wall == WallKind::dynamic) && in_space(c) &&
                    c.channel.sides == Sides::half;
         }},
    }};
}

}  // namespace riffle::inline case_file
