#include <algorithm>
#include <cmath>

#include "case/conversion.hpp"
#include "case/flow_kind.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/warnings.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

bool near(double a, double b) { return std::abs(a - b) < rounding_of_ratios; }

// What is verified (docs/theory.md, section 18).
constexpr double least_diffusion = 0.02;
constexpr double most_diffusion = 0.1;
constexpr double most_compression = 0.02;
constexpr double velocity_to_maximum = 1.4;  ///< surface velocity over depth mean, at most

double largest_courant_number(const Numerics& n) {
    switch (n.stepping) {
        case Stepping::semi_implicit_euler:
        case Stepping::leapfrog:
            return 0.8;
        case Stepping::verlet:
            return 0.2;
        case Stepping::predictor_corrector:
        case Stepping::symplectic:
        case Stepping::beeman:
            break;
    }
    return 0.4;
}

bool diffuses_density(const Case& c) { return c.numerics.density_diffusion != DensityDiffusion::none; }

bool density_is_noisy(const Case& c) {
    return !diffuses_density(c) && c.numerics.density_filter == DensityFilter::none;
}

/// Whether the particles of a flow in space are in disorder: no mixing length keeps them in layers.
bool has_eddies(const Case& c) {
    return in_space(c) && (c.turbulence.closure == ClosureKind::sps || !has_closure(c) || resolves_eddies(c));
}

/// A velocity that the case names, at the surface, m/s.
double named_velocity(const Case& c) {
    return std::max(c.measured.depth_mean_velocity.value_or(0.0) * velocity_to_maximum,
                    std::abs(c.start.velocity.value_or(0.0)));
}

/// Share by which the water's weight compresses it at the bed.
double compression(const Case& c) {
    const double speed = c.numerics.sound_speed.value_or(0.0);
    return speed > 0.0 ? c.normal_gravity() * c.total_depth() / (speed * speed) : 0.0;
}

}  // namespace

