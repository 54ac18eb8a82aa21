#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// The numerics of a preset, before any key of the case changes them. In three dimensions the thesis took a
/// lower speed of sound than in two.
[[nodiscard]] Numerics preset_numerics(Preset preset, int dimensions = 2);

/// Give a case in three dimensions the closure and the numerics with which its particles carry the eddies, as
/// `riffle new --resolved`. Measured in docs/resolved-eddies.md.
void choose_for_resolved_eddies(Case& c);

/// Which of the keys that follow from others a case gives itself.
struct GivenNumerics {
    bool spacing = false;
    bool smoothing_ratio = false;
    bool wall_layers = false;
    bool lattice = false;
    bool pressure_correction_time = false;
    bool settling_time = false;
};

/// Layers of wall particles as deep as the kernel reaches, 2 h.
[[nodiscard]] int layers_of_kernel(double smoothing_ratio);

/// Choose the others, with the presets of Riffle's own numerics: over beds of spheres a spacing that resolves
/// the flow among the crests and over the depth, in two dimensions with h = 2 dx; walls as deep as the kernel
/// reaches. Measured in docs/validation.md.
void choose_resolution(Case& c, const GivenNumerics& given);

}  // namespace riffle::inline case_file
