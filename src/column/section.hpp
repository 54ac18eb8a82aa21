#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "roughness/side_wall_partition.hpp"

namespace riffle::inline column {

/// The cross-section twin of a case: the same model for the mean flow along a straight channel with side
/// walls, without secondary flow.
struct SectionResult {
    std::vector<double> y;                     ///< centres of the cells over the simulated width, m
    std::vector<double> z;                     ///< centres of the cells above the bed level, m
    std::vector<double> velocity;              ///< U at [iz * y.size() + iy], m/s; so are the following
    std::vector<double> mixing_length;         ///< l_x, m
    std::vector<double> shear_stress;          ///< tau_xz, Pa
    std::vector<double> lateral_shear_stress;  ///< tau_xy, Pa
    std::vector<double> porosity;              ///< empty without porous zones
    double bulk_velocity = 0.0;                ///< mean over the whole section from the bed level
    double depth_mean_velocity = 0.0;          ///< mean over the section above the datum
    double centreline_velocity = 0.0;          ///< mean over the depth above the datum, at the centreline
    double maximum_velocity = 0.0;
    double wall_layer_velocity = 0.0;   ///< mean over the walls' layers; without their drag 0
    double discharge = 0.0;             ///< of the whole width above the bed level, m3/s
    double momentum_coefficient = 1.0;  ///< beta, mean of U^2 over the square of the mean
    double energy_coefficient = 1.0;    ///< alpha, mean of U^3 over the cube of the mean
    double drag_share = 0.0;            ///< force on the bed / weight component
    double side_wall_share = 0.0;       ///< force on both side walls / weight component
    /// Of both, the friction of a bed and side walls at which the water rests: what the particles book as
    /// that of walls, / weight component.
    double wall_share = 0.0;
    double vegetation_share = 0.0;       ///< force on the vegetation / weight component
    double porous_share = 0.0;           ///< resistance of porous layers / weight component
    double bed_stress = 0.0;             ///< force on the bed per plan area, Pa
    double wall_stress = 0.0;            ///< force on a side wall per its area, Pa
    double side_wall_coefficient = 0.0;  ///< beta_w of the walls' layers, 1/m
    SideWallPartition partition;         ///< Yang & Lim's
    /// E-folding time of the slowest mode of small departures from the steady state, s; in a transient state
    /// that of the steady state it came from, or 0.
    double relaxation_time = 0.0;

    /// U at a point: bilinear between the centres, constant beyond the outermost.
    [[nodiscard]] double velocity_at(double across, double height) const;

    /// Mean of the water over the depth above `datum` at each y, m/s. Cells that the datum cuts count in
    /// part, those in porous zones as their water does.
    [[nodiscard]] std::vector<double> depth_means(double datum, double total_depth) const;
};

/// Cells of the grid over half of the width and over the depth, of which plane beds get two and a half times
/// as many: halving the cells changes no printed value by more than 0.1 %.
struct SectionOptions {
    int cells_across = 120;
    int cells_over_depth = 90;
    /// Transient: largest local error of a step, relative to the largest velocity (root mean square).
    double tolerance = 3e-4;
    /// Steady: whether to find the relaxation time, which takes as long as the flow; it is 0 without.
    bool with_relaxation_time = true;
};

/// Why a case has no section twin, the steady uniform flow between side walls: a sentence with what to
/// change. Nothing where it has one. Periodic sides have the column.
[[nodiscard]] std::optional<std::string> why_no_section(const Case& c);
[[nodiscard]] inline bool has_section(const Case& c) { return !why_no_section(c); }

/// Solve the steady flow of
///     dU/dt = g S0 + d/dy[(nu0 + A nu_t) dU/dy] + d/dz[(nu0 + nu_t) dU/dz] - (beta_bed + beta_w) U|U|,
/// nu_t = l_x^2 sqrt((dU/dy)^2 + (dU/dz)^2), A = 1/2 (1 + q^2), with the closure, the plan mean of the bed
/// drag and the side walls' drag of the particles. No flux through bed level, surface, side walls and plane
/// of symmetry; U = 0 at the bed level of no-slip beds. The flow being symmetric, half of the section is
/// solved; with sides = "walls" it is mirrored. Throws InputError where there is no section (has_section()).
[[nodiscard]] SectionResult solve_section(const Case& c, const SectionOptions& options = {});

/// What a transient section starts from.
enum class SectionStart {
    column,     ///< the profile of the column twin, everywhere across the channel
    uniform,    ///< the depth-mean velocity of the column
    power_law,  ///< U_max (z/H)^(1/m), the start of the thesis; start.velocity and start.exponent of the case
    rest,
};

/// State to start from. Power law: without `start.velocity` U_max is such that the flow through the section
/// is that of the column. Throws as solve_section(), and as solve_column() where there is no column.
[[nodiscard]] SectionResult start_section(const Case& c, SectionStart start,
                                          const SectionOptions& options = {});

/// The flow at an instant of a transient.
struct SectionMoment {
    double time = 0.0;  ///< since the start, s
    double depth_mean_velocity = 0.0;
    double centreline_velocity = 0.0;
    double wall_layer_velocity = 0.0;
    double side_wall_share = 0.0;
};

/// Let the flow develop over `time` (s) from `start`, which must be symmetric about the centreline; its
/// velocities are interpolated where it stands on another grid. Two-stage Rosenbrock method of order 2
/// (L-stable) with steps that keep the local error; `observe` is called at the start and after each step.
[[nodiscard]] SectionResult advance_section(const Case& c, const SectionResult& start, double time,
                                            const SectionOptions& options = {},
                                            const std::function<void(const SectionMoment&)>& observe = {});

}  // namespace riffle::inline column
