#pragma once

#include <optional>
#include <span>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"
#include "record/numbers.hpp"
#include "solver/convergence.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "solver/twins.hpp"

namespace riffle::inline solver {

/// Shear stress at the crest, Pa, from the straight line of uniform flow, tau_c (H - z)/(H - d_h)
/// (thesis 4.6), fitted by least squares to the total stress above the crest without the four top layers,
/// where the kernel is cut. The half-width of its 95 % interval takes the departures of the layers as
/// independent.
struct StressLine {
    double crest_stress = 0.0;
    double half_width = 0.0;
};

/// Mean force of the bed on the water per plan area, Pa, from rows of its share of the weight component of
/// the water that is there (drag_over_gravity, wall_over_gravity) and of the water's volume, m3 (2D: m2);
/// none without a slope.
[[nodiscard]] std::optional<double> bed_stress_of_weight(const Case& c, std::span<const double> share,
                                                         std::span<const double> volume);

/// Friction velocity at the crests between open ends, where no line of stress tells it: from the force of the
/// bed over all of the channel, the part of it that the water above the crests has. None where something else
/// holds the water as well, and without a slope. Spans as of bed_stress_of_weight().
[[nodiscard]] std::optional<double> open_friction_velocity(const Case& c, std::span<const double> drag_share,
                                                           std::span<const double> wall_share,
                                                           std::span<const double> volume);

/// None without a slope or with too few layers above the crest, and where more than the bed holds the water
/// (only_bed_holds()), but below a wall at the top, where the line need not end with nothing.
[[nodiscard]] std::optional<StressLine> fit_stress_line(const Case& c, const Profiles& profiles);
/// The same of stresses at these heights above the bed level, from below; the four highest are left out.
[[nodiscard]] std::optional<StressLine> fit_stress_line(const Case& c, const std::vector<double>& height,
                                                        const std::vector<double>& total_stress);

/// Summarise the averaging window, as the attributes of `/summary` say it: means with their intervals,
/// friction velocities, departures from the twin (the section where there is one, else the column) and from
/// the stress line. Velocities are compared at the particles' own places and relative to the local velocity
/// of the twin; stresses relative to the crest's, without the top three layers, where the kernel is cut.
[[nodiscard]] Numbers summarise(const Case& c, const Twins& twins, const TimeSeries& series,
                                const Profiles& profiles, const Convergence& convergence);

}  // namespace riffle::inline solver
