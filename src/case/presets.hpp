#pragma once

#include "case/case.hpp"

namespace riffle {

/// The numerics of a preset, before any key of the case changes them. In three dimensions the thesis took a
/// lower speed of sound than in two.
[[nodiscard]] Numerics preset_numerics(Preset preset, int dimensions = 2);

/// The keys of the resolution that a case gives itself.
struct GivenResolution {
    bool spacing = false;
    bool smoothing_ratio = false;
    bool wall_layers = false;
};

/// Choose the others, with the presets of Riffle's own numerics: over beds of spheres a spacing that resolves
/// the flow among the crests and over the depth, in two dimensions with h = 2 dx; walls as deep as the kernel
/// reaches. Measured in docs/validation.md.
void choose_resolution(Case& c, const GivenResolution& given);

}  // namespace riffle
