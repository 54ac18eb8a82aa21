#pragma once

#include <memory>
#include <vector>

#include "case/case.hpp"
#include "hydraulics/lateral_profile.hpp"
#include "hydraulics/steady_channel.hpp"

namespace riffle::inline column {

/// The cross-section of a canal (canal_of(), or another solid of a section), with the upright sides above it,
/// which are wetted perimeter where the side walls have friction.
[[nodiscard]] std::shared_ptr<const SectionShape> shape_of_section(const Case& c, const Solid& section);

/// A channel whose section (section_of()) has the friction of the log law, with a discharge over the width of
/// its channel (m2/s) and the friction of Colebrook and White for its hydraulic radius, as canal_flow(),
/// which patches of another roughness change as they change the velocities across; the coefficients of
/// momentum and energy are those of the velocities across it by lateral_profile().
[[nodiscard]] SteadyChannel canal_channel(const Case& c, double unit_discharge);

/// The same without what the velocities across it add: even coefficients.
[[nodiscard]] SteadyChannel canal_by_radius(const Case& c, double unit_discharge);

/// Discharge of uniform flow with the patches on the section of a canal over that without, at a depth (m): of
/// the velocities across it by lateral_profile(). 1 without patches.
[[nodiscard]] double share_of_patches(const Case& c, double depth);

/// Discharge of uniform flow in such a channel at a depth (m), over its width, m2/s.
[[nodiscard]] double canal_uniform_discharge(const Case& c, double depth);
/// The same with the shape of its section at hand.
[[nodiscard]] double canal_uniform_discharge(const Case& c, const SectionShape& shape, double depth);

/// Strips of equal width across the simulated channel of a section with the water at a depth over its lowest
/// point, and the height of the bed in the middle of each over that point, m.
struct SectionStrips {
    double width = 0.0;  ///< of a strip, m
    std::vector<LateralStrip> strips;
    std::vector<double> bed;
};
[[nodiscard]] SectionStrips section_strips(const Case& c, const Solid& section, double depth, int count);

/// Depth-mean velocities over the strips of uniform flow in a canal down a slope (sine), m/s.
[[nodiscard]] std::vector<double> canal_velocities(const Case& c, const SectionStrips& strips, double slope);

}  // namespace riffle::inline column
