#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boundary/free_body.hpp"
#include "case/body_state.hpp"
#include "case/case.hpp"
#include "case/solid_motion.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// Bodies that wall particles belong to (WallParticles::body): walls at rest, the lid, and from `first_solid`
/// on the solids in the order of the case.
inline constexpr std::int32_t resting_body = 0;
inline constexpr std::int32_t lid_body = 1;
inline constexpr std::int32_t first_solid = 2;

/// A vector of a body as one of a flow in D dimensions.
template <int D>
[[nodiscard]] Vec<D> in_flow(const Vec<3>& v) {
    if constexpr (D == 3) {
        return v;
    } else {
        return {v[0], v[2]};
    }
}

/// A vector of a flow in D dimensions as one of a body.
template <int D>
[[nodiscard]] Vec<3> in_space_of(const Vec<D>& v) {
    if constexpr (D == 3) {
        return v;
    } else {
        return {v[0], 0.0, v[1]};
    }
}

/// A place of a flow as one of a body, in a channel that repeats the image nearest to another place.
template <int D>
[[nodiscard]] Vec<3> image_beside(const Domain<D>& domain, const Vec<3>& other, Vec<D> place) {
    const Vec<D> near = in_flow<D>(other);
    for (std::size_t k = 0; k < place.size(); ++k) place[k] = domain.image_near(near[k], place[k], k);
    return in_space_of<D>(place);
}

/// The same beside the middle of a body's turning, as turning it about that needs; where the body does not
/// turn, as it is.
template <int D>
[[nodiscard]] Vec<3> place_beside(const Domain<D>& domain, const BodyState& body, const Vec<D>& place) {
    if (!body.turns) return in_space_of<D>(place);
    Vec<3> middle = body.centre;
    for (std::size_t k = 0; k < middle.size(); ++k) middle[k] += body.displacement[k];
    return image_beside<D>(domain, middle, place);
}

/// The motion of the walls and solids of a case: of free bodies as far as the case prescribes it, their
/// start.
class WallMotion {
  public:
    WallMotion() = default;
    explicit WallMotion(const Case& c);

    /// Whether any wall has a velocity: the lid or a solid that is not fixed.
    [[nodiscard]] bool any() const { return lid_velocity_ != 0.0 || solids_move_; }
    /// Whether wall particles change their place.
    [[nodiscard]] bool displaces() const { return solids_move_; }
    /// State of all bodies at a time, by body (case/solid_motion.hpp). `free`: of the free ones, in the order
    /// of the case, where they are known.
    [[nodiscard]] std::vector<BodyState> at(double time, std::span<const FreeBodyState> free = {}) const;

  private:
    std::vector<Solid> solids_;
    std::vector<SolidTurning> turning_;
    double lid_velocity_ = 0.0;
    bool solids_move_ = false;
};

/// Largest speed of the lid and of the solids of a case, m/s.
[[nodiscard]] double largest_wall_speed(const Case& c);

}  // namespace riffle::inline boundary
