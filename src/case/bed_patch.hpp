#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// The bed of a patch as that of a whole channel: with the depth of the case over the bed level z = 0, which
/// all beds of a channel share. Its spheres act by the form of those of the channel's bed, where that has
/// some, else by the consistent one.
[[nodiscard]] Bed bed_of(const Case& c, const BedPatch& patch);

/// The case with the bed of a patch everywhere, and without patches.
[[nodiscard]] Case with_bed_of(const Case& c, const BedPatch& patch);

/// The case with the bed that it has at a place along the channel (m) everywhere: that of the patch which
/// covers the width there, else that of [bed] with the patches that lie in parts of the width there as strips
/// all along the channel: of an outline what it covers of the width at the place.
[[nodiscard]] Case with_bed_at(const Case& c, double x);

/// The patch that lies in a part of the width at a place along the channel, m; nullptr where none does.
[[nodiscard]] const BedPatch* patch_beside(const Case& c, double x);

/// Whether the flow over the patches that lie in parts of the width at a place along the channel, m, has the
/// twin of a cross-section: they and the bed are plane, between side walls, and the same on both sides of the
/// centreline.
[[nodiscard]] bool strips_have_section(const Case& c, double x);

}  // namespace riffle::inline case_file
