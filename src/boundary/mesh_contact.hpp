#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/push.hpp"
#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "case/solid_mesh.hpp"
#include "particles/particles.hpp"

namespace riffle::inline boundary {

/// Keeps water out of the solids of a case in three dimensions, as SolidContact does in two: in an impact
/// single particles are driven in between the wall particles. Up to the surface itself where those fill the
/// solid up to it (walls_end_at_surface); on the places of the lattice, water that rests at a solid stands
/// half a spacing before its first layer of wall particles; where that layer lies deeper than half a spacing
/// behind the surface, as much of the solid is the water's.
class MeshContact {
  public:
    MeshContact() = default;
    /// `walls`: all wall particles of the case; looks at those of the solids.
    MeshContact(const Case& c, const WallParticles<3>& walls);

    [[nodiscard]] bool empty() const { return !meshes_ || meshes_->empty(); }
    /// Put a particle that is up to a spacing too deep in a solid back to where water may stand, along the
    /// shortest way out, and take from its velocity what still leads into the solid. `now`: the bodies,
    /// WallMotion::at(). Returns how far it was put back, m; 0 where it may stand; deeper it stays where it
    /// is.
    double resolve(const std::vector<BodyState>& now, Vec<3>& position, Vec<3>& velocity,
                   const Push& push = {}) const;

    /// How deep a place is behind the surface of a solid, m; 0 outside.
    [[nodiscard]] double depth(std::size_t solid, const std::vector<BodyState>& now,
                               const Vec<3>& position) const;

  private:
    /// The place of water where the surface of a solid stood at t = 0; of one that has moved through periodic
    /// ends or sides its image at the solid.
    [[nodiscard]] Vec<3> in_body(std::size_t solid, const BodyState& state, Vec<3> position) const;
    /// Depth up to which water may stand behind the surface at a place of it, m. Below zero, before the
    /// surface, at a solid that moves: it catches up with water that no pressure holds off, and what comes
    /// nearer than half a spacing to its first layer has less room than its density says, and sinks along the
    /// next edge.
    [[nodiscard]] double room_at(std::size_t solid, const Vec<3>& place) const;
    [[nodiscard]] std::int64_t cell_of(const Vec<3>& place, const std::array<int, 3>& beside) const;

    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
    /// Of each solid, the depth of its wall particle in a cell a spacing wide; none where they end at the
    /// surface.
    std::vector<std::unordered_map<std::int64_t, double>> layers_;
    std::vector<bool> moves_;  ///< of each solid
    double spacing_ = 0.0;
    std::array<double, 3> period_{};  ///< along x, y, z, m; 0: none
    std::vector<BoundaryPlane> planes_;
};

}  // namespace riffle::inline boundary
