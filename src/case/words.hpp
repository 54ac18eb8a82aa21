#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "case/case.hpp"

namespace riffle {

/// A word of the case file that names an option, and what the option is.
struct Word {
    std::string_view name;
    std::string_view meaning;
    std::string_view source = "";  ///< the equation and who stated it
    std::string_view advice = "";  ///< where to take it and where not, with what was measured
};

/// The words of an enumeration, in the order of its enumerators.
template <class Enum>
struct Words;

template <>
struct Words<Preset> {
    static constexpr std::array<Word, 3> list{{
        {"riffle", "the verified scheme of this program"},
        {"thesis", "the numerics of the thesis (cubic spline, symmetric pressure form), for study"},
        {"paper", "the numerics of the 2016 paper (as the thesis, linear equation of state), for study"},
    }};
};

template <>
struct Words<Ends> {
    static constexpr std::array<Word, 2> list{{
        {"periodic", "what leaves at one end enters at the other"},
        {"walls",
         "upright walls at both ends: no-slip with `bed.kind = \"no-slip\"` or dynamic walls, else "
         "frictionless"},
    }};
};

template <>
struct Words<Top> {
    static constexpr std::array<Word, 3> list{{
        {"free-surface", "open to the air"},
        {"wall",
         "a resting plate at the top (flow between plates): no-slip with `bed.kind = \"no-slip\"` or dynamic "
         "walls, else frictionless"},
        {"periodic", "the top joins the bottom (no bed, no gravity: tests)"},
    }};
};

template <>
struct Words<Sides> {
    static constexpr std::array<Word, 3> list{{
        {"periodic", "what leaves at one side enters at the other: part of a wide channel"},
        {"walls", "frictionless walls at y = 0 and y = width, whose drag is that of [side_walls]"},
        {"half", "a side wall at y = 0 and the plane of symmetry at y = width / 2"},
    }};
};

template <>
struct Words<SideDragForm> {
    static constexpr std::array<Word, 3> list{{
        {"consistent", "the bed's drag times H / (k^2 width) on each wall (Yang & Lim), over the layer"},
        {"thesis", "as printed in the thesis (5.11-5.13); counts k^2 twice and scales as 1 / spacing"},
        {"none", "frictionless walls"},
    }};
};

template <>
struct Words<BedKind> {
    static constexpr std::array<Word, 3> list{{
        {"spheres", "a layer of spheres that acts by its drag in the roughness zone"},
        {"slip", "a smooth frictionless plane"},
        {"no-slip", "a smooth plane at which the water rests"},
    }};
};

template <>
struct Words<Packing> {
    static constexpr std::array<Word, 2> list{{
        {"hexagonal", "2 / (sqrt(3) D^2) spheres per plan area"},
        {"square", "1 / D^2 spheres per plan area"},
    }};
};

template <>
struct Words<DragForm> {
    static constexpr std::array<Word, 5> list{{
        {"consistent",
         "frontal area of the packed spheres per volume; in 3D the drag of each sphere over its volume; does "
         "not "
         "depend on the spacing"},
        {"thesis", "as printed in the thesis; scales as 1 / spacing"},
        {"paper", "as printed in the paper: C_d / (2 D) over the roughness zone (2D)"},
        {"slice",
         "3D: the drag of each slice of a sphere over the slice; its plan mean is the 2D consistent form"},
        {"plan-mean",
         "3D: at each height the mean of the consistent form over the plan; spheres without places, for "
         "checks against "
         "the twins"},
    }};
};

template <>
struct Words<ClosureKind> {
    static constexpr std::array<Word, 6> list{{
        {"none", "laminar"},
        {"ramp", "mixing length kappa z, at most lambda H (thesis 4.2)"},
        {"nezu-rodi", "mixing length of Nezu & Rodi with Coles' wake (thesis 2.21)"},
        {"nikuradse", "mixing length of Nikuradse (thesis 2.20)"},
        {"sps", "sub-particle scale model with a constant C_s (thesis 4.1)"},
        {"czernuszenko-rylov", "anisotropic mixing lengths over the cross-section (thesis 5.1-5.7)"},
    }};
};

template <>
struct Words<StressTerms> {
    static constexpr std::array<Word, 2> list{{
        {"full", "the whole stress tensor, |S| = sqrt(2 S_ij S_ij)"},
        {"shear",
         "|S| = |du/dz| (the paper); only with `eddy_stress = \"stress-divergence\"` is tau_xz alone kept as "
         "well"},
    }};
};

template <>
struct Words<KernelKind> {
    static constexpr std::array<Word, 7> list{{
        {"wendland-c2", "Wendland's quintic C2 kernel"},
        {"cubic-spline", "cubic B-spline"},
        {"gaussian",
         "Gaussian of length 2 h/3, cut at 2 h and normalised there; narrow, take h = 2 dx or more"},
        {"quadratic", "parabola (SPHysics): does not clump, but its sums converge worst"},
        {"quintic-spline", "quintic B-spline of radius 2 h; narrow, take h = 2 dx or more"},
        {"wendland-c4", "Wendland's C4 kernel; narrow, take h = 2 dx or more"},
        {"wendland-c6", "Wendland's C6 kernel; the narrowest, take h = 2 dx or more"},
    }};
};

template <>
struct Words<EquationOfState> {
    static constexpr std::array<Word, 2> list{{
        {"linear", "p = c0^2 (rho - rho0)"},
        {"tait", "p = (c0^2 rho0 / 7) [(rho / rho0)^7 - 1]"},
    }};
};

template <>
struct Words<PressureForm> {
    static constexpr std::array<Word, 3> list{{
        {"corrected", "conservative form with the corrected kernel gradient: no spurious friction"},
        {"symmetric", "the usual p_i + p_j form: spurious friction where the particles are disordered"},
        {"riemann",
         "p_i + p_j with the limited dissipation of a Riemann problem: for violent flow, not for channels"},
    }};
};

template <>
struct Words<VelocityGradient> {
    static constexpr std::array<Word, 2> list{{
        {"corrected", "exact for linear velocity fields"},
        {"plain", "plain kernel sum"},
    }};
};

template <>
struct Words<KernelCorrection> {
    static constexpr std::array<Word, 2> list{{
        {"kernel-gradient", "inverse of the first moments: exact for linear fields (Bonet & Lok)"},
        {"kernel", "the kernel over its sum (Shepard): exact for constants alone"},
    }};
};

template <>
struct Words<DensityDiffusion> {
    static constexpr std::array<Word, 4> list{{
        {"fourtakas", "diffusion of the density less its hydrostatic part"},
        {"none", "no diffusion"},
        {"molteni", "diffusion of the density (Molteni & Colagrossi): moves the level of water at rest"},
        {"antuono", "diffusion of the density less its corrected linear part (Antuono et al.)"},
    }};
};

template <>
struct Words<DensityFilter> {
    static constexpr std::array<Word, 3> list{{
        {"none", "no filter"},
        {"shepard", "zeroth-order renormalisation of the density"},
        {"mls", "first-order moving least squares renormalisation of the density"},
    }};
};

template <>
struct Words<SurfaceDetection> {
    static constexpr std::array<Word, 4> list{{
        {"volume-fraction",
         "where the water's share of the kernel's support falls to 1/2; 0.1 dx high in layered runs"},
        {"position-divergence",
         "where the divergence of the position falls to half (thesis 2.60); 0.2 dx high, and blind to short "
         "waves"},
        {"density-ratio", "highest particle with an incomplete support (Koshizuka); half a spacing low"},
        {"depth-sum",
         "depth of the water column (Tis Isat); exact in the mean, smooths short waves, counts spray as "
         "depth"},
    }};
};

template <>
struct Words<ViscosityForm> {
    static constexpr std::array<Word, 4> list{{
        {"morris", "acts along the velocity difference"},
        {"monaghan-gingold",
         "acts along the line of centres; conserves angular momentum, too weak in layered shear: by 11 % at "
         "h = 1.5 dx, 4 % at 2 dx (Wendland)"},
        {"lo-shao", "acts along the velocity difference, softened (Lo & Shao; SPHysics): 1 to 2 % too weak"},
        {"artificial",
         "Monaghan's artificial viscosity, alpha h c0, between approaching particles: instead of the "
         "water's"},
    }};
};

template <>
struct Words<EddyStress> {
    static constexpr std::array<Word, 2> list{{
        {"two-point", "the eddy viscosity enters the pair viscosity"},
        {"stress-divergence", "kernel divergence of the stress at the particles (the thesis)"},
    }};
};

template <>
struct Words<Stepping> {
    static constexpr std::array<Word, 5> list{{
        {"semi-implicit-euler",
         "one force evaluation per step, first order: advised, as fast again as the "
         "others and the same flow to 0.03 %"},
        {"predictor-corrector", "two force evaluations per step, second order (the thesis)"},
        {"verlet",
         "one force evaluation per step, a leap over two steps (SPHysics); not with density diffusion "
         "at Courant numbers above 0.2, where it fails"},
        {"symplectic", "two force evaluations per step, the second at its middle; second order (SPHysics)"},
        {"beeman",
         "two force evaluations per step, with the rates of the step before; third order (SPHysics)"},
    }};
};

template <>
struct Words<WallKind> {
    static constexpr std::array<Word, 4> list{{
        {"dummy", "layers of particles that carry the pressure of the fluid before them"},
        {"dynamic",
         "staggered layers whose density follows the continuity equation (the thesis); the water rests at "
         "them"},
        {"modified-dynamic",
         "layers of particles that carry the density found at their mirror image in the water (English et "
         "al.)"},
        {"repulsive",
         "one row of particles that push the water away (Monaghan & Kos): no pressure, no friction"},
    }};
};

template <>
struct Words<Precision> {
    static constexpr std::array<Word, 2> list{{
        {"single", "pair arithmetic in single precision, state in double"},
        {"double", "everything in double precision; 1.5-1.8 times slower"},
    }};
};

template <>
struct Words<StartLattice> {
    static constexpr std::array<Word, 3> list{{
        {"square", "rows and columns; the layers slide in a shear flow"},
        {"hexagonal", "rows shifted against each other, the arrangement that stays at rest in still water"},
        {"body-centred", "3D: body-centred cubic"},
    }};
};

template <>
struct Words<StartKind> {
    static constexpr std::array<Word, 8> list{{
        {"column", "the steady velocity profile of the column twin"},
        {"uniform", "one velocity everywhere"},
        {"rest", "still water"},
        {"power-law", "u = U_max (z / H)^(1 / m)"},
        {"results", "the last state of a results file"},
        {"standing-wave", "a standing gravity wave, one wave length over the channel length"},
        {"taylor-green", "Taylor-Green vortices (periodic in both directions)"},
        {"section", "3D: the steady velocity of the cross-section twin"},
    }};
};

template <>
struct Words<SolidSurface> {
    static constexpr std::array<Word, 2> list{{
        {"no-slip", "the water rests at it"},
        {"slip", "frictionless: it gives pressure alone"},
    }};
};

template <>
struct Words<SolidMotion> {
    static constexpr std::array<Word, 3> list{{
        {"fixed", "it stands still"},
        {"constant", "it moves at a constant velocity from its start"},
        {"oscillating", "it swings harmonically from its start"},
    }};
};

template <>
struct Words<RunUntil> {
    static constexpr std::array<Word, 2> list{{
        {"time", "until a simulated time"},
        {"converged", "until the depth-mean velocity is known within the tolerance"},
    }};
};

template <>
struct Words<ProbeKind> {
    static constexpr std::array<Word, 6> list{{
        {"velocity", "u and w at points, as an acoustic Doppler velocimeter gives them"},
        {"wave", "elevation of the surface at positions along the channel"},
        {"surface_line", "elevation of the surface on an even line over the whole channel"},
        {"grid",
         "means and second moments of u and w on a grid, window by window, as from image velocimetry"},
        {"flow_rate", "discharge per unit width through sections, and the depth there"},
        {"force", "drag and friction of the bed, its normal force, and the weight component, per unit width"},
    }};
};

/// The word of the case file for an option.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::string_view word(Enum option) {
    return Words<Enum>::list[static_cast<std::size_t>(option)].name;
}

}  // namespace riffle
