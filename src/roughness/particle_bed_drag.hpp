#pragma once

#include <memory>

#include "roughness/bed_drag.hpp"

namespace riffle::inline roughness {

/// The drag of the bed as particles in rows of a height (m) meet it: of its spheres or by its wall law, in
/// patches of it that of theirs, each over its part of a particle. nullptr where no part of the bed has one.
[[nodiscard]] std::unique_ptr<const BedDrag> make_particle_bed_drag(const Case& c, double row_height);

}  // namespace riffle::inline roughness
