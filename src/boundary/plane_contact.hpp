#pragma once

#include <vector>

#include "boundary/boundary_planes.hpp"
#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// Keeps water before the plane walls of a case: bed, end walls, side walls and lid. Their pressure does so
/// but for single particles that an impact drives in between the wall particles.
template <int D>
class PlaneContact {
  public:
    PlaneContact() = default;
    /// None where the channel has no walls, or walls that are planes already (`wall = "repulsive"`).
    explicit PlaneContact(const Case& c);

    [[nodiscard]] bool empty() const { return planes_.empty(); }
    /// Put a particle that is a quarter of a spacing to a spacing behind a wall onto its plane, and take from
    /// its velocity what still leads into the wall. Returns how deep it was, m; 0 where nothing was done. Up
    /// to the quarter the wall's own pressure holds it. Farther behind it has come over the wall's top.
    /// Why a quarter, and why onto the plane: the table of docs/theory.md, section 9.
    double resolve(Vec<D>& position, Vec<D>& velocity) const;

  private:
    std::vector<BoundaryPlane> planes_;
    double spacing_ = 0.0;
};

}  // namespace riffle::inline boundary
