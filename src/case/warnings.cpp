#include "case/warnings.hpp"

#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/conversion.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"
#include "case/outline_check.hpp"
#include "case/presets.hpp"
#include "case/refusals.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double small = 1e-9;  ///< for the comparison of ratios given as decimals

bool near(double a, double b) { return std::abs(a - b) < small; }

// What is verified (docs/theory.md, section 18). In three dimensions the lowest layers are mixed among the
// spheres anyway.
double rows_over_depth(const Case& c) { return in_space(c) ? 10.0 : 20.0; }
double rows_in_roughness(const Case& c) { return in_space(c) ? 2.0 : 4.0; }
constexpr double least_diffusion = 0.02;
constexpr double most_diffusion = 0.1;
constexpr double most_compression = 0.02;
constexpr double most_jitter = 0.25;
constexpr double velocity_to_maximum = 1.4;  ///< surface velocity over depth mean, at most

double largest_courant_number(const Numerics& n) {
    switch (n.stepping) {
        case Stepping::semi_implicit_euler:
        case Stepping::leapfrog:
            return 0.8;
        case Stepping::verlet:
            return 0.2;
        default:
            return 0.4;
    }
}

bool has_closure(const Case& c) { return c.turbulence.closure != ClosureKind::none; }
bool diffuses_density(const Case& c) { return c.numerics.density_diffusion != DensityDiffusion::none; }

bool density_is_noisy(const Case& c) {
    return !diffuses_density(c) && c.numerics.density_filter == DensityFilter::none;
}

/// Whether the particles of a flow in space are in disorder: no mixing length keeps them in layers.
bool has_eddies(const Case& c) {
    return in_space(c) && (c.turbulence.closure == ClosureKind::sps || !has_closure(c) || resolves_eddies(c));
}

