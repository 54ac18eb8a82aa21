#pragma once

namespace riffle::inline case_file {

// The options of a case. Each enumerator has one word in the case file (words.hpp). They stand apart from the
// case so that the loops over particles, which know options but no case, are not compiled anew for each new
// key.

enum class Preset { riffle, violent, thesis, paper };
enum class Ends { periodic, walls, open };
enum class InflowProfile { twin, column, uniform, power_law, log_law, file, results };
enum class OutflowKind { depth, normal_depth, critical_depth, weir, rating_curve, free, free_fall, pressure };
enum class Top { free_surface, wall, periodic };
enum class Sides { periodic, walls, half };
enum class SideDragForm { consistent, thesis, log_law, none };
enum class BedKind { spheres, slip, no_slip, roughness, smooth };
enum class DragSampling { row, point };
enum class Packing { hexagonal, square };
enum class DragForm { consistent, thesis, paper, slice, plan_mean };
enum class ClosureKind {
    none,
    ramp,
    nezu_rodi,
    nikuradse,
    sps,
    czernuszenko_rylov,
    wale,
    vreman,
    smagorinsky
};
enum class StressTerms { full, shear };
enum class EddyRate { strain, rotation, strain_and_rotation };
enum class ClosureDepth { automatic, initial, local };
enum class KernelKind {
    wendland_c2,
    cubic_spline,
    gaussian,
    quadratic,
    quintic_spline,
    wendland_c4,
    wendland_c6
};
enum class EquationOfState { linear, tait };
enum class PressureForm { corrected, symmetric, riemann, riemann_non_conservative };
enum class ReferencePressure { none, hydrostatic };
enum class VelocityGradient { corrected, plain };
enum class KernelCorrection { kernel_gradient, kernel };
enum class DensityDiffusion { fourtakas, none, molteni, antuono };
enum class DensityFilter { none, shepard, mls };
enum class ViscosityForm { morris, monaghan_gingold, lo_shao, artificial };
enum class EddyStress { two_point, stress_divergence };
enum class Stepping { semi_implicit_euler, leapfrog, predictor_corrector, verlet, symplectic, beeman };
enum class StepRule { acoustic, monaghan_kos };
enum class WallKind { dummy, dynamic, modified_dynamic, repulsive };
enum class Precision { single_precision, double_precision };
enum class StartKind {
    column,
    uniform,
    rest,
    power_law,
    results,
    standing_wave,
    taylor_green,
    isotropic,
    section,
    backwater
};
enum class StartLattice { square, hexagonal, body_centred };
enum class SurfaceDetection { volume_fraction, position_divergence, density_ratio, depth_sum };
enum class SolidShape {
    free_form,
    box,
    sphere,
    cylinder,
    rectangle,
    circle,
    bed,
    section,
    trapezoid,
    compound,
    pipe,
    spheres
};
enum class SolidAxis { x, y, z };
enum class SolidPacking { hexagonal, square, random };
enum class SolidSurface { no_slip, slip, log_law };
enum class SolidMotion { fixed, constant, oscillating, table, free };
enum class RunUntil { time, converged };
enum class ProbeKind { velocity, wave, surface_line, grid, flow_rate, pressure, force };

}  // namespace riffle::inline case_file
