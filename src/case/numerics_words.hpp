#pragma once

#include <array>

#include "case/case.hpp"
#include "case/word.hpp"

namespace riffle::inline case_file {

// The words of [numerics].

template <>
struct Words<Preset> {
    static constexpr std::array<Word, 4> list{{
        {"riffle", "the verified scheme of this program, for channels and calm water"},
        {"violent", "for water that falls, breaks and hits: dam breaks, impacts, sloshing, jets"},
        {"thesis", "the numerics of the thesis (cubic spline, symmetric pressure form), for study"},
        {"paper", "the numerics of the 2016 paper (as the thesis, linear equation of state), for study"},
    }};
};

template <>
struct Words<KernelKind> {
    static constexpr std::array<Word, 7> list{{
        {"wendland-c2", "Wendland's quintic C2 kernel", "Wendland (1995)",
         "all flows: the scheme is verified with it"},
        {"cubic-spline", "cubic B-spline", "Monaghan & Lattanzio (1985); thesis (2.36)",
         "to repeat SPHysics; clumps"},
        {"gaussian",
         "Gaussian of length 2 h/3, cut at 2 h and normalised there; narrow, take h = 2 dx or more",
         "Colagrossi & Landrini (2003)", "laminar checks with h = 2 dx; nothing gained in channels"},
        {"quadratic", "parabola (SPHysics): does not clump, but its sums converge worst",
         "Johnson et al. (1996); SPHysics",
         "impact without clumping; its second derivative jumps, and the viscous force is low at h = 1.5 dx"},
        {"quintic-spline", "quintic B-spline of radius 2 h; narrow, take h = 2 dx or more",
         "Morris et al. (1997)", "laminar flow with h = 2 dx, with more pairs for it"},
        {"wendland-c4", "Wendland's C4 kernel; narrow, take h = 2 dx or more",
         "Wendland (1995); Dehnen & Aly (2012)", "h = 2 dx or more; nothing gained in channels"},
        {"wendland-c6", "Wendland's C6 kernel; the narrowest, take h = 2 dx or more",
         "Wendland (1995); Dehnen & Aly (2012)", "h = 2 dx or more; nothing gained in channels"},
    }};
};

template <>
struct Words<DragSampling> {
    static constexpr std::array<Word, 2> list{{
        {"row",
         "its mean over the height of the particle's row: the rows meet the whole drag wherever they stand",
         "theory 8", "all channels over spheres"},
        {"point", "its value at the height of the particle's centre", "thesis (4.3)",
         "to repeat the thesis; the flow depends on where the rows stand"},
    }};
};

template <>
struct Words<EquationOfState> {
    static constexpr std::array<Word, 2> list{{
        {"linear", "p = c0^2 (rho - rho0)", "paper (10); Morris et al. (1997)",
         "always: the density varies by little"},
        {"tait", "p = (c0^2 rho0 / 7) [(rho / rho0)^7 - 1]", "thesis (2.45)",
         "to repeat the thesis; differs from the linear one by 3 s, s the relative density change"},
    }};
};

template <>
struct Words<PressureForm> {
    static constexpr std::array<Word, 4> list{{
        {"corrected", "conservative form with the corrected kernel gradient: no spurious friction",
         "theory 5; Bonet & Lok (1999) made conservative", "all channels"},
        {"symmetric", "the usual p_i + p_j form: spurious friction where the particles are disordered",
         "thesis (2.42)", "not for channels: a spurious stress brakes the flow"},
        {"riemann",
         "p_i + p_j with the limited dissipation of a Riemann problem: for violent flow, not for channels",
         "Zhang, Hu & Adams (2017)", "violent flow; in channels as `symmetric`, and it damps vortices"},
        {"riemann-non-conservative",
         "the same with p_j - p_i: no force at uniform pressure, but momentum is not conserved",
         "theory 5; Zhang, Hu & Adams (2017)",
         "closed flow without mean shear; refused with a free surface, which blows up"},
    }};
};

template <>
struct Words<ReferencePressure> {
    static constexpr std::array<Word, 2> list{{
        {"none", "the pairs carry the whole pressure", "",
         "water whose surface moves up and down, violent flow, open ends"},
        {"hydrostatic",
         "below a surface that stays level the weight of the water is held by a function of the height, and the pairs carry the rest",
         "theory 5",
         "resolved eddies, and water at rest: what disorder makes of the pressure falls with the pressure of the pairs"},
    }};
};

template <>
struct Words<VelocityGradient> {
    static constexpr std::array<Word, 2> list{{
        {"corrected", "exact for linear velocity fields", "theory 6; Bonet & Lok (1999)",
         "always with a closure: exact up to the last row at walls and surface"},
        {"plain", "plain kernel sum", "theory 6, without the matrix", "laminar flow, where nothing uses it"},
    }};
};

template <>
struct Words<KernelCorrection> {
    static constexpr std::array<Word, 2> list{{
        {"kernel-gradient", "inverse of the first moments: exact for linear fields (Bonet & Lok)",
         "B = M^-1, M = -sum V r grad W (Bonet & Lok 1999)", "all flows"},
        {"kernel", "the kernel over its sum (Shepard): exact for constants alone",
         "B = I / S, S = sum V W (Shepard 1968)",
         "no flow; it shows what the gradient's correction is worth (theory 5)"},
    }};
};

template <>
struct Words<DensityDiffusion> {
    static constexpr std::array<Word, 4> list{{
        {"fourtakas", "diffusion of the density less its hydrostatic part",
         "theory 4; Fourtakas et al. (2019)", "always under gravity"},
        {"none", "no diffusion", "", "short laminar flows with a filter, or to see the noise it takes away"},
        {"molteni", "diffusion of the density (Molteni & Colagrossi): moves the level of water at rest",
         "theory 4; Molteni & Colagrossi (2009)", "without gravity; with it still water sinks (theory 4)"},
        {"antuono", "diffusion of the density less its corrected linear part (Antuono et al.)",
         "sum V [2 (s_i - s_j) - (g_i + g_j).r] F, g = M^-1 sum V (s_j - s_i) grad W (Antuono et al. 2012)",
         "water that is not hydrostatic along z (tilted, violent); over a rough bed a run failed with it, where fourtakas holds for a fraction of the time (theory 4)"},
    }};
};

template <>
struct Words<DensityFilter> {
    static constexpr std::array<Word, 3> list{{
        {"none", "no filter", "", "with density diffusion"},
        {"shepard", "zeroth-order renormalisation of the density", "Shepard (1968); SPHysics",
         "to repeat published runs; density diffusion does the same at each step"},
        {"mls", "first-order moving least squares renormalisation of the density",
         "Colagrossi & Landrini (2003); the thesis",
         "to repeat the thesis; density diffusion does the same at each step"},
    }};
};

template <>
struct Words<ViscosityForm> {
    static constexpr std::array<Word, 4> list{{
        {"morris", "acts along the velocity difference", "theory 6; Morris et al. (1997)",
         "channels: exact in layered shear; a free surface has zero normal gradient, so waves lose half of nature's damping"},
        {"monaghan-gingold",
         "acts along the line of centres; conserves angular momentum, too weak in layered shear",
         "Monaghan & Gingold (1983), Monaghan (2005)",
         "viscous damping of waves; weak in sheared layers (theory 6)"},
        {"lo-shao",
         "acts along the velocity difference, softened (Lo & Shao; SPHysics), and so a little too weak",
         "Lo & Shao (2002); SPHysics; the thesis",
         "to repeat SPHysics; `morris` is the same without the loss"},
        {"artificial",
         "Monaghan's artificial viscosity, alpha h c0, between approaching particles: instead of the water's",
         "Monaghan (1992); SPHysics",
         "calming still water or impacts (alpha 0.01 to 0.1); changes with the spacing, not where friction counts"},
    }};
};

template <>
struct Words<EddyStress> {
    static constexpr std::array<Word, 2> list{{
        {"two-point", "the eddy viscosity enters the pair viscosity", "theory 6", "always"},
        {"stress-divergence", "kernel divergence of the stress at the particles (the thesis)",
         "thesis (4.1); Gotoh et al. (2001)",
         "to repeat the thesis: velocity zigzags from row to row (theory 6)"},
    }};
};

template <>
struct Words<Stepping> {
    static constexpr std::array<Word, 6> list{{
        {"semi-implicit-euler", "one force evaluation per step, first order; disordered water swells",
         "theory 10; order 1.00",
         "to save time where particles keep their order; eddying water in three dimensions swells (theory 10)"},
        {"leapfrog",
         "one force evaluation per step, velocities half a step before positions, densities from the middle of each step's way: keeps the volume of disordered water",
         "theory 10; order 1.00 once friction counts", "always"},
        {"predictor-corrector", "two force evaluations per step, second order (the thesis)",
         "thesis (2.50-2.52), Monaghan (1989); order 2.00", "transients; Courant number 0.4 or less"},
        {"verlet",
         "one force evaluation per step, a leap over two steps (SPHysics); not with density diffusion at Courant numbers above 0.2, where it fails",
         "Verlet (1967), SPHysics; order 1.95 in small steps",
         "without density diffusion, or Courant numbers up to 0.2"},
        {"symplectic", "two force evaluations per step, the second at its middle; second order (SPHysics)",
         "Leimkuhler et al. (1996), DualSPHysics; order 2.00", "transients"},
        {"beeman",
         "two force evaluations per step, with the rates of the step before; third order (SPHysics)",
         "Beeman (1976), SPHysics; order 3.0", "transients that must be accurate"},
    }};
};

template <>
struct Words<StepRule> {
    static constexpr std::array<Word, 2> list{{
        {"acoustic", "C h / c0, or less where forces (a quarter of sqrt(h / a)) or viscosity ask for it",
         "theory 10", "always: at c0 of 20 U_max and more the pairs' velocities change little"},
        {"monaghan-kos",
         "C times the smaller of sqrt(h / a) and h / (c0 + the largest velocity of a pair along its line)",
         "thesis (2.53); Monaghan & Kos (1999)",
         "to repeat the thesis, and violent flow with a low speed of sound; the pairs are looked at once more in each step, in plain code"},
    }};
};

template <>
struct Words<WallKind> {
    static constexpr std::array<Word, 4> list{{
        {"dummy", "layers of particles that carry the pressure of the fluid before them",
         "theory 9; Adami et al. (2012)", "always"},
        {"dynamic",
         "staggered layers whose density follows the continuity equation (the thesis); the water rests at them",
         "Dalrymple & Knio (2001); SPHysics; the thesis",
         "to repeat SPHysics; a slip bed is not possible with it"},
        {"modified-dynamic",
         "layers of particles that carry the density found at their mirror image in the water (English et al.)",
         "s_w = s_g + (x_w - x_g).grad s, s_g and its gradient by Liu & Liu's first-order interpolation (English et al. 2022)",
         "plane walls of still water and laminar flow, as accurate as dummy; in disordered flow dummy is better. Only with density diffusion, without which the pressure scatters (theory 9)"},
        {"repulsive",
         "one row of particles that push the water away (Monaghan & Kos): no pressure, no friction",
         "n R(y) P(x) eps, R = (g H / h) (1 - q) / sqrt(q), q = y / (2 dx) (Monaghan & Kos 1999; SPHysics)",
         "to repeat runs of SPHysics over a bed; not between end walls, where their force, which has no potential, stirs still water (theory 9)"},
    }};
};

template <>
struct Words<Precision> {
    static constexpr std::array<Word, 2> list{{
        {"single", "pair arithmetic in single precision, state in double", "theory 16", "always"},
        {"double", "everything in double precision; slower", "theory 16",
         "convergence of the arithmetic itself"},
    }};
};

}  // namespace riffle::inline case_file