CheckList numerics_warnings() {
    return {{
        {{"numerics.kernel"},
         "`kernel = \"cubic-spline\"`",
         "the cubic spline does not keep the particles in order, and the flow brakes (docs/theory.md, section 3)",
         "verified with \"wendland-c2\"",
         [](const Case& c) { return c.numerics.kernel == KernelKind::cubic_spline; }},
        {{"numerics.kernel"},
         "another `kernel` than `\"wendland-c2\"`",
         "this kernel is verified in laminar flow alone",
         "verified with \"wendland-c2\"",
         [](const Case& c) {
             return c.numerics.kernel != KernelKind::wendland_c2 &&
                    c.numerics.kernel != KernelKind::cubic_spline;
         }},
        {{"numerics.smoothing_ratio", "start.lattice"},
         R"(a `smoothing_ratio` other than 1.5 and 2.0, or 1.83 and 2.1 with `start.lattice = "hexagonal"`, 1.65 with `"body-centred"`, 2.5 with `[[porous]]`)",
         "",
         "verified with 1.5 and 2.0 (1.83 and 2.1 on the hexagonal lattice, 1.65 on the body-centred one, 2.5 with porous zones)",
         [](const Case& c) {
             const double ratio = c.numerics.smoothing_ratio;
             const bool hexagonal =
                 c.start.lattice == StartLattice::hexagonal && (near(ratio, 1.83) || near(ratio, 2.1));
             const bool cubic = c.start.lattice == StartLattice::body_centred && near(ratio, 1.65);
             const bool wide = !c.porous.empty() && near(ratio, 2.5);
             return found_if(!near(ratio, 1.5) && !near(ratio, 2.0) && !hexagonal && !cubic && !wide,
                             "{} is not verified", ratio);
         }},
        {{"numerics.pressure_form"},
         "`pressure_form = \"symmetric\"`",
         "in the symmetric form any disorder of the particles turns pressure into a shear stress as large as the flow's own friction, which refinement does not cure (docs/theory.md, section 5)",
         "use \"corrected\" unless this is what you study",
         [](const Case& c) { return c.numerics.pressure_form == PressureForm::symmetric; }},
        {{"numerics.kernel_correction"},
         "`kernel_correction = \"kernel\"`",
         "\"kernel\" leaves the spurious shear stress of the symmetric form as it is (docs/theory.md, section 5)",
         "verified with \"kernel-gradient\"",
         [](const Case& c) { return c.numerics.kernel_correction == KernelCorrection::kernel; }},
        {{"numerics.pressure_form"},
         "a Riemann `pressure_form`",
         "a Riemann form keeps the spurious shear stress of the symmetric one, and the mean velocity is low with it (docs/theory.md, section 5)",
         R"(use "corrected" unless this is what you study, and preset = "violent" for impacts)",
         [](const Case& c) { return c.numerics.has_riemann_problem(); }},
        {{"numerics.density_diffusion", "channel.top"},
         "`density_diffusion = \"molteni\"` with a free surface",
         "\"molteni\" diffuses the hydrostatic difference too: it moves the level of the water, and runs of a rough bed fail with it (docs/theory.md, section 4)",
         "use \"fourtakas\" under gravity",
         [](const Case& c) {
             return c.numerics.density_diffusion == DensityDiffusion::molteni && has_free_surface(c);
         }},
        {{"numerics.density_diffusion", "bed.kind"},
         "`density_diffusion = \"antuono\"` over spheres",
         "a run over a rough bed failed with \"antuono\" after 19 s (docs/theory.md, section 4)",
         "use \"fourtakas\"",
         [](const Case& c) {
             return c.numerics.density_diffusion == DensityDiffusion::antuono && over_spheres(c);
         }},
        {{"numerics.density_diffusion", "numerics.density_filter"},
         "neither `density_diffusion` nor `density_filter`",
         "neither diffusion nor filter keeps the density free of noise",
         "use \"fourtakas\"",
         density_is_noisy},
        {{"numerics.density_diffusion_coefficient"},
         "a `density_diffusion_coefficient` outside of 0.02 to 0.1",
         "",
         "verified from 0.02 to 0.1",
         [](const Case& c) {
             const double delta = c.numerics.density_diffusion_coefficient;
             return found_if(diffuses_density(c) && (delta < least_diffusion - rounding_of_ratios ||
                                                     delta > most_diffusion + rounding_of_ratios),
                             "{} is not verified", delta);
         }},
        {{"numerics.density_diffusion_coefficient", "numerics.smoothing_ratio"},
         "a `density_diffusion_coefficient` below 0.1 with a `smoothing_ratio` below 2",
         "so little lets density and spacing drift apart in a disordered flow",
         "use 0.1",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return found_if(n.density_diffusion == DensityDiffusion::fourtakas && n.smoothing_ratio < 2.0 &&
                                 n.density_diffusion_coefficient < most_diffusion - rounding_of_ratios,
                             "with h = {} dx use 0.1, not {}", n.smoothing_ratio,
                             n.density_diffusion_coefficient);
         }},
        {{"numerics.xsph"},
         "`xsph` above 0",
         "not verified with the other defaults",
         "the verified value is 0",
         [](const Case& c) { return c.numerics.xsph > 0.0; }},
        {{"numerics.sound_speed", "channel.depth"},
         "a `sound_speed` at which the water's weight compresses it by more than 2 % at the bed",
         "",
         "take a larger one",
         [](const Case& c) {
             Findings found =
                 found_if(compression(c) > most_compression,
                          "at {} m/s the water's own weight compresses it by {:.1f} % at the bed",
                          c.numerics.sound_speed.value_or(0.0), 100 * compression(c));
             for (CaseFinding& finding : found) {
                 finding.cure = fmt::format("take at least {:.2g} m/s (10 sqrt(g H))",
                                            10 * std::sqrt(c.normal_gravity() * c.total_depth()));
             }
             return found;
         }},
        {{"numerics.sound_speed", "measured.depth_mean_velocity", "start.velocity"},
         "a `sound_speed` below 10 times the largest velocity: `start.velocity`, or 1.4 times `measured.depth_mean_velocity`",
         "the density would vary by more than 1 %",
         "take a larger one",
         [](const Case& c) {
             const double speed = c.numerics.sound_speed.value_or(0.0);
             return found_if(c.numerics.sound_speed && speed < 10 * named_velocity(c),
                             "{} m/s is less than 10 times the largest velocity of about {:.2g} m/s", speed,
                             named_velocity(c));
         }},
        {{"numerics.viscosity"},
         "`viscosity = \"monaghan-gingold\"`",
         "\"monaghan-gingold\" is too weak in layered shear (docs/theory.md, section 6)",
         "use \"morris\" unless viscous damping of waves counts",
         [](const Case& c) { return c.numerics.viscosity == ViscosityForm::monaghan_gingold; }},
        {{"numerics.viscosity"},
         "`viscosity = \"artificial\"`",
         "\"artificial\" is no viscosity of the water: it grows with c0 and h, and a shear flow with it does not converge to the profile of fluid.kinematic_viscosity",
         "use \"morris\" where friction counts",
         [](const Case& c) { return c.numerics.viscosity == ViscosityForm::artificial; }},
        {{"numerics.eddy_stress"},
         "`eddy_stress = \"stress-divergence\"`",
         "with \"stress-divergence\" the velocity zigzags from row to row (docs/theory.md, section 6)",
         "verified with \"two-point\"",
         [](const Case& c) {
             return has_closure(c) && c.numerics.eddy_stress == EddyStress::stress_divergence;
         }},
        {{"numerics.courant_number", "numerics.stepping"},
         "a `courant_number` above 0.8, with the methods of two evaluations above 0.4, with Verlet's above 0.2",
         "",
         "take the largest value verified or less",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return found_if(
                 !n.time_step && n.courant_number > largest_courant_number(n) + rounding_of_ratios,
                 "{} is more than {}, the largest value verified with \"{}\"", n.courant_number,
                 largest_courant_number(n), word(n.stepping));
         }},
        {{"numerics.stepping", "channel.dimensions", "turbulence.closure"},
         "`stepping = \"semi-implicit-euler\"` down a slope in three dimensions for more than 1 s without a mixing length",
         "water whose particles are in disorder swells with it (docs/theory.md, section 10)",
         "\"leapfrog\" keeps its volume",
         [](const Case& c) {
             return c.numerics.stepping == Stepping::semi_implicit_euler && has_eddies(c) &&
                    c.run.time > 1.0 && c.channel.slope > 0.0;
         }},
        {{"numerics.wall_layers", "numerics.smoothing_ratio"},
         "`wall_layers` that do not fill the kernel",
         "particles may pass through the bed",
         "take 2 h / dx or more",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             const bool layered = n.wall == WallKind::dummy || n.wall == WallKind::modified_dynamic;
             Findings found = found_if(layered && c.channel.top != Top::periodic &&
                                           wall_thickness(c) < kernel_support(c) * (1 - rounding_of_ratios),
                                       "{} layers do not fill the kernel (2 h = {} dx)", n.wall_layers,
                                       2 * n.smoothing_ratio);
             for (CaseFinding& finding : found) {
                 finding.cure = fmt::format("take {}", std::ceil(2 * n.smoothing_ratio));
             }
             return found;
         }},
        {{"numerics.wall", "numerics.density_diffusion"},
         "`wall = \"modified-dynamic\"` with neither `density_diffusion` nor `density_filter`",
         "\"modified-dynamic\" walls carry the noise of the density beside them on into the wall (docs/theory.md, section 9)",
         "use density diffusion",
         [](const Case& c) { return c.numerics.wall == WallKind::modified_dynamic && density_is_noisy(c); }},
        {{"numerics.wall", "bed.kind"},
         "`wall = \"modified-dynamic\"` over spheres",
         "\"modified-dynamic\" walls pass the noise of disordered water on, and runs over a rough bed fail with them after some seconds (docs/theory.md, section 9)",
         "use \"dummy\"",
         [](const Case& c) { return c.numerics.wall == WallKind::modified_dynamic && over_spheres(c); }},
        {{"numerics.wall"},
         "`wall = \"repulsive\"`",
         "\"repulsive\" walls hold the water and give no more: no friction, and between end walls they stir still water (docs/theory.md, section 9)",
         "verified with \"dummy\" walls",
         [](const Case& c) { return c.numerics.wall == WallKind::repulsive; }},
        {{"numerics.wall", "numerics.preset"},
         R"(`wall = "dynamic"` with `preset = "riffle"`)",
         "",
         "verified with \"dummy\" walls, which act by their pressure only",
         [](const Case& c) {
             return c.numerics.wall == WallKind::dynamic && c.numerics.preset == Preset::riffle;
         }},
        {{"bed.kind", "numerics.wall"},
         R"(`kind = "slip"` with `wall = "dynamic"`)",
         "dynamic particles rub on the water as resting water would: the bed is a no-slip one all the same",
         R"(a slip bed goes with "dummy" walls; or set kind = "no-slip")",
         [](const Case& c) { return c.numerics.wall == WallKind::dynamic && c.bed.kind == BedKind::slip; }},
    }};
}

}  // namespace riffle::inline case_file