/// Whether solids cover the bed.
bool covers_bed(const Case& c) {
    return std::any_of(c.solids.begin(), c.solids.end(),
                       [](const Solid& solid) { return is_bed_shape(solid.shape); });
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

/// Whether a solid that is not lifted holds the water at one edge of its outline, over its whole height.
bool is_held(const Case& c, double edge, double height) {
    const double touch = 2.0 * c.numerics.spacing;
    return std::any_of(c.solids.begin(), c.solids.end(), [&](const Solid& solid) {
        const auto x = extent_of(c, solid, 0);
        const auto z = extent_of(c, solid, 2);
        return solid.velocity_z <= 0.0 && x && z && x->low - touch <= edge && edge <= x->high + touch &&
               z->high + touch >= height;
    });
}

/// Whether the water falls, or meets a wall of a tank that it does not fill.
bool breaks(const Case& c) {
    if (c.start.water_x.empty() || c.channel.ends != Ends::walls) return false;
    const Extent x(c.start.water_x);
    const Extent z(c.start.water_z);
    // The front of a breaking dam without friction runs at twice sqrt(g h) (Ritter 1892).
    const double gap = std::max(is_held(c, x.low, z.high) ? 0.0 : x.low,
                                is_held(c, x.high, z.high) ? 0.0 : c.channel.length - x.high);
    const double front = 2.0 * std::sqrt(c.normal_gravity() * z.high);
    const bool arrives = gap > c.numerics.spacing && c.run.time * front > gap;
    return arrives || z.low > c.numerics.spacing;
}

/// "the depth", or "the depth of the inflow, 20 mm".
std::string depth_text(const LeastDepth& least) {
    return least.of == nullptr ? "the depth"
                               : fmt::format("the depth of {}, {}", least.of, shown_length(least.depth));
}

CheckList make_warnings() {
    return {{
        {{"numerics.spacing", "bed.roughness_height"},
         "fewer than 4 rows of particles in the roughness zone, in three dimensions fewer than 2",
         "the layers between the crests are not resolved",
         "make the spacing smaller",
         [](const Case& c) {
             const double rows = c.bed.roughness_height / c.numerics.spacing;
             return found_if(
                 over_spheres(c) && rows * (1 + small) < rows_in_roughness(c),
                 "{} leaves only {:.1f} rows in the roughness zone of {}, verified with {:.0f} and more",
                 shown_length(c.numerics.spacing), rows, shown_length(c.bed.roughness_height),
                 rows_in_roughness(c));
         }},
        {{"numerics.spacing", "channel.depth"},
         "fewer than 20 rows of particles over the total depth of a bed of spheres, or over a depth given at an open end of it, in three dimensions fewer than 10",
         "the layers of the flow may break up",
         "make the spacing smaller",
         [](const Case& c) {
             const LeastDepth least = least_named_depth(c);
             const double rows = least.depth / c.numerics.spacing;
             return found_if(over_spheres(c) && rows * (1 + small) < rows_over_depth(c),
                             "{} leaves only {:.0f} rows over {}, verified with {:.0f} and more",
                             shown_length(c.numerics.spacing), rows, depth_text(least), rows_over_depth(c));
         }},
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
             return found_if(
                 diffuses_density(c) && (delta < least_diffusion - small || delta > most_diffusion + small),
                 "{} is not verified", delta);
         }},
        {{"numerics.density_diffusion_coefficient", "numerics.smoothing_ratio"},
         "a `density_diffusion_coefficient` below 0.1 with a `smoothing_ratio` below 2",
         "so little lets density and spacing drift apart in a disordered flow",
         "use 0.1",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return found_if(n.density_diffusion == DensityDiffusion::fourtakas && n.smoothing_ratio < 2.0 &&
                                 n.density_diffusion_coefficient < most_diffusion - small,
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
        {{"turbulence.closure", "bed.kind"},
         R"(`closure = "none"` with `bed.kind = "spheres"`)",
         "a rough bed without a closure gives velocities far above any real flow",
         "choose a mixing length",
         [](const Case& c) { return !has_closure(c) && over_spheres(c); }},
        {{"numerics.eddy_stress"},
         "`eddy_stress = \"stress-divergence\"`",
         "with \"stress-divergence\" the velocity zigzags from row to row (docs/theory.md, section 6)",
         "verified with \"two-point\"",
         [](const Case& c) {
             return has_closure(c) && c.numerics.eddy_stress == EddyStress::stress_divergence;
         }},
        {{"turbulence.closure"},
         "`closure = \"sps\"`",
         "the constant-C_s model at this resolution gives a stress far below the weight of the water above, so the velocity does not settle at a real value, and it is offered to show this (docs/theory.md, section 7)",
         R"(use a mixing length ("ramp", "nezu-rodi", "nikuradse"))",
         [](const Case& c) { return c.turbulence.closure == ClosureKind::sps; }},
        {{"turbulence.closure", "channel.sides"},
         "`closure = \"sps\"` between side walls",
         R"(between side walls the constant-C_s model has no steady flow, and the run no cross-section twin; with start.kind = "section" it starts from that of the same channel with "czernuszenko-rylov")",
         "use \"czernuszenko-rylov\"",
         [](const Case& c) { return c.turbulence.closure == ClosureKind::sps && c.has_side_walls(); }},
        {{"bed.kind", "turbulence.closure"},
         "`kind = \"no-slip\"` with a closure of the mean flow",
         "a no-slip bed with a mixing length is under-resolved at this kind of spacing",
         "compare two spacings",
         [](const Case& c) {
             return has_closure(c) && !resolves_eddies(c) && c.bed.kind == BedKind::no_slip;
         }},
        {{"bed.kind", "turbulence.closure"},
         "`kind = \"no-slip\"` with resolved eddies, no bed of solids over it",
         "beside a plane bed at which the water rests the particles that overtake each other in its shear push each other up and down, and this noise takes the place of the eddies (docs/theory.md, section 7, what the particles do to eddies)",
         "compare two spacings; a bed of solid spheres, or of measured heights, was run with resolved eddies",
         [](const Case& c) {
             return resolves_eddies(c) && c.bed.kind == BedKind::no_slip && !covers_bed(c);
         }},
        {{"numerics.spacing", "bed.equivalent_roughness"},
         "over a bed by roughness a spacing below k_s/33, the height of zero velocity of its log law",
         "the rows are finer than what the law says of the flow among the elements",
         "make the spacing larger",
         [](const Case& c) {
             const double zero =
                 zero_height_of_roughness(c.bed.equivalent_roughness.value_or(0.0), c.turbulence.kappa);
             return found_if(c.bed.kind == BedKind::roughness && c.numerics.spacing < zero,
                             "{} is below the height of zero velocity of the log law, {}",
                             shown_length(c.numerics.spacing), fmt::format("{:.2g} mm", 1e3 * zero));
         }},
        {{"numerics.spacing", "channel.depth"},
         "fewer than 12 rows of particles over the depth of a bed by a wall law, or over a depth given at an open end of it",
         "the rows of the wall layer are a large part of the depth",
         "make the spacing smaller",
         [](const Case& c) {
             const LeastDepth least = least_named_depth(c);
             const double rows = least.depth / c.numerics.spacing;
             return found_if(has_wall_law(c) && rows * (1 + small) < 12.0,
                             "{} leaves only {:.0f} rows over {}, verified with 12 and more",
                             shown_length(c.numerics.spacing), rows, depth_text(least));
         }},
        {{"numerics.courant_number", "numerics.stepping"},
         "a `courant_number` above 0.8, with the methods of two evaluations above 0.4, with Verlet's above 0.2",
         "",
         "take the largest value verified or less",
         [](const Case& c) {
             const Numerics& n = c.numerics;
             return found_if(!n.time_step && n.courant_number > largest_courant_number(n) + small,
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
                                           wall_thickness(c) < kernel_support(c) * (1 - small),
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
        {{"bed.drag_form"},
         "`drag_form = \"thesis\"`",
         "the form printed in the thesis scales as 1 / spacing, so the flow changes with the resolution",
         "\"consistent\" does not",
         [](const Case& c) { return over_spheres(c) && c.bed.drag_form == DragForm::thesis; }},
        {{"measured.uniform"},
         "`uniform = false`",
         "the measured flow was not uniform",
         "a uniform simulation need not agree with it",
         [](const Case& c) { return !c.measured.uniform; }},
        {{"numerics.preset", "start.water_x"},
         "water that falls or breaks against an end wall without `preset = \"violent\"`",
         "in this run water breaks against a wall or falls, pressures scatter and spray may leave the water",
         "such flows are verified with preset = \"violent\"",
         [](const Case& c) { return breaks(c) && c.numerics.preset != Preset::violent; }},
        {{"start.lattice", "start.kind"},
         "`lattice = \"body-centred\"` of water that does not start at rest",
         "\"body-centred\" has no layers that slide in a shear flow (docs/theory.md, section 12)",
         "verified with \"square\"",
         [](const Case& c) {
             return c.start.lattice == StartLattice::body_centred && c.start.kind != StartKind::rest;
         }},
        {{"start.jitter"},
         "`jitter` above 0.25",
         "particles so near to each other may throw the start apart",
         "verified up to 0.25 spacings",
         [](const Case& c) { return c.start.jitter > most_jitter; }},
    }};
}

/// Keys that differ from their default though nothing uses them.
void warn_of_keys_without_effect(const Case& c, std::vector<std::string>& messages) {
    Case defaults;
    defaults.numerics = preset_numerics(c.numerics.preset, c.channel.dimensions);
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            if (!key.applies.strictly && !key_applies(key, c) && key.get(c) != key.get(defaults)) {
                messages.push_back(fmt::format("{} = {} has no effect: it is used only with {} = \"{}\"",
                                               key.id(), value_text(key, key.get(c)), key.applies.id,
                                               fmt::join(key.applies.words, "\", \"")));
            }
        }
    }
}

}  // namespace

const CheckList& warnings() {
    static const CheckList list = [] {
        CheckList all = make_warnings();
        for (const CheckList& more : {patch_warnings(), solid_warnings()}) {
            all.checks.insert(all.checks.end(), more.checks.begin(), more.checks.end());
        }
        return all;
    }();
    return list;
}

std::vector<std::string> case_warnings(const Case& c) {
    std::vector<std::string> messages;
    for_each_finding(warnings(), c, [&](const CaseCheck& check, const CaseFinding& finding) {
        messages.push_back(
            check.keys.front() + ": " +
            finding_text(finding.detail.empty() ? finding.name : finding.detail, check, finding));
    });
    warn_of_keys_without_effect(c, messages);
    return messages;
}

}  // namespace riffle::inline case_file
