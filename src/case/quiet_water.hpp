#pragma once

#include <optional>
#include <string>

#include "case/case.hpp"
#include "case/presets.hpp"

namespace riffle::inline case_file {

/// Whether a solid has faces that cut the rows of a lattice: any that is neither level nor upright along an
/// axis of the channel. Its outline or its surface must be there.
[[nodiscard]] bool has_inclined_faces(const Case& c, const Solid& solid);

/// Whether the water of a case lies beside inclined faces and nothing drives it steadily: a basin without
/// slope, lid and bodies that turn, go one way or are free. Disorder beside such faces would keep it in
/// motion (docs/theory.md, section 5), and no mean flow needs the pressure corrected at each moment.
[[nodiscard]] bool is_quiet_beside_inclined_faces(const Case& c);

/// Whether nothing can move the water of a plane basin: it starts at rest, level in each of its pools,
/// between walls and solids that rest. The square lattice gives way under it, and the pressure of each moment
/// drives what has left its place.
[[nodiscard]] bool is_still(const Case& c);

/// Choose what keeps such water quiet, with the preset of Riffle's own numerics, where the case does not: the
/// lattice and the smoothing length, the mean of the pressure's correction over a time longer than the run,
/// and in three dimensions, where nothing moves, a time to settle. Measured in docs/verification.md (solids).
void choose_for_quiet_water(Case& c, const GivenNumerics& given);

/// Which of a case's numerics are those of such water, in words; none where the water is not such.
[[nodiscard]] std::optional<std::string> quiet_water_note(const Case& c);

}  // namespace riffle::inline case_file
