#pragma once

#include <cstdint>
#include <vector>

#include "boundary/body_state.hpp"
#include "case/case.hpp"

namespace riffle {

/// Bodies that wall particles belong to (WallParticles::body): walls at rest, the lid, and from `first_solid`
/// on the solids in the order of the case.
inline constexpr std::int32_t resting_body = 0;
inline constexpr std::int32_t lid_body = 1;
inline constexpr std::int32_t first_solid = 2;

/// The prescribed motion of the walls and solids of a case.
class WallMotion {
  public:
    WallMotion() = default;
    explicit WallMotion(const Case& c);

    /// Whether any wall has a velocity: the lid or a solid that is not fixed.
    [[nodiscard]] bool any() const { return lid_velocity_ != 0.0 || solids_move_; }
    /// Whether wall particles change their place.
    [[nodiscard]] bool displaces() const { return solids_move_; }
    /// State of all bodies at a time, by body (case/solid_motion.hpp).
    [[nodiscard]] std::vector<BodyState> at(double time) const;

  private:
    std::vector<Solid> solids_;
    double lid_velocity_ = 0.0;
    bool solids_move_ = false;
};

/// Largest speed of the lid and of the solids of a case, m/s.
[[nodiscard]] double largest_wall_speed(const Case& c);

}  // namespace riffle
