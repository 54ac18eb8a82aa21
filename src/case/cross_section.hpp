#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// A cross-section: places across the simulated channel and the heights of the bed there, m, from one side to
/// the other.
struct CrossSection {
    std::vector<double> y;
    std::vector<double> levels;
};

/// Whether a solid of this shape is a bed of one cross-section all along the channel.
[[nodiscard]] bool is_section(SolidShape shape);

/// The corners of such a solid: those it gives, or those of its trapezoid, compound channel or pipe about the
/// channel's centreline. The polygon of a pipe holds the pipe's area.
[[nodiscard]] CrossSection cross_section(const Case& c, const Solid& solid);

/// What is wrong with the keys or the corners of a cross-section, in words; empty where nothing is.
[[nodiscard]] std::string section_fault(const Case& c, const Solid& solid);

/// The water up to a level over a cross-section.
struct WettedSection {
    double area = 0.0;       ///< m2
    double perimeter = 0.0;  ///< of the section itself that is wet, m
    double top_width = 0.0;  ///< of the surface, m
};
[[nodiscard]] WettedSection wetted_section(const CrossSection& section, double level);

/// What the water up to a level wets of the upright sides above a section, m: nothing of sides without
/// friction, nor of the middle of half a channel.
struct WettedSides {
    double left = 0.0;
    double right = 0.0;
};
[[nodiscard]] WettedSides wetted_sides(const Case& c, const CrossSection& section, double level);

/// The solid of a case in three dimensions that gives its channel one cross-section all along; nothing where
/// none does, more than one, or one that is drawn wrong.
[[nodiscard]] const Solid* section_of(const Case& c);

/// The solid of a case in three dimensions that is a bed of measured heights; nothing where none is.
[[nodiscard]] const Solid* measured_bed_of(const Case& c);

/// Either of the two: the solid over which the channel is no rectangle; nothing where it is one.
[[nodiscard]] const Solid* uneven_bed_of(const Case& c);

/// The one solid of a case that makes it a canal: of one cross-section all along the channel, with the
/// friction of the log law, of one roughness or of strips all along the channel; between periodic ends down a
/// slope and with no solid beside it. Nothing where the case is another.
[[nodiscard]] const Solid* canal_of(const Case& c);

/// Whether solids stand in a channel beside the section that makes it a canal.
[[nodiscard]] bool has_solids_beside_section(const Case& c);

}  // namespace riffle::inline case_file
