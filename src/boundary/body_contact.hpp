#pragma once

#include <cstddef>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/free_body.hpp"
#include "boundary/solid_surface.hpp"
#include "case/case.hpp"

namespace riffle::inline boundary {

/// Contact of free bodies with walls, other solids and each other by soft spheres (Cundall & Strack 1979):
/// points of the surface of a body that have gone behind a wall by d are pushed out by k d - c v, never
/// pulled, v their velocity out of the wall; along the wall a spring of the way that the contact has slipped
/// holds up to Coulomb's mu times that force.
///
/// The stiffness is that which an impact of a set length needs, k = m (pi/t)^2, m the mass that the body
/// shows at the place of contact; the damping is what leaves the speed of the restitution, with no force that
/// pulls (Schwager & Poeschel 2007). The points of one body on one wall share one such spring, in proportion
/// to their depths: a face at rest and a corner alone are as stiff.
class BodyContact {
  public:
    BodyContact() = default;
    /// `duration`, s: of an impact without damping.
    BodyContact(const Case& c, const std::vector<FreeBody>& bodies, double duration);

    /// Forces and moments on the free bodies; `bodies` as WallMotion::at(). `springs`: the state of the
    /// tangential springs, which go on by a step of `step`, s; springs() of them.
    [[nodiscard]] std::vector<BodyLoad> loads(const std::vector<FreeBody>& free,
                                              const std::vector<FreeBodyState>& states,
                                              const std::vector<BodyState>& bodies, double step,
                                              std::vector<Point3>& springs) const;
    /// How many tangential springs there are.
    [[nodiscard]] std::size_t springs() const { return free_count_ * (planes_.size() + points_.size()); }

    /// Depth of the deepest place of a free body behind a wall or in another solid, m; for checks.
    [[nodiscard]] double deepest(const std::vector<FreeBody>& free, std::size_t n,
                                 const std::vector<BodyState>& bodies) const;

  private:
    /// A place where two bodies touch.
    struct Touch {
        Point3 place{};   ///< where the first body is: in a channel that repeats, of its images
        Point3 other{};   ///< the same place where the second one is
        Point3 normal{};  ///< towards the first body
        double depth = 0.0;
    };
    /// One of the two.
    struct Party {
        const FreeBody* free = nullptr;  ///< null: it does not give way
        const FreeBodyState* state = nullptr;
        const BodyState* body = nullptr;  ///< null: at rest
        BodyLoad* load = nullptr;
    };

    void touch_plane(std::size_t solid, const BoundaryPlane& plane, const BodyState& body,
                     std::vector<Touch>& touches) const;
    /// Where two solids stand in each other.
    void touch_solid(std::size_t first, std::size_t second, const std::vector<BodyState>& bodies,
                     std::vector<Touch>& touches) const;
    /// Points of one solid in another one.
    template <class Add>
    void points_inside(std::size_t points_of, std::size_t in, const std::vector<BodyState>& bodies,
                       const Add& add) const;
    [[nodiscard]] bool may_touch(std::size_t first, std::size_t second,
                                 const std::vector<BodyState>& bodies) const;
    void press(const std::vector<Touch>& touches, const Party& first, const Party& second, double step,
               Point3& spring) const;

    std::vector<BoundaryPlane> planes_;
    int dimensions_ = 2;
    SolidSurfaces surfaces_;
    std::vector<std::vector<Point3>> points_;  ///< of the surface of each solid, at t = 0
    std::vector<Point3> middle_;               ///< of each solid, at t = 0
    std::vector<double> radius_;               ///< around it
    std::size_t free_count_ = 0;
    double duration_ = 0.0;
};

/// Share of critical damping with which a spring that does not pull leaves an impact at `restitution` times
/// its speed; `restitution` from exp(-2) on, which critical damping leaves (Schwager & Poeschel 2007).
[[nodiscard]] double damping_ratio(double restitution);

}  // namespace riffle::inline boundary
