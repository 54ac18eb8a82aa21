#pragma once

#include <optional>

#include "case/case.hpp"
#include "column/column.hpp"
#include "column/section.hpp"
#include "hydraulics/steady_channel.hpp"

namespace riffle::inline column {

/// The reach of a channel far from its open ends, from all bodies in it and patches of its bed: the case with
/// periodic ends and without solids and patches, whose uniform flow is that of the bed. A case with other
/// ends is returned as it is.
[[nodiscard]] Case uniform_reach(const Case& c);

/// Whether the twin of that reach is one of the cross-section, between side walls.
[[nodiscard]] bool has_section_reach(const Case& c);

/// Whether it has a column twin, whatever its slope; a canal has the friction of its section in its place.
[[nodiscard]] bool has_column_reach(const Case& c);

/// A column twin and the weight along the bed that drives it, m/s2.
struct CarryingColumn {
    double weight = 0.0;
    ColumnResult column;
};

/// The column twin over the bed of a case that carries a discharge (m2/s over the whole depth) at a depth
/// over the datum (m), whatever the slope of the case. Throws InputError where there is none.
[[nodiscard]] CarryingColumn carrying_column(const Case& c, double depth, double unit_discharge);

/// The twin of a cross-section between side walls and the weight that drives it, m/s2.
struct CarryingSection {
    double weight = 0.0;
    SectionResult section;
};

/// The same between side walls: the section twin that carries the discharge, in the mean over its width, on
/// 40 by 30 cells over half of the width (plane beds more). Throws InputError where there is none.
[[nodiscard]] CarryingSection carrying_section(const Case& c, double depth, double unit_discharge);

/// Depth over the datum of the uniform flow that carries a discharge (m2/s) on the slope of the case, m: of
/// its column twin, between side walls of its section twin on the grid of carrying_section(). Throws
/// InputError as normal_depth(), and where there is none.
[[nodiscard]] std::optional<double> twin_normal_depth(const Case& c, double unit_discharge);

/// From where on the friction of the bed of a case is known, m over the datum.
[[nodiscard]] double least_known_depth(const Case& c);

/// Discharge of a unit of the width of the uniform flow over the bed of a case at another depth over the
/// datum (m), m2/s: of its column twin, between side walls of its section twin on the grid of
/// carrying_section().
[[nodiscard]] double uniform_discharge_at(const Case& c, double depth);

/// Discharge per unit of width of the uniform flow of a case, over the whole depth from the bed level, m2/s:
/// that of its section twin where it has one, between side walls, else of its column. Throws InputError where
/// the case has neither.
[[nodiscard]] double uniform_unit_discharge(const Case& c);

/// A channel over the bed of a case, with the friction and the coefficients of momentum and energy of its
/// column twin at each depth, between side walls of its section twin: S_f is the weight along the bed, over
/// g, with which the twin of that depth carries the discharge. The slope of the channel is that of the case.
/// The states are found at depths 10 % apart when they are first asked for and interpolated between them in
/// ln h (five-degree polynomials, to 5e-6 of the discharge of the column). Known from where the water covers
/// the crests, over a bed by roughness from twice its k_s, over a smooth bed from a thousandth of the depth
/// of the case. Of a canal canal_channel(). Throws InputError where the case has no column twin for another
/// reason than its slope.
[[nodiscard]] SteadyChannel twin_channel(const Case& c, double unit_discharge);

}  // namespace riffle::inline column
