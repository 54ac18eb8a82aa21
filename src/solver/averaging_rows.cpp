#include "solver/averaging_rows.hpp"

#include <algorithm>
#include <cmath>

#include "boundary/wall.hpp"
#include "case/flow_kind.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline solver {

int averaging_rows(const Case& c) {
    const Lattice lattice = lattice_of(c);
    if (!varies_along(flow_kind(c)) || c.channel.top != Top::free_surface) return lattice.rows;
    return std::max(lattice.rows, static_cast<int>(std::ceil(end_wall_height(c) / lattice.dz - 1e-9)));
}

}  // namespace riffle::inline solver
