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

/// A place as it lies beside a body that turns: in a channel that repeats, the image nearest to the middle of
/// its turning, as turning it about that needs; beside others as it is.
template <int D>
[[nodiscard]] Vec<3> place_beside(const Domain<D>& domain, const BodyState& body, Vec<D> place) {
    if (body.turns) {
        const Vec<D> centre = in_flow<D>(body.centre);
        const Vec<D> moved = in_flow<D>(body.displacement);
        for (std::size_t k = 0; k < place.size(); ++k) {
            place[k] = domain.image_near(centre[k] + moved[k], place[k], k);
        }
    }
    return in_space_of<D>(place);
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
