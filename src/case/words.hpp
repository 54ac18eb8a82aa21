#pragma once

#include <array>

#include "case/case.hpp"
#include "case/numerics_words.hpp"
#include "case/word.hpp"

namespace riffle::inline case_file {

template <>
struct Words<Ends> {
    static constexpr std::array<Word, 3> list{{
        {"periodic", "what leaves at one end enters at the other"},
        {"walls",
         "upright walls at both ends: no-slip with `bed.kind = \"no-slip\"` or dynamic walls, else frictionless"},
        {"open", "water enters at x = 0 as [inflow] says and leaves at the other end as [outflow] does"},
    }};
};

template <>
struct Words<InflowProfile> {
    static constexpr std::array<Word, 7> list{{
        {"twin",
         "that of the twin which carries the discharge at the depth of the case: of the cross-section between side walls, where it has one, else of the column",
         "theory 20", "wherever bed or side walls resist"},
        {"column", "that of the column twin, the same all across the channel", "theory 20",
         "over a bed with friction, where the water comes from a channel that is wider"},
        {"uniform", "one velocity over the depth", "", "over slip beds, below gates"},
        {"power-law", "u = U_max (z / H)^(1 / m)", "thesis (5.8)",
         "where no more is known of the flow upstream"},
        {"log-law", "u = u_* / kappa ln(1 + 30 z / k_s), z above the datum", "Nikuradse (1933)",
         "a developed flow over another bed than that of the case"},
        {"file", "measured or computed velocities from a CSV file with the columns z, u", "",
         "profiles of a flume or of another run"},
        {"results",
         "the water of a run with periodic ends, with its eddies: what its snapshots hold, one after the other",
         "theory 20", "turbulence that enters"},
    }};
};

template <>
struct Words<OutflowKind> {
    static constexpr std::array<Word, 8> list{{
        {"depth", "the depth that `depth` or `depth_file` gives"},
        {"normal-depth",
         "the depth of uniform flow with the discharge of the inflow, where that changes with what leaves"},
        {"critical-depth",
         "the depth (q^2 / g)^(1/3) of the discharge that leaves: what a drop or overfall does to the flow a few depths before it"},
        {"weir",
         "the head over a sharp crest with the discharge that leaves, by `weir_height` and `weir_coefficient`"},
        {"rating-curve", "the depth that goes with the discharge that leaves, from `rating_file`"},
        {"free",
         "nothing: supercritical flow leaves as it comes, slower water at the critical depth, and a dry bed stays dry until water comes"},
        {"free-fall", "nothing: the bed ends there, and the water falls over its edge"},
        {"pressure",
         "the pressure at the end of a duct, the same over its height (channel.top = \"wall\"): only what differs from it moves the water"},
    }};
};

template <>
struct Words<Top> {
    static constexpr std::array<Word, 3> list{{
        {"free-surface", "open to the air"},
        {"wall",
         "a resting plate at the top (flow between plates): no-slip with `bed.kind = \"no-slip\"` or dynamic walls, else frictionless"},
        {"periodic", "the top joins the bottom (no bed, no gravity: tests)"},
    }};
};

template <>
struct Words<Sides> {
    static constexpr std::array<Word, 3> list{{
        {"periodic", "what leaves at one side enters at the other: part of a wide channel"},
        {"walls",
         "walls at y = 0 and y = width: frictionless but for the drag of [side_walls]; no-slip with `bed.kind = \"no-slip\"`"},
        {"half", "a side wall at y = 0 and the plane of symmetry at y = width / 2"},
    }};
};

template <>
struct Words<SideDragForm> {
    static constexpr std::array<Word, 4> list{{
        {"consistent", "the bed's drag times H / (k^2 width) on each wall (Yang & Lim), over the layer"},
        {"thesis", "as printed in the thesis (5.11-5.13); counts k^2 twice and scales as 1 / spacing"},
        {"log-law",
         "the friction of the log law over the walls' own `equivalent_roughness`, or of smooth walls"},
        {"none", "frictionless walls"},
    }};
};

template <>
struct Words<BedKind> {
    static constexpr std::array<Word, 5> list{{
        {"spheres", "a layer of spheres that acts by its drag in the roughness zone"},
        {"slip", "a smooth frictionless plane"},
        {"no-slip", "a smooth plane at which the water rests"},
        {"roughness",
         "a plane whose friction is that of the log law over `equivalent_roughness` or `manning`", "theory 8",
         "beds known by k_s or Manning's n"},
        {"smooth", "a smooth plane with the friction of the log law of smooth walls", "theory 8",
         "turbulent flow over glass, steel and smooth concrete"},
    }};
};

template <>
struct Words<Packing> {
    static constexpr std::array<Word, 2> list{{
        {"hexagonal", "2 / (sqrt(3) D^2) spheres per plan area", "theory 8", "the measured beds"},
        {"square", "1 / D^2 spheres per plan area", "theory 8",
         "looser beds: fewer spheres, and so less drag, at equal diameter"},
    }};
};

template <>
struct Words<DragForm> {
    static constexpr std::array<Word, 5> list{{
        {"consistent",
         "frontal area of the packed spheres per volume; in 3D the drag of each sphere over its volume; does not depend on the spacing",
         "thesis (2.16) on each sphere, per volume",
         "always: independent of the spacing, and near to the measured conditions with nothing fitted (theory 8)"},
        {"thesis", "as printed in the thesis; scales as 1 / spacing", "thesis (4.3-4.4) as printed",
         "only to repeat the thesis: the flow changes with the spacing (theory 8)"},
        {"paper", "as printed in the paper: C_d / (2 D) over the roughness zone (2D)", "paper (4-5)",
         "only to repeat the paper"},
        {"slice",
         "3D: the drag of each slice of a sphere over the slice; its plan mean is the 2D consistent form",
         "thesis (2.16), slice by slice", "3D runs to be compared with a 2D one"},
        {"plan-mean",
         "3D: at each height the mean of the consistent form over the plan; spheres without places, for checks against the twins",
         "plan mean of the consistent form", "checks of a 3D run against its section twin"},
    }};
};

template <>
struct Words<ClosureKind> {
    static constexpr std::array<Word, 9> list{{
        {"none", "laminar", "", "laminar flow"},
        {"ramp", "mixing length kappa z, at most lambda H (thesis 4.2)",
         "thesis (4.2); Nezu & Nakagawa (1993), Stansby (2003)",
         "wide channels and 2D: near to the measured conditions (docs/column.md)"},
        {"nezu-rodi", "mixing length of Nezu & Rodi with Coles' wake (thesis 2.21)",
         "thesis (2.21); Nezu & Rodi (1986)",
         "as the ramp, where the wake of the outer layer matters; the paper's choice"},
        {"nikuradse", "mixing length of Nikuradse (thesis 2.20)", "thesis (2.20); Nikuradse (1932)",
         "comparison: made for pipes"},
        {"sps", "sub-particle scale model with a constant C_s (thesis 4.1)",
         "thesis (4.1); Gotoh et al. (2001)",
         "not for channels: its length is a share of the spacing, and the flow far too fast (theory 7)"},
        {"czernuszenko-rylov", "anisotropic mixing lengths over the cross-section (thesis 5.1-5.7)",
         "thesis (5.1-5.7); Czernuszenko & Rylov (2000)", "3D channels with side walls"},
        {"wale", "eddies resolved by the particles, those below by the wall-adapting local eddy viscosity",
         "Nicoud & Ducros (1999); C_w^2 = 10.6 C_s^2",
         "resolved eddies in 3D: none where the flow is plane shear"},
        {"vreman", "eddies resolved by the particles, those below by Vreman's viscosity",
         "Vreman (2004); c = 2.5 C_s^2",
         "resolved eddies in 3D, as wale: the difference shows what the closure does"},
        {"smagorinsky",
         "eddies resolved by the particles, those below by Smagorinsky's viscosity, its length no more than kappa (z - zero) at the bed",
         "Smagorinsky (1963); damped at rough beds after Mason & Thomson (1992)",
         "resolved eddies in 3D, to compare with other codes: it brakes plane shear too"},
    }};
};

template <>
struct Words<StressTerms> {
    static constexpr std::array<Word, 2> list{{
        {"full", "the whole stress tensor, |S| = sqrt(2 S_ij S_ij)", "Smagorinsky (1963)", "always"},
        {"shear",
         "|S| = |du/dz| (the paper); only with `eddy_stress = \"stress-divergence\"` is tau_xz alone kept as well",
         "the paper", "to repeat the paper; in parallel flow the same"},
    }};
};

template <>
struct Words<EddyRate> {
    static constexpr std::array<Word, 3> list{{
        {"strain", "the strain rate, sqrt(2 S_ij S_ij)", "Prandtl (1925); Smagorinsky (1963)",
         "uniform flow"},
        {"rotation", "the rate of rotation, sqrt(2 W_ij W_ij)", "Baldwin & Lomax (1978)",
         "flow that is pressed together or drawn out without shear: before weirs and gates; in parallel flow the same"},
        {"strain-and-rotation", "the root of their product", "Kato & Launder (1993)",
         "as rotation, with less in eddies that turn like a wheel"},
    }};
};

template <>
struct Words<ClosureDepth> {
    static constexpr std::array<Word, 3> list{{
        {"auto",
         "that of the start in uniform channels, the local one where the flow varies along the channel"},
        {"initial", "the total depth of the case, everywhere and always"},
        {"local",
         "the depth of the water over each place of the bed, from the particles, smoothed and relaxed",
         "theory 7", "flow that varies along the channel: bodies, waves, other depths than `channel.depth`"},
    }};
};

template <>
struct Words<SurfaceDetection> {
    static constexpr std::array<Word, 4> list{{
        {"volume-fraction", "where the water's share of the kernel's support falls to 1/2",
         "docs/free-surface.md", "always"},
        {"position-divergence",
         "where the divergence of the position falls to half (thesis 2.60); blind to short waves",
         "thesis (2.60)", "to repeat the thesis; blind to short waves"},
        {"density-ratio", "highest particle with an incomplete support (Koshizuka); half a spacing low",
         "Koshizuka & Oka (1996)", "to repeat published runs; half a spacing low"},
        {"depth-sum",
         "depth of the water column (Tis Isat); exact in the mean, smooths short waves, counts spray as depth",
         "docs/free-surface.md", "mean depth; smooths short waves and counts spray"},
    }};
};

template <>
struct Words<StartLattice> {
    static constexpr std::array<Word, 3> list{{
        {"square", "rows and columns; the layers slide in a shear flow", "theory 12",
         "sheared flow; unstable in still water"},
        {"hexagonal",
         "rows shifted against each other, the arrangement that stays at rest in still water; in space the same in "
         "each file",
         "theory 12", "still water and quiet flows in two dimensions, with h of 1.8 or 2.1 dx"},
        {"body-centred", "3D: body-centred cubic, rows 2^(-2/3) dx apart",
         "two particles in a cell of (2^(1/3) dx)^3 (SPHysics)",
         "water at rest in space; not for shear flow, where it has no layers to slide (theory 12)"},
    }};
};

template <>
struct Words<StartKind> {
    static constexpr std::array<Word, 10> list{{
        {"column", "the steady velocity profile of the column twin"},
        {"uniform", "one velocity everywhere"},
        {"rest", "still water"},
        {"power-law", "u = U_max (z / H)^(1 / m)"},
        {"results",
         "the last state of a results file; of another spacing, or of a shorter or narrower periodic channel, its flow"},
        {"standing-wave", "a standing gravity wave, one wave length over the channel length"},
        {"taylor-green", "Taylor-Green vortices (periodic in all directions)"},
        {"isotropic",
         "3D: isotropic turbulence of the energy spectrum in `file` (periodic in all directions)"},
        {"section", "3D: the steady velocity of the cross-section twin"},
        {"backwater",
         "open ends: the depths of steady varied flow along the channel, as `riffle backwater` finds them"},
    }};
};

template <>
struct Words<SolidShape> {
    static constexpr std::array<Word, 12> list{{
        {"free-form", "the outline of `x` and `z` in two dimensions, the closed surface of `file` in three"},
        {"box", "three dimensions: by `centre` and `size`, turned by `angle`"},
        {"sphere", "three dimensions: by `centre` and `diameter`"},
        {"cylinder", "three dimensions: by `centre`, `diameter`, `length` and `axis`"},
        {"rectangle", "two dimensions: by `centre` and `size`, turned by `angle`"},
        {"circle", "two dimensions: by `centre` and `diameter`"},
        {"bed",
         "a bed from measured heights, by the file `heights`: under all of the channel, down to below the bed level"},
        {"section",
         "three dimensions: a bed of one cross-section all along the channel, by `y` and `levels`"},
        {"trapezoid",
         "three dimensions: such a bed, a canal about the centreline by `bottom_width` and `bank_slope`"},
        {"compound", "three dimensions: the same with floodplains on both sides at `bank_height`"},
        {"pipe", "three dimensions: such a bed, the lower half of a pipe about the centreline by `diameter`"},
        {"spheres",
         "three dimensions: a layer of equal spheres over all of the bed, by `diameter` and `packing`"},
    }};
};

template <>
struct Words<SolidAxis> {
    static constexpr std::array<Word, 3> list{{
        {"x", "along the channel"},
        {"y", "across the channel"},
        {"z", "upright"},
    }};
};

template <>
struct Words<SolidPacking> {
    static constexpr std::array<Word, 3> list{{
        {"hexagonal", "rows along the channel, every other one shifted by half a sphere"},
        {"square", "rows along the channel, side by side"},
        {"random",
         "one after the other at random places that are free, until hardly one is left: about 0.55 of the area"},
    }};
};

template <>
struct Words<SolidSurface> {
    static constexpr std::array<Word, 3> list{{
        {"no-slip", "the water rests at it",
         "dummy particles whose velocity continues the water's through that of the surface (Adami, Hu & Adams 2012)",
         "the default; the boundary layer needs some four particles"},
        {"slip", "frictionless: it gives pressure alone", "dummy particles without viscous pairs",
         "for water at rest and where the boundary layer is far thinner than the spacing"},
        {"log-law",
         "the friction of the log law over its `equivalent_roughness`, in a layer of three spacings",
         "theory 9",
         "banks, floors and beds from data in turbulent flow, whose boundary layer the spacing does not resolve"},
    }};
};

template <>
struct Words<SolidMotion> {
    static constexpr std::array<Word, 5> list{{
        {"fixed", "it stands still"},
        {"constant", "it moves at a constant velocity from its start",
         "u_w in the continuity equation, (g - a_w).r in the wall pressure (Adami, Hu & Adams 2012, eq. 27)",
         "pistons and gates"},
        {"oscillating", "it swings harmonically from its start",
         "displacement amplitude sin(2 pi frequency (t - start)); at full speed from the start",
         "wavemakers, with h = 2 dx"},
        {"table", "it follows a table of places and angles in time",
         "cubic pieces through the values, with the slopes of the parabolas through three of them: velocities "
         "without jumps"},
        {"free", "the water, its weight and what it touches move it",
         "M dv/dt = F, I dw/dt + w x I w = T, with the water's step; soft contacts (Cundall & Strack 1979)",
         "docs/bodies.md"},
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
    static constexpr std::array<Word, 7> list{{
        {"velocity", "u and w at points, as an acoustic Doppler velocimeter gives them"},
        {"wave", "elevation of the surface at positions along the channel"},
        {"surface_line", "elevation of the surface on an even line over the whole channel"},
        {"grid",
         "means and second moments of u and w on a grid, window by window, as from image velocimetry"},
        {"flow_rate", "discharge per unit width through sections, and the depth there"},
        {"pressure", "pressure at points of walls or in the water, as transducers give it"},
        {"force", "drag and friction of the bed, its normal force, and the weight component, per unit width"},
    }};
};

}  // namespace riffle::inline case_file
