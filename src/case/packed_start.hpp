#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Whether rows of water enter at an end under a free surface: those of the lattice, drawn out to the
/// surface, which packing would move.
[[nodiscard]] bool packing_meets_entering_rows(const Case& c);

/// Whether a solid stands so near to an open end that packing would move the water of the end, which stands
/// on the lattice.
[[nodiscard]] bool packing_reaches_an_open_end(const Case& c);

/// Whether packing has no walls to fill the water up to: layers of wall particles as dense as the water.
[[nodiscard]] bool packing_lacks_wall_layers(const Case& c);

/// Whether the particles of a case's start are moved to fill the water evenly, `start.packed`; a start from
/// other results has their particles. `start.packed = "auto"` packs around solids in two dimensions, where
/// packing is possible, no jitter is asked for and their faces leave gaps among the rows
/// (solver/start_packing.hpp looks at that).
[[nodiscard]] bool starts_packed(const Case& c);

}  // namespace riffle::inline case_file
