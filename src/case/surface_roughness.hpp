#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

// The roughness of solids whose surface has the log law, and of the patches on them.

/// k_s whose log law has Manning's n (s/m^(1/3)) in wide water of the depth of the case, m; nothing where no
/// k_s up to that depth has it.
[[nodiscard]] std::optional<double> roughness_of_surface_manning(const Case& c, double manning);

/// k_s of the surface of a solid, m, and of a patch; 0: smooth.
[[nodiscard]] double surface_roughness(const Case& c, const Solid& solid);
[[nodiscard]] double surface_roughness(const Case& c, const SurfacePatch& patch);

/// The patches on a solid, in the order of the case.
[[nodiscard]] std::vector<const SurfacePatch*> patches_on(const Case& c, const Solid& solid);

/// Whether all patches on a solid are strips all along the channel, so that the solid has one roughness at
/// each place across it.
[[nodiscard]] bool has_strips_alone(const Case& c, const Solid& solid);

/// k_s of the surface of such a solid at a place across the channel, m.
[[nodiscard]] double surface_roughness_at(const Case& c, const Solid& solid, double y);

}  // namespace riffle::inline case_file
