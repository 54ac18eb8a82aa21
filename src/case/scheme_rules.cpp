#include "case/scheme_rules.hpp"

#include <fmt/format.h>

#include "case/conversion.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"

namespace riffle {

namespace {

/// Largest Courant number at which Verlet's method held the channel of condition 2 with density diffusion.
constexpr double verlet_courant_number = 0.2;

bool repels(const Case& c) { return c.numerics.wall == WallKind::repulsive; }

/// `[numerics] wall = "dummy"`; of a repeated section its heading alone.
std::string value_in_case(const std::string& id, const Case& c) {
    const Key& key = *find_key(id);
    const SectionKeys& section = *find_section(key.section);
    return section.repeated()
               ? section.heading()
               : fmt::format("{} {} = {}", section.heading(), key.name, handy_value_text(key, key.get(c)));
}

}  // namespace

const std::vector<SchemeRule>& scheme_rules() {
    static const std::vector<SchemeRule> rules{
        {{"numerics.tensile_correction", "numerics.pressure_form"},
         "`tensile_correction` above 0 without `pressure_form = \"symmetric\"`",
         "the correction cures the clumping of the symmetric form; set it to 0 or choose pressure_form = "
         "\"symmetric\"",
         [](const Case& c) {
             return c.numerics.tensile_correction > 0.0 &&
                    c.numerics.pressure_form != PressureForm::symmetric;
         }},
        {{"turbulence.closure", "channel.dimensions"},
         "`closure = \"wale\"` or `\"vreman\"` in two dimensions",
         "eddies hand their energy down to smaller ones in three dimensions only; set [channel] dimensions "
         "= 3, or choose a mixing length",
         [](const Case& c) { return resolves_eddies(c) && c.channel.dimensions == 2; }},
        {{"numerics.tensile_correction", "numerics.kernel"},
         "`tensile_correction` above 0 without `kernel = \"cubic-spline\"`",
         "it is made for the cubic spline, whose gradient vanishes at the centre faster than particles "
         "approach; set it to 0 or choose kernel = \"cubic-spline\"",
         [](const Case& c) {
             return c.numerics.tensile_correction > 0.0 && c.numerics.kernel != KernelKind::cubic_spline;
         }},
        {{"numerics.kernel_correction", "numerics.pressure_form", "numerics.velocity_gradient",
          "turbulence.closure"},
         "`kernel_correction = \"kernel\"` without a corrected form",
         "there is nothing to correct: neither the pressure form is \"corrected\" nor does a closure use a "
         "corrected velocity gradient; choose pressure_form = \"corrected\", or remove the key",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return n.kernel_correction == KernelCorrection::kernel &&
                    n.pressure_form != PressureForm::corrected &&
                    (n.velocity_gradient != VelocityGradient::corrected ||
                     c.turbulence.closure == ClosureKind::none);
         }},
        {{"numerics.viscosity", "numerics.pressure_form"},
         "`viscosity = \"artificial\"` with a Riemann `pressure_form`",
         "both damp approaching particles, the one by alpha, the other by the Riemann problem; choose "
         "viscosity = \"morris\" or pressure_form = \"corrected\"",
         [](const Case& c) {
             return c.numerics.viscosity == ViscosityForm::artificial && c.numerics.has_riemann_problem();
         }},
        {{"numerics.impact_dissipation", "numerics.pressure_form"},
         "`impact_dissipation` above 0 with a Riemann `pressure_form`",
         "the Riemann forms have this dissipation already; set it to 0, or choose pressure_form = "
         "\"corrected\"",
         [](const Case& c) {
             return c.numerics.impact_dissipation > 0.0 && c.numerics.has_riemann_problem();
         }},
        {{"numerics.impact_dissipation", "numerics.viscosity"},
         "`impact_dissipation` above 0 with `viscosity = \"artificial\"`",
         "both damp approaching particles, and no viscosity of the water would be left; set it to 0, or "
         "choose viscosity = \"morris\"",
         [](const Case& c) {
             return c.numerics.impact_dissipation > 0.0 && c.numerics.viscosity == ViscosityForm::artificial;
         }},
        {{"numerics.viscosity", "turbulence.closure", "numerics.eddy_stress"},
         "`viscosity = \"artificial\"` with a closure and `eddy_stress = \"two-point\"`",
         "artificial viscosity acts between approaching particles alone, so the eddy viscosity cannot act "
         "through it; set [numerics] eddy_stress = \"stress-divergence\", or [turbulence] closure = "
         "\"none\", or choose viscosity = \"morris\"",
         [](const Case& c) {
             return c.numerics.viscosity == ViscosityForm::artificial &&
                    c.turbulence.closure != ClosureKind::none &&
                    c.numerics.eddy_stress == EddyStress::two_point;
         }},
        {{"numerics.courant_number", "numerics.stepping", "numerics.density_diffusion"},
         "`stepping = \"verlet\"` with density diffusion and `courant_number` above 0.2",
         "the leap over two steps amplifies any diffusion of the density, and the run fails within 0.03 s at "
         "0.3; make it 0.2 or less, set density_diffusion = \"none\", or choose another stepping",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return n.stepping == Stepping::verlet && n.density_diffusion != DensityDiffusion::none &&
                    !n.time_step && n.courant_number > verlet_courant_number;
         }},
        {{"numerics.stepping", "numerics.xsph"},
         "`stepping = \"leapfrog\"` with `xsph` above 0",
         "the leapfrog takes the way of the last step from the velocities, and XSPH moves the particles with "
         "others; set xsph = 0, or stepping = \"semi-implicit-euler\"",
         [](const Case& c) { return c.numerics.stepping == Stepping::leapfrog && c.numerics.xsph > 0.0; }},
        {{"numerics.pressure_form", "channel.top"},
         "`pressure_form = \"riemann-non-conservative\"` with a free surface",
         "the difference of two pressures does not vanish where there is none, and the surface blows up: "
         "condition 2 fails after 0.04 s; choose \"riemann\" or \"corrected\", or set [channel] top = "
         "\"wall\"",
         [](const Case& c) {
             return c.numerics.pressure_form == PressureForm::riemann_non_conservative &&
                    c.channel.top == Top::free_surface;
         }},
        {{"numerics.wall", "solid.name"},
         "`wall = \"modified-dynamic\"` or `\"repulsive\"` with a `[[solid]]`",
         "both are made for planes, at which the water has a mirror image, and the outline of a solid is "
         "none; choose wall = \"dummy\", or remove the solids",
         [](const Case& c) {
             return (c.numerics.wall == WallKind::modified_dynamic || repels(c)) && !c.solids.empty();
         }},
        {{"numerics.wall", "bed.kind"},
         "`wall = \"repulsive\"` with `bed.kind = \"no-slip\"`",
         "repulsive walls push along the normal alone, and nothing holds the water back along it; choose "
         "[bed] kind = \"slip\" or \"spheres\", or wall = \"dummy\"",
         [](const Case& c) { return repels(c) && c.bed.kind == BedKind::no_slip; }},
        {{"numerics.wall", "channel.top"},
         "`wall = \"repulsive\"` without a free surface",
         "their force scales with the depth below a free surface, which must be there; set [channel] top = "
         "\"free-surface\", or choose wall = \"dummy\"",
         [](const Case& c) { return repels(c) && c.channel.top != Top::free_surface; }},
        {{"numerics.wall", "numerics.pressure_form"},
         "`wall = \"repulsive\"` with `pressure_form = \"corrected\"`",
         "repulsive walls have no particles that complete the kernel, and the correction would take them for "
         "a free surface; choose pressure_form = \"symmetric\" or \"riemann\", or wall = \"dummy\"",
         [](const Case& c) { return repels(c) && c.numerics.pressure_form == PressureForm::corrected; }},
        {{"numerics.wall", "channel.ends"},
         "`wall = \"dynamic\"` with end walls in three dimensions",
         "the staggered layers are there below the bed and behind side walls; choose wall = \"dummy\", or "
         "[channel] ends = \"periodic\"",
         [](const Case& c) {
             return c.numerics.wall == WallKind::dynamic && c.channel.dimensions == 3 &&
                    c.channel.ends == Ends::walls;
         }},
        {{"numerics.wall", "channel.sides"},
         "`wall = \"repulsive\"` or `\"dynamic\"` with `channel.sides = \"half\"`",
         "a plane of symmetry must mirror the water and neither push nor hold it; choose [channel] sides = "
         "\"walls\" or \"periodic\", or wall = \"dummy\"",
         [](const Case& c) {
             return (repels(c) || c.numerics.wall == WallKind::dynamic) && c.channel.dimensions == 3 &&
                    c.channel.sides == Sides::half;
         }},
    };
    return rules;
}

void validate_scheme(const Case& c, const Places& places, Problems& problems) {
    for (const SchemeRule& rule : scheme_rules()) {
        if (!rule.broken(c)) {
            continue;
        }
        std::vector<std::string> values;
        for (const std::string& id : rule.keys) {
            values.push_back(value_in_case(id, c));
        }
        problems.add(places.of_first(rule.keys),
                     fmt::format("{}: {}", fmt::join(values, " with "), rule.reason));
    }
}

}  // namespace riffle
